#include "animation/synthesis/movement_controller.h"

#include <gtest/gtest.h>

#include "animation/synthesis/action.h"
#include "animation/synthesis/walk_synthesizer.h"
#include "base/rotation.h"
#include "tests/animation/default_library.h"
#include "tests/animation/walk_paths.h"

namespace amble {
namespace {

const Motion& carry() { return *defaultLibrary().find("carry"); }

/// Frames of identity rotations at some phases, all standing by one share.
AnimationBuffer framesAt(const std::vector<double>& phases, double standing) {
  AnimationBuffer buffer;
  buffer.poses = PoseArray(defaultLibrary().skeleton.size());
  buffer.poses.resize(static_cast<int>(phases.size()));
  for (const double phase : phases) {
    FrameState state;
    state.phase = phase;
    state.standing = standing;
    buffer.states.push_back(state);
  }
  for (int i = 0; i < buffer.size(); ++i) {
    for (auto& q : buffer.poses.rotations(i)) q.setIdentity();
  }
  return buffer;
}

TEST(MovementController, WalkingItsJointsAreTheCyclesAndNoOthersMove) {
  AnimationBuffer buffer = framesAt({0.0, 0.2, 0.7}, 0.0);
  ASSERT_TRUE(MovementController(defaultLibrary(), carry()).apply(buffer));
  const FourierSeries& series = carry().cycle.series;
  std::vector<bool> moved(defaultLibrary().skeleton.size(), false);
  for (const int j : movedJoints(defaultLibrary(), carry())) moved[j] = true;
  for (int i = 0; i < buffer.size(); ++i) {
    for (int j = 0; j < defaultLibrary().skeleton.size(); ++j) {
      Eigen::Vector3d v = Eigen::Vector3d::Zero();
      for (int k = 0; k <= series.harmonics(); ++k) {
        const double angle = 2.0 * kPi * k * buffer.states[i].phase;
        v += std::cos(angle) * series.alpha.block<3, 1>(3 + 3 * j, k) +
             std::sin(angle) * series.beta.block<3, 1>(3 + 3 * j, k);
      }
      const Eigen::Quaterniond expected =
          moved[j] ? defaultLibrary().stand().rotations[j] * expRotation(v)
                   : Eigen::Quaterniond::Identity();
      EXPECT_LT(buffer.poses.rotations(i)[j].angularDistance(expected), 1e-7) << j;
    }
  }
}

TEST(MovementController, StandingItIsTheMeanPoseWhateverThePhase) {
  AnimationBuffer buffer = framesAt({0.0, 0.3, 0.5, 0.9}, 1.0);
  ASSERT_TRUE(MovementController(defaultLibrary(), carry()).apply(buffer));
  for (const int j : movedJoints(defaultLibrary(), carry())) {
    const Eigen::Vector3d mean = carry().cycle.series.alpha.block<3, 1>(3 + 3 * j, 0);
    const Eigen::Quaterniond expected = defaultLibrary().stand().rotations[j] * expRotation(mean);
    for (int i = 0; i < buffer.size(); ++i) {
      EXPECT_LT(buffer.poses.rotations(i)[j].angularDistance(expected), 1e-7) << j;
    }
  }
}

// A standing stance's phase is 0; the last walking frame's may be next to 0.5.
TEST(MovementController, NoJointJumpsAtAStandingEndWhicheverFootIsLast) {
  const FlatGround floor;
  CharacterSettings settings;
  settings.actions = {"carry"};
  const WalkSynthesizer with(defaultLibrary(), floor, settings);
  bool left = false, right = false;
  AnimationBuffer walk;
  for (double length = 2.0; length < 4.0; length += 0.2) {
    const RootPath path = straightPath(length);
    const WalkResult result =
        with.walk(stanceAt(path, false, true), stanceAt(path, true, true), path, true, walk);
    ASSERT_EQ(result.refused, WalkRule::kNone);
    (result.leading == kLeft ? left : right) = true;
    double largest = 0.0;
    for (const int i : {1, walk.size() - 1}) {
      for (const int j : movedJoints(defaultLibrary(), carry())) {
        largest = std::max(
            largest, walk.poses.rotations(i)[j].angularDistance(walk.poses.rotations(i - 1)[j]));
      }
    }
    EXPECT_LT(largest, 0.2 * kDegree) << length;
  }
  EXPECT_TRUE(left && right);
}

}  // namespace
}  // namespace amble

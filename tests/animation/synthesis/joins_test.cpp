// Where captured starts, stops and turns are joined to the walk, no joint is jerked.

#include <gtest/gtest.h>

#include <algorithm>

#include "animation/preparation/motion_library_add.h"
#include "animation/synthesis/walk_synthesizer.h"
#include "base/rotation.h"
#include "tests/animation/default_library.h"
#include "tests/animation/planted_clip.h"
#include "tests/animation/walk_paths.h"

namespace amble {
namespace {

/// Largest angular acceleration of a joint in what walks, starts and turns were captured, at 30 Hz
/// [rad/s²]. Captures begin and end with a jump.
double capturedAcceleration() {
  constexpr int kJump = 10;  // frames
  double most = 0.0;
  for (const char* name : {"B01_StandToWalk", "B03_Walk1", "B09_WalkTurnLeft90"}) {
    const auto file =
        sharedFolder() / "mocap" / ("accad_female1/Female1_" + std::string(name) + ".bvh");
    MotionLibrary library = defaultLibrary();
    const Clip clip = clipForLibrary(library, readForLibrary(file, {}), file.string());
    most = std::max(most, jointAcceleration(clip, kJump, clip.frames() - kJump));
  }
  return most;
}

TEST(Joins, AreNoMoreSuddenThanTheCaptures) {
  AMBLE_NEEDS_CAPTURES();
  const double captured = capturedAcceleration();
  const FlatGround ground;
  CharacterSettings settings;
  settings.frame_time = 1.0 / 30.0;
  AnimationBuffer buffer;
  int transitions = 0;
  for (const double speed : {1.0, 1.2, 1.3}) {
    settings.speed = speed;
    const WalkSynthesizer walker(defaultLibrary(), ground, settings);
    for (double length = 4.0; length < 6.0; length += 0.35) {
      for (const double angle : {0.0, 1.2, -1.2}) {
        const RootPath path =
            angle == 0.0 ? straightPath(length) : circlePath(length / angle, angle);
        ASSERT_EQ(
            walker.walk(stanceAt(path, false, true), stanceAt(path, true, true), path, true, buffer)
                .refused,
            WalkRule::kNone);
        for (const FrameState& state : buffer.states)
          transitions += state.start.there || state.stop.there ? 1 : 0;
        Clip walk;
        walk.skeleton = walker.skeleton();
        walk.frame_time = settings.frame_time;
        walk.poses = buffer.poses;
        EXPECT_LE(jointAcceleration(walk, 0, walk.frames()), 1.05 * captured)
            << speed << " m/s, " << length << " m, " << angle;
      }
    }
  }
  EXPECT_GT(transitions, 0);
}

/// Of the root over three frames from `first` on [m/s^2].
double rootAcceleration(const AnimationBuffer& walk, int first) {
  const auto at = [&](int i) -> Eigen::Vector3d { return walk.poses.p_WR(first + i); };
  return (at(0) - 2.0 * at(1) + at(2)).norm() / (walk.frame_time * walk.frame_time);
}

// Free fall is 9.8, and who walks never falls.
TEST(Joins, HipsAreNowhereJolted) {
  const FlatGround ground;
  CharacterSettings settings;
  AnimationBuffer buffer;
  for (const double speed : {0.7, 1.0, 1.2, 1.5}) {
    settings.speed = speed;
    const WalkSynthesizer walker(defaultLibrary(), ground, settings);
    for (double length = 3.0; length < 6.0; length += 0.35) {
      const RootPath path = straightPath(length);
      ASSERT_EQ(
          walker.walk(stanceAt(path, false, true), stanceAt(path, true, true), path, true, buffer)
              .refused,
          WalkRule::kNone);
      for (int i = 0; i + 2 < buffer.size(); ++i)
        EXPECT_LT(rootAcceleration(buffer, i), 9.8) << speed << " m/s, " << length << " m, " << i;
    }
  }
}

/// How fast the root turns from a frame to the next [rad/s].
Eigen::Vector3d rootTurn(const AnimationBuffer& walk, int frame) {
  const Eigen::Quaterniond a(walk.poses.rotations(frame)[0]), b(walk.poses.rotations(frame + 1)[0]);
  return logRotation(b * a.conjugate()) / walk.frame_time;
}

// By 1.2 rad/s where the body turned with its path.
TEST(Joins, AStanceBetweenTwoCurvesIsWalkedThroughWithoutAJerkOfThePelvis) {
  const FlatGround ground;
  const WalkSynthesizer walker(defaultLibrary(), ground, {});
  constexpr double kRadius = 2.0, kAngle = 1.6;
  // What t (1 - t / T)^2 is at most, times the turn rate.
  const double most_facing = 4.0 / 27.0 * WalkSynthesizer::kTurnIn * walker.maxTurnRate();
  for (const double into : {kRadius, -kRadius}) {
    const RootPath to_b = circlePath(into, std::copysign(kAngle, into));
    const Stance b = stanceAt(to_b, true, false);
    for (const double out : {kRadius, -kRadius}) {
      RootPath from_b({circlePath(out, std::copysign(kAngle, out), b.heading)});
      AnimationBuffer one, two;
      ASSERT_EQ(walker.walk(stanceAt(to_b, false, true), b, to_b, false, one).refused,
                WalkRule::kNone);
      Stance from = stanceAt(from_b, false, false), to = stanceAt(from_b, true, true);
      ASSERT_EQ(walker.walk(from, to, from_b, true, two).refused, WalkRule::kNone);
      const Eigen::Vector3d before = rootTurn(one, one.size() - 2), after = rootTurn(two, 0);
      EXPECT_LT((after - before).norm(), 0.4) << into << " then " << out;
      for (const AnimationBuffer* walk : {&one, &two})
        for (const FrameState& state : walk->states) EXPECT_LE(std::abs(state.facing), most_facing);
    }
  }
}

}  // namespace
}  // namespace amble

#include "animation/synthesis/posture_controller.h"

#include <gtest/gtest.h>

#include "animation/synthesis/action.h"
#include "animation/synthesis/walk_synthesizer.h"
#include "tests/animation/default_library.h"
#include "tests/animation/walk_paths.h"

namespace amble {
namespace {

TEST(PostureController, ItsJointsAreHeldFromStandingToStandingAndTheOthersWalk) {
  const FlatGround floor;
  CharacterSettings settings;
  const WalkSynthesizer without(defaultLibrary(), floor, settings);
  settings.actions = {"hold-box"};
  const WalkSynthesizer with(defaultLibrary(), floor, settings);
  const RootPath path = straightPath(3.0);
  AnimationBuffer held, plain;
  const Stance from = stanceAt(path, false, true), to = stanceAt(path, true, true);
  ASSERT_EQ(with.walk(from, to, path, true, held).refused, WalkRule::kNone);
  ASSERT_EQ(without.walk(from, to, path, true, plain).refused, WalkRule::kNone);
  ASSERT_EQ(held.size(), plain.size());
  const Motion& motion = *defaultLibrary().find("hold-box");
  std::vector<bool> moved(defaultLibrary().skeleton.size(), false);
  for (const int j : movedJoints(defaultLibrary(), motion)) moved[j] = true;
  for (int i = 0; i < held.size(); ++i) {
    for (int j = 0; j < defaultLibrary().skeleton.size(); ++j) {
      const Eigen::Quaterniond& expected =
          moved[j] ? motion.posture.rotations[j] : plain.poses.rotations(i)[j];
      EXPECT_EQ(held.poses.rotations(i)[j].coeffs(), expected.coeffs()) << i << " " << j;
    }
  }
}

}  // namespace
}  // namespace amble

#include "animation/synthesis/posture_controller.h"

#include <gtest/gtest.h>

#include "animation/library/motion_library_reader.h"
#include "animation/synthesis/action.h"
#include "animation/synthesis/walk_synthesizer.h"
#include "tests/animation/walk_paths.h"

namespace amble {
namespace {

const MotionLibrary& library() {
  static const MotionLibrary kLibrary = openMotionLibrary("default");
  return kLibrary;
}

TEST(PostureController, ItsJointsAreHeldFromStandingToStandingAndTheOthersWalk) {
  const FlatGround floor;
  CharacterSettings settings;
  const WalkSynthesizer without(library(), floor, settings);
  settings.actions = {"hold-box"};
  const WalkSynthesizer with(library(), floor, settings);
  const RootPath path = straightPath(3.0);
  AnimationBuffer held, plain;
  const Stance from = stanceAt(path, false, true), to = stanceAt(path, true, true);
  ASSERT_EQ(with.walk(from, to, path, true, held).refused, WalkRule::kNone);
  ASSERT_EQ(without.walk(from, to, path, true, plain).refused, WalkRule::kNone);
  ASSERT_EQ(held.size(), plain.size());
  const Motion& motion = *library().find("hold-box");
  std::vector<bool> moved(library().skeleton.size(), false);
  for (const int j : movedJoints(library(), motion)) moved[j] = true;
  for (int i = 0; i < held.size(); ++i) {
    for (int j = 0; j < library().skeleton.size(); ++j) {
      const Eigen::Quaterniond& expected =
          moved[j] ? motion.posture.rotations[j] : plain.poses.rotations(i)[j];
      EXPECT_EQ(held.poses.rotations(i)[j].coeffs(), expected.coeffs()) << i << " " << j;
    }
  }
}

}  // namespace
}  // namespace amble

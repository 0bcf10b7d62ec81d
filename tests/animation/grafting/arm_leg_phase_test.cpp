#include "animation/grafting/arm_leg_phase.h"

#include <gtest/gtest.h>

#include "base/rotation.h"
#include "tests/animation/person.h"

namespace amble {
namespace {

// Arms of a puppet's walker as they swing by `swing` times how far the opposite foot is ahead.
Clip swinging(double swing) {
  Clip clip = walkingPerson();
  const JointRoles roles = guessJointRoles(clip.skeleton, "person");
  std::vector<JointFrame> frames(clip.skeleton.size());
  for (int i = 0; i < clip.frames(); ++i) {
    forwardKinematics(clip, i, frames);
    const Eigen::Quaterniond back = frames[0].q_WJ.conjugate();
    for (const Side side : {kLeft, kRight}) {
      const double ahead =
          (back * (frames[roles.legs[other(side)].foot].p_WJ - frames[0].p_WJ)).z();
      // The rest faces z: about -x a hanging arm goes ahead.
      clip.poses.rotations(i)[roles.arms[side].arm] =
          expRotation({-swing * ahead, 0, 0}) * expRotation({0, 0, side == kLeft ? -1.4 : 1.4});
    }
    clip.poses.rotations(i)[9].setIdentity();  // the chest
  }
  return clip;
}

TEST(ArmLegPhase, IsOneWhereArmsGoWithTheOppositeLegAndMinusOneWithTheirOwn) {
  for (const double swing : {0.8, -0.8}) {
    const Clip clip = swinging(swing);
    const auto phase = armLegPhase(clip, guessJointRoles(clip.skeleton, "person"), 0, 60);
    EXPECT_GT(swing * phase[kLeft], 0.98 * 0.8);
    EXPECT_GT(swing * phase[kRight], 0.98 * 0.8);
  }
}

}  // namespace
}  // namespace amble

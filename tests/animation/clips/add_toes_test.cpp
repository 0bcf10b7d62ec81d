#include "animation/clips/add_toes.h"

#include <gtest/gtest.h>

#include "animation/body/foot_shape.h"
#include "base/error.h"
#include "base/rotation.h"
#include "tests/animation/puppet.h"

namespace amble {
namespace {

/// The puppet with feet of one bone that end `reach` of stature before the ankle and 0.05 m below
/// it, and its roles.
Clip toeless(double reach, JointRoles& roles) {
  const Clip whole = Puppet().clip();
  roles = {};
  std::vector<Joint> joints(7);
  for (const int side : {0, 1}) {
    roles.legs[side] = {1 + 3 * side, 2 + 3 * side, 3 + 3 * side, -1};
    for (int i = 0; i < 3; ++i) {
      Joint& joint = joints[1 + 3 * side + i];
      joint = whole.skeleton.joint(1 + 4 * side + i);
      joint.parent = i == 0 ? 0 : 3 * side + i;
      joint.name = (side == 0 ? "left" : "right") + std::to_string(i);
    }
  }
  const double stature = (Puppet::kThigh + Puppet::kShank) / kLegOfStature;
  for (const int side : {0, 1}) joints[3 + 3 * side].end_sites = {{reach * stature, 0.0, -0.05}};
  Clip clip{"toeless", Skeleton(joints), 0.01, PoseArray(7), {}};
  clip.poses.resize(4);
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 7; ++j) clip.poses.rotations(i)[j] = expRotation({0.1 * i, 0.02 * j, 0.3});
  }
  return clip;
}

std::vector<JointFrame> placed(const Clip& clip, int frame) {
  std::vector<JointFrame> joints(clip.skeleton.size());
  forwardKinematics(clip, frame, joints);
  return joints;
}

TEST(AddToes, AFootWithoutToeAndTipIsRefusedByName) {
  JointRoles roles;
  Clip clip = toeless(0.0, roles);
  std::vector<Joint> joints = clip.skeleton.joints();
  joints[3].end_sites.clear();
  clip.skeleton = Skeleton(joints);
  try {
    addToes(clip, roles, "rig.bvh");
    FAIL() << "nothing was refused";
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).find("rig.bvh: a foot without toes or a tip: joint left2"),
              0u)
        << error.what();
  }
}

TEST(AddToes, NothingElseMoves) {
  for (const double reach : {0.075, 0.11}) {
    JointRoles roles;
    Clip clip = toeless(reach, roles);
    const Clip before = clip;
    const JointRoles before_roles = roles;
    addToes(clip, roles, "rig.bvh");
    ASSERT_EQ(clip.skeleton.size(), 9);
    for (int frame = 0; frame < clip.frames(); ++frame) {
      const auto now = placed(clip, frame), then = placed(before, frame);
      for (const std::string& role : roleNames()) {
        const int joint = roleJoint(before_roles, role);
        if (joint < 0) continue;
        const JointFrame &a = now[roleJoint(roles, role)], &b = then[joint];
        EXPECT_LT((a.p_WJ - b.p_WJ).norm(), 1e-12) << role;
        EXPECT_LT(a.q_WJ.angularDistance(b.q_WJ), 1e-7) << role;
      }
    }
  }
}

TEST(AddToes, ANearTipIsTheBallAndAFarOneTheToes) {
  JointRoles roles;
  Clip clip = toeless(0.075, roles);
  addToes(clip, roles, "rig.bvh");
  const double stature = statureOf(clip.skeleton, roles);
  EXPECT_NEAR(clip.skeleton.joint(roles.legs[kLeft].toe).offset.x(), 0.075 * stature, 1e-12);
  clip = toeless(0.11, roles);
  addToes(clip, roles, "rig.bvh");
  const Joint& toe = clip.skeleton.joint(roles.legs[kRight].toe);
  EXPECT_NEAR((toe.offset + toe.end_sites[0]).x(), 0.11 * stature, 1e-12);
  EXPECT_NEAR(toe.end_sites[0].norm(), 0.035 * stature, 1e-12);
}

TEST(AddToes, FeetThatHaveToesStayAsTheyAre) {
  JointRoles roles = Puppet::roles();
  Clip clip = Puppet().clip();
  addToes(clip, roles, "rig.bvh");
  EXPECT_EQ(clip.skeleton.size(), 9);
  EXPECT_FALSE(clip.joint_positions.empty());
}

// A child that no name tells is the toe all the same.
TEST(AddToes, AFootsChildIsItsToe) {
  JointRoles roles = Puppet::roles();
  Clip clip = Puppet().clip();
  const int toe = roles.legs[kLeft].toe;
  roles.legs[kLeft].toe = -1;
  addToes(clip, roles, "rig.bvh");
  EXPECT_EQ(roles.legs[kLeft].toe, toe);
}

}  // namespace
}  // namespace amble

#include "animation/clips/carry_over.h"

#include <gtest/gtest.h>

#include "animation/analysis/motion_measures.h"
#include "animation/body/foot_shape.h"
#include "animation/body/pelvis.h"
#include "animation/clips/level_capture.h"
#include "base/rotation.h"
#include "tests/animation/captures.h"
#include "tests/animation/rig.h"

namespace amble {
namespace {

Clip walkOf(const Rig& rig) { return rig.walk(Puppet{}); }

Clip carried(const Clip& clip, const JointRoles& roles, const Skeleton& target) {
  const ReferencePose from = referenceOf(clip, roles);
  ReferencePose to;
  to.q_HJ.assign(target.size(), restToHeading(target, roles));
  return carriedOver(clip, {clip.skeleton, roles, from}, {target, roles, to});
}

TEST(CarryOver, OntoItsOwnSkeletonAMotionStaysAsItIs) {
  const Rig rig;
  const Clip clip = walkOf(rig), same = carried(clip, rig.roles, rig.skeleton);
  ASSERT_EQ(same.frames(), clip.frames());
  for (int i = 0; i < clip.frames(); i += 7) {
    EXPECT_LT((same.poses.p_WR(i) - clip.poses.p_WR(i)).norm(), 1e-9);
    for (int j = 0; j < rig.skeleton.size(); ++j) {
      EXPECT_LT(same.poses.rotations(i)[j].angularDistance(clip.poses.rotations(i)[j]), 1e-6);
    }
  }
}

TEST(CarryOver, OnALargerSkeletonEveryJointGoesAsFarAsLegsAreLong) {
  const Rig rig;
  const Clip clip = walkOf(rig);
  const Clip large = carried(clip, rig.roles, rig.skeleton.scaled(1.3));
  std::vector<JointFrame> a(rig.skeleton.size()), b(rig.skeleton.size());
  for (int i = 0; i < clip.frames(); i += 7) {
    forwardKinematics(clip, i, a);
    forwardKinematics(large, i, b);
    for (size_t j = 0; j < a.size(); ++j) {
      EXPECT_LT((b[j].p_WJ - 1.3 * a[j].p_WJ).norm(), 1e-9) << i << " " << j;
    }
  }
}

// A rig whose joint frames are turned any way at rest moves alike.
TEST(CarryOver, JointFramesOfTheTargetDoNotMatter) {
  const Rig rig;
  const Clip clip = walkOf(rig);
  const ReferencePose from = referenceOf(clip, rig.roles);
  std::vector<Eigen::Quaterniond> turn;  // new joint frame in the old one
  for (int j = 0; j < rig.skeleton.size(); ++j) {
    turn.push_back(expRotation({0.3 * j, 0.5 - 0.1 * j, 0.2}));
  }
  std::vector<Joint> joints = rig.skeleton.joints();
  for (size_t j = 1; j < joints.size(); ++j) {
    joints[j].offset = turn[joints[j].parent].conjugate() * joints[j].offset;
  }
  const Skeleton turned(joints);
  ReferencePose to;
  for (int j = 0; j < turned.size(); ++j) to.q_HJ.push_back(from.q_HJ[j] * turn[j]);
  const Clip other = carriedOver(clip, {clip.skeleton, rig.roles, from}, {turned, rig.roles, to});
  std::vector<JointFrame> a(turned.size()), b(turned.size());
  for (int i = 0; i < clip.frames(); i += 7) {
    forwardKinematics(clip, i, a);
    forwardKinematics(other, i, b);
    for (size_t j = 0; j < a.size(); ++j) EXPECT_LT((b[j].p_WJ - a[j].p_WJ).norm(), 1e-9) << j;
  }
}

// Real rigs of other makers: what walks straight ahead and upright still does.
TEST(CarryOver, CapturesOfOtherRigsKeepTheirHeadingTheirHeightAndTheirFeet) {
  AMBLE_NEEDS_CAPTURES();
  const std::filesystem::path mocap = sharedFolder() / "mocap";
  const LevelCapture target = readLevelCapture(mocap / "accad_female1/Female1_A01_Stand.bvh");
  const Skeleton& skeleton = target.motion.clip.skeleton;
  const ReferencePose to = referenceOf(target.motion.clip, target.motion.roles);
  for (const char* const path : {"accad_male1/Male1_B3_Walk.bvh", "cmu_mb2/07_01.bvh",
                                 "cmu_mb2/08_03.bvh", "formats/mass_walk.bvh"}) {
    const LevelCapture source = readLevelCapture(mocap / path);
    const Clip& clip = source.motion.clip;
    const JointRoles& roles = source.motion.roles;
    const ReferencePose from = referenceOf(clip, roles);
    const Clip other =
        carriedOver(clip, {clip.skeleton, roles, from}, {skeleton, target.motion.roles, to});
    const double ratio = statureOf(skeleton, target.motion.roles) / statureOf(clip.skeleton, roles);
    std::vector<JointFrame> a(clip.skeleton.size()), b(skeleton.size());
    for (int i = 0; i < clip.frames(); i += 10) {
      forwardKinematics(clip, i, a);
      forwardKinematics(other, i, b);
      const JointRoles& other_roles = target.motion.roles;
      EXPECT_NEAR(wrapAngle(pelvisHeading(b, other_roles) - pelvisHeading(a, roles)), 0.0,
                  12.0 * kDegree)
          << path;
      for (const Side side : {kLeft, kRight}) {
        const Eigen::Vector3d there = a[roles.legs[side].foot].p_WJ - a[roles.hips].p_WJ;
        const Eigen::Vector3d here = b[other_roles.legs[side].foot].p_WJ - b[other_roles.hips].p_WJ;
        EXPECT_LT((here - ratio * there).norm(), 0.12) << path << " " << i;
      }
      EXPECT_GT(b[other_roles.head].p_WJ.z(), b[other_roles.hips].p_WJ.z() + 0.4) << path;
    }
  }
}

TEST(CarryOver, KneesBendAboutAnAxisAcrossTheBody) {
  const Rig rig;
  const auto axes = kneeAxes(rig.roles, referenceOf(walkOf(rig), rig.roles));
  const Eigen::Quaterniond q = restToHeading(rig.skeleton, rig.roles);
  for (const Eigen::Vector3d& axis : axes) {
    EXPECT_LT((q * axis - Eigen::Vector3d::UnitY()).norm(), 1e-9);
  }
}

}  // namespace
}  // namespace amble

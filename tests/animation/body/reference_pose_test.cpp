#include "animation/body/reference_pose.h"

#include <gtest/gtest.h>

#include "animation/preparation/motion_library_add.h"
#include "base/rotation.h"
#include "tests/animation/level_walk.h"
#include "tests/animation/moved_clip.h"
#include "tests/animation/other_axes.h"
#include "tests/animation/random_clip.h"
#include "tests/animation/taller_clip.h"

namespace amble {
namespace {

double farthestTurn(const ReferencePose& a, const ReferencePose& b) {
  double most = 0.0;
  for (size_t j = 0; j < a.q_HJ.size(); ++j)
    most = std::max(most, a.q_HJ[j].angularDistance(b.q_HJ[j]));
  return most;
}

class ReferencePoses : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    AMBLE_NEEDS_CAPTURES();
    walk = std::make_unique<LevelWalk>(
        readForLibrary(sharedFolder() / "mocap" / GetParam(), {}).motion);
  }
  std::unique_ptr<LevelWalk> walk;
};

// Whoever stands in it stands: legs below the hips, the head over them, left on the left.
TEST_P(ReferencePoses, AreUprightAndFaceAhead) {
  const ReferencePose pose = referenceOf(walk->clip, walk->roles);
  const std::vector<JointFrame> joints = posed(walk->clip.skeleton, pose.q_HJ);
  const double leg = legOf(walk->clip.skeleton, walk->roles);
  for (const LegJoints& l : walk->roles.legs) {
    EXPECT_GT(joints[l.up_leg].p_WJ.z() - joints[l.foot].p_WJ.z(), 0.85 * leg);
    EXPECT_GT(joints[l.toe].p_WJ.x(), joints[l.foot].p_WJ.x());
  }
  EXPECT_GT(joints[walk->roles.head].p_WJ.z(), joints[walk->roles.hips].p_WJ.z() + 0.3 * leg);
  EXPECT_GT(joints[walk->roles.legs[kLeft].up_leg].p_WJ.y(),
            joints[walk->roles.legs[kRight].up_leg].p_WJ.y());
}

TEST_P(ReferencePoses, DoNotKnowWhereTheClipWasTaken) {
  const Clip there = moved(walk->clip, aboutZ(2.9), {12.0, 3.0, 0.0});
  EXPECT_LT(farthestTurn(referenceOf(walk->clip, walk->roles), referenceOf(there, walk->roles)),
            1e-6);
  EXPECT_LT(farthestTurn(meanPose(walk->clip, walk->roles), meanPose(there, walk->roles)), 1e-6);
}

TEST_P(ReferencePoses, DoNotKnowHowTallThePersonIs) {
  const Clip tall = taller(walk->clip, 1.3);
  EXPECT_LT(farthestTurn(meanPose(walk->clip, walk->roles), meanPose(tall, walk->roles)), 1e-6);
  EXPECT_NEAR(legOf(tall.skeleton, walk->roles), 1.3 * legOf(walk->clip.skeleton, walk->roles),
              1e-12);
}

// How a rig's joints lie in their bones is nothing to where they are.
TEST_P(ReferencePoses, OfTheMeanArePosesOfTheJointsNotOfTheirAxes) {
  Generator generator(7);
  std::vector<Eigen::Quaterniond> q_JK;
  for (int j = 0; j < walk->clip.skeleton.size(); ++j) q_JK.push_back(randomRotation(generator));
  const Clip other = otherAxes(walk->clip, q_JK);
  const auto a = jointFrames(walk->clip, 5), b = jointFrames(other, 5);
  for (size_t j = 0; j < a.size(); ++j) ASSERT_LT((a[j].p_WJ - b[j].p_WJ).norm(), 1e-9);
  const ReferencePose here = meanPose(walk->clip, walk->roles),
                      there = meanPose(other, walk->roles);
  for (size_t j = 0; j < here.q_HJ.size(); ++j)
    EXPECT_LT(there.q_HJ[j].angularDistance(here.q_HJ[j] * q_JK[j]), 1e-6) << j;
}

// Knees bend backwards about the thigh's left: shanks turned about the axes go behind.
TEST_P(ReferencePoses, HaveKneesThatBendAboutTheirAxes) {
  const ReferencePose pose = referenceOf(walk->clip, walk->roles);
  const auto axes = kneeAxes(walk->roles, pose);
  for (const Side side : {kLeft, kRight}) {
    EXPECT_NEAR(axes[side].norm(), 1.0, 1e-9);
    const LegJoints& leg = walk->roles.legs[side];
    ReferencePose bent = pose;
    const Eigen::Vector3d axis_H = pose.q_HJ[leg.up_leg] * axes[side];
    const Eigen::Quaterniond bend(Eigen::AngleAxisd(0.5, axis_H));
    for (const int j : {leg.leg, leg.foot, leg.toe}) bent.q_HJ[j] = bend * pose.q_HJ[j];
    const auto a = posed(walk->clip.skeleton, pose.q_HJ), b = posed(walk->clip.skeleton, bent.q_HJ);
    EXPECT_LT(b[leg.foot].p_WJ.x(), a[leg.foot].p_WJ.x() - 0.05);
    EXPECT_GT(b[leg.foot].p_WJ.z(), a[leg.foot].p_WJ.z());
  }
}

TEST_P(ReferencePoses, KeepBonesAsLongAsTheyAre) {
  const Skeleton& skeleton = walk->clip.skeleton;
  const auto joints = posed(skeleton, referenceOf(walk->clip, walk->roles).q_HJ);
  EXPECT_EQ(joints[0].p_WJ.norm(), 0.0);
  for (int j = 1; j < skeleton.size(); ++j) {
    const double bone = (joints[j].p_WJ - joints[skeleton.joint(j).parent].p_WJ).norm();
    EXPECT_NEAR(bone, skeleton.joint(j).offset.norm(), 1e-9);
  }
}

INSTANTIATE_TEST_SUITE_P(, ReferencePoses,
                         testing::Values("accad_female1/Female1_B03_Walk1.bvh",
                                         "accad_male1/Male1_B3_Walk.bvh", "cmu_mb2/07_01.bvh",
                                         "cmu_asfamc/07_05-walk.amc", "cmu_daz/07_01.bvh",
                                         "cmu_style_loops/142_08_EDIT_LOOP.bvh"));

}  // namespace
}  // namespace amble

#include "animation/body/foot_shape.h"

#include <gtest/gtest.h>

#include "base/rotation.h"
#include "tests/animation/random_clip.h"
#include "tests/animation/rig.h"

namespace amble {
namespace {

TEST(FootShape, StatureComesFromLegLength) {
  const Rig rig;
  EXPECT_NEAR(statureOf(rig.skeleton, rig.roles), (Rig::kThigh + Rig::kShank) / kLegOfStature,
              1e-12);
  EXPECT_NEAR(statureOf(rig.skeleton.scaled(1.3), rig.roles),
              1.3 * statureOf(rig.skeleton, rig.roles), 1e-12);
}

TEST(FootShape, TheSoleIsAsLongAsFeetAreWithItsOriginInTheMiddle) {
  const Rig rig;
  for (const FootShape& foot : rig.feet) {
    const double heel = foot.heel_x - foot.radius, tip = foot.tip_x + foot.radius;
    EXPECT_NEAR(tip - heel, kFootLengthOfStature * statureOf(rig.skeleton, rig.roles), 1e-12);
    EXPECT_NEAR(tip + heel, 0.0, 1e-12);
    EXPECT_NEAR(foot.ball_x - foot.ankle_x, Puppet::kFoot, 1e-12);
    EXPECT_NEAR(foot.ankle_height, Puppet::kAnkle, 1e-12);
    EXPECT_LT(foot.heel_x, foot.ankle_x);
    EXPECT_LT(foot.ball_x, foot.tip_x);
  }
}

TEST(FootShape, LengthsGrowWithTheSkeletonAndRotationsDoNot) {
  const Rig rig;
  const double stature = statureOf(rig.skeleton, rig.roles);
  const FootShape one = rig.feet[kLeft];
  const FootShape two = makeFootShape(rig.skeleton.scaled(0.8), rig.roles, kLeft, 0.8 * stature);
  EXPECT_NEAR(two.radius, 0.8 * one.radius, 1e-12);
  EXPECT_NEAR(two.ankle_height, 0.8 * one.ankle_height, 1e-12);
  EXPECT_NEAR(two.heel_x, 0.8 * one.heel_x, 1e-12);
  EXPECT_NEAR(two.tip_x, 0.8 * one.tip_x, 1e-12);
  EXPECT_LT(two.q_SF.angularDistance(one.q_SF), 1e-7);
}

TEST(FootShape, TheRestPoseFacesWhereItsFeetPoint) {
  const Rig rig;  // y up, facing +z: its left is +x
  const Eigen::Quaterniond q = restToHeading(rig.skeleton, rig.roles);
  EXPECT_LT((q * Eigen::Vector3d::UnitY() - Eigen::Vector3d::UnitZ()).norm(), 1e-12);
  EXPECT_LT((q * Eigen::Vector3d::UnitZ() - Eigen::Vector3d::UnitX()).norm(), 1e-12);
  EXPECT_LT((q * Eigen::Vector3d::UnitX() - Eigen::Vector3d::UnitY()).norm(), 1e-12);
}

TEST(FootShape, TheFlatFootsFrameIsTheRestPoses) {
  const Rig rig;
  for (const FootShape& foot : rig.feet) {
    EXPECT_LT(foot.q_SF.angularDistance(restToHeading(rig.skeleton, rig.roles)), 1e-7);
    EXPECT_LT((foot.lateral_T - Eigen::Vector3d::UnitX()).norm(), 1e-12);
  }
}

TEST(RolledAnkle, KeepsItsDistanceFromTheEndThatItRollsAbout) {
  const Rig rig;
  const FootShape& foot = rig.feet[kLeft];
  const Eigen::Vector3d flat(foot.ankle_x, 0, foot.ankle_height);
  for (double pitch = -1.0; pitch <= 1.0; pitch += 0.01) {
    const Eigen::Vector3d end(pitch < 0.0 ? foot.heel_x : foot.ball_x, 0, foot.radius);
    const Eigen::Vector3d ankle = rolledAnkle(foot, pitch);
    EXPECT_NEAR((ankle - end).norm(), (flat - end).norm(), 1e-12);
    const Eigen::Vector3d turned =
        end + Eigen::AngleAxisd(pitch, Eigen::Vector3d::UnitY()) * (flat - end);
    EXPECT_LT((ankle - turned).norm(), 1e-12);
  }
}

TEST(RolledAnkle, IsContinuousThroughTheFlatFoot) {
  const Rig rig;
  const FootShape& foot = rig.feet[kRight];
  const Eigen::Vector3d flat(foot.ankle_x, 0, foot.ankle_height);
  EXPECT_LT((rolledAnkle(foot, 0.0) - flat).norm(), 1e-15);
  EXPECT_LT((rolledAnkle(foot, -1e-9) - flat).norm(), 1e-8);
  EXPECT_LT((rolledAnkle(foot, 1e-9) - flat).norm(), 1e-8);
}

TEST(FootShape, AToeWithoutATipHasOne) {
  const Rig rig;
  std::vector<Joint> joints = Rig::joints();
  for (Joint& joint : joints) joint.end_sites.clear();
  const FootShape foot = makeFootShape(Skeleton(joints), rig.roles, kLeft, 1.8);
  EXPECT_GT(foot.tip_x, foot.ball_x);
}

}  // namespace
}  // namespace amble

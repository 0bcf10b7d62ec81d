#include "animation/body/foot_shape.h"

#include <gtest/gtest.h>

#include "animation/body/rest_feet.h"
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

// However differently its feet drop: both ankles are as high over the sole, a toe joint is where
// the foot has it below them, none in the floor, and the flat foot is the rest pose's.
TEST(FootShape, EachFootHasASoleOfItsOwnUnderAnklesThatAreAsHigh) {
  const Rig rig;
  const double stature = statureOf(rig.skeleton, rig.roles);
  for (const double left : {-10.0, 8.0, 20.0, 45.0}) {
    for (const double right : {8.0, 20.0, 33.0}) {
      const std::array<double, 2> drops = {left * kDegree, right * kDegree};
      const Skeleton skeleton = withFootDrops(rig.skeleton, rig.roles, drops);
      const std::array<FootShape, 2> feet = makeFootShapes(skeleton, rig.roles, stature);
      EXPECT_EQ(feet[kLeft].ankle_height, feet[kRight].ankle_height);
      const double mean = 0.5 * (feet[kLeft].radius + feet[kRight].radius) / stature;
      EXPECT_GE(mean, kBallHeightOfStature - 1e-12);
      for (const Side side : {kLeft, kRight}) {
        const FootShape& foot = feet[side];
        const double length = skeleton.joint(rig.roles.legs[side].toe).offset.norm();
        EXPECT_NEAR(foot.ankle_height - foot.radius, length * std::sin(drops[side]), 1e-12);
        EXPECT_NEAR(foot.ball_x - foot.ankle_x, length * std::cos(drops[side]), 1e-12);
        EXPECT_GE(foot.radius, kLowestBallOfStature * stature - 1e-12);
        EXPECT_LT(foot.q_SF.angularDistance(rig.feet[side].q_SF), 1e-7);
        if (foot.radius > (kLowestBallOfStature + 1e-6) * stature &&
            feet[other(side)].radius > (kLowestBallOfStature + 1e-6) * stature) {
          EXPECT_NEAR(mean, kBallHeightOfStature, 1e-12);  // ankles are no higher than they need be
        }
      }
    }
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
  EXPECT_EQ(rolledBall(foot, 0.0), Eigen::Vector3d::Zero());
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

TEST(FootShape, AFlatFootStandsOnBothEndsWhereverItIsAndHowsoeverItHeads) {
  const Rig rig;
  Generator generator(431);
  for (int i = 0; i < 100; ++i) {
    for (const FootShape& foot : rig.feet) {
      const Eigen::Quaterniond q_WS = aboutZ(uniform(generator, -3.0, 3.0));
      const Eigen::Vector3d at(uniform(generator, -5, 5), uniform(generator, -5, 5), 0.0);
      const Eigen::Vector3d ankle = at + q_WS * Eigen::Vector3d(foot.ankle_x, 0, foot.ankle_height);
      const SoleEnds ends = soleEnds(foot, ankle, q_WS * foot.q_SF);
      EXPECT_NEAR(ends.heel.z(), 0.0, 1e-12);
      EXPECT_NEAR(ends.ball.z(), 0.0, 1e-12);
      EXPECT_LT((ends.heel - at - q_WS * Eigen::Vector3d(foot.heel_x, 0, 0)).norm(), 1e-12);
      EXPECT_LT((ends.ball - at - q_WS * Eigen::Vector3d(foot.ball_x, 0, 0)).norm(), 1e-12);
    }
  }
}

// What is rolled about stays on the ground, the other end leaves it.
TEST(FootShape, ARolledFootStandsOnTheEndThatItRollsAbout) {
  const Rig rig;
  const FootShape& foot = rig.feet[kLeft];
  for (double pitch = -1.0; pitch <= 1.0; pitch += 0.05) {
    const Eigen::Quaterniond roll(Eigen::AngleAxisd(pitch, Eigen::Vector3d::UnitY()));
    const SoleEnds ends = soleEnds(foot, rolledAnkle(foot, pitch), roll * foot.q_SF);
    const Eigen::Vector3d& on = pitch < 0.0 ? ends.heel : ends.ball;
    const Eigen::Vector3d& off = pitch < 0.0 ? ends.ball : ends.heel;
    EXPECT_NEAR(on.z(), 0.0, 1e-12) << pitch;
    EXPECT_NEAR(on.x(), pitch < 0.0 ? foot.heel_x : foot.ball_x, 1e-12) << pitch;
    EXPECT_NEAR(off.z(), (foot.ball_x - foot.heel_x) * std::sin(std::abs(pitch)), 1e-12) << pitch;
  }
}

TEST(SoleFrame, ItsZIsTheNormalAndItsXHeadsAsSaid) {
  Generator generator(432);
  for (int i = 0; i < 200; ++i) {
    const double heading = uniform(generator, -3.1, 3.1);
    const Eigen::Vector3d normal(uniform(generator, -0.5, 0.5), uniform(generator, -0.5, 0.5),
                                 uniform(generator, 0.5, 2.0));
    const Eigen::Quaterniond q = soleFrame(heading, normal);
    EXPECT_LT((q * Eigen::Vector3d::UnitZ() - normal.normalized()).norm(), 1e-12);
    const Eigen::Quaterniond tilt = q * aboutZ(-heading);
    EXPECT_NEAR(logRotation(tilt).z(), 0.0, 1e-9);  // on the shortest way: no turn about z
    EXPECT_LT(soleFrame(heading, 7.0 * normal).angularDistance(q), 1e-7);
  }
  EXPECT_EQ(soleFrame(0.3, {0, 0, 2}).coeffs(), aboutZ(0.3).coeffs());
}

TEST(FootShape, ARigTurnedAtRestByQuartersHasTheSameFeet) {
  const Rig rig;
  const double stature = statureOf(rig.skeleton, rig.roles);
  for (int quarter = 0; quarter < 4; ++quarter) {
    for (const Eigen::Vector3d axis : {Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitZ()}) {
      const Eigen::Quaterniond turn(Eigen::AngleAxisd(0.5 * kPi * quarter, axis));
      std::vector<Joint> joints = Rig::joints();
      for (Joint& joint : joints) {
        joint.offset = turn * joint.offset;
        for (Eigen::Vector3d& tip : joint.end_sites) tip = turn * tip;
      }
      const Skeleton turned(joints);
      const FootShape foot = makeFootShape(turned, rig.roles, kLeft, stature);
      const FootShape& same = rig.feet[kLeft];
      EXPECT_NEAR(foot.ankle_height, same.ankle_height, 1e-12);
      EXPECT_NEAR(foot.ankle_x, same.ankle_x, 1e-12);
      EXPECT_NEAR(foot.heel_x, same.heel_x, 1e-12);
      EXPECT_NEAR(foot.tip_x, same.tip_x, 1e-12);
      EXPECT_LT((foot.q_SF * turn).angularDistance(same.q_SF), 1e-7);
      const Eigen::Quaterniond rest = restToHeading(turned, rig.roles);
      EXPECT_LT((rest * turn).angularDistance(restToHeading(rig.skeleton, rig.roles)), 1e-7);
      EXPECT_LT(restToPelvisHeading(turned, rig.roles).angularDistance(rest), 1e-7);
    }
  }
}

TEST(FootShape, FeetThatToeOutTurnTheHeadingOfTheFeetAndNotOfThePelvis) {
  const Rig rig;
  std::vector<Joint> joints = Rig::joints();
  const Eigen::Quaterniond out(Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitY()));
  for (const LegJoints& leg : rig.roles.legs) joints[leg.toe].offset = out * joints[leg.toe].offset;
  const Skeleton toed(joints);
  EXPECT_LT(restToPelvisHeading(toed, rig.roles)
                .angularDistance(restToPelvisHeading(rig.skeleton, rig.roles)),
            1e-7);
  EXPECT_NEAR(
      restToHeading(toed, rig.roles).angularDistance(restToHeading(rig.skeleton, rig.roles)), 0.3,
      1e-7);
}

}  // namespace
}  // namespace amble

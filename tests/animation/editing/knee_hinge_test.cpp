#include "animation/editing/knee_hinge.h"

#include <gtest/gtest.h>

#include "base/rotation.h"
#include "tests/animation/rig.h"

namespace amble {
namespace {

const Eigen::Vector3d kHip(0.1, 0.2, 0.9);

/// Walks along x: its left is y. Thigh 0.45, shank 0.4, the knee bent so far.
CapturedLeg leg(double flexion, double sideways = 0.0) {
  CapturedLeg leg;
  leg.hip = kHip;
  leg.hinge = Eigen::Vector3d::UnitY();
  const Eigen::Vector3d down(0.0, 0.0, -1.0);
  leg.knee = leg.hip + 0.45 * (expRotation({0.0, -0.3, 0.0}) * down);
  leg.ankle = leg.knee + 0.4 * (expRotation({sideways, 0.0, 0.0}) *
                                (expRotation({0.0, flexion - 0.3, 0.0}) * down));
  return leg;
}

/// The leg after a change, its hip there.
CapturedLeg changed(const CapturedLeg& leg, const LegChange& change, const Eigen::Vector3d& hip) {
  CapturedLeg after;
  after.hip = hip;
  after.knee = hip + change.thigh * (leg.knee - leg.hip);
  after.ankle = after.knee + change.shank * (leg.ankle - leg.knee);
  after.hinge = change.thigh * leg.hinge;
  return after;
}

double flexionOf(const CapturedLeg& leg) {
  const Eigen::Vector3d thigh = leg.knee - leg.hip, shank = leg.ankle - leg.knee;
  return std::atan2(thigh.cross(shank).dot(leg.hinge), thigh.dot(shank));
}

TEST(KneeHinge, ALegWhoseAnkleStaysIsGivenBackHoweverStraightOrBentBack) {
  for (const double flexion : {-0.1, -1e-3, 0.0, 1e-4, 0.02, 0.5, 1.5}) {
    for (const double sideways : {0.0, 0.1}) {
      const CapturedLeg before = leg(flexion, sideways);
      const LegChange change = changeLeg(before, before.hip, before.ankle);
      const auto identity = Eigen::Quaterniond::Identity();
      EXPECT_LT(change.thigh.angularDistance(identity), 1e-6) << flexion;
      EXPECT_LT(change.shank.angularDistance(identity), 1e-6) << flexion;
    }
  }
}

TEST(KneeHinge, TheAnkleGetsWhereItShallBe) {
  for (const double flexion : {0.0, 0.02, 0.5, 1.5}) {
    const CapturedLeg before = leg(flexion, 0.05);
    for (const Eigen::Vector3d& move :
         {Eigen::Vector3d(0.05, 0.0, 0.05), {-0.1, 0.05, 0.1}, {0.0, 0.0, 0.2}}) {
      const Eigen::Vector3d hip = before.hip + Eigen::Vector3d(0.0, 0.0, -0.06);
      const Eigen::Vector3d ankle = before.ankle + move;
      const LegChange change = changeLeg(before, hip, ankle);
      const CapturedLeg after = changed(before, change, hip);
      EXPECT_LT((after.ankle - ankle).norm(), 1e-9) << flexion;
      EXPECT_LT(change.miss, 1e-9);
      EXPECT_GT(flexionOf(after), 0.0);
    }
  }
}

TEST(KneeHinge, AKneeThatWasBentBackComesForwardWithoutAJump) {
  const CapturedLeg before = leg(-0.1);
  double last = flexionOf(before);
  for (double shorter = 0.0; shorter < 0.03; shorter += 1e-4) {
    const Eigen::Vector3d way = before.ankle - before.hip;
    const Eigen::Vector3d ankle = before.hip + (1.0 - shorter / way.norm()) * way;
    const double flexion =
        flexionOf(changed(before, changeLeg(before, before.hip, ankle), before.hip));
    EXPECT_GE(flexion, last - 1e-9);
    EXPECT_LT(flexion - last, 0.02) << shorter;
    last = flexion;
  }
  EXPECT_GT(last, 0.3);
}

TEST(KneeHinge, ALegThatIsShortenedAsItsKneePassesStraightDoesNotSnap) {
  for (const double shorter : {0.0005, 0.002, 0.006}) {
    double last = 0.0;
    for (double captured = -0.12; captured < 0.06; captured += 1e-4) {
      const CapturedLeg before = leg(captured);
      const Eigen::Vector3d way = before.ankle - before.hip;
      const Eigen::Vector3d ankle = before.hip + (1.0 - shorter / way.norm()) * way;
      const double flexion =
          flexionOf(changed(before, changeLeg(before, before.hip, ankle), before.hip));
      if (captured > -0.12) {
        EXPECT_LT(std::abs(flexion - last), 0.002) << captured;
      }
      last = flexion;
    }
  }
}

TEST(KneeHinge, ALegThatIsTooShortSaysByHowMuch) {
  const CapturedLeg before = leg(0.3);
  const Eigen::Vector3d ankle = before.hip + Eigen::Vector3d(0.0, 0.0, -0.95);
  const LegChange change = changeLeg(before, before.hip, ankle);
  EXPECT_NEAR(change.miss, 0.1, 1e-9);
  const CapturedLeg after = changed(before, change, before.hip);
  EXPECT_NEAR(after.reach(), 0.85, 1e-9);
}

TEST(KneeHinge, TheHingeOfAWalkerIsItsThighsLeft) {
  const Rig rig;
  const Clip clip = rig.walk(Puppet{});
  for (const Eigen::Vector3d& hinge : kneeHinges(clip, rig.roles)) {
    EXPECT_GT(hinge.x(), 0.99);  // the rest pose faces z: its left is x
  }
}

}  // namespace
}  // namespace amble

#include "animation/steps/stride_law.h"

#include <gtest/gtest.h>

#include <cmath>

#include "animation/body/joint_roles.h"

namespace amble {
namespace {

TEST(StrideLaw, PassesThroughTheCapturedWalk) {
  const StrideLaw law(1.1, 0.62);
  EXPECT_NEAR(law.stepLength(1.1), 0.62, 1e-15);
  EXPECT_NEAR(law.speed(0.62), 1.1, 1e-15);
  EXPECT_EQ(law.capturedStep(), 0.62);
}

TEST(StrideLaw, SpeedIsTheInverseOfStepLength) {
  const StrideLaw law(1.1, 0.62);
  for (double v = 0.05; v < 2.5; v += 0.05) EXPECT_NEAR(law.speed(law.stepLength(v)), v, 1e-12);
}

TEST(StrideLaw, StepLengthAndCadenceBothGrowWithSpeed) {
  const StrideLaw law(1.1, 0.62);
  for (double v = 0.1; v < 2.5; v += 0.01) {
    EXPECT_GT(law.stepLength(v + 0.01), law.stepLength(v));
    EXPECT_GE((v + 0.01) / law.stepLength(v + 0.01), v / law.stepLength(v) - 1e-12);
  }
}

TEST(StrideLaw, StepLengthGoesWithThePowerOfSpeed) {
  const StrideLaw law(1.0, 0.6);
  EXPECT_NEAR(std::log(law.stepLength(1.6) / law.stepLength(0.8)) / std::log(2.0),
              StrideLaw::kStepPower, 1e-12);
}

TEST(StrideLaw, StepsInTurnsAreTheCapturedOnesAndOnTheStraightItsOwn) {
  StrideLaw law(1.1, 0.62);
  EXPECT_EQ(law.turnedShare(1.0), 1.0);
  law.addTurn(0, {0.5, 0.95, {}});
  law.addTurn(0, {1.0, 0.9, {}});
  law.addTurn(1, {0.8, 3.0, {}});
  EXPECT_EQ(law.turnedShare(0.0), 1.0);
  EXPECT_NEAR(law.turnedShare(0.5), 0.95, 1e-12);
  EXPECT_NEAR(law.turnedShare(1.0), 0.9, 1e-12);
  EXPECT_NEAR(law.turnedShare(2.0), 0.9, 1e-12);  // the fastest is held
  EXPECT_NEAR(law.turnedShare(-0.8), StrideLaw::kMostTurned, 1e-12);
  for (double rate = -2.0; rate < 2.0; rate += 0.001)  // without a jump
    EXPECT_LT(std::abs(law.turnedShare(rate + 0.001) - law.turnedShare(rate)), 0.001);
}

TEST(StrideLaw, CadenceIsNeverSlowerThanItsLeast) {
  const StrideLaw law(1.1, 0.62);
  const double captured = 1.1 / 0.62;
  for (double v = 0.05; v < 2.5; v += 0.01) {
    EXPECT_GE(v / law.stepLength(v), StrideLaw::kSlowestCadence * captured * (1.0 - 1e-12));
  }
  EXPECT_NEAR(0.1 / law.stepLength(0.1), StrideLaw::kSlowestCadence * captured, 1e-12);
}

TEST(StrideLaw, IsContinuousWhereSlowWalkingBegins) {
  const StrideLaw law(1.1, 0.62);
  double before = law.stepLength(0.2);
  for (double v = 0.2; v < 1.2; v += 1e-4) {
    EXPECT_LT(std::abs(law.stepLength(v) - before), 2e-4);  // at most 0.62 / 1.1 / 0.7 m per m/s
    before = law.stepLength(v);
  }
}

TEST(DoubleSupportNorm, IsTheClasssInTheMiddleOfItsRange) {
  const double leg = 0.85, unit = std::sqrt(9.81 * leg);
  EXPECT_NEAR(doubleSupportNorm(0.432 * unit, leg), 0.19, 1e-9);
  EXPECT_NEAR(doubleSupportNorm(0.5 * (0.432 + 0.568) * unit, leg), 0.175, 1e-9);
}

TEST(DoubleSupportNorm, NeverGrowsWithSpeed) {
  for (double speed = 0.0; speed < 3.0; speed += 0.05) {
    EXPECT_GE(doubleSupportNorm(speed, 0.8), doubleSupportNorm(speed + 0.05, 0.8));
  }
  EXPECT_EQ(doubleSupportNorm(0.0, 0.8), 0.36);
  EXPECT_EQ(doubleSupportNorm(9.0, 0.8), 0.14);
}

TEST(DoubleSupportNorm, IsThatOfAnyLegLengthAtTheSameFroudeNumber) {
  for (double v = 0.3; v < 2.0; v += 0.1) {
    EXPECT_NEAR(doubleSupportNorm(v, 0.8), doubleSupportNorm(v * std::sqrt(1.5), 1.2), 1e-12);
  }
}

/// Somebody with so much double support [share of the cycle], a third of it with the left foot in
/// front, a quarter of each before its node.
StrideLaw::Support limping(double speed, double share) {
  StrideLaw::Support support{speed, {}};
  support.steps << share / 6.0, share / 2.0, share / 3.0, share;
  return support;
}

/// A subject who is off the norm by two shares at two speeds.
StrideLaw supported() {
  StrideLaw law(1.1, 0.62);
  law.setSupports({limping(1.0, doubleSupportNorm(1.0, 0.8) + 0.02),
                   limping(1.6, doubleSupportNorm(1.6, 0.8) - 0.01)},
                  0.8);
  return law;
}

/// Share of time with both feet planted, straight on.
double doubleSupport(const StrideLaw& law, double speed) {
  return 0.5 * law.supports(speed, 0.0).sum();
}

TEST(DoubleSupport, IsTheCapturedOneAtTheCapturedSpeeds) {
  const StrideLaw law = supported();
  EXPECT_NEAR(doubleSupport(law, 1.0), doubleSupportNorm(1.0, 0.8) + 0.02, 1e-12);
  EXPECT_NEAR(doubleSupport(law, 1.6), doubleSupportNorm(1.6, 0.8) - 0.01, 1e-12);
  EXPECT_EQ(doubleSupport(StrideLaw(1.1, 0.62), 1.3), doubleSupportNorm(1.3, 0.8));
}

TEST(DoubleSupport, IsContinuousAndNeverFarFromTheNorm) {
  StrideLaw law = supported();
  double before = doubleSupport(law, 0.01);
  for (double v = 0.01; v < 3.0; v += 0.001) {
    const double share = doubleSupport(law, v);
    EXPECT_LT(std::abs(before - share), 0.001);
    EXPECT_LE(std::abs(share - doubleSupportNorm(v, 0.8)), StrideLaw::kSupportOff + 1e-12);
    before = share;
  }
  law.setSupports({limping(1.2, 0.9)}, 0.8);  // a detector that is wrong
  EXPECT_NEAR(doubleSupport(law, 1.2), doubleSupportNorm(1.2, 0.8) + StrideLaw::kSupportOff, 1e-12);
}

TEST(DoubleSupport, OfATurnIsTheCapturedOneAtItsRateAndOnTheOtherSideThatOfAStraightWalk) {
  StrideLaw law = supported();
  const double share = doubleSupportNorm(1.2, 0.8);
  DoubleSupports captured;
  captured << 0.6 * share, 0.5 * share, 0.4 * share, 0.5 * share;
  law.addTurn(0, {0.6, 1.0, {1.2, captured}});
  EXPECT_LT((law.supports(1.2, 0.6) - captured).abs().maxCoeff(), 1e-12);
  EXPECT_TRUE((law.supports(1.2, -0.6) == law.supports(1.2, 0.0)).all());
  DoubleSupports before = law.supports(1.2, 0.0);
  for (double rate = 0.0; rate < 0.8; rate += 0.001) {
    const DoubleSupports now = law.supports(1.2, rate);
    EXPECT_LT((now - before).abs().maxCoeff(), 0.002) << rate;
    before = now;
  }
}

TEST(DoubleSupport, IsSharedOutBetweenTheFeetAsCapturedAtAnySpeed) {
  const StrideLaw law = supported();
  for (double v = 0.05; v < 3.0; v += 0.05) {
    const DoubleSupports steps = law.supports(v, 0.0);
    EXPECT_GT(steps.minCoeff(), 0.0) << v;
    EXPECT_NEAR(steps.row(1).sum(), 2.0 * steps.row(0).sum(), 0.2 * steps.sum()) << v;
  }
  const DoubleSupports unknown = StrideLaw(1.1, 0.62).supports(1.2, 0.0);
  EXPECT_EQ(unknown.minCoeff(), unknown.maxCoeff());
}

}  // namespace
}  // namespace amble

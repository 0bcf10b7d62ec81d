#include "animation/steps/stride_law.h"

#include <gtest/gtest.h>

#include <cmath>

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

TEST(DoubleSupport, FallsWithSpeedAndIsContinuous) {
  double before = doubleSupport(0.01, 0.8);
  EXPECT_NEAR(before, 0.36, 1e-12);  // Schwartz et al., very slow
  for (double v = 0.01; v < 3.0; v += 0.001) {
    const double share = doubleSupport(v, 0.8);
    EXPECT_LE(share, before);
    EXPECT_LT(before - share, 0.001);
    before = share;
  }
  EXPECT_NEAR(before, 0.14, 1e-12);  // very fast
}

TEST(DoubleSupport, IsThatOfAnyLegLengthAtTheSameFroudeNumber) {
  for (double v = 0.3; v < 2.0; v += 0.1) {
    EXPECT_NEAR(doubleSupport(v, 0.8), doubleSupport(v * std::sqrt(1.5), 1.2), 1e-12);
  }
}

}  // namespace
}  // namespace amble

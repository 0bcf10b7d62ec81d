#include "animation/library/transition.h"

#include <gtest/gtest.h>

#include <cmath>

namespace amble {
namespace {

TEST(SplineWeights, SumToOneAndHoldAtTheEnds) {
  for (double x = -0.5; x <= 1.5; x += 0.01) {
    const SplineWeights w = splineWeights(7, x);
    EXPECT_NEAR(w.weight[0] + w.weight[1] + w.weight[2] + w.weight[3], 1.0, 1e-14);
    EXPECT_GE(w.first, 0);
    EXPECT_LE(w.first + 3, 9);
  }
}

TEST(SplineWeights, ALineOfCoefficientsIsALine) {
  constexpr int kPieces = 5;
  for (double x = 0.0; x <= 1.0; x += 0.03) {
    const SplineWeights w = splineWeights(kPieces, x);
    double value = 0.0;
    for (int k = 0; k < 4; ++k) value += w.weight[k] * (w.first + k - 1);
    EXPECT_NEAR(value, kPieces * x, 1e-12);
  }
}

TEST(Transition, ThePathsPointGainsTheSpeedOfTheWalkFromRest) {
  constexpr double kStep = 1e-6;
  const auto slope = [](double clock) {
    return (transitionAdvance(clock + kStep) - transitionAdvance(clock - kStep)) / (2.0 * kStep);
  };
  EXPECT_EQ(transitionAdvance(-1.0), 0.0);
  EXPECT_EQ(transitionAdvance(2.0), 1.0);
  EXPECT_NEAR(slope(kStep), 0.0, 1e-9);
  for (double clock = 0.05; clock < 1.0; clock += 0.05) {
    const double eased = clock * clock * (3.0 - 2.0 * clock);
    EXPECT_NEAR(slope(clock), 2.0 * eased, 1e-6);  // of the speed at 1, twice the mean
  }
}

}  // namespace
}  // namespace amble

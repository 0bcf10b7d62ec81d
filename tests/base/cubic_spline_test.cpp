#include "base/cubic_spline.h"

#include <gtest/gtest.h>

#include <random>

namespace amble {
namespace {

TEST(CubicSpline, ACubicComesBack) {
  const auto f = [](double x) { return 2.0 - x + 0.5 * x * x - 0.3 * x * x * x; };
  const auto slope = [](double x) { return -1.0 + x - 0.9 * x * x; };
  const std::vector<double> x = {-1.0, -0.3, 0.4, 1.7, 2.0};
  std::vector<double> y;
  for (const double at : x) y.push_back(f(at));
  const CubicSpline spline(x, y, slope(x.front()), slope(x.back()));
  for (double at = -1.0; at <= 2.0; at += 0.05) {
    EXPECT_NEAR(spline.at(at), f(at), 1e-12);
    EXPECT_NEAR(spline.slope(at), slope(at), 1e-12);
  }
}

TEST(CubicSpline, PassesItsPointsWithContinuousAccelerations) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> step(0.2, 1.0), height(-1.0, 1.0);
  std::vector<double> x = {0.0}, y = {0.3};
  for (int i = 0; i < 12; ++i) x.push_back(x.back() + step(random)), y.push_back(height(random));
  const CubicSpline spline(x, y, 0.7, -0.2);
  EXPECT_NEAR(spline.slope(x.front()), 0.7, 1e-12);
  EXPECT_NEAR(spline.slope(x.back()), -0.2, 1e-12);
  constexpr double kStep = 1e-6;
  for (size_t i = 0; i < x.size(); ++i) {
    EXPECT_NEAR(spline.at(x[i]), y[i], 1e-12);
    if (i == 0 || i + 1 == x.size()) continue;
    const double before = (spline.slope(x[i]) - spline.slope(x[i] - kStep)) / kStep;
    const double after = (spline.slope(x[i] + kStep) - spline.slope(x[i])) / kStep;
    EXPECT_NEAR(before, after, 1e-3);
  }
}

TEST(CubicSpline, WherePointsRiseTheCurveRisesWhenAsked) {
  CubicSpline spline({0.0, 1.0, 2.0, 3.0, 4.0}, {0.0, 0.01, 1.0, 1.01, 1.01}, 0.0, 0.0);
  spline.keepRising();
  for (double x = 0.0; x < 4.0; x += 0.01) EXPECT_GE(spline.at(x + 0.01) - spline.at(x), -1e-12);
  EXPECT_NEAR(spline.at(2.0), 1.0, 1e-12);
}

TEST(CubicSpline, BeyondItsPointsItHoldsTheirEnds) {
  const CubicSpline spline({0.0, 1.0}, {2.0, 3.0}, 1.0, 1.0);
  EXPECT_EQ(spline.at(-5.0), 2.0);
  EXPECT_EQ(spline.at(9.0), 3.0);
}

}  // namespace
}  // namespace amble

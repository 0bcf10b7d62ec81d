// What every linear filter without delay obeys, and this one's own formula.

#include <gtest/gtest.h>

#include <cmath>

#include "animation/analysis/low_pass.h"
#include "base/rotation.h"
#include "tests/animation/random_clip.h"

namespace amble {
namespace {

Eigen::MatrixXd randomRows(Generator& generator, int rows, int columns) {
  Eigen::MatrixXd x(rows, columns);
  for (double& value : x.reshaped()) value = uniform(generator, -1.0, 1.0);
  return x;
}

Eigen::MatrixXd filtered(Eigen::MatrixXd x, double rate, double cutoff) {
  lowPass(x, rate, cutoff);
  return x;
}

double largestOf(const Eigen::MatrixXd& x) { return x.cwiseAbs().maxCoeff(); }

/// Share of a sine that is left in the middle of a long signal.
double leftOf(double frequency, double rate, double cutoff) {
  const int rows = static_cast<int>(24.0 * rate);
  Eigen::MatrixXd x(rows, 1);
  for (int i = 0; i < rows; ++i) x(i, 0) = std::sin(2.0 * kPi * frequency * i / rate);
  const Eigen::MatrixXd y = filtered(x, rate, cutoff);
  const Eigen::Index from = rows / 3, count = rows / 3;
  return y.middleRows(from, count).cwiseProduct(x.middleRows(from, count)).sum() /
         x.middleRows(from, count).squaredNorm();
}

TEST(LowPassLaws, ASumIsFilteredAsItsTermsAre) {
  Generator generator(301);
  for (const double rate : {30.0, 60.0, 120.0}) {
    const Eigen::MatrixXd x = randomRows(generator, 200, 3), y = randomRows(generator, 200, 3);
    const Eigen::MatrixXd whole = filtered(2.0 * x - 0.7 * y, rate, 6.0);
    EXPECT_LT(largestOf(whole - 2.0 * filtered(x, rate, 6.0) + 0.7 * filtered(y, rate, 6.0)),
              1e-12);
  }
}

TEST(LowPassLaws, ColumnsDoNotKnowOfEachOther) {
  Generator generator(302);
  const Eigen::MatrixXd x = randomRows(generator, 150, 4), y = filtered(x, 100.0, 8.0);
  for (int c = 0; c < 4; ++c) EXPECT_EQ(filtered(x.col(c), 100.0, 8.0), y.col(c)) << c;
}

TEST(LowPassLaws, TurningTheAxesBeforeOrAfterIsTheSame) {
  Generator generator(303);
  const Eigen::MatrixXd x = randomRows(generator, 150, 3);
  const Eigen::Matrix3d R = randomRotation(generator).toRotationMatrix();
  EXPECT_LT(largestOf(filtered(x * R, 100.0, 8.0) - filtered(x, 100.0, 8.0) * R), 1e-12);
}

TEST(LowPassLaws, WhatGoesEvenlyBesideGoesOnEvenly) {
  Generator generator(304);
  const Eigen::MatrixXd x = randomRows(generator, 150, 2);
  Eigen::MatrixXd line(150, 2);
  for (int i = 0; i < 150; ++i) line.row(i) << 3.0 - 0.2 * i, 100.0 + 0.01 * i;
  EXPECT_LT(largestOf(filtered(x + line, 120.0, 7.0) - line - filtered(x, 120.0, 7.0)), 1e-10);
}

// Reflected through its end points a signal is odd about them, and so is what is left of it.
TEST(LowPassLaws, EndsStayWhereTheyAre) {
  Generator generator(305);
  for (const int rows : {150, 300, 700}) {
    const Eigen::MatrixXd x = randomRows(generator, rows, 2), y = filtered(x, 120.0, 6.0);
    EXPECT_LT(largestOf(y.topRows(1) - x.topRows(1)), 1e-3) << rows;
    EXPECT_LT(largestOf(y.bottomRows(1) - x.bottomRows(1)), 1e-3) << rows;
  }
}

// Butterworth of second order through the bilinear transform, twice: 1 / (1 + (T / T_c)^4) with
// T = tan(pi f / rate), and half of the power left at the cut-off.
TEST(LowPassLaws, WhatIsLeftOfASineIsByTheFormulaAtEveryFrequency) {
  for (const double rate : {60.0, 100.0, 120.0, 240.0}) {
    for (const double cutoff : {4.0, 8.5, 12.0}) {
      const double at = std::tan(kPi * cutoff / rate) / std::pow(std::sqrt(2.0) - 1.0, 0.25);
      for (const double frequency : {0.5, 2.0, 4.0, 8.5, 15.0, 22.0}) {
        const double ratio = std::tan(kPi * frequency / rate) / at;
        EXPECT_NEAR(leftOf(frequency, rate, cutoff), 1.0 / (1.0 + std::pow(ratio, 4)), 2e-3)
            << frequency << " of " << rate << " below " << cutoff;
      }
    }
  }
}

TEST(LowPassLaws, OnlyFrequencyOverRateCounts) {
  Generator generator(306);
  const Eigen::MatrixXd x = randomRows(generator, 200, 2);
  EXPECT_LT(largestOf(filtered(x, 60.0, 6.0) - filtered(x, 240.0, 24.0)), 1e-12);
}

TEST(LowPassLaws, AHigherCutOffLeavesMore) {
  for (const double frequency : {3.0, 7.0, 14.0}) {
    double before = 0.0;
    for (double cutoff = 2.0; cutoff < 40.0; cutoff += 4.0) {
      const double now = leftOf(frequency, 120.0, cutoff);
      EXPECT_GT(now, before) << frequency << ' ' << cutoff;
      before = now;
    }
  }
}

// Of one sample that is out the others on both sides see the same.
TEST(LowPassLaws, AnImpulseIsSpreadEvenlyToBothSides) {
  Eigen::MatrixXd x = Eigen::MatrixXd::Zero(401, 1);
  x(200, 0) = 1.0;
  const Eigen::MatrixXd y = filtered(x, 120.0, 9.0);
  for (int k = 1; k < 100; ++k) EXPECT_NEAR(y(200 - k, 0), y(200 + k, 0), 1e-9) << k;
  EXPECT_NEAR(y.sum(), 1.0, 1e-9);
  EXPECT_EQ(largestOf(y), y(200, 0));
}

TEST(LowPassLaws, ADerivativeIsLinearAndOfRowsBackwardsItsNegative) {
  Generator generator(307);
  const Eigen::MatrixXd x = randomRows(generator, 80, 3), y = randomRows(generator, 80, 3);
  EXPECT_LT(
      largestOf(derivative(x + 3.0 * y, 50.0) - derivative(x, 50.0) - 3.0 * derivative(y, 50.0)),
      1e-11);
  const Eigen::MatrixXd backwards = x.colwise().reverse();
  EXPECT_LT(largestOf(derivative(backwards, 50.0).colwise().reverse() + derivative(x, 50.0)),
            1e-12);
  EXPECT_LT(largestOf(derivative(x, 100.0) - 2.0 * derivative(x, 50.0)), 1e-12);
}

TEST(LowPassLaws, DerivativesSumUpToTheWay) {
  Generator generator(308);
  const Eigen::MatrixXd x = randomRows(generator, 60, 1), slope = derivative(x, 30.0);
  // Trapezes of central differences leave the two ends' halves over.
  double way = 0.0;
  for (int i = 1; i + 1 < 60; ++i) way += slope(i, 0) / 30.0;
  EXPECT_NEAR(way, 0.5 * (x(59, 0) + x(58, 0) - x(1, 0) - x(0, 0)), 1e-12);
}

}  // namespace
}  // namespace amble

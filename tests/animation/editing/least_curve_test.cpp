#include "animation/editing/least_curve.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace amble {
namespace {

constexpr double kFrameTime = 0.01, kWidth = 0.05;

// What leastCurve says that it makes least.
double cost(const Eigen::MatrixXd& curve, const Eigen::MatrixXd& wanted,
            const std::vector<double>& weights) {
  double sum = curve.squaredNorm();
  for (Eigen::Index i = 0; i < curve.rows(); ++i) {
    sum += weights[i] * (curve.row(i) - wanted.row(i)).squaredNorm();
  }
  const double stiffness = std::pow(kWidth / kFrameTime, 6);
  for (Eigen::Index i = 0; i + 3 < curve.rows(); ++i) {
    sum += stiffness *
           (curve.row(i + 3) - 3.0 * curve.row(i + 2) + 3.0 * curve.row(i + 1) - curve.row(i))
               .squaredNorm();
  }
  return sum;
}

struct Asked {
  Eigen::MatrixXd wanted = Eigen::MatrixXd::Zero(100, 2);
  std::vector<double> weights = std::vector<double>(100, 0.0);
};

Asked asked() {
  Asked asked;
  for (int i = 60; i < 75; ++i) {
    asked.weights[i] = i < 70 ? 1e4 : 1.0;
    asked.wanted.row(i) << 0.02, 0.001 * i;
  }
  return asked;
}

TEST(LeastCurve, NoOtherCurveCostsLess) {
  const Asked ask = asked();
  const Eigen::MatrixXd curve = leastCurve(ask.wanted, ask.weights, kFrameTime, kWidth);
  const double least = cost(curve, ask.wanted, ask.weights);
  std::mt19937_64 generator(1);
  std::uniform_real_distribution<double> change(-1e-4, 1e-4);
  for (int k = 0; k < 200; ++k) {
    Eigen::MatrixXd tried = curve;
    tried(k % 100, k % 2) += change(generator);
    EXPECT_GE(cost(tried, ask.wanted, ask.weights), least) << k;
  }
}

TEST(LeastCurve, HoldsWhatWeighsAndGoesBackToNothingElsewhere) {
  Asked ask = asked();
  for (int i = 60; i < 75; ++i) ask.weights[i] = 1e10;
  const Eigen::MatrixXd curve = leastCurve(ask.wanted, ask.weights, kFrameTime, kWidth);
  for (int i = 60; i < 75; ++i) EXPECT_LT((curve.row(i) - ask.wanted.row(i)).norm(), 1e-6) << i;
  EXPECT_LT(curve.row(0).norm(), 1e-3);
}

TEST(LeastCurve, NothingAskedIsNothing) {
  const Eigen::MatrixXd none = Eigen::MatrixXd::Zero(9, 1);
  EXPECT_EQ(leastCurve(none, std::vector<double>(9, 0.0), kFrameTime, kWidth), none);
  EXPECT_EQ(curveOver(std::vector<double>(9, 0.0), kFrameTime, kWidth),
            std::vector<double>(9, 0.0));
  EXPECT_EQ(leastCurve(Eigen::MatrixXd(0, 2), {}, kFrameTime, kWidth).rows(), 0);
  EXPECT_TRUE(curveOver({}, kFrameTime, kWidth).empty());
}

TEST(CurveOver, LiesOverWhatIsMissingAndNotOverMoreThanTheLargest) {
  std::mt19937_64 generator(2);
  std::uniform_real_distribution<double> draw(0.0, 0.1);
  std::vector<double> missing(200, 0.0);
  for (int i = 60; i < 90; ++i) missing[i] = draw(generator);
  missing[199] = 0.05;
  const std::vector<double> curve = curveOver(missing, kFrameTime, kWidth);
  for (size_t i = 0; i < missing.size(); ++i) {
    EXPECT_GE(curve[i], missing[i] - 1e-15) << i;
    EXPECT_LE(curve[i], 0.1 + 1e-15) << i;
    const bool far_off = i < 50 || (i > 100 && i < 189);
    EXPECT_TRUE(!far_off || curve[i] == 0.0) << i;
  }
}

TEST(CurveOver, DoesNotJumpWhereASingleFrameMissesSomething) {
  std::vector<double> missing(100, 0.0);
  missing[50] = 0.1;
  const std::vector<double> curve = curveOver(missing, kFrameTime, kWidth);
  for (size_t i = 1; i + 1 < curve.size(); ++i) {
    const double bend = std::abs(curve[i - 1] - 2.0 * curve[i] + curve[i + 1]);
    EXPECT_LT(bend, 0.1 * 4.0 * std::pow(kFrameTime / kWidth, 2)) << i;
  }
}

}  // namespace
}  // namespace amble

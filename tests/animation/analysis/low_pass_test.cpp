#include "animation/analysis/low_pass.h"

#include <gtest/gtest.h>

#include "base/rotation.h"
#include "tests/animation/random_clip.h"

namespace amble {
namespace {

Eigen::MatrixXd sampled(int rows, double rate, const std::function<double(double)>& signal) {
  Eigen::MatrixXd samples(rows, 1);
  for (int i = 0; i < rows; ++i) samples(i, 0) = signal(i / rate);
  return samples;
}

/// Size of a sine of this frequency after the filter, in the middle of a long signal.
double gain(double frequency, double rate, double cutoff) {
  const auto sine = [&](double t) { return std::sin(2.0 * kPi * frequency * t + 0.3); };
  const int rows = static_cast<int>(20.0 * rate);
  Eigen::MatrixXd x = sampled(rows, rate, sine);
  const Eigen::MatrixXd before = x;
  lowPass(x, rate, cutoff);
  const Eigen::Index third = rows / 3;
  // No delay: what comes out is the same sine, smaller.
  const double size =
      x.middleRows(third, third).cwiseProduct(before.middleRows(third, third)).sum() /
      before.middleRows(third, third).squaredNorm();
  EXPECT_LT((x - size * before).middleRows(third, third).cwiseAbs().maxCoeff(), 1e-6);
  return size;
}

TEST(LowPass, NothingToFilterStaysAsItIs) {
  for (const int rows : {0, 1}) {
    Eigen::MatrixXd x = Eigen::MatrixXd::Constant(rows, 2, 3.0);
    lowPass(x, 30.0, 5.0);
    EXPECT_EQ(x, Eigen::MatrixXd(Eigen::MatrixXd::Constant(rows, 2, 3.0)));
  }
  Eigen::MatrixXd x = Eigen::MatrixXd::Random(40, 2);
  const Eigen::MatrixXd before = x;
  lowPass(x, 30.0, 14.0);
  EXPECT_EQ(x, before);
}

TEST(LowPass, StraightLinesPass) {
  for (const int rows : {2, 3, 10, 500}) {
    Eigen::MatrixXd x = sampled(rows, 100.0, [](double t) { return 4.0 - 1.5 * t; });
    const Eigen::MatrixXd before = x;
    lowPass(x, 100.0, 6.0);
    EXPECT_LT((x - before).cwiseAbs().maxCoeff(), 1e-9) << rows;
  }
}

TEST(LowPass, HalfOfThePowerIsLeftAtTheCutOff) {
  for (const double rate : {30.0, 60.0, 120.0}) {
    EXPECT_NEAR(gain(6.0, rate, 6.0), std::sqrt(0.5), 0.01) << rate;
    EXPECT_NEAR(gain(1.0, rate, 6.0), 1.0, 0.01) << rate;
    EXPECT_LT(gain(0.4 * rate, rate, 6.0), 0.06) << rate;
  }
}

TEST(LowPass, TimeMayRunBackwards) {
  Eigen::MatrixXd x = Eigen::MatrixXd::Random(300, 3), reversed = x.colwise().reverse();
  lowPass(x, 120.0, 10.0);
  lowPass(reversed, 120.0, 10.0);
  EXPECT_LT(
      (x.topRows(300) - reversed.colwise().reverse()).middleRows(60, 180).cwiseAbs().maxCoeff(),
      1e-6);
}

TEST(LowPass, DerivativeOfAParabolaIsExactInside) {
  const Eigen::MatrixXd x = sampled(20, 50.0, [](double t) { return 2.0 * t * t - t; });
  const Eigen::MatrixXd slope = derivative(x, 50.0);
  for (int i = 1; i < 19; ++i) EXPECT_NEAR(slope(i, 0), 4.0 * i / 50.0 - 1.0, 1e-12);
  EXPECT_NEAR(slope(0, 0), (x(1, 0) - x(0, 0)) * 50.0, 1e-12);
  EXPECT_EQ(derivative(Eigen::MatrixXd::Ones(1, 2), 50.0),
            Eigen::MatrixXd(Eigen::MatrixXd::Zero(1, 2)));
}

}  // namespace
}  // namespace amble

#include "animation/preparation/swing_fit.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/rotation.h"
#include "tests/animation/random_clip.h"
#include "tests/animation/rig.h"

namespace amble {
namespace {

double tauOf(int i) { return static_cast<double>(i) / (kSwingPoints - 1); }

std::vector<double> valuesOf(const SwingTerms& terms) {
  std::vector<double> values;
  for (int i = 0; i < kSwingPoints; ++i) values.push_back(swingPolynomial(terms, tauOf(i)));
  return values;
}

std::vector<double> noise(Generator& generator, double size) {
  std::vector<double> values;
  for (int i = 0; i < kSwingPoints; ++i) values.push_back(uniform(generator, -size, size));
  return values;
}

SwingTerms randomTerms(Generator& generator, int terms) {
  SwingTerms random = {};
  for (int k = 0; k < terms; ++k) random[k] = uniform(generator, -2.0, 2.0);
  return random;
}

double largestGap(const SwingTerms& a, const SwingTerms& b) {
  double gap = 0.0;
  for (size_t k = 0; k < a.size(); ++k) gap = std::max(gap, std::abs(a[k] - b[k]));
  return gap;
}

struct Fit {
  const char* name;
  SwingTerms (*of)(const std::vector<double>&);
  int terms;
};
void PrintTo(const Fit& fit, std::ostream* out) { *out << fit.name; }

class SwingFits : public testing::TestWithParam<Fit> {};

TEST_P(SwingFits, GiveBackAPolynomialOfTheirTerms) {
  Generator generator(1);
  for (int trial = 0; trial < 50; ++trial) {
    const SwingTerms wanted = randomTerms(generator, GetParam().terms);
    EXPECT_LT(largestGap(GetParam().of(valuesOf(wanted)), wanted), 1e-9);
  }
}

// What is left over is at right angles to all that the fit could add.
TEST_P(SwingFits, AreLeastSquares) {
  Generator generator(2);
  for (int trial = 0; trial < 20; ++trial) {
    const std::vector<double> values = noise(generator, 0.1);
    const std::vector<double> fitted = valuesOf(GetParam().of(values));
    for (int k = 0; k < GetParam().terms; ++k) {
      SwingTerms one = {};
      one[k] = 1.0;
      double product = 0.0;
      for (int i = 0; i < kSwingPoints; ++i)
        product += (values[i] - fitted[i]) * swingPolynomial(one, tauOf(i));
      EXPECT_NEAR(product, 0.0, 1e-12);
    }
  }
}

TEST_P(SwingFits, AreLinear) {
  Generator generator(3);
  const std::vector<double> a = noise(generator, 0.1), b = noise(generator, 0.1);
  std::vector<double> both;
  for (int i = 0; i < kSwingPoints; ++i) both.push_back(2.0 * a[i] - 3.0 * b[i]);
  const SwingTerms of_a = GetParam().of(a), of_b = GetParam().of(b);
  SwingTerms wanted = {};
  for (size_t k = 0; k < wanted.size(); ++k) wanted[k] = 2.0 * of_a[k] - 3.0 * of_b[k];
  EXPECT_LT(largestGap(GetParam().of(both), wanted), 1e-9);
}

// A swing backwards is as well fitted as forwards: powers of 1 - tau span what powers of tau do.
TEST_P(SwingFits, AreTheSameBackwards) {
  Generator generator(4);
  std::vector<double> values = noise(generator, 0.1);
  const std::vector<double> forwards = valuesOf(GetParam().of(values));
  std::reverse(values.begin(), values.end());
  const std::vector<double> backwards = valuesOf(GetParam().of(values));
  for (int i = 0; i < kSwingPoints; ++i)
    EXPECT_NEAR(forwards[i], backwards[kSwingPoints - 1 - i], 1e-12);
}

TEST_P(SwingFits, LeaveTheTermsBeyondTheirsAtNothing) {
  Generator generator(5);
  const SwingTerms fitted = GetParam().of(noise(generator, 0.1));
  for (size_t k = GetParam().terms; k < fitted.size(); ++k) EXPECT_EQ(fitted[k], 0.0);
}

INSTANTIATE_TEST_SUITE_P(, SwingFits,
                         testing::Values(Fit{"progress", fitProgress, 4},
                                         Fit{"stray", fitStray, 3}));

FootCycle footOfPitch(double (*pitch)(double)) {
  FootCycle foot;
  for (int i = 0; i < FootCycle::kStanceSamples; ++i) foot.pitch.push_back(0.0);
  for (int i = 0; i < FootCycle::kSwingSamples; ++i)
    foot.pitch.push_back(pitch(static_cast<double>(i) / FootCycle::kSwingSamples));
  return foot;
}

/// How low the lower end of the sole is, by the sole itself.
double lowest(const FootShape& shape, const FootCycle& foot, const SwingTerms& height, double tau) {
  const double pitch = footPitch(foot, 1.0 + tau);
  const Eigen::Quaterniond rolled(Eigen::AngleAxisd(pitch, Eigen::Vector3d::UnitY()));
  const Eigen::Vector3d ankle =
      rolledAnkle(shape, pitch) + Eigen::Vector3d(0, 0, swingPolynomial(height, tau));
  const SoleEnds ends = soleEnds(shape, ankle, rolled * shape.q_SF);
  return std::min(ends.heel.z(), ends.ball.z());
}

TEST(SwingHeights, ThatClearTheGroundAreLeftAlone) {
  const Rig rig;
  const FootCycle flat = footOfPitch([](double) { return 0.0; });
  for (const double size : {0.8, 1.5, 3.0}) {  // 5 to 19 cm in the middle
    const SwingTerms wanted = {size, 0.2 * size, -0.1 * size, 0.0, 0.0};
    const SwingTerms fitted = fitSwingHeight(rig.feet[kLeft], flat, valuesOf(wanted));
    EXPECT_LT(largestGap(fitted, wanted), 1e-9);
  }
}

class DippingSwings : public testing::TestWithParam<double (*)(double)> {};

// Toes that hang and heels that come first: the whole sole is over the ground, by more than a
// centimetre in the middle of the swing.
TEST_P(DippingSwings, AreRaisedUntilNoEndOfTheSoleDips) {
  const Rig rig;
  const FootCycle foot = footOfPitch(GetParam());
  Generator generator(6);
  for (int trial = 0; trial < 10; ++trial) {
    const SwingTerms height = fitSwingHeight(rig.feet[kLeft], foot, noise(generator, 0.03));
    for (double tau = 0.0; tau <= 1.0; tau += 1.0 / 64.0) {
      EXPECT_GT(lowest(rig.feet[kLeft], foot, height, tau), -5e-4) << tau;
    }
    EXPECT_GT(lowest(rig.feet[kLeft], foot, height, 0.5), 0.011);
  }
}

INSTANTIATE_TEST_SUITE_P(, DippingSwings,
                         testing::Values(
                             +[](double) { return 0.0; },
                             +[](double tau) { return 0.5 * std::sin(kPi * tau); },
                             +[](double tau) { return -0.3 * std::sin(kPi * tau); },
                             +[](double tau) { return 0.4 * std::sin(2.0 * kPi * tau); }));

// Where a swing is as high as it has to be, more height in the capture is more height in the fit.
TEST(SwingHeights, RiseWithTheCapturedOnes) {
  const Rig rig;
  const FootCycle foot = footOfPitch([](double tau) { return 0.4 * std::sin(2.0 * kPi * tau); });
  const SwingTerms low = {1.5, 0.0, 0.0, 0.0, 0.0}, high = {2.5, 0.0, 0.0, 0.0, 0.0};
  const SwingTerms a = fitSwingHeight(rig.feet[kRight], foot, valuesOf(low));
  const SwingTerms b = fitSwingHeight(rig.feet[kRight], foot, valuesOf(high));
  for (double tau = 0.2; tau < 0.85; tau += 0.1)
    EXPECT_LT(swingPolynomial(a, tau), swingPolynomial(b, tau));
}

}  // namespace
}  // namespace amble

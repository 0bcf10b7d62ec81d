#include "animation/steps/captured_shares.h"

#include <gtest/gtest.h>

#include <vector>

#include "tests/animation/random_clip.h"

namespace amble {
namespace {

CapturedShares sharesOf(const std::vector<double>& rates, double rate) {
  return capturedShares(
      rates.size(), [&](size_t i) { return rates[i]; }, rate);
}

/// What all turns have of a walk, by turn; the rest is the straight walk's.
std::vector<double> byTurn(const std::vector<double>& rates, double rate) {
  std::vector<double> all(rates.size() + 1, 0.0);
  const CapturedShares shares = sharesOf(rates, rate);
  all[shares.low] += shares.of_low;
  all[shares.low + 1] += shares.of_next;
  EXPECT_TRUE(shares.of_next == 0.0 || shares.low + 1 < rates.size());
  return all;
}

std::vector<double> randomRates(Generator& generator) {
  std::vector<double> rates;
  double rate = 0.0;
  for (int i = 0; i < 4; ++i) rates.push_back(rate += uniform(generator, 0.1, 0.8));
  return rates;
}

TEST(CapturedShares, WithoutATurnOrOnTheStraightThereIsNone) {
  EXPECT_EQ(sharesOf({}, 0.7).of_low, 0.0);
  EXPECT_EQ(sharesOf({0.5, 1.0}, 0.0).of_low, 0.0);
  EXPECT_EQ(sharesOf({0.5, 1.0}, 0.0).of_next, 0.0);
}

TEST(CapturedShares, AtACapturedRateAreThatTurnsAlone) {
  Generator generator(1);
  for (int trial = 0; trial < 20; ++trial) {
    const std::vector<double> rates = randomRates(generator);
    for (size_t i = 0; i < rates.size(); ++i) {
      const std::vector<double> all = byTurn(rates, rates[i]);
      for (size_t k = 0; k < rates.size(); ++k) EXPECT_NEAR(all[k], k == i ? 1.0 : 0.0, 1e-12);
    }
  }
}

// Beyond the slowest turn nothing of the straight walk is left; before it, the more the slower.
TEST(CapturedShares, AddUpToOneFromTheSlowestTurnOn) {
  Generator generator(2);
  for (int trial = 0; trial < 20; ++trial) {
    const std::vector<double> rates = randomRates(generator);
    double before = 0.0;
    for (double rate = 0.0; rate < 4.0; rate += 0.01) {
      double sum = 0.0;
      for (const double share : byTurn(rates, rate)) {
        EXPECT_GE(share, 0.0);
        sum += share;
      }
      EXPECT_GE(sum, before - 1e-12);
      if (rate >= rates[0]) {
        EXPECT_NEAR(sum, 1.0, 1e-12);
      }
      before = sum;
    }
  }
}

TEST(CapturedShares, OfTheFastestAreHeld) {
  const CapturedShares shares = sharesOf({0.3, 0.6, 1.2}, 5.0);
  EXPECT_EQ(shares.low, 2u);
  EXPECT_EQ(shares.of_low, 1.0);
}

// Neither they nor their slopes jump where a curve begins or one turn takes over from another.
TEST(CapturedShares, GoOverWithoutAKink) {
  Generator generator(3);
  constexpr double kStep = 1e-4;
  for (int trial = 0; trial < 10; ++trial) {
    const std::vector<double> rates = randomRates(generator);
    for (double rate = kStep; rate < 4.0; rate += 0.003) {
      const auto a = byTurn(rates, rate - kStep), b = byTurn(rates, rate),
                 c = byTurn(rates, rate + kStep);
      for (size_t k = 0; k < rates.size(); ++k) {
        // Smoothstep over 0.1 rad/s bends by 6 / 0.1^2 at most.
        EXPECT_LT(std::abs(a[k] - 2.0 * b[k] + c[k]), 601.0 * kStep * kStep);
      }
    }
  }
}

}  // namespace
}  // namespace amble

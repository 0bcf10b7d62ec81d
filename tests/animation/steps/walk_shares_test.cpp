#include "animation/steps/walk_shares.h"

#include <gtest/gtest.h>

#include "tests/animation/random_clip.h"

namespace amble {
namespace {

const std::vector<double> kPaces = {1.0, 1.4, 1.6, 1.9};

WalkDepartures planned(double speed) {
  WalkDepartures departures;
  departures.setPaces(kPaces, speed);
  departures.turns = {std::vector{0.5, 1.0}, std::vector{0.6}};
  return departures;
}

/// Shares of the straight rest: the plan's walk, then of kPaces, the slowest first.
std::vector<double> ofPaces(const WalkDepartures& departures, const WalkShares& shares) {
  std::vector<double> all = {shares.plans};
  for (size_t i = departures.slower.size(); i-- > 0;) {
    const CapturedShares& slower = shares.slower;
    all.push_back(i == slower.low ? slower.of_low : i == slower.low + 1 ? slower.of_next : 0.0);
  }
  return all;
}

TEST(WalkDepartures, OfOnePaceOrFromTheSlowestDownThereAreNone) {
  WalkDepartures one;
  one.setPaces({1.2}, 1.5);
  EXPECT_EQ(one.slowerBy(0.1), 0.0);
  for (const double speed : {0.4, kPaces.front()}) EXPECT_EQ(planned(speed).slowerBy(0.1), 0.0);
}

TEST(WalkDepartures, AtThePlansSpeedAndAboveTheWalkIsThePlansToTheBit) {
  for (double speed = 0.4; speed < 2.2; speed += 0.03) {
    const WalkDepartures departures = planned(speed);
    for (const double walked : {speed, 1.1 * speed}) {
      const WalkShares shares = departures.at(departures.slowerBy(walked), 0.0);
      EXPECT_EQ(shares.plans, 1.0) << speed;
      EXPECT_EQ(shares.straight, 1.0);
      EXPECT_EQ(shares.slower.of_low, 0.0);
    }
  }
}

TEST(WalkDepartures, ASlowerCapturedPaceIsThatWalkAlone) {
  for (const double speed : {1.401, 1.5, 1.65, 2.0}) {
    const WalkDepartures departures = planned(speed);
    for (size_t i = 0; i < departures.slower.size(); ++i) {
      const std::vector<double> all =
          ofPaces(departures, departures.at(departures.slowerBy(kPaces[i]), 0.0));
      for (size_t k = 0; k < all.size(); ++k) EXPECT_NEAR(all[k], k == i + 1 ? 1.0 : 0.0, 1e-12);
    }
  }
}

TEST(WalkDepartures, SlowerThanTheSlowestPaceItIsHeld) {
  const WalkDepartures departures = planned(1.7);
  EXPECT_EQ(departures.slowerBy(0.0), departures.slowerBy(kPaces.front()));
  EXPECT_EQ(ofPaces(departures, departures.at(departures.slowerBy(0.0), 0.0))[1], 1.0);
}

// Whatever the speed and the turn: none is negative, all are 1 together, and none jumps.
TEST(WalkDepartures, SharesSumToOneAndGoOverWithoutAJump) {
  Generator generator(7);
  for (int trial = 0; trial < 500; ++trial) {
    const WalkDepartures departures = planned(uniform(generator, 0.8, 2.2));
    const double walked = uniform(generator, 0.0, 2.2), rate = uniform(generator, -1.5, 1.5);
    const WalkShares now = departures.at(departures.slowerBy(walked), rate);
    const WalkShares next = departures.at(departures.slowerBy(walked + 1e-9), rate);
    const std::vector<double> all = ofPaces(departures, now), other = ofPaces(departures, next);
    double sum = 0.0;
    for (size_t i = 0; i < all.size(); ++i) {
      EXPECT_GE(all[i], 0.0);
      EXPECT_NEAR(all[i], other[i], 1e-5);
      sum += all[i];
    }
    EXPECT_NEAR(sum, 1.0, 1e-12);
    EXPECT_NEAR(now.straight + now.turning.of_low + now.turning.of_next, 1.0, 1e-12);
  }
}

}  // namespace
}  // namespace amble

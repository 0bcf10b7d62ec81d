#include "animation/ground/ground.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "animation/ground/slope_ground.h"
#include "animation/ground/stair_ground.h"
#include "base/rotation.h"

namespace amble {
namespace {

TEST(FlatGround, IsFoundWithinReachOnly) {
  const FlatGround ground(2.7);
  EXPECT_EQ(ground.height(1, 2, 2.7, 0.0), 2.7);
  EXPECT_EQ(ground.height(1, 2, 2.4, 0.31), 2.7);
  EXPECT_FALSE(ground.height(1, 2, 2.4, 0.29).has_value());
  EXPECT_FALSE(ground.height(1, 2, 3.0, 0.29).has_value());
  EXPECT_FALSE(ground.height(1, 2, std::numeric_limits<double>::quiet_NaN(), 1.0).has_value());
}

TEST(SlopeGround, HeightsAndNormalsAreThoseOfThePlane) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> at(-5, 5), angle(-40, 40), turn(-kPi, kPi);
  for (int i = 0; i < 100; ++i) {
    const double incline = angle(random) * kDegree, heading = turn(random);
    const SlopeGround ground(incline, heading);
    const double x = at(random), y = at(random);
    const auto point = ground.surface(x, y, 0.0, 100.0);
    ASSERT_TRUE(point.has_value());
    EXPECT_NEAR(point->normal.norm(), 1.0, 1e-12);
    EXPECT_NEAR(point->normal.dot(Eigen::Vector3d(x, y, point->height)), 0.0, 1e-12);
    const double ahead =
        *ground.height(x + std::cos(heading), y + std::sin(heading), 0.0, 100.0) - point->height;
    EXPECT_NEAR(ahead, std::tan(incline), 1e-12);
    EXPECT_FALSE(ground.surface(x, y, point->height + 0.2, 0.1).has_value());
  }
}

TEST(StairGround, GoesFromFloorToFloorByEqualSteps) {
  const StairGround up({.rise = 0.17, .going = 0.29, .count = 3, .start = 1.0});
  EXPECT_EQ(up.height(-5, 9, 0, 1), 0.0);
  EXPECT_EQ(up.height(0.999, 0, 0, 1), 0.0);
  EXPECT_NEAR(*up.height(1.001, 0, 0, 1), 0.17, 1e-12);
  EXPECT_NEAR(*up.height(1.3, 0, 0, 1), 0.34, 1e-12);
  EXPECT_NEAR(*up.height(7, 0, 0, 1), 0.51, 1e-12);
  EXPECT_FALSE(up.height(7, 0, 0, 0.5).has_value());
  EXPECT_EQ(up.surface(1.1, 0, 0, 1)->normal, Eigen::Vector3d::UnitZ());
}

TEST(StairGround, OnARiserTheHigherTreadCounts) {
  const StairGround up({.rise = 0.2, .going = 0.25, .count = 2, .start = 1.0});
  EXPECT_NEAR(*up.height(1.0, 0, 0, 1), 0.2, 1e-12);
  const StairGround down({.rise = -0.2, .going = 0.25, .count = 2, .start = 1.0});
  EXPECT_EQ(*down.height(1.0, 0, 0, 1), 0.0);
  EXPECT_NEAR(*down.height(1.25, 0, 0, 1), -0.2, 1e-12);
}

TEST(StairGround, TheSameFlightWalkedTheOtherWayIsTheSameGround) {
  const StairGround up({.rise = 0.17, .going = 0.29, .count = 5});
  const StairGround down(
      {.rise = -0.17, .going = 0.29, .count = 5, .start = -4 * 0.29, .heading = kPi});
  for (double x = -1.005; x < 3.0; x += 0.01) {
    EXPECT_NEAR(*up.height(x, 0.3, 0, 2), *down.height(x, 0.3, -0.85, 2) + 0.85, 1e-12) << x;
  }
}

TEST(Ground, ACrestIsTheHighestOfWhatEndsWithinTheRange) {
  const StairGround stairs({.rise = 0.17, .going = 0.29, .count = 10, .start = 1.0});
  const double none = -std::numeric_limits<double>::infinity();
  EXPECT_EQ(stairs.crest({0.5, 0}, {0.9, 0}, 0.05, -0.1, 0.3), 0.0);
  EXPECT_NEAR(stairs.crest({0.5, 0}, {1.1, 0}, 0.05, -0.1, 0.3), 0.17, 1e-12);
  EXPECT_NEAR(stairs.crest({1.1, 0}, {0.5, 0}, 0.05, -0.1, 0.3), 0.17, 1e-12);
  EXPECT_NEAR(stairs.crest({0.95, -1}, {0.95, 1}, 0.06, -0.1, 0.3), 0.17, 1e-12);
  EXPECT_EQ(stairs.crest({2.0, 0}, {2.1, 0}, 0.05, -0.1, 0.3), none);
  EXPECT_EQ(stairs.crest({0.5, 0}, {0.5, 0}, 0.0, -0.1, 0.3), 0.0);
}

}  // namespace
}  // namespace amble

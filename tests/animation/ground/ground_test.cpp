#include "animation/ground/ground.h"

#include <gtest/gtest.h>

#include <limits>
#include <utility>

#include "animation/ground/stair_ground.h"

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

TEST(FlatGround, ItsCrestsAreThoseOfEveryGround) {
  const FlatGround ground(0.25);
  for (const auto& [low, high] : {std::pair(0.0, 1.0), {0.25, 0.25}, {0.3, 0.9}, {-1.0, 0.2}})
    EXPECT_EQ(ground.crest({0, 0}, {0.4, 0.3}, 0.05, low, high),
              ground.Ground::crest({0, 0}, {0.4, 0.3}, 0.05, low, high));
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

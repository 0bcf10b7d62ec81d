#include "animation/ground/stair_ground.h"

#include <gtest/gtest.h>

#include "base/rotation.h"

namespace amble {
namespace {

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

}  // namespace
}  // namespace amble

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

// From its nosing to the next: as long as the going, level, a rise over the one before.
TEST(StairGround, EveryTreadIsAsLongAsTheGoingWhicheverWayTheFlightLies) {
  for (const double rise : {0.17, -0.21}) {
    for (const double heading : {0.0, 0.7, kPi, -2.0}) {
      const Stairs stairs{
          .rise = rise, .going = 0.29, .count = 6, .start = 1.3, .heading = heading};
      const StairGround ground(stairs);
      const Eigen::Vector2d way(std::cos(heading), std::sin(heading)), aside(-way.y(), way.x());
      for (int tread = 0; tread <= stairs.count; ++tread) {
        const double begin = stairs.start + (tread - 1) * stairs.going;
        for (const double along : {0.01, 0.5, 0.99}) {
          const Eigen::Vector2d p = (begin + along * stairs.going) * way + 3.0 * aside;
          const auto here = ground.surface(p.x(), p.y(), 0.0, 2.0);
          ASSERT_TRUE(here.has_value());
          EXPECT_NEAR(here->height, tread * rise, 1e-12) << tread << " " << along;
          EXPECT_EQ(here->normal, Eigen::Vector3d::UnitZ());
        }
      }
    }
  }
}

}  // namespace
}  // namespace amble

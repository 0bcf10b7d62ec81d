#include "animation/ground/slope_ground.h"

#include <gtest/gtest.h>

#include <random>

#include "base/rotation.h"

namespace amble {
namespace {

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

TEST(SlopeGround, WhereTheInclineChangesItIsTheAngleOfTheGround) {
  constexpr double h = 1e-5;
  const SlopeGround ground(10.0 * kDegree, -15.0 * kDegree, 4.0);
  for (double s = -1.0; s < 6.0; s += 0.05) {
    const double rise = (ground.height(s + h) - ground.height(s - h)) / (2.0 * h);
    EXPECT_NEAR(std::atan(rise), ground.incline(s), 1e-4) << s;
    const auto point = ground.surface(s, 0.3, ground.height(s), 0.1);
    ASSERT_TRUE(point.has_value());
    EXPECT_NEAR(-point->normal.x() / point->normal.z(), std::tan(ground.incline(s)), 1e-12);
  }
  EXPECT_EQ(ground.height(0.0), 0.0);
}

}  // namespace
}  // namespace amble

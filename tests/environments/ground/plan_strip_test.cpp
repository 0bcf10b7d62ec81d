#include "environments/ground/plan_strip.h"

#include <gtest/gtest.h>

#include "tests/animation/random_clip.h"

namespace amble {
namespace {

Eigen::AlignedBox2d randomBox(Generator& generator) {
  const Eigen::Vector2d low = randomVector(generator, 0.3).head<2>();
  return {low,
          low + Eigen::Vector2d(uniform(generator, 0.001, 0.2), uniform(generator, 0.001, 0.2))};
}

Triangle3 randomTriangle(Generator& generator) {
  return {randomVector(generator, 0.5), randomVector(generator, 0.5), randomVector(generator, 0.5)};
}

TEST(PlanStrip, KeepsDistancesAndHeights) {
  Generator generator(61);
  for (int trial = 0; trial < 100; ++trial) {
    const PlanStrip strip(
        {randomVector(generator, 1.0).head<2>(), randomVector(generator, 1.0).head<2>()}, 0.1);
    const Triangle3 t = randomTriangle(generator), own = strip.local(t);
    for (int k = 0; k < 3; ++k) {
      EXPECT_EQ(own[k].z(), t[k].z());
      EXPECT_NEAR((own[k] - own[(k + 1) % 3]).norm(), (t[k] - t[(k + 1) % 3]).norm(), 1e-14);
    }
  }
}

// What is found without clipping is what clipping finds.
TEST(HeightUpSlope, IsTheHighestPointOfTheTriangleOverTheBox) {
  Generator generator(62);
  int held = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    const Triangle3 t = randomTriangle(generator);
    const Eigen::AlignedBox2d box = randomBox(generator);
    const StripPlane plane(t);
    const auto clipped = heightsWithin(t, box);
    if (clipped) {
      EXPECT_LE(clipped->high, plane.highestOver(box));
    }
    const auto height = heightUpSlope(t, box);
    if (!height) continue;
    ++held;
    ASSERT_TRUE(clipped);
    EXPECT_NEAR(*height, clipped->high, 1e-12);
  }
  EXPECT_GT(held, 1000);
}

TEST(HeightUpSlope, IsToldOfEveryBoxInsideATriangle) {
  Generator generator(63);
  for (int trial = 0; trial < 1000; ++trial) {
    const double up = uniform(generator, -1.0, 1.0), aside = uniform(generator, -1.0, 1.0);
    const auto at = [&](double x, double y) {
      return Eigen::Vector3d(x, y, 0.3 + up * x + aside * y);
    };
    const Triangle3 large = {at(-3, -3), at(3, -3), at(0, 5)},
                    turned = {large[0], large[2], large[1]};
    const Eigen::AlignedBox2d box = randomBox(generator);
    const double highest = 0.3 + up * (up > 0.0 ? box.max().x() : box.min().x()) +
                           aside * (aside > 0.0 ? box.max().y() : box.min().y());
    for (const Triangle3& t : {large, turned}) {
      const auto height = heightUpSlope(t, box);
      ASSERT_TRUE(height);
      EXPECT_NEAR(*height, highest, 1e-12);
    }
  }
}

TEST(HeightUpSlope, OfALevelTriangleIsItsHeightToTheBit) {
  const Triangle3 level = {Eigen::Vector3d(-1, -1, 0.1), {2, -1, 0.1}, {0, 3, 0.1}};
  Generator generator(64);
  for (int trial = 0; trial < 100; ++trial)
    EXPECT_EQ(heightUpSlope(level, randomBox(generator)), 0.1);
}

TEST(HeightUpSlope, WhatStandsUprightHasNone) {
  const Triangle3 wall = {Eigen::Vector3d(0, 0, 0), {1, 0, 0}, {1, 0, 1}};
  const Eigen::AlignedBox2d box(Eigen::Vector2d(0.2, -0.1), Eigen::Vector2d(0.4, 0.1));
  EXPECT_FALSE(heightUpSlope(wall, box));
  EXPECT_NEAR(crestWithin(wall, box, 0.0, 1.0), 0.4, 1e-15);
  EXPECT_EQ(crestWithin(wall, box, 0.0, 0.3), -HUGE_VAL) << "it goes on above";
}

}  // namespace
}  // namespace amble

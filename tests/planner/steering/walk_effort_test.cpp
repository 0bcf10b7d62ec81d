#include "planner/steering/walk_effort.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/rotation.h"

namespace amble {
namespace {

AnimationBuffer walkOfSteps(const std::vector<GaitParameters>& steps) {
  AnimationBuffer walk;
  for (const GaitParameters& gait : steps) {
    walk.footprints.emplace_back();
    walk.footprints.back().gait = gait;
  }
  return walk;
}

TEST(WalkEffort, OfALevelWalkIsNone) {
  EXPECT_EQ(effortOf(walkOfSteps({}), 0.05, 1.2), 0.0);
  EXPECT_EQ(effortOf(walkOfSteps({{0.65, 0.05, 0.0}, {0.65, 0.055, 0.0}}), 0.05, 1.2), 0.0);
}

TEST(WalkEffort, AMetreWonCostsAsMuchAsEightOnTheLevel) {
  const AnimationBuffer walk = walkOfSteps({{0.3, 0.05, 0.5}, {0.3, 0.05, 0.5}});
  EXPECT_NEAR(effortOf(walk, 0.05, 1.0), 19.6 / 2.5, 1e-12);
  EXPECT_NEAR(effortOf(walk, 0.05, 2.0), 9.8 / 2.5, 1e-12);
}

TEST(WalkEffort, GoingDownIsChargedNothingAndLiftingSomething) {
  EXPECT_EQ(effortOf(walkOfSteps({{0.3, 0.05, -0.2}}), 0.05, 1.2), 0.0);
  const double low = effortOf(walkOfSteps({{0.6, 0.15, 0.0}}), 0.05, 1.2);
  const double high = effortOf(walkOfSteps({{0.6, 0.25, 0.0}}), 0.05, 1.2);
  EXPECT_GT(low, 0.0);
  EXPECT_NEAR(high, 2.0 * low, 1e-12);
}

TEST(WalkEffort, OfStepsAddsUpAndGrowsWithEachMetre) {
  const std::vector<GaitParameters> steps = {{0.5, 0.1, 0.17}, {0.6, 0.2, 0.0}, {0.4, 0.05, -0.1}};
  double sum = 0.0;
  for (const GaitParameters& step : steps) sum += effortOf(walkOfSteps({step}), 0.05, 1.2);
  EXPECT_NEAR(effortOf(walkOfSteps(steps), 0.05, 1.2), sum, 1e-12);
  double before = -1.0;
  for (const double climb : {0.0, 0.05, 0.1, 0.2}) {
    const double now = effortOf(walkOfSteps({{0.5, 0.05, climb}}), 0.05, 1.2);
    EXPECT_GT(now, before);
    before = now;
  }
}

// Hips on a wave between two heights, of that period.
AnimationBuffer walkOnWave(double height, double period, double frame_time) {
  AnimationBuffer walk;
  walk.frame_time = frame_time;
  const int frames = static_cast<int>(2.0 / frame_time) + 1;
  walk.poses.resize(frames);
  walk.states.resize(frames);
  for (int i = 0; i < frames; ++i)
    walk.poses.p_WR(i) = {0.0, 0.0,
                          0.9 + 0.5 * height * std::cos(2.0 * kPi * i * frame_time / period)};
  return walk;
}

TEST(WalkEffort, HipsThatSwayCostNothingAndThatJoltCostTheMoreTheHarder) {
  EXPECT_EQ(effortOf(walkOnWave(0.04, 0.5, 1.0 / 60.0), 0.05, 1.2), 0.0);  // as people's do
  double before = 0.0;
  for (const double height : {0.04, 0.06, 0.1}) {
    const double cost = effortOf(walkOnWave(height, 0.15, 1.0 / 120.0), 0.05, 1.2);
    EXPECT_GT(cost, before) << height;
    // Frames are no part of it.
    EXPECT_NEAR(effortOf(walkOnWave(height, 0.15, 1.0 / 240.0), 0.05, 1.2), cost, 0.05 * cost);
    before = cost;
  }
}

}  // namespace
}  // namespace amble

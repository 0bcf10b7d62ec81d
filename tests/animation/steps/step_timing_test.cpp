#include "animation/steps/step_timing.h"

#include <gtest/gtest.h>

#include <cmath>

namespace amble {
namespace {

TimedSteps unevenSteps() {
  TimedSteps steps;
  steps.arcs = {0.0, 0.3, 0.9, 1.4, 1.7, 2.0, 2.5, 2.8};
  steps.lengths = {0.6, 0.6, 0.6, 0.4, 0.29, 0.31, 0.6, 0.6};
  steps.durations = {0.55, 0.53, 0.6, 0.7, 0.7, 0.55, 0.56};
  return steps;
}

TEST(StepTiming, AWalkIsAWholeNumberOfFramesNearItsWantedDuration) {
  const StepTiming timing(unevenSteps());
  EXPECT_NEAR(timing.frames() / 60.0, 4.19, 0.5 / 60.0 + 1e-12);
  const auto first = timing.at(0), last = timing.at(timing.frames());
  EXPECT_EQ(first.arc, 0.0);
  EXPECT_EQ(first.steps, 0.0);
  EXPECT_EQ(first.speed, 0.0);
  EXPECT_NEAR(last.arc, 2.8, 1e-12);
  EXPECT_NEAR(last.steps, 7.0, 1e-12);
}

TEST(StepTiming, ArcIsThatOfTheNodeWhereProgressIsWhole) {
  TimedSteps steps = unevenSteps();
  steps.frame_time = 1.0 / 2000.0;  // dense enough to come near every node
  const StepTiming timing(steps);
  size_t node = 1;
  for (int k = 1; k <= timing.frames() && node < steps.arcs.size(); ++k) {
    if (timing.at(k).steps < static_cast<double>(node) - 1e-9) continue;
    EXPECT_NEAR(timing.at(k).arc, steps.arcs[node], 2e-3) << node;
    ++node;
  }
  EXPECT_EQ(node, steps.arcs.size());
}

TEST(StepTiming, NobodyWalksBackwards) {
  TimedSteps steps = unevenSteps();
  steps.first_speed = 1.2;
  steps.last_speed = 1.2;
  const StepTiming timing(steps);
  for (int k = 0; k < timing.frames(); ++k) {
    EXPECT_GE(timing.at(k + 1).arc, timing.at(k).arc);
    EXPECT_GE(timing.at(k + 1).steps, timing.at(k).steps);
  }
  EXPECT_NEAR(timing.at(0).speed, 1.2, 1e-9);
  EXPECT_NEAR(timing.at(timing.frames()).speed, 1.2, 1e-9);
}

}  // namespace
}  // namespace amble

#include "animation/quality/step_measures.h"

#include <gtest/gtest.h>

#include "animation/library/motion_library_reader.h"
#include "animation/synthesis/walk_synthesizer.h"

namespace amble {
namespace {

class MeasureWalkSteps : public testing::Test {
 protected:
  MeasureWalkSteps() : library_(openMotionLibrary("default")), walker_(library_, ground_, {}) {
    Stance from, to;
    to.position = {6.0, 0.0, 0.0};
    const RootPath path({makeBezier(from.position.head<2>(), 0.0, to.position.head<2>(), 0.0)});
    EXPECT_EQ(walker_.walk(from, to, path, true, walk_).refused, WalkRule::kNone);
  }
  std::vector<JudgedStep> steps(const Ground& ground) const {
    return measureWalkSteps(walker_.skeleton(), walker_.roles(), walker_.feet(), walk_, ground);
  }

  FlatGround ground_;
  MotionLibrary library_;
  WalkSynthesizer walker_;
  AnimationBuffer walk_;
};

TEST_F(MeasureWalkSteps, StepsOfAStraightWalkAddUpToIt) {
  double way = 0.0;
  const auto all = steps(ground_);
  ASSERT_GE(all.size(), 6u);
  for (const JudgedStep& step : all) {
    way += step.achieved.stride;
    EXPECT_GT(step.achieved.width, 0.0);
    EXPECT_NEAR(step.achieved.climb, 0.0, 1e-6);
    EXPECT_GT(step.achieved.supported, 0.95);
    EXPECT_LT(step.achieved.tilt, 0.02);
  }
  EXPECT_LT(way, 6.0);
  EXPECT_GT(way, 6.0 - 2.0 * all.front().achieved.stride);
}

TEST_F(MeasureWalkSteps, AWalkBesideTheGroundIsNotSupported) {
  const FlatGround lower(-0.05);
  for (const JudgedStep& step : steps(lower)) EXPECT_EQ(step.achieved.supported, 0.0);
}

TEST_F(MeasureWalkSteps, WhatIsAskedToBeLiftedAQuarterMoreIsMissedByAFifth) {
  EXPECT_LE(largestMiss(steps(ground_)).lift, 0.02);
  for (Footprint& print : walk_.footprints) print.gait.lift *= 1.25;
  const auto all = steps(ground_);
  for (const JudgedStep& step : all) {
    EXPECT_NEAR(step.achieved.lift, step.asked.lift / 1.25, 0.02 * step.asked.lift);
  }
  EXPECT_NEAR(largestMiss(all).lift, 0.2, 0.02);
}

TEST(LargestMiss, OfNoStepIsNone) {
  const GaitParameters miss = largestMiss({});
  EXPECT_EQ(miss.stride, 0.0);
  EXPECT_EQ(miss.lift, 0.0);
  EXPECT_EQ(miss.climb, 0.0);
}

TEST(LargestMiss, OfWhatIsAskedToBeLittleIsAgainstTwoCentimetres) {
  JudgedStep step;
  step.asked = {0.7, 0.05, 0.0};
  step.achieved.stride = 0.77;
  step.achieved.lift = 0.05;
  step.achieved.climb = 0.002;
  const GaitParameters miss = largestMiss({step});
  EXPECT_NEAR(miss.stride, 0.1, 1e-12);
  EXPECT_EQ(miss.lift, 0.0);
  EXPECT_NEAR(miss.climb, 0.1, 1e-12);
}

}  // namespace
}  // namespace amble

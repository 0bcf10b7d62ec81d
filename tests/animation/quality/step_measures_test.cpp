#include "animation/quality/step_measures.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "animation/library/motion_library_reader.h"
#include "animation/synthesis/walk_synthesizer.h"
#include "tests/animation/random_clip.h"
#include "tests/animation/walk_paths.h"

namespace amble {
namespace {

class MeasureWalkSteps : public testing::Test {
 protected:
  MeasureWalkSteps() : library_(openMotionLibrary("default")), walker_(library_, ground_, {}) {
    walkFrom({0.0, 0.0}, 0.0);
  }
  /// Six metres ahead from there.
  void walkFrom(const Eigen::Vector2d& start, double heading) {
    const RootPath path = straightPath(6.0, heading, start);
    walk_ = AnimationBuffer();
    EXPECT_EQ(
        walker_.walk(stanceAt(path, false, true), stanceAt(path, true, true), path, true, walk_)
            .refused,
        WalkRule::kNone);
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

TEST_F(MeasureWalkSteps, WhereAWalkGoesAndWhichWayIsNothingToItsSteps) {
  const auto here = steps(ground_);
  for (const double heading : {0.9, -2.5}) {
    walkFrom({-3.0, 8.0}, heading);
    const auto there = steps(ground_);
    ASSERT_EQ(here.size(), there.size());
    for (size_t i = 0; i < here.size(); ++i) {
      const StepMeasure &a = here[i].achieved, &b = there[i].achieved;
      EXPECT_EQ(a.side, b.side);
      EXPECT_NEAR(a.stride, b.stride, 1e-6);
      EXPECT_NEAR(a.width, b.width, 1e-6);
      EXPECT_NEAR(a.lift, b.lift, 1e-6);
      EXPECT_NEAR(a.climb, b.climb, 1e-6);
      EXPECT_NEAR(a.supported, b.supported, 1e-6);
    }
  }
}

TEST_F(MeasureWalkSteps, FeetAlternateAndLandOneAheadOfTheOther) {
  const auto all = steps(ground_);
  for (size_t i = 1; i < all.size(); ++i) {
    EXPECT_EQ(all[i].achieved.side, other(all[i - 1].achieved.side));
    const Eigen::Vector3d on = all[i].achieved.at - all[i - 1].achieved.at;
    EXPECT_GE(on.x(), -1e-6);
    EXPECT_NEAR(on.x(), all[i].achieved.stride, 0.02);  // feet toe out, each a little otherwise
  }
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

// The largest of all: in any order, and of more steps no less.
TEST(LargestMiss, OfMoreStepsIsNoLessAndKnowsNoOrder) {
  Generator generator(9);
  std::vector<JudgedStep> all;
  GaitParameters before;
  for (int i = 0; i < 30; ++i) {
    JudgedStep step;
    step.asked = {uniform(generator, 0.3, 0.9), uniform(generator, 0.0, 0.2),
                  uniform(generator, -0.2, 0.2)};
    step.achieved.stride = step.asked.stride + uniform(generator, -0.1, 0.1);
    step.achieved.lift = step.asked.lift + uniform(generator, -0.02, 0.02);
    step.achieved.climb = step.asked.climb + uniform(generator, -0.02, 0.02);
    all.push_back(step);
    const GaitParameters now = largestMiss(all);
    EXPECT_GE(now.stride, before.stride);
    EXPECT_GE(now.lift, before.lift);
    EXPECT_GE(now.climb, before.climb);
    before = now;
  }
  std::shuffle(all.begin(), all.end(), generator);
  const GaitParameters shuffled = largestMiss(all);
  EXPECT_EQ(shuffled.stride, before.stride);
  EXPECT_EQ(shuffled.lift, before.lift);
  EXPECT_EQ(shuffled.climb, before.climb);
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

#include "animation/body/step_measure.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/rotation.h"

namespace amble {
namespace {

constexpr double kHeel = -0.1, kBall = 0.08;  // of a foot's ends from its middle [m]

/// A foot that stands flat at a place, or hangs level over it.
SolePrint standing(const Eigen::Vector3d& at, double heading) {
  const Eigen::Vector3d ahead = aboutZ(heading) * Eigen::Vector3d::UnitX();
  return {at, {at + kHeel * ahead, at + kBall * ahead}};
}

/// A left foot's step of 0.7 m, 0.1 m beside the right one's, on a way with this heading; it rises
/// as a parabola of `height` over the line between its prints.
StepPrints stepOf(double heading, double climb, double height) {
  const auto on = [&](double x, double y, double z) {
    return standing(aboutZ(heading) * Eigen::Vector3d(x, y, z), heading);
  };
  StepPrints prints{kLeft, on(-0.7, 0.1, -climb), on(0.7, 0.1, climb), on(0, 0, 0), heading, {}};
  for (int i = 0; i <= 20; ++i) {
    const double t = i / 20.0;
    const double z = -climb + 2.0 * climb * t + 4.0 * height * t * (1.0 - t);
    prints.swing.push_back(on(-0.7 + 1.4 * t, 0.1, z).ends);
  }
  return prints;
}

TEST(StepMeasure, IsTheSameWhicheverWayTheWalkFaces) {
  for (const double heading : {0.0, 0.5, 1.57, 3.0, -2.2}) {
    const StepMeasure step = measureStep(stepOf(heading, 0.17, 0.09));
    EXPECT_NEAR(step.stride, 0.7, 1e-12);
    EXPECT_NEAR(step.width, 0.1, 1e-12);
    EXPECT_NEAR(step.climb, 0.17, 1e-12);
    EXPECT_NEAR(step.lift, 0.09, 1e-12);
    EXPECT_NEAR(step.two_steps, 1.4, 1e-12);
  }
}

TEST(StepMeasure, WidthIsPositiveForEitherFootThatKeepsToItsSide) {
  StepPrints prints = stepOf(0.4, 0.0, 0.05);
  EXPECT_GT(measureStep(prints).width, 0.0);
  prints.side = kRight;
  EXPECT_LT(measureStep(prints).width, 0.0);
}

// A toe that is lifted while the heel stays at the ground clears nothing.
TEST(StepMeasure, WhoWalksBackwardsStepsAsWide) {
  for (const double facing : {0.0, 1.0, -2.5}) {
    StepPrints prints = stepOf(facing, 0.0, 0.05);
    std::swap(prints.from, prints.to);
    prints.along = facing + kPi;
    const StepMeasure step = measureStep(prints);
    EXPECT_NEAR(step.width, 0.1, 1e-12);
    EXPECT_NEAR(step.stride, 0.7, 1e-12);
  }
}

TEST(StepMeasure, LiftIsThatOfTheSolesLowestPoint) {
  StepPrints prints = stepOf(0.0, 0.0, 0.0);
  for (SoleEnds& sole : prints.swing) sole.ball.z() += 0.2;
  EXPECT_NEAR(measureStep(prints).lift, 0.0, 1e-12);
  for (SoleEnds& sole : prints.swing) sole.heel.z() += 0.06;
  EXPECT_NEAR(measureStep(prints).lift, 0.06, 1e-12);
}

TEST(StepMeasure, ASwingThatWasNotSeenHasNoLift) {
  StepPrints prints = stepOf(0.0, 0.1, 0.05);
  prints.swing.clear();
  const StepMeasure step = measureStep(prints);
  EXPECT_EQ(step.lift, 0.0);
  EXPECT_EQ(step.two_steps, 0.0);
  EXPECT_NEAR(step.stride, 0.7, 1e-12);
}

TEST(StepMeasure, FeetThatToeOutAlikeGoTheWayBetween) {
  EXPECT_NEAR(headingBetween(1.0 + 0.2, 1.0 - 0.2), 1.0, 1e-12);
  EXPECT_NEAR(wrapAngle(headingBetween(kPi - 0.1, -kPi + 0.1) - kPi), 0.0, 1e-12);
}

}  // namespace
}  // namespace amble

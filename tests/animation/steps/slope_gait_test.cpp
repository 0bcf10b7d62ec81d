#include "animation/steps/slope_gait.h"

#include <gtest/gtest.h>

#include <cmath>

#include "animation/ground/slope_ground.h"
#include "base/rotation.h"

namespace amble {
namespace {

TEST(SlopePace, IsThatOfTheLevelAtMostAndFallsWithSteepness) {
  EXPECT_EQ(slopePace(0.0), 1.0);
  for (double slope = 0.0; slope < 0.6; slope += 0.01) {
    EXPECT_LE(slopePace(slope), 1.0);
    EXPECT_LE(slopePace(-slope), 1.0);
    EXPECT_LT(slopePace(slope + 0.01), slopePace(slope));
    EXPECT_LE(slopePace(-slope - 0.01), slopePace(-slope));
    EXPECT_LE(slopePace(slope), slopePace(-slope)) << "downhill is faster";
  }
}

TEST(SlopePace, IsTheRootOfToblersSlowing) {
  for (const double slope : {0.05, 0.1, 0.3, -0.2, -0.4}) {
    const double tobler = std::exp(-3.5 * std::abs(slope + 0.05)) / std::exp(-3.5 * 0.05);
    EXPECT_NEAR(slopePace(slope), std::sqrt(tobler), 1e-12);
  }
}

TEST(SlopeLean, IsIntoTheSlopeAndLessThanItsAngle) {
  EXPECT_EQ(slopeLean(0.0), 0.0);
  for (const double slope : {0.05, 0.2, 0.5}) {
    EXPECT_GT(slopeLean(slope), 0.0);
    EXPECT_LT(slopeLean(slope), std::atan(slope));
    EXPECT_LT(slopeLean(-slope), 0.0);
    EXPECT_GT(slopeLean(-slope), -slopeLean(slope)) << "people lean back less than forwards";
  }
}

TEST(SlopeStrike, IsWholeOnTheLevelAndDownhillAndNoneOnASteepClimb) {
  FootPlace place;
  place.heading = 0.4;
  EXPECT_EQ(slopeStrike(place), 1.0);
  for (const double degrees : {5.0, 10.0, 25.0}) {
    const SlopeGround up(degrees * kDegree, place.heading);
    place.normal = up.surface(0, 0, 0, 1)->normal;
    const double kept = 1.0 - std::tan(degrees * kDegree) / SlopeGait::kFlatStrike;
    EXPECT_NEAR(slopeStrike(place), std::max(0.0, kept), 1e-12);
    FootPlace down = place;
    down.heading += kPi;
    EXPECT_EQ(slopeStrike(down), 1.0);
    down.heading = place.heading + 0.5 * kPi;
    EXPECT_NEAR(slopeStrike(down), 1.0, 1e-12) << "across a slope feet strike as on the level";
  }
}

TEST(ClimbStrike, UpATreadLandsFlatAndDownOneOnTheBall) {
  for (const double scale : {0.9, 1.0, 1.2}) {
    const double high = SlopeGait::kFlatLanding * scale;
    EXPECT_EQ(climbStrike(1.0, 0.0, scale), 1.0);
    EXPECT_EQ(climbStrike(1.0, 1.1 * high, scale), 0.0);
    EXPECT_EQ(climbStrike(1.0, -1.1 * high, scale), -1.0);
    EXPECT_NEAR(climbStrike(1.0, 0.5 * high, scale), 0.5, 1e-12);
    EXPECT_NEAR(climbStrike(1.0, -0.5 * high, scale), 0.0, 1e-12);
  }
}

TEST(ClimbTime, GrowsEvenlyWithHeightAndMoreUpThanDown) {
  EXPECT_EQ(climbTime(0.0, 1.0), 1.0);
  EXPECT_NEAR(climbTime(0.17, 1.0), 1.41 / (2 * 0.53), 0.01);   // Riener et al.'s cycles
  EXPECT_NEAR(climbTime(-0.17, 1.0), 1.19 / (2 * 0.53), 0.01);  // of two steps
  EXPECT_NEAR(climbTime(0.34, 2.0), climbTime(0.17, 1.0), 1e-12);
}

TEST(ClimbStep, IsHalvedAtItsHeightUpOrDown) {
  EXPECT_EQ(climbStep(0.7, 0.0), 0.7);
  for (const double sign : {1.0, -1.0}) {
    EXPECT_NEAR(climbStep(0.7, sign * SlopeGait::kHalvingHeight), 0.35, 1e-12);
  }
}

}  // namespace
}  // namespace amble

#include "animation/steps/stance_feet.h"

#include <gtest/gtest.h>

#include "animation/ground/slope_ground.h"
#include "animation/ground/stair_ground.h"
#include "animation/steps/slope_gait.h"
#include "tests/animation/step_character.h"

namespace amble {
namespace {

StanceFeet feetOn(const Ground& ground, const Stance& stance) {
  const StepCharacter& c = stepCharacter();
  const StepSettings settings = c.settings();
  return findStanceFeet(settings, FootholdFinder(ground, c.feet, settings.footholds),
                        c.blend.feet(), stance);
}

TEST(StanceFeet, WithoutGroundOrOnASteepOneTheRuleIsSaid) {
  EXPECT_EQ(feetOn(FlatGround(1.0), {}).refused, WalkRule::kNoGround);
  EXPECT_EQ(feetOn(SlopeGround(30.0 * kDegree), {}).refused, WalkRule::kSlope);
}

TEST(StanceFeet, AcrossARiserNobodyStands) {
  const StairGround stairs({.rise = 0.17, .going = 0.29, .count = 3, .start = 0.0});
  EXPECT_NE(feetOn(stairs, {}).refused, WalkRule::kNone);
  Stance walking{{0.0, 0.0, 0.0}, 0.0, false, kLeft};
  EXPECT_NE(feetOn(stairs, walking).refused, WalkRule::kNone) << "one foot on a tread";
}

TEST(StanceFeet, OnTheLevelTheyAreTheStancesOwn) {
  const FlatGround ground(0.4);
  for (const bool standing : {true, false}) {
    const Stance stance{{1.0, 2.0, 0.4}, 0.7, standing, kRight};
    const StanceFeet found = feetOn(ground, stance);
    ASSERT_EQ(found.refused, WalkRule::kNone);
    EXPECT_TRUE(found.level);
    EXPECT_EQ(found.height, 0.4);
    EXPECT_EQ(found.rise, 0.0);
    const auto asked = Footsteps::atStance(stepCharacter().settings().placement, stance);
    for (const Side side : {kLeft, kRight}) {
      EXPECT_EQ(found.feet[side].position, asked[side].from.position);
    }
  }
}

TEST(StanceFeet, OnASlopeTheFrontFootStandsHigherByTheSlopeAndStepsAreShorter) {
  const StepSettings settings = stepCharacter().settings();
  for (const double degrees : {6.0, 12.0, -12.0}) {
    const SlopeGround ground(degrees * kDegree);
    const double slope = std::tan(degrees * kDegree);
    const StanceFeet found = feetOn(ground, {Eigen::Vector3d::Zero(), 0.0, false, kLeft});
    ASSERT_EQ(found.refused, WalkRule::kNone) << degrees;
    EXPECT_FALSE(found.level);
    const double wanted = settings.limits.law.stepLength(settings.limits.speed * slopePace(slope));
    EXPECT_NEAR(found.placement.step_length, wanted, 1e-9);
    const double apart = (found.feet[kLeft].position - found.feet[kRight].position).x();
    EXPECT_NEAR(found.rise, slope * apart, 1e-3);
    const double middle = 0.5 * (found.feet[kLeft].position + found.feet[kRight].position).x();
    EXPECT_NEAR(found.height, slope * middle, 1e-3);
  }
}

TEST(SlopeUnder, IsThatOfTheGroundBetweenTheFeet) {
  const StepCharacter& c = stepCharacter();
  const StepSettings settings = c.settings();
  for (const double degrees : {10.0, -7.0}) {
    const SlopeGround ground(degrees * kDegree, 0.5);
    const FootholdFinder holds(ground, c.feet, settings.footholds);
    const double slope = std::tan(degrees * kDegree);
    const auto along = [&](double heading) {
      return slopeUnder(settings, holds, {Eigen::Vector3d::Zero(), heading});
    };
    EXPECT_NEAR(along(0.5), slope, 1e-9);
    EXPECT_NEAR(along(0.5 + kPi), -slope, 1e-9);
    EXPECT_NEAR(along(0.5 + 0.5 * kPi), 0.0, 1e-9);
  }
}

}  // namespace
}  // namespace amble

#include "animation/synthesis/turn_on_spot.h"

#include <gtest/gtest.h>

#include "animation/ground/stair_ground.h"
#include "tests/animation/step_character.h"

namespace amble {
namespace {

constexpr double kFrame = 1.0 / 60.0;

SpotTurn turnOn(const Ground& ground, double angle, double scale = 1.0) {
  return planSpotTurn(stepCharacter().placer(ground), {{0.0, 0.0, 0.0}, 0.3}, angle, scale, kFrame);
}

TEST(TurnOnSpot, OverAnEdgeOrNothingItIsRefused) {
  EXPECT_EQ(turnOn(FlatGround(1.0), 1.0).refused, WalkRule::kNoGround);
  const StairGround edge({.rise = -0.2, .going = 1.0, .count = 1, .start = 0.02});
  EXPECT_NE(turnOn(edge, 2.0).refused, WalkRule::kNone);
}

TEST(TurnOnSpot, APairOfStepsTurnsNoFartherThanAPairMay) {
  const FlatGround floor;
  for (const double degrees : {1.0, 44.9, 45.0, 45.1, 90.0, -90.0, 180.0, -359.0, 360.0}) {
    const SpotTurn turn = turnOn(floor, degrees * kDegree);
    ASSERT_EQ(turn.refused, WalkRule::kNone);
    const int pairs = turn.steps / 2;
    EXPECT_EQ(turn.steps % 2, 0);
    EXPECT_LE(std::abs(degrees), pairs * 45.0 + 1e-6);
    const double one_fewer = pairs > 1 ? (pairs - 1) * 45.0 : 0.0;
    EXPECT_GT(std::abs(degrees), one_fewer) << "no pair is idle";
    EXPECT_EQ(turn.first, degrees > 0.0 ? kLeft : kRight) << "the foot on the inside opens";
  }
}

TEST(TurnOnSpot, FeetEndBesideTheTurnedStance) {
  const FlatGround floor;
  const SpotTurn turn = turnOn(floor, -2.0);
  const auto end = Footsteps::atStance(stepCharacter().settings().placement, turn.end);
  for (int i = turn.steps - 1; i <= turn.steps; ++i) {
    const FootPlace &place = turn.feet->places()[i + 1], &wanted = end[turn.feet->side(i)].from;
    EXPECT_LT((place.position - wanted.position).norm(), 1e-12);
    EXPECT_NEAR(place.heading, wanted.heading, 1e-12);
  }
}

TEST(TurnOnSpot, TheTurnRateIsTheRateOfTheHeadingAndNearWhatPeopleReachAtMost) {
  const FlatGround floor;
  const SpotTurn turn = turnOn(floor, kPi);
  FrameState standing;
  standing.heading = turn.from.heading;
  double fastest = 0.0;
  for (int k = 1; k < turn.frames; ++k) {
    const FrameState here = spotTurnState(turn, standing, k);
    const double rate = (spotTurnState(turn, standing, k + 1).heading -
                         spotTurnState(turn, standing, k - 1).heading) /
                        (2.0 * kFrame);
    EXPECT_NEAR(here.turn_rate, rate, 0.01);
    fastest = std::max(fastest, here.turn_rate);
  }
  EXPECT_LT(fastest, 100.0 * kDegree);
}

TEST(TurnOnSpot, NoFootIsTwistedFarAgainstThePelvis) {
  const FlatGround floor;
  for (const double degrees : {45.0, -90.0, 180.0, 270.0, -360.0}) {
    const SpotTurn turn = turnOn(floor, degrees * kDegree);
    FrameState standing;
    standing.heading = turn.from.heading;
    for (int k = 1; k < turn.frames; ++k) {
      const FrameState state = spotTurnState(turn, standing, k);
      for (const FootState& foot : state.feet) {
        const double share = foot.planted() ? 0.0 : foot.at - 1.0;
        const double heading =
            foot.from.heading + share * wrapAngle(foot.to.heading - foot.from.heading);
        EXPECT_LT(std::abs(wrapAngle(heading - state.heading)), 30.0 * kDegree) << degrees << k;
      }
    }
  }
}

TEST(TurnOnSpot, TheRootSwaysOverTheFootThatStands) {
  const FlatGround floor;
  for (const double angle : {1.5, -1.5}) {
    const SpotTurn turn = turnOn(floor, angle);
    for (int k = 1; k < turn.frames; ++k) {
      const FrameState state = spotTurnState(turn, {}, k);
      EXPECT_LE(std::abs(state.sway), SpotTurnGait::kSway + 1e-12);
      for (const Side side : {kLeft, kRight}) {
        if (state.feet[side].planted()) continue;
        EXPECT_EQ(state.sway < 0.0, side == kLeft) << k;
        EXPECT_TRUE(state.feet[other(side)].planted()) << "one foot at a time";
      }
    }
  }
}

}  // namespace
}  // namespace amble

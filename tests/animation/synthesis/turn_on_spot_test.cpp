#include "animation/synthesis/turn_on_spot.h"

#include <gtest/gtest.h>

#include "animation/analysis/gait_measures.h"
#include "animation/ground/stair_ground.h"
#include "animation/synthesis/walk_synthesizer.h"
#include "tests/animation/default_library.h"
#include "tests/animation/step_character.h"
#include "tests/animation/walk_paths.h"

namespace amble {
namespace {

constexpr double kFrame = 1.0 / 60.0;

SpotTurn turnOn(const Ground& ground, double angle, double scale = 1.0) {
  return planSpotTurn(stepCharacter().placer(ground),
                      {{{0.0, 0.0, 0.0}, 0.3}, angle, 0.3 + angle, scale, kFrame});
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

// However far out somebody's toes stand, a turn is of a few pairs of steps.
TEST(TurnOnSpot, WithToesFarOutNoPairIsIdleNorTurnsAllOfIt) {
  const FlatGround floor;
  for (const double toe_out : {0.0, 6.5, 20.0, 26.4, 26.5, 30.0, 60.0}) {
    StepSettings settings = stepCharacter().settings();
    settings.placement.stand_toe_out = toe_out * kDegree;
    const StepPlacer placer(floor, stepCharacter().feet, stepCharacter().blend.feet(), settings);
    const SpotTurn turn = planSpotTurn(placer, {{{0.0, 0.0, 0.0}, 0.0}, kPi, kPi, 1.0, kFrame});
    EXPECT_GE(turn.steps, 8) << toe_out;
    EXPECT_LE(turn.steps, 24) << toe_out;
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

// A turn takes whole frames, its steps somewhat more or less than theirs: so is its rate.
TEST(TurnOnSpot, InWhateverFramesItIsMadeTheRatesOfATurnAddUpToIt) {
  const FlatGround floor;
  for (const double frame_time : {1.0 / 24.0, 1.0 / 30.0, 1.0 / 60.0}) {
    for (const double degrees : {20.0, -40.0, 45.0, 90.0, 130.0}) {
      const double angle = degrees * kDegree;
      const SpotTurn turn = planSpotTurn(stepCharacter().placer(floor),
                                         {{{0.0, 0.0, 0.0}, 0.0}, angle, angle, 1.0, frame_time});
      double sum = 0.0;
      for (int k = 0; k <= turn.frames; ++k)
        sum += spotTurnState(turn, {}, k).turn_rate * frame_time;
      EXPECT_NEAR(sum, angle, 0.005 * std::abs(angle)) << degrees << " " << frame_time;
    }
  }
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

// As one finds who has the motion only: walk, turn, walk on.
TEST(TurnOnSpot, AJudgeThatFindsPlantsItselfSeesEveryStepAndNoSlide) {
  const FlatGround floor;
  for (const double height : {1.4, 0.0, 2.0}) {
    const WalkSynthesizer walker(defaultLibrary(), floor, {.height = height});
    for (const double degrees : {45.0, -45.0, 100.0, -180.0, 270.0, 360.0}) {
      AnimationBuffer all, part;
      const RootPath there = straightPath(4.0);
      Stance at = stanceAt(there, true, true);
      ASSERT_EQ(walker.walk(stanceAt(there, false, true), at, there, true, all).refused,
                WalkRule::kNone);
      const WalkResult turn = walker.turnOnSpot(at, degrees * kDegree, part);
      ASSERT_EQ(turn.refused, WalkRule::kNone);
      all.append(part);
      at.heading += degrees * kDegree;
      const RootPath on = straightPath(4.0, at.heading, at.position.head<2>());
      const WalkResult walk = walker.walk(at, stanceAt(on, true, true), on, true, part);
      ASSERT_EQ(walk.refused, WalkRule::kNone);
      all.append(part);
      Clip clip;
      clip.skeleton = walker.skeleton();
      clip.frame_time = walker.settings().frame_time;
      clip.poses = all.poses;
      const JointRoles& roles = walker.roles();
      const GaitMeasures seen = measureGait(clip, roles, detectPlants(clip, roles));
      EXPECT_LE(seen.toe_skate, 0.010) << height << " m, " << degrees;
      EXPECT_LE(seen.largest_drift, 0.002) << height << " m, " << degrees;
    }
  }
}

}  // namespace
}  // namespace amble

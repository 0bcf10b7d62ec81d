#include "animation/steps/footstep_plan.h"

#include <gtest/gtest.h>

#include <cmath>

#include "animation/ground/stair_ground.h"
#include "animation/library/motion_library_reader.h"
#include "tests/animation/walk_paths.h"

namespace amble {
namespace {

constexpr double kStep = 0.65;

const std::array<FootShape, 2>& ownFeet() {
  static const std::array<FootShape, 2> kFeet = openMotionLibrary("default").feet();
  return kFeet;
}

/// From standing at the origin to standing `length` further along +x.
FootstepPlan planOver(const Ground& ground, double length, GroundLimits limits = {},
                      double longest = 0.9) {
  const RootPath path = straightPath(length);
  const FootholdFinder holds(ground, ownFeet(), limits);
  FootPlacement placement;
  placement.step_length = kStep;
  Stance from, to;
  to.position = {length, 0.0, *ground.height(length, 0.0, 0.0, 9.0)};
  std::array<FootPlace, 2> from_feet, to_feet;
  for (const Side side : {kLeft, kRight}) {
    from_feet[side] = holds.at(Footsteps::atStance(placement, from)[side].from, side, 0.3).place;
    to_feet[side] = holds.at(Footsteps::atStance(placement, to)[side].from, side, 0.3).place;
  }
  return planFootsteps({.path = path,
                        .placement = placement,
                        .from = from,
                        .to = to,
                        .from_feet = from_feet,
                        .to_feet = to_feet,
                        .to_other_feet = to_feet,
                        .any_leading = true,
                        .print = [&](Side side, double) { return placement.print(side); },
                        .wanted = [](double) { return kStep; },
                        .shortest = 0.2,
                        .longest = longest},
                       holds);
}

TEST(FootstepPlan, AStepThatIsTooHighIsRefused) {
  const StairGround wall({.rise = 0.24, .going = 1.0, .count = 1, .start = 2.0});
  EXPECT_EQ(planOver(wall, 4.0).refused, WalkRule::kNone);
  EXPECT_EQ(planOver(wall, 4.0, {.max_climb = 0.2}).refused, WalkRule::kStepHeight);
}

TEST(FootstepPlan, OnTheLevelStepsAreEven) {
  const FootstepPlan plan = planOver(FlatGround(), 9 * kStep);
  ASSERT_EQ(plan.refused, WalkRule::kNone);
  ASSERT_EQ(static_cast<int>(plan.places.size()), plan.steps + 2);
  EXPECT_EQ(plan.steps, 10);
  for (int i = 1; i < plan.steps; ++i) {
    EXPECT_NEAR(plan.arcs[i + 1] - plan.arcs[i], kStep, 0.01 * kStep);
  }
}

TEST(FootstepPlan, EveryTreadGetsOneFootInItsMiddleWhereverTheStairsBegin) {
  for (const double rise : {0.1, 0.17, -0.1, -0.17}) {
    for (double start = 1.0; start < 1.6; start += 0.13) {
      const Stairs flight{.rise = rise, .going = 0.29, .count = 8, .start = start};
      const FootstepPlan plan = planOver(StairGround(flight), start + 7 * 0.29 + 1.5);
      ASSERT_EQ(plan.refused, WalkRule::kNone) << rise << " " << start;
      std::vector<int> treads(7, 0);
      for (const FootPlace& place : plan.places) {
        const double at = (place.position.x() - start) / flight.going;
        if (at < 0.0 || at >= 7.0) continue;
        ++treads[static_cast<int>(at)];
        EXPECT_NEAR(at - std::floor(at), 0.5, 0.05);
        EXPECT_NEAR(place.position.z(), (std::floor(at) + 1.0) * rise, 1e-9);
      }
      for (const int count : treads) EXPECT_EQ(count, 1);
    }
  }
}

// The higher the next step, the farther before its riser a foot stands, the whole sole on its
// tread.
TEST(FootstepPlan, FeetStandFartherBeforeHighRisers) {
  double before = -1.0;
  for (const double rise : {0.18, 0.28}) {
    const Stairs flight{.rise = rise, .going = 0.37, .count = 6, .start = 1.5};
    const FootstepPlan plan =
        planOver(StairGround(flight), 1.5 + 5 * 0.37 + 1.5, {.max_climb = 0.3});
    ASSERT_EQ(plan.refused, WalkRule::kNone) << rise;
    double least = 1.0;
    for (const FootPlace& place : plan.places) {
      const double into = place.position.x() - flight.start;
      if (into < 0.0 || into > 5 * flight.going) continue;
      const double room = flight.going * std::ceil(into / flight.going) - into;
      EXPECT_GT(flight.going - room, ownFeet()[kLeft].radius - ownFeet()[kLeft].heel_x - 1e-3)
          << rise;
      least = std::min(least, room);
    }
    EXPECT_GT(least, before + 0.03) << rise;
    before = least;
  }
}

// Where a tread asks for a short step, what is left for those beside it is no reason for one that
// is longer than legs may step.
TEST(FootstepPlan, NoStepIsLongerThanStepsMayBeHoweverTheyAreEvenedOut) {
  constexpr double kLongest = 0.72;
  int near = 0;  // steps that would be longer
  for (const double rise : {0.17, -0.17}) {
    for (double start = 1.0; start < 2.5; start += 0.07) {
      const Stairs flight{.rise = rise, .going = 0.29, .count = 3, .start = start};
      const FootstepPlan plan = planOver(StairGround(flight), start + 2.0, {}, kLongest);
      ASSERT_EQ(plan.refused, WalkRule::kNone) << rise << " " << start;
      for (int i = 1; i < plan.steps; ++i) {
        const double step = plan.arcs[i + 1] - plan.arcs[i];
        EXPECT_LE(step, kLongest + 1e-9) << rise << " " << start;
        EXPECT_GE(step, 0.2 - 1e-9) << rise << " " << start;
        near += step > kLongest - 1e-6 ? 1 : 0;
      }
    }
  }
  EXPECT_GT(near, 0);
}

TEST(FootstepPlan, LeftAndRightAlternateAndStayOnTheirLines) {
  const FootstepPlan plan =
      planOver(StairGround({.rise = 0.17, .going = 0.29, .count = 5, .start = 1.3}), 4.0);
  ASSERT_EQ(plan.refused, WalkRule::kNone);
  for (int i = 1; i <= plan.steps; ++i) {
    const bool left = (i % 2 != 0) == (plan.first == kLeft);
    EXPECT_EQ(plan.places[i + 1].position.y() > 0.0, left) << i;
  }
}

TEST(FootstepPlan, StepHeightIsWhatTheSlopeDoesNotExplain) {
  FootPlace a, b;
  b.position = {0.6, 0.0, 0.1};
  EXPECT_NEAR(stepHeight(a, b), 0.1, 1e-12);
  a.normal = b.normal = Eigen::Vector3d(-0.1, 0.0, 0.6).normalized();
  EXPECT_NEAR(stepHeight(a, b), 0.0, 1e-12);
  EXPECT_NEAR(stepHeight(b, a), 0.0, 1e-12);
}

}  // namespace
}  // namespace amble

#include "animation/steps/step_swings.h"

#include <gtest/gtest.h>

#include "animation/steps/foot_target.h"
#include "tests/animation/step_character.h"

namespace amble {
namespace {

SwingFeet swingFeet() {
  const StepCharacter& c = stepCharacter();
  return {c.feet, c.blend.feet(), {0.05, 0.06}, 1.0};
}

/// Six steps straight on over level ground, standing at both ends.
Footsteps sixSteps() {
  const FootPlacement placement = stepCharacter().settings().placement;
  Stance from, to;
  to.position.x() = 5.0 * placement.step_length;
  Footsteps steps(placement, from, to, 6, kRight);
  steps.place([&](int i) {
    return footBeside({{i * placement.step_length + placement.forward, 0.0, 0.0}, 0.0},
                      placement.print(steps.side(i)));
  });
  return steps;
}

TEST(AskedLift, TheCapturedLiftGivesEachFootItsOwnAndAnotherTheSameToBoth) {
  const SwingFeet feet = swingFeet();
  EXPECT_NEAR(askedLift(feet, 0.055, kLeft), 0.05, 1e-12);
  EXPECT_NEAR(askedLift(feet, 0.055, kRight), 0.06, 1e-12);
  for (const double lift : {0.03, 0.1}) {
    EXPECT_EQ(askedLift(feet, lift, kLeft), lift);
    EXPECT_EQ(askedLift(feet, lift, kRight), lift);
  }
}

TEST(StepSwings, EveryStepIsAsLiftedAsItWasAsked) {
  const FlatGround ground;
  const SwingFeet feet = swingFeet();
  const SwingClearance clearance(ground, feet.shapes, 0.25);
  GaitWishes wishes;
  wishes.lift = [](double arc) { return 0.08 + 0.02 * arc; };
  Footsteps steps = sixSteps();
  std::vector<GaitParameters> gait;
  ASSERT_TRUE(shapeSwings(feet, clearance, wishes, 3.0, true, steps, gait));
  ASSERT_EQ(gait.size(), 6u);
  for (int i = 1; i <= 6; ++i) {
    EXPECT_NEAR(gait[i - 1].lift, wishes.lift(3.0 * (i - 0.5) / 6.0), 1e-4) << i;
    EXPECT_EQ(gait[i - 1].climb, 0.0);
  }
}

TEST(StepSwings, AStrideIsTheWayFromTheOtherFootAndTheyAddUpToTheWalk) {
  const FlatGround ground;
  const SwingFeet feet = swingFeet();
  const SwingClearance clearance(ground, feet.shapes, 0.25);
  Footsteps steps = sixSteps();
  std::vector<GaitParameters> gait;
  ASSERT_TRUE(shapeSwings(feet, clearance, {}, 3.0, true, steps, gait));
  double sum = 0.0;
  for (const GaitParameters& step : gait) sum += step.stride;
  EXPECT_NEAR(sum, (steps.places().back().position - steps.places()[1].position).x(), 0.01);
}

TEST(StepSwings, AStepUpIsPutDownFlatAndAStepDownOnTheBall) {
  const FlatGround ground;
  const SwingFeet feet = swingFeet();
  const SwingClearance clearance(ground, feet.shapes, 0.25);
  for (const double height : {0.17, -0.17}) {
    Footsteps steps = sixSteps();
    for (int i = 4; i < 8; ++i) steps.places()[i].position.z() = height;
    std::vector<GaitParameters> gait;
    ASSERT_TRUE(shapeSwings(feet, clearance, {}, 3.0, true, steps, gait));
    EXPECT_EQ(steps.landings()[4].strike_roll, height > 0.0 ? 0.0 : -1.0);
    EXPECT_EQ(steps.landings()[3].strike_roll, 1.0) << "the one before as on the level";
    EXPECT_EQ(gait[2].climb, height);
  }
}

}  // namespace
}  // namespace amble

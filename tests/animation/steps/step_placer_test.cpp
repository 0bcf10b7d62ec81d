#include "animation/steps/step_placer.h"

#include <gtest/gtest.h>

#include "animation/ground/slope_ground.h"
#include "animation/ground/stair_ground.h"
#include "base/sample_stream.h"
#include "tests/animation/step_character.h"
#include "tests/animation/walk_paths.h"

namespace amble {
namespace {

WalkSteps stepsOver(const Ground& ground, const RootPath& path, bool standing = true,
                    bool any_leading = true, const GaitWishes& wishes = {}) {
  Stance from = stanceAt(path, false, standing), to = stanceAt(path, true, standing);
  double z = 0.0;
  for (double s = 0.0; s <= path.length(); s += 0.02) {
    const Eigen::Vector2d p = path.at(s).position;
    z = ground.height(p.x(), p.y(), z, 0.5).value_or(z);
  }
  to.position.z() = z;
  return stepCharacter().placer(ground).plan({from, to, path, any_leading, wishes});
}

TEST(StepPlacer, WhatRefusesIsTheRuleThatIsBroken) {
  EXPECT_EQ(stepsOver(FlatGround(3.0), straightPath(4.0)).refused, WalkRule::kNoGround);
  EXPECT_EQ(stepsOver(FlatGround(), straightPath(0.03)).refused, WalkRule::kStepLength);
  EXPECT_EQ(stepsOver(SlopeGround(25.0 * kDegree), straightPath(4.0)).refused, WalkRule::kSlope);
  EXPECT_EQ(stepsOver(FlatGround(), circlePath(0.5, 6.0), false).refused, WalkRule::kTurnRate);
  const StairGround kerb({.rise = 0.3, .going = 1.0, .count = 1, .start = 2.0});
  EXPECT_EQ(stepsOver(kerb, straightPath(4.0)).refused, WalkRule::kStepHeight);
}

TEST(StepPlacer, FeetAlternateAndTheLastLeads) {
  for (const double length : {2.0, 3.1, 4.4, 5.0}) {
    const WalkSteps walk = stepsOver(FlatGround(), straightPath(length));
    ASSERT_EQ(walk.refused, WalkRule::kNone);
    EXPECT_TRUE(walk.level);
    for (int i = 1; i <= walk.steps; ++i) EXPECT_NE(walk.feet->side(i), walk.feet->side(i - 1));
    EXPECT_EQ(walk.feet->side(walk.steps), walk.end.leading);
    EXPECT_EQ(walk.gait.size(), static_cast<size_t>(walk.steps));
  }
}

TEST(StepPlacer, FromStandingTheFootOnTheInsideOfTheTurnGoesFirst) {
  EXPECT_EQ(stepsOver(FlatGround(), circlePath(3.0, 1.2)).first, kLeft);
  EXPECT_EQ(stepsOver(FlatGround(), circlePath(-3.0, -1.2)).first, kRight);
}

TEST(StepPlacer, TheLeadingFootIsTheOneThatIsAskedFor) {
  for (const double length : {3.0, 4.5, 6.0}) {
    const WalkSteps walk = stepsOver(FlatGround(), straightPath(length), false, false);
    if (walk.refused != WalkRule::kNone) continue;
    EXPECT_EQ(walk.end.leading, kLeft);
    EXPECT_EQ(walk.steps % 2, 0) << "left led at the begin as well";
  }
}

TEST(StepPlacer, OnStairsEveryTreadHasOneFoot) {
  constexpr int kRisers = 6;
  constexpr double kRise = 0.17, kGoing = 0.29, kStart = 1.5;
  const StairGround stairs({.rise = kRise, .going = kGoing, .count = kRisers, .start = kStart});
  const WalkSteps walk = stepsOver(stairs, straightPath(kStart + kRisers * kGoing + 1.4));
  ASSERT_EQ(walk.refused, WalkRule::kNone);
  EXPECT_TRUE(walk.timing.has_value());
  std::array<int, kRisers + 1> feet = {};
  for (const FootPlace& place : walk.feet->places()) {
    ++feet[static_cast<size_t>(std::lround(place.position.z() / kRise))];
  }
  for (int tread = 1; tread < kRisers; ++tread) EXPECT_EQ(feet[tread], 1) << tread;
}

TEST(StepPlacer, TheRootPathIsMidwayBetweenTheFeetAtEveryNode) {
  const SlopeGround ground(8.0 * kDegree);
  const WalkSteps walk = stepsOver(ground, straightPath(5.0));
  ASSERT_EQ(walk.refused, WalkRule::kNone);
  ASSERT_FALSE(walk.level);
  const auto& places = walk.feet->places();
  for (int i = 1; i < walk.steps; ++i) {
    EXPECT_NEAR(walk.height.at(i), 0.5 * (places[i].position.z() + places[i + 1].position.z()),
                1e-12);
  }
}

TEST(StepPlacer, OnALevelSpotFeetOfATurnStayAndOverAnEdgeTheyDoNot) {
  const FootPlacement placement = stepCharacter().settings().placement;
  Stance from, to;
  to.heading = 0.5;
  Footsteps steps(placement, from, to, 2, kLeft);
  const std::vector<FootPlace> asked = steps.places();
  EXPECT_EQ(stepCharacter().placer(FlatGround()).standOnGround(steps), WalkRule::kNone);
  for (size_t i = 0; i < asked.size(); ++i) {
    EXPECT_EQ(steps.places()[i].position, asked[i].position);
  }
  const StairGround edge({.rise = -0.2, .going = 1.0, .count = 1, .start = 0.0});
  Footsteps over(placement, from, to, 4, kLeft);
  EXPECT_NE(stepCharacter().placer(edge).standOnGround(over), WalkRule::kNone);
}

// A walk is kept as what it is made of, with the foot in front that it ended with. Where it ends
// beside the edge of a landing one foot may stand in front, and the other not.
TEST(StepPlacer, PlannedAgainWithTheFootThatItEndedWithAWalkIsTheSame) {
  constexpr int kRisers = 5;
  constexpr double kGoing = 0.29;
  const StairGround stairs({.rise = 0.17, .going = kGoing, .count = kRisers, .start = 0.0});
  const StepPlacer placer = stepCharacter().placer(stairs);
  SampleStream stream(5, 0);
  int walks = 0, by_one_foot = 0;
  for (int i = 0; i < 400; ++i) {
    const Eigen::Vector2d begin(stream.uniform(-2.0, -0.3), 0.0);
    const Eigen::Vector2d end((kRisers - 1) * kGoing + stream.uniform(0.2, 0.6), 0.0);
    const double turned = stream.uniform(-0.5, 0.5);
    const RootPath path({makeBezier(begin, 0.0, end, turned, 1.0 / 3.0)});
    const Stance from = stanceAt(path, false, stream.uniform() < 0.5);
    Stance to = stanceAt(path, true, false, i % 2 == 0 ? kLeft : kRight);
    to.position.z() = *stairs.height(end.x(), 0.0, 0.0, 2.0);
    const WalkSteps walk = placer.plan({from, to, path, true, {}});
    if (walk.refused != WalkRule::kNone) continue;
    ++walks;
    to.leading = other(to.leading);
    by_one_foot += placer.stanceFeet(to).refused != WalkRule::kNone;
    const WalkSteps again = placer.plan({from, walk.end, path, true, {}});
    ASSERT_EQ(again.refused, WalkRule::kNone) << i;
    EXPECT_EQ(again.end.leading, walk.end.leading) << i;
    ASSERT_EQ(again.feet->places().size(), walk.feet->places().size()) << i;
    for (size_t k = 0; k < walk.feet->places().size(); ++k)
      EXPECT_EQ(again.feet->places()[k].position, walk.feet->places()[k].position) << i;
  }
  EXPECT_GE(walks, 50);
  EXPECT_GE(by_one_foot, 5);
}

}  // namespace
}  // namespace amble

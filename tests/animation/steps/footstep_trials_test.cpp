#include "animation/steps/footstep_trials.h"

#include <gtest/gtest.h>

#include "animation/ground/stair_ground.h"
#include "tests/animation/step_character.h"
#include "tests/animation/walk_paths.h"

namespace amble {
namespace {

/// Along the x axis over a ground, from 0 to `length`.
struct Trials {
  Trials(const Ground& ground, double length)
      : path(straightPath(length)),
        holds(ground, stepCharacter().feet, stepCharacter().settings().footholds),
        placement(stepCharacter().settings().placement),
        request{path, [this](Side side, double) { return placement.print(side); }, 0.0, length,
                0.0},
        trials(tryPlaces(request, holds)) {}

  RootPath path;
  FootholdFinder holds;
  FootPlacement placement;
  TrialRequest request;
  FootTrials trials;
};

TEST(FootstepTrials, WhereGroundEndsOrIsAWallThatIsCounted) {
  const Trials cliff(FlatGround(-1.0), 2.0);
  EXPECT_EQ(cliff.trials.refused(Foothold::Refusal::kNoGround), 2 * cliff.trials.count());
  EXPECT_EQ(cliff.trials.out_of_step, cliff.trials.count()) << "it lies within sight";
  const Trials abyss(FlatGround(-9.0), 2.0);
  EXPECT_EQ(abyss.trials.out_of_step, 0);
}

TEST(FootstepTrials, OnTheLevelEveryPlaceStandsOnItsLine) {
  const Trials level(FlatGround(), 3.0);
  EXPECT_EQ(level.trials.count(), 149);
  for (const Side side : {kLeft, kRight}) {
    for (int k = 0; k < level.trials.count(); ++k) {
      const FootTrial& trial = level.trials.lines[side][k];
      EXPECT_TRUE(trial.stands());
      EXPECT_EQ(trial.aside, 0.0);
      EXPECT_NEAR(trial.arc, (k + 1) * TrialGrid::kSpacing, 1e-12);
      EXPECT_NEAR(trial.hold.place.position.y(),
                  (side == kLeft ? 0.5 : -0.5) * level.placement.walk_width, 1e-12);
    }
  }
}

TEST(FootstepTrials, ATreadIsASurfaceOfItsOwnWhoseEndsAreFound) {
  constexpr double kGoing = 0.3, kStart = 1.0;
  const StairGround stairs({.rise = 0.17, .going = kGoing, .count = 4, .start = kStart});
  const Trials on(stairs, 3.0);
  const int middle = static_cast<int>((kStart + 0.5 * kGoing) / TrialGrid::kSpacing) - 1;
  ASSERT_TRUE(on.trials.lines[kLeft][middle].stands());
  const auto [low, high] = surfaceAround(on.request, on.holds, on.trials, kLeft, middle);
  EXPECT_LT(low, high);
  EXPECT_GT(low, kStart);
  EXPECT_LT(high, kStart + kGoing);
  // Just beyond, the foot stands worse than in the middle.
  const FootTrial& own = on.trials.lines[kLeft][middle];
  for (const double beyond : {low - 3.0 * TrialGrid::kFinest, high + 3.0 * TrialGrid::kFinest}) {
    EXPECT_FALSE(standsLike(own.hold, holdAt(on.request, on.holds, kLeft, own, beyond)));
  }
}

}  // namespace
}  // namespace amble

#include "animation/steps/path_pace.h"

#include <gtest/gtest.h>

#include "animation/ground/slope_ground.h"
#include "animation/ground/stair_ground.h"
#include "animation/steps/slope_gait.h"
#include "tests/animation/step_character.h"
#include "tests/animation/walk_paths.h"

namespace amble {
namespace {

std::function<double(double)> paceOver(const Ground& ground, double length) {
  const StepCharacter& c = stepCharacter();
  const StepSettings settings = c.settings();
  const RootPath path = straightPath(length);
  return paceAlong(settings, FootholdFinder(ground, c.feet, settings.footholds), path,
                   stanceAt(path, false, true), stanceAt(path, true, true));
}

TEST(PathPace, LevelGroundAndTreadsAskForNone) {
  EXPECT_EQ(paceOver(FlatGround(), 5.0), nullptr);
  const StairGround stairs({.rise = 0.17, .going = 0.29, .count = 6, .start = 1.0});
  EXPECT_EQ(paceOver(stairs, 4.0), nullptr);
}

TEST(PathPace, AnEvenSlopeHasItsPaceEverywhere) {
  for (const double degrees : {8.0, -15.0}) {
    const auto pace = paceOver(SlopeGround(degrees * kDegree), 6.0);
    ASSERT_TRUE(pace);
    for (double arc = 0.0; arc <= 6.0; arc += 0.1) {
      EXPECT_NEAR(pace(arc), slopePace(std::tan(degrees * kDegree)), 1e-9) << arc;
    }
  }
}

TEST(PathPace, FollowsASlopeThatChanges) {
  const SlopeGround ground(2.0 * kDegree, 18.0 * kDegree, 8.0);
  const auto pace = paceOver(ground, 8.0);
  ASSERT_TRUE(pace);
  for (double arc = 0.5; arc <= 7.5; arc += 0.1) {
    EXPECT_NEAR(pace(arc), slopePace(std::tan(ground.incline(arc))), 0.01) << arc;
    EXPECT_LT(pace(arc + 0.1), pace(arc));
  }
}

}  // namespace
}  // namespace amble

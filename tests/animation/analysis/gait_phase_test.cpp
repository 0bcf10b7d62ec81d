#include "animation/analysis/gait_phase.h"

#include <gtest/gtest.h>

#include <cmath>

#include "animation/clips/level_capture.h"
#include "tests/animation/captures.h"
#include "tests/animation/puppet.h"

namespace amble {
namespace {

TEST(GaitPhase, OfAClipThatStandsIsNone) {
  EXPECT_TRUE(gaitPhase({}).empty());
  EXPECT_TRUE(gaitPhase(Puppet{.speed = 0.0, .stance = 1.0, .lift = 0.0}.plants()).empty());
}

// The middle between a left strike and the lift-off of the right foot, which trails.
TEST(GaitPhase, IsWholeInTheMiddleOfADoubleSupportWithTheLeftFootInFront) {
  const Puppet puppet;
  for (const PhaseMoment& moment : gaitPhase(puppet.plants())) {
    const Side front = std::fmod(moment.phase, 1.0) == 0.0 ? kLeft : kRight;
    const double time = moment.frame / puppet.rate;
    double nearest = 1.0;
    for (int cycle = 0; cycle < 8; ++cycle) {
      const double strike = puppet.strike(front, cycle);
      for (int before : {cycle - 1, cycle}) {
        const double leaves = puppet.liftOff(other(front), before);
        if (leaves < strike || leaves > strike + 0.3 * puppet.period) continue;
        nearest = std::min(nearest, std::abs(0.5 * (strike + leaves) - time));
      }
    }
    EXPECT_LT(nearest, 1.0 / puppet.rate) << moment.frame;
  }
}

TEST(GaitPhase, GoesOnByHalfACycleAStep) {
  AMBLE_NEEDS_CAPTURES();
  for (const char* clip : {"accad_female1/Female1_B03_Walk1.bvh",
                           "accad_female1/Female1_C03_Run.bvh", "cmu_mb2/07_01.bvh"}) {
    const LevelCapture level = readLevelCapture(sharedFolder() / "mocap" / clip);
    const auto moments = gaitPhase(detectPlants(level.motion.clip, level.motion.roles));
    ASSERT_GE(moments.size(), 3u) << clip;
    double longest = 0.0, shortest = 1e9;
    for (size_t i = 1; i < moments.size(); ++i) {
      EXPECT_EQ(moments[i].phase - moments[i - 1].phase, 0.5) << clip;
      const double step = moments[i].frame - moments[i - 1].frame;
      longest = std::max(longest, step);
      shortest = std::min(shortest, step);
    }
    EXPECT_LT(longest, 1.6 * shortest) << clip;  // a steady gait
  }
}

// Two walks with a pause between: the longer one's phase, which the pause does not stretch.
TEST(GaitPhase, EndsAtAPause) {
  FootPlants plants;
  const auto plant = [](int first, int last) {
    return FootPlant{first, last, first - 0.5, last + 0.5};
  };
  plants.frames = 400;
  plants.plants[kLeft] = {plant(0, 20), plant(40, 60), plant(80, 200), plant(220, 240),
                          plant(260, 399)};
  plants.plants[kRight] = {plant(10, 45), plant(55, 85), plant(95, 225), plant(235, 265)};
  const auto moments = gaitPhase(plants);
  ASSERT_EQ(moments.size(), 4u);
  EXPECT_LT(moments.back().frame, 110.0);
}

// Steps on both sides of a hop are two stretches, whichever foot is called left.
TEST(GaitPhase, AHopOntoBothFeetEndsAStretchWhicheverFootIsLeft) {
  const auto plant = [](int first, int last) {
    return FootPlant{first, last, first - 0.5, last + 0.5};
  };
  FootPlants plants;
  plants.frames = 400;
  plants.plants[kLeft] = {plant(0, 20), plant(40, 62), plant(80, 100), plant(140, 160),
                          plant(180, 399)};
  plants.plants[kRight] = {plant(10, 45), plant(58, 84), plant(140, 185), plant(200, 399)};
  const FootPlants image{{plants.plants[kRight], plants.plants[kLeft]}, plants.frames};
  const auto here = gaitPhase(plants), there = gaitPhase(image);
  ASSERT_EQ(here.size(), there.size());
  ASSERT_GE(here.size(), 2u);
  for (size_t i = 0; i < here.size(); ++i) {
    EXPECT_EQ(here[i].frame, there[i].frame);
    EXPECT_LT(here[i].frame, 140.0);
  }
}

}  // namespace
}  // namespace amble

#include "animation/grafting/plant_correlation.h"

#include <gtest/gtest.h>

#include "tests/animation/grafting/graft_sources.h"

namespace amble {
namespace {

std::vector<Correlation> correlated(const LocomotiveClip& base, const LocomotiveClip& upper) {
  return correlate(base, upper, {stretchOf(base), stretchOf(upper)});
}

TEST(PlantCorrelation, AClipGoesWithItselfFrameByFrame) {
  AMBLE_NEEDS_CAPTURES();
  for (const char* const path : {kWalk, kRun, kJump}) {
    const LocomotiveClip& clip = graftSource(path);
    const Correlation best = correlated(clip, clip).front();
    EXPECT_EQ(best.shift, 0) << path;
    EXPECT_EQ(best.mismatch, 0.0) << path;
    const TimeWarp warp(best);
    for (int i = best.first; i <= best.last; ++i) EXPECT_NEAR(warp.at(i), i, 1e-9) << path;
  }
}

TEST(PlantCorrelation, OfferedAreAlternativesAStepApartThoseWhoseLegsAgreeFirst) {
  AMBLE_NEEDS_CAPTURES();
  const auto all = correlated(graftSource(kLongWalk), graftSource("cmu_mb2/07_01.bvh"));
  ASSERT_GE(all.size(), 4u);
  bool aside = false;
  for (const Correlation& each : all) {
    aside = aside || !each.same_foot;
    EXPECT_NE(each.same_foot, aside) << "left with left comes before left with right";
    EXPECT_EQ(each.same_foot, each.mismatch < 0.3) << each.mismatch;
  }
  EXPECT_TRUE(aside);
}

TEST(PlantCorrelation, TimeGoesForwardsInEveryAlternative) {
  AMBLE_NEEDS_CAPTURES();
  for (const auto& [base, upper] : {std::pair(kWalk, kRun), std::pair(kRun, kLongWalk)}) {
    for (const Correlation& each : correlated(graftSource(base), graftSource(upper))) {
      const TimeWarp warp(each);
      for (int i = each.first; i < each.last; ++i) EXPECT_LT(warp.at(i), warp.at(i + 1));
      EXPECT_NEAR(warp.at(each.moments[1].base), each.moments[1].upper, 1e-9);
    }
  }
}

TEST(PlantCorrelation, OfStandsTimeGoesOnAlike) {
  AMBLE_NEEDS_CAPTURES();
  const LocomotiveClip &base = graftSource(kLongWalk), &upper = graftSource(kStand);
  const auto all = correlated(base, upper);
  ASSERT_EQ(all.size(), 1u);
  const TimeWarp warp(all[0]);
  EXPECT_NEAR((warp.at(70) - warp.at(10)) * upper.clip.frame_time, 60 * base.clip.frame_time, 1e-9);
}

// A skip flies, but no two of its steps are a run's: there is nothing to match.
TEST(PlantCorrelation, WithoutTwoStepsInARowNothingGoesTogether) {
  AMBLE_NEEDS_CAPTURES();
  const LocomotiveClip& skip = graftSource("accad_female1/Female1_A13_Skipping.bvh");
  EXPECT_TRUE(correlated(graftSource(kLongWalk), skip).empty());
  MotionStretch moment = stretchOf(graftSource(kStand));
  moment.last = moment.first;
  EXPECT_TRUE(correlate(graftSource(kLongWalk), graftSource(kStand),
                        {stretchOf(graftSource(kLongWalk)), moment})
                  .empty());
}

}  // namespace
}  // namespace amble

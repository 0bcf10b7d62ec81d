#include "animation/steps/sole_phase.h"

#include <gtest/gtest.h>

namespace amble {
namespace {

SolePhase phaseAt(double at) {
  FootState foot;
  foot.at = at;
  return solePhase(foot);
}

TEST(SolePhase, OfAStandingFootIsPlanted) {
  for (const double at : {0.0, 0.5, 1.0}) EXPECT_EQ(phaseAt(at), SolePhase::kPlanted) << at;
}

TEST(SolePhase, IsBesideTheGroundForATenthOfASwingAtBothEnds) {
  for (const double at : {1.001, 1.099, 1.901, 2.0})
    EXPECT_EQ(phaseAt(at), SolePhase::kBeside) << at;
  for (const double at : {1.101, 1.5, 1.899}) EXPECT_EQ(phaseAt(at), SolePhase::kSwinging) << at;
}

}  // namespace
}  // namespace amble

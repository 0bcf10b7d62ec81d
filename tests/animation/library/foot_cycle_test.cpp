#include "animation/library/foot_cycle.h"

#include <gtest/gtest.h>

namespace amble {
namespace {

FootCycle drawn(double strike, double pitch) {
  FootCycle foot;
  foot.strike = strike;
  foot.lift_off = strike + 0.6;
  if (foot.lift_off >= 1.0) foot.lift_off -= 1.0;
  foot.progress = {0.4, -0.2, 0.1, 0.3};
  foot.height = {1.0, 0.5, -0.4, 0.2};
  for (int i = 0; i < FootCycle::kStanceSamples + FootCycle::kSwingSamples; ++i) {
    foot.pitch.push_back(pitch * i * i);
  }
  return foot;
}

TEST(FootCycle, SwingsBeginAndEndAtRestOnTheirPrints) {
  const FootCycle foot = drawn(0.1, 0.0);
  constexpr double kStep = 1e-6;
  for (const double end : {0.0, 1.0}) {
    const double inside = end == 0.0 ? kStep : 1.0 - kStep;
    EXPECT_NEAR(swingProgress(foot, end), end, 1e-15);
    EXPECT_NEAR((swingProgress(foot, inside) - end) / kStep, 0.0, 1e-4);
    EXPECT_EQ(swingPolynomial(foot.height, end), 0.0);
    EXPECT_NEAR(swingPolynomial(foot.height, inside) / kStep, 0.0, 1e-4);
  }
}

TEST(FootCycle, PitchGoesThroughItsSamplesAndRepeats) {
  const FootCycle foot = drawn(0.1, 0.001);
  for (int i = 0; i < FootCycle::kStanceSamples; ++i) {
    EXPECT_NEAR(footPitch(foot, static_cast<double>(i) / FootCycle::kStanceSamples), foot.pitch[i],
                1e-12);
  }
  for (int i = 0; i < FootCycle::kSwingSamples; ++i) {
    EXPECT_NEAR(footPitch(foot, 1.0 + static_cast<double>(i) / FootCycle::kSwingSamples),
                foot.pitch[FootCycle::kStanceSamples + i], 1e-12);
  }
  EXPECT_NEAR(footPitch(foot, 2.0), footPitch(foot, 0.0), 1e-12);
}

TEST(FootCycle, TheMeanOfPhasesGoesTheShorterWayAroundTheCycle) {
  const FootCycle mean = meanFoot({drawn(0.98, 0.0), drawn(0.02, 0.0)});
  EXPECT_NEAR(mean.strike < 0.5 ? mean.strike : mean.strike - 1.0, 0.0, 1e-12);
  EXPECT_NEAR(mean.lift_off, 0.6, 1e-12);
}

TEST(FootCycle, TheMeanOfEqualFeetIsTheFoot) {
  const FootCycle foot = drawn(0.3, 0.002), mean = meanFoot({foot, foot, foot});
  EXPECT_NEAR(mean.strike, foot.strike, 1e-12);
  for (int k = 0; k < 4; ++k) EXPECT_NEAR(mean.progress[k], foot.progress[k], 1e-12);
  for (size_t i = 0; i < foot.pitch.size(); ++i) EXPECT_NEAR(mean.pitch[i], foot.pitch[i], 1e-12);
}

}  // namespace
}  // namespace amble

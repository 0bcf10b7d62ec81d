#include "animation/library/foot_cycle.h"

#include <gtest/gtest.h>

#include <cmath>

namespace amble {
namespace {

FootCycle drawn(double strike, double pitch) {
  FootCycle foot;
  foot.strike = strike;
  foot.lift_off = strike + 0.6;
  if (foot.lift_off >= 1.0) foot.lift_off -= 1.0;
  foot.progress = {0.4, -0.2, 0.1, 0.3};
  foot.height = {1.0, 0.5, -0.4, 0.2};
  for (int k = 0; k < FootCycle::kToeSplines; ++k) foot.toes[k] = 0.01 * k;
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

// Splines of one height are that height where they all are, and nothing before and after.
TEST(FootCycle, ToesRollAsTheirSplinesSay) {
  FootCycle foot = drawn(0.1, 0.0);
  foot.toes.fill(0.3);
  constexpr int kSamples = FootCycle::kStanceSamples, kFrom = FootCycle::kToesFrom;
  constexpr int kLast = kFrom + FootCycle::kToeSplines - 1;
  for (double i = 0.0; i < 2.0 * kSamples; i += 0.25) {
    const double roll = toeRoll(foot, i / kSamples);
    const bool inside = i >= kFrom + 1 && i <= kLast - 1;
    const bool outside = i <= kFrom - 2 || i >= kLast + 2;
    EXPECT_GE(roll, outside ? 0.0 : inside ? 0.3 - 1e-12 : 1e-6) << i;
    EXPECT_LE(roll, outside ? 0.0 : 0.3 + 1e-12) << i;
  }
}

// Twice differentiable, and no lower than the ground: what is not negative at splines is not
// between them.
TEST(FootCycle, ToesRollSmoothlyWhateverTheirSplines) {
  FootCycle foot = drawn(0.1, 0.0);
  for (int k = 0; k < FootCycle::kToeSplines; ++k) foot.toes[k] = k % 3 == 0 ? 0.5 : 0.0;
  constexpr double kStep = 1e-4, kMost = 0.5 * 32.0 * 32.0 * 4.0;  // of the second slope
  for (double x = 0.7; x < 1.5; x += 0.001) {
    const double before = toeRoll(foot, x - kStep), here = toeRoll(foot, x);
    const double after = toeRoll(foot, x + kStep);
    EXPECT_GE(here, 0.0);
    EXPECT_LT(std::abs(before - 2.0 * here + after), kMost * kStep * kStep) << x;
  }
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
  for (size_t k = 0; k < foot.toes.size(); ++k) EXPECT_NEAR(mean.toes[k], foot.toes[k], 1e-12);
}

}  // namespace
}  // namespace amble

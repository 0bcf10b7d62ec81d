#include "animation/library/frequency_law.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace amble {
namespace {

std::vector<FrequencySample> on(const FrequencyLaw& law, const std::vector<double>& speeds) {
  std::vector<FrequencySample> samples;
  for (const double V : speeds) samples.push_back({V, law(V)});
  return samples;
}

TEST(FrequencyLaw, GlardonsEquationsAreThese) {
  EXPECT_NEAR(kInmanLaw(4.0), 0.743 * 2.0, 1e-12);
  EXPECT_NEAR(kGlardonLaw(32.0), 0.85 * 4.0, 1e-12);
  EXPECT_EQ(kInmanLaw(0.0), 0.0);
}

TEST(FrequencyLaw, AFitGivesBackTheLawThatItsSamplesAreOn) {
  for (const FrequencyLaw& law : {kInmanLaw, kGlardonLaw, FrequencyLaw{0.6, 0.58}}) {
    const FrequencyFit fit = fitFrequencyLaw(on(law, {0.8, 1.2, 1.7, 2.4}));
    EXPECT_TRUE(fit.own_power);
    EXPECT_NEAR(fit.law.factor, law.factor, 1e-12);
    EXPECT_NEAR(fit.law.power, law.power, 1e-12);
    EXPECT_NEAR(fit.residual, 0.0, 1e-12);
    EXPECT_EQ(fit.samples, 4);
  }
}

TEST(FrequencyLaw, WalksOfOneSpeedKeepInmansPower) {
  for (const auto& samples : {on(kGlardonLaw, {1.5}), on(kGlardonLaw, {1.49, 1.5, 1.51})}) {
    const FrequencyFit fit = fitFrequencyLaw(samples);
    EXPECT_FALSE(fit.own_power);
    EXPECT_EQ(fit.law.power, kInmanLaw.power);
    EXPECT_NEAR(fit.law(1.5), kGlardonLaw(1.5), 1e-4);
  }
}

TEST(FrequencyLaw, TheResidualIsTheRelativeError) {
  std::vector<FrequencySample> samples = on(kInmanLaw, {1.0, 1.0, 2.0, 2.0});
  for (size_t i = 0; i < samples.size(); ++i) samples[i].frequency *= i % 2 == 0 ? 1.01 : 1 / 1.01;
  EXPECT_NEAR(fitFrequencyLaw(samples).residual, std::log(1.01), 1e-12);
}

TEST(FrequencyLaw, BiasSaysByHowMuchALawIsTooHigh) {
  EXPECT_NEAR(lawBias({1.1 * 0.743, 0.5}, on(kInmanLaw, {0.7, 1.9})), 0.1, 1e-12);
  EXPECT_EQ(lawBias(kInmanLaw, {}), 0.0);
}

}  // namespace
}  // namespace amble

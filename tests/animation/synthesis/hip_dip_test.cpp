#include "animation/synthesis/hip_dip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace amble {
namespace {

constexpr double kFrameTime = 1.0 / 60.0;

/// Something is missing around the middle of two seconds.
std::vector<double> bump(double first, double last) {
  std::vector<double> missing(121, 0.0);
  for (int i = 45; i < 75; ++i) missing[i] = 0.03;
  missing.front() = first;
  missing.back() = last;
  return missing;
}

TEST(HipDip, WhereNothingIsMissingNothingIsLowered) {
  for (const double dip : hipDip(std::vector<double>(30, 0.0), kFrameTime)) EXPECT_EQ(dip, 0.0);
}

TEST(HipDip, AStanceIsLoweredByWhatIsMissingThereToTheBit) {
  for (const auto& [first, last] : {std::pair(0.0, 0.0), {0.01, 0.0}, {0.0, 0.07}, {0.04, 0.02}}) {
    const std::vector<double> dip = hipDip(bump(first, last), kFrameTime);
    EXPECT_EQ(dip.front(), first);
    EXPECT_EQ(dip.back(), last);
  }
  EXPECT_EQ(hipDip({0.05}, kFrameTime), std::vector<double>{0.05});
}

TEST(HipDip, AwayFromStancesAllThatIsMissingIsCovered) {
  const std::vector<double> missing = bump(0.02, 0.0), dip = hipDip(missing, kFrameTime);
  for (size_t i = 10; i < 110; ++i) EXPECT_GE(dip[i], missing[i] - 1e-15) << i;
  EXPECT_LE(*std::ranges::max_element(dip), givenWay(0.03) + 1e-12);  // and no more than that
}

// The more is missing the farther beyond it, but by less than half of it, and no more than is told.
TEST(HipDip, HipsGiveWayByMoreThanIsMissing) {
  EXPECT_EQ(givenWay(0.0), 0.0);
  for (double missing = 0.001; missing < HipDip::kDeepest; missing += 0.001) {
    const double more = givenWay(missing) - missing;
    EXPECT_GT(more, 0.0);
    EXPECT_LT(more, std::min(0.5 * missing, HipDip::kMore));
    EXPECT_GT(more, givenWay(0.99 * missing) - 0.99 * missing);
  }
}

// Twice as finely sampled it is the same curve, and its acceleration is bounded.
TEST(HipDip, TheCurveIsSmooth) {
  const std::vector<double> dip = hipDip(bump(0.02, 0.0), kFrameTime);
  for (size_t i = 1; i + 1 < dip.size(); ++i) {
    const double bend = dip[i - 1] - 2.0 * dip[i] + dip[i + 1];
    EXPECT_LT(std::abs(bend) / (kFrameTime * kFrameTime), 12.0) << i;  // [m/s^2], of 3 cm in 0.16 s
  }
}

// What legs lack at a distance does not lower the hips up to the frame beside a stance, from which
// they would leap.
TEST(HipDip, HipsComeBackToAStanceInTheTimeThatLegsLeaveThem) {
  for (const int away : {6, 9, 12, 15}) {
    std::vector<double> missing(121, 0.0);
    for (int i = 0; i < 8; ++i) missing[missing.size() - 1 - away - i] = 0.006;
    const std::vector<double> dip = hipDip(missing, kFrameTime);
    for (size_t i = 1; i + 1 < dip.size(); ++i) {
      const double bend = dip[i - 1] - 2.0 * dip[i] + dip[i + 1];
      EXPECT_LT(std::abs(bend) / (kFrameTime * kFrameTime), 5.0) << away << " at " << i;
      EXPECT_GE(dip[i] + 0.0005, missing[i]) << away << " at " << i;
    }
    EXPECT_LT(dip[dip.size() - 2], 0.001);
  }
}

TEST(HipDip, RunBackwardsItIsTheSameBackwards) {
  std::vector<double> missing = bump(0.02, 0.01);
  missing[20] = 0.015;
  const std::vector<double> dip = hipDip(missing, kFrameTime);
  std::ranges::reverse(missing);
  std::vector<double> back = hipDip(missing, kFrameTime);
  std::ranges::reverse(back);
  for (size_t i = 0; i < dip.size(); ++i) EXPECT_NEAR(dip[i], back[i], 1e-12) << i;
}

}  // namespace
}  // namespace amble

#include "animation/editing/root_rise.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "tests/animation/editing/edited_walks.h"

namespace amble {
namespace {

TEST(RootRise, TheRatioIsThatOfTheThesisFalls) {
  const double leg = 0.9, stride = 0.7;
  // Eq. 6.1 by hand, for 0.7 m and 0.84 m.
  const double captured = 0.9 - std::sqrt(0.81 - 0.1225), longer = 0.9 - std::sqrt(0.81 - 0.1764);
  EXPECT_NEAR(riseRatio(stride, 1.2, leg), longer / captured, 1e-12);
  EXPECT_DOUBLE_EQ(riseRatio(stride, 1.0, leg), 1.0);
  // What short steps come near to: the fall goes with the square.
  EXPECT_NEAR(riseRatio(0.0, 1.3, leg), 1.69, 1e-12);
  EXPECT_NEAR(riseRatio(0.0901, 1.3, leg), 1.69, 0.01);
}

/// The mean over steps of the root's lowest height, of what `height` gives at each frame, and its
/// highest before it [m].
double bobbing(const GaitMeasures& gait, const std::function<double(size_t)>& height,
               double frame_time) {
  double sum = 0.0;
  int count = 0;
  for (size_t k = 1; k < gait.steps.size(); ++k) {
    double low = 1e9, high = -1e9;
    const double from = gait.steps[k - 1].strike + 0.25 * gait.steps[k].duration;
    for (double t = from; t < from + gait.steps[k].duration; t += frame_time) {
      const double z = height(static_cast<size_t>(t / frame_time));
      low = std::min(low, z);
      high = std::max(high, z);
    }
    sum += high - low;
    ++count;
  }
  return sum / count;
}

TEST(RootRise, ItIsAChangeOfTheCapturedBobbingInTheRatioOfTheFalls) {
  AMBLE_NEEDS_CAPTURES();
  const CapturedWalk walk = capturedWalk("mocap/accad_male1/Male1_B3_Walk.bvh");
  const GaitMeasures& gait = walk.analysis.gait;
  const double frame_time = walk.clip.frame_time;
  const WalkTracks captured = tracksOf(walk.clip, walk.roles);
  const double before = bobbing(
      gait, [&](size_t i) { return captured.root[i].z(); }, frame_time);
  for (const double factor : {0.7, 1.3}) {
    WalkTracks tracks = captured;
    riseWithStride(
        walk, [&](int) { return factor; }, tracks);
    const double change = bobbing(
        gait, [&](size_t i) { return tracks.root[i].z() - captured.root[i].z(); }, frame_time);
    const double ratio = riseRatio(gait.step_length, factor, 1.08 * gait.leg_length);
    EXPECT_NEAR(change / before, std::abs(ratio - 1.0), 0.2 * std::abs(ratio - 1.0)) << factor;
  }
}

TEST(RootRise, OverTheStandingFootTheRootStays) {
  AMBLE_NEEDS_CAPTURES();
  const CapturedWalk walk = capturedWalk("mocap/accad_male1/Male1_B3_Walk.bvh");
  const WalkTracks captured = tracksOf(walk.clip, walk.roles);
  WalkTracks tracks = captured;
  riseWithStride(
      walk, [](int) { return 1.3; }, tracks);
  double lowest = 0.0, highest = -1.0, jump = 0.0;
  for (size_t i = 0; i < tracks.root.size(); ++i) {
    const double change = tracks.root[i].z() - captured.root[i].z();
    lowest = std::min(lowest, change);
    highest = std::max(highest, change);
    if (i == 0) continue;
    const double last = tracks.root[i - 1].z() - captured.root[i - 1].z();
    jump = std::max(jump, std::abs(change - last));
  }
  EXPECT_LT(lowest, -0.01);
  EXPECT_NEAR(highest, 0.0, 1e-4);
  EXPECT_LT(jump, 0.012);
}

}  // namespace
}  // namespace amble

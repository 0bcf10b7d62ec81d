#include "animation/synthesis/engine_walk.h"

#include <gtest/gtest.h>

#include "animation/analysis/clip_analysis.h"
#include "animation/preparation/speed_engine_fit.h"
#include "tests/animation/captures.h"
#include "tests/animation/drawn_engine.h"

namespace amble {
namespace {

EngineWalkRequest steady(double speed) {
  EngineWalkRequest request;
  request.speed = [speed](double) { return speed; };
  return request;
}

TEST(EngineWalk, TheRootGoesAsFarAsTheSpeedSaysAndThePhaseAsTheCadenceDoes) {
  const DrawnEngine drawn;
  const SpeedEngine engine(drawn.data({0.6, 1.2, 1.8}));
  EngineWalkRequest request = steady(1.5);
  EngineWalk walk = engineWalk(engine, request);
  EXPECT_EQ(walk.clip.frames(), 301);
  EXPECT_NEAR(walk.length, 1.5 * 5.0, 1e-9);
  EXPECT_NEAR(walk.phases.back(), 5.0 * drawn.frequency(1.5), 1e-9);
  request.speed = [](double time) { return 0.6 + 0.2 * time; };
  walk = engineWalk(engine, request);
  EXPECT_NEAR(walk.length, 0.6 * 5.0 + 0.1 * 25.0, 1e-9);
  EXPECT_NEAR(walk.clip.poses.p_WR(300).x() - walk.clip.poses.p_WR(0).x(), walk.length, 0.05);
  for (size_t i = 1; i < walk.speeds.size(); ++i) EXPECT_GT(walk.speeds[i], walk.speeds[i - 1]);
}

TEST(EngineWalk, OneWhoIsTallerTakesLongerStepsAtTheSameCadenceAndScaledSpeed) {
  const SpeedEngine engine(DrawnEngine().data({0.6, 1.2, 1.8}));
  const EngineWalk own = engineWalk(engine, steady(1.0));
  EngineWalkRequest request = steady(1.2);
  request.scale = 1.2;
  const EngineWalk tall = engineWalk(engine, request);
  EXPECT_NEAR(tall.phases.back(), own.phases.back(), 1e-9);
  EXPECT_NEAR(tall.length, 1.2 * own.length, 1e-9);
  EXPECT_NEAR(tall.clip.poses.p_WR(7).z(), 1.2 * own.clip.poses.p_WR(7).z(), 1e-9);
}

/// Frames in which a foot swings from where it is seen to leave to where it is seen to come down.
std::vector<std::array<int, 2>> swingsOf(const std::vector<bool>& planted) {
  std::vector<std::array<int, 2>> swings;
  int left = -1;
  for (int i = 1; i < static_cast<int>(planted.size()); ++i) {
    if (planted[i - 1] && !planted[i]) left = i;
    if (!planted[i - 1] && planted[i] && left >= 0) swings.push_back({left, i});
  }
  return swings;
}

TEST(EngineWalk, FeetStandByTheCapturedTimingUnlessTheWalkSlowsDownBelowTheSlowestCapture) {
  const SpeedEngine engine(DrawnEngine().data({0.6, 1.2, 1.8}));
  for (const auto& [from, to] : {std::array{0.2, 0.2}, {0.0, 1.5}, {1.7, 0.7}}) {
    EngineWalkRequest request;
    request.speed = [from, to](double time) { return from + (to - from) * time / 5.0; };
    const EngineWalk walk = engineWalk(engine, request);
    for (const Side side : {kLeft, kRight}) {
      for (int i = 0; i < walk.clip.frames(); ++i) {
        EXPECT_EQ(walk.planted[side][i], engine.planted(walk.speeds[i], walk.phases[i], side));
      }
    }
  }
}

TEST(EngineWalk, WhoComesToAStandPutsAFootDownSoonerByAsMuchAsHeIsSlower) {
  const SpeedEngine engine(DrawnEngine().data({0.6, 1.2, 1.8}));
  int sooner = 0;
  for (const double begin : {0.5, 0.55, 0.6}) {
    EngineWalkRequest request;
    request.speed = [begin](double time) { return std::max(0.0, begin * (1.0 - time / 4.0)); };
    const EngineWalk walk = engineWalk(engine, request);
    for (const Side side : {kLeft, kRight}) {
      for (const auto& [first, last] : swingsOf(walk.planted[side])) {
        const double at = walk.speeds[first - 1];
        const std::array<double, 2> both = engine.support(at);
        const double usual = (0.5 - 0.5 * (both[0] + both[1])) / engine.frequency(at);
        const double swung = (last - first) * request.frame_time;
        EXPECT_LT(swung, usual * walk.speeds[last - 1] / at + 1.01 * request.frame_time);
        sooner += !engine.planted(walk.speeds[last], walk.phases[last], side);
      }
    }
  }
  EXPECT_GT(sooner, 3);
}

// At a speed between the captured ones, and while it rises.
TEST(EngineWalk, FeetSlideNoMoreThanCapturesDoAndStandAsLongAsIsSaid) {
  AMBLE_NEEDS_CAPTURES();
  EngineRequest captures;
  for (const char* clip : {"07_01.bvh", "07_03.bvh", "07_06.bvh", "07_10.bvh", "07_12.bvh"}) {
    captures.captures.push_back({sharedFolder() / "mocap/cmu_mb2" / clip, {}, clip, "", ""});
  }
  const SpeedEngine engine(fitSpeedEngine(captures));
  for (const double faster : {0.0, 0.15}) {
    EngineWalkRequest request;
    request.duration = 4.0;
    request.speed = [faster](double time) { return 1.1 + faster * time; };
    const EngineWalk walk = engineWalk(engine, request);
    const ClipAnalysis seen = analyseClip(walk.clip, engine.data().roles);
    EXPECT_EQ(seen.kind.largest(), MotionType::kWalk);
    EXPECT_LT(seen.gait.toe_skate, 0.106);  // QUALITY.md: CMU walks
    EXPECT_EQ(seen.gait.knee_backwards, 0.0);
    EXPECT_LT(seen.gait.pops, 2.5);
    int alike = 0;
    for (const Side side : {kLeft, kRight}) {
      for (int i = 0; i < walk.clip.frames(); ++i) {
        alike += walk.planted[side][i] == seen.plants.planted(side, i);
      }
    }
    EXPECT_GT(alike, 0.93 * 2 * walk.clip.frames());
  }
}

TEST(EngineWalk, OneWhoSpeedsUpFromStandingWalksAndThenRuns) {
  AMBLE_NEEDS_CAPTURES();
  EngineRequest captures;
  for (const char* clip : {"02_01.bvh", "02_03.bvh"}) {
    captures.captures.push_back({sharedFolder() / "mocap/cmu_mb2" / clip, {}, clip, "", ""});
  }
  const SpeedEngine engine(fitSpeedEngine(captures));
  EngineWalkRequest request;
  request.duration = 8.0;
  request.speed = [](double time) { return 0.35 * time; };
  const EngineWalk walk = engineWalk(engine, request);
  const ClipAnalysis seen = analyseClip(walk.clip, engine.data().roles);
  EXPECT_EQ(seen.kind.frames[180], MotionType::kWalk);
  EXPECT_EQ(seen.kind.frames[450], MotionType::kRun);
  EXPECT_LT(seen.gait.pops, 2.5);
}

}  // namespace
}  // namespace amble

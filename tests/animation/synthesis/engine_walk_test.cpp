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

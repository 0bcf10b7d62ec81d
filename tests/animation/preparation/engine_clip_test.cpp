#include "animation/preparation/engine_clip.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "tests/animation/drawn_engine.h"

namespace amble {
namespace {

void expectNoWalk(const SpeedEngine& engine, double speed, const std::string& problem,
                  const std::string& expected) {
  try {
    walkOfEngine(engine, speed, "anna.yaml");
    FAIL() << speed;
  } catch (const InputError& error) {
    EXPECT_EQ(error.file(), "anna.yaml");
    EXPECT_NE(error.problem().find(problem), std::string::npos) << error.what();
    EXPECT_NE(error.expected().find(expected), std::string::npos) << error.what();
  }
}

TEST(WalkOfEngine, RunsAndSpeedsThatNobodyWalkedAtAreRefusedByName) {
  const DrawnEngine drawn;
  expectNoWalk(SpeedEngine(drawn.data({}, {2.5, 3.0})), 2.5, "holds runs and no walk", "walks");
  const SpeedEngine both(drawn.data({0.8, 1.2}, {2.5}));
  expectNoWalk(both, 1.8, "1.8 m/s is no walk but, in part, a run", "0.3 to 1.2 m/s");
  expectNoWalk(both, 2.6, "2.6 m/s is beyond what was captured", "0.3 to 1.2 m/s");
  expectNoWalk(both, 0.2, "0.2 m/s is slower than plans walk", "0.3 to 1.2 m/s");
  EXPECT_NO_THROW(walkOfEngine(both, 0.3, "anna.yaml"));
  EXPECT_NO_THROW(walkOfEngine(both, 1.2, "anna.yaml"));
}

// Where walks were captured faster than runs, people change from one to the other between them.
TEST(WalkOfEngine, WalksNoFasterThanItBeginsToRun) {
  const SpeedEngine engine(DrawnEngine().data({0.8, 1.2, 2.0}, {1.6, 3.0}));
  EXPECT_NO_THROW(walkOfEngine(engine, engine.fastestWalk(), "anna.yaml"));
  expectNoWalk(engine, engine.fastestWalk() + 0.01, "in part, a run", "0.3 to 1.71 m/s");
}

TEST(WalkOfEngine, IsTheEnginesCycleOverAndOver) {
  const SpeedEngine engine(DrawnEngine().data({0.8, 1.0, 1.5}));
  Pose pose;
  pose.rotations.resize(engine.joints());
  for (const double speed : {0.5, 0.9, 1.5}) {
    const WalkOfEngine walk = walkOfEngine(engine, speed, "");
    const Clip& clip = walk.capture.motion.clip;
    EXPECT_NEAR(clip.frame_time * kEnginePhases * engine.frequency(speed), 1.0, 1e-12);
    EXPECT_GE(clip.frames(), 3 * kEnginePhases);
    for (int i = 0; i < clip.frames(); ++i) {
      const double phase = static_cast<double>(i) / kEnginePhases;
      engine.poseAt(speed, phase, pose);
      pose.p_WR.x() += speed * i * clip.frame_time;
      EXPECT_LT((clip.poses.p_WR(i) - pose.p_WR).norm(), 1e-9);
      for (int j = 0; j < engine.joints(); ++j) {
        EXPECT_LT(clip.poses.rotations(i)[j].angularDistance(pose.rotations[j]), 1e-7);
      }
      for (const Side side : {kLeft, kRight}) {
        const bool before = engine.planted(speed, phase - 1e-6, side);
        if (engine.planted(speed, phase + 1e-6, side) != before) continue;  // it lands, or leaves
        EXPECT_EQ(walk.plants.planted(side, i), before) << speed << " m/s, frame " << i;
      }
    }
  }
}

TEST(WalkOfEngine, NamesEachOfItsCapturesLicencesOnce) {
  EngineData data = DrawnEngine().data({0.8, 1.0, 1.2});
  data.walk->clips[0].source.licence = "CC BY 3.0";
  data.walk->clips[1].source.licence = "CC0";
  data.walk->clips[2].source.licence = "CC BY 3.0";
  const WalkOfEngine walk = walkOfEngine(SpeedEngine(data), 1.0, "");
  EXPECT_EQ(walk.licence, "CC BY 3.0; CC0");
  EXPECT_EQ(walk.credit, "none");
}

}  // namespace
}  // namespace amble

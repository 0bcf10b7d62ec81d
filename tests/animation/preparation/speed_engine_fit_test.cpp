#include "animation/preparation/speed_engine_fit.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "animation/library/harmonics.h"
#include "animation/preparation/motion_library_add.h"
#include "base/error.h"
#include "tests/animation/engine_library.h"

namespace amble {
namespace {

TEST(FitSpeedEngine, WhoStandsOnlyAndWhoDoesNeitherAreRefusedByName) {
  AMBLE_NEEDS_CAPTURES();
  for (const char* clip : {"accad_female1/Female1_A01_Stand.bvh", "cmu_mb2/02_04.bvh"}) {
    try {
      fitSpeedEngine(engineRequestOf({clip}));
      FAIL() << clip;
    } catch (const InputError& error) {
      EXPECT_NE(error.file().find(clip), std::string::npos) << error.what();
    }
  }
}

TEST(FitSpeedEngine, ACaptureWithoutASteadyCycleIsLeftOutAndSaid) {
  AMBLE_NEEDS_CAPTURES();
  std::vector<std::string> warnings;
  const EngineData engine =
      fitSpeedEngine(engineRequestOf({"cmu_mb2/02_01.bvh", "cmu_mb2/02_04.bvh"}), &warnings);
  EXPECT_EQ(engine.walk->clips.size(), 1u);
  ASSERT_FALSE(warnings.empty());
  EXPECT_NE(warnings[0].find("02_04.bvh"), std::string::npos);
  EXPECT_NE(warnings[0].find("left out"), std::string::npos);
}

TEST(FitSpeedEngine, ComponentsAreAsFewAsKeepTheVarianceAndStandUpright) {
  AMBLE_NEEDS_CAPTURES();
  const GaitSpace space = *fitSpeedEngine(engineRequestOf(kWalksOf07)).walk;
  EXPECT_GE(space.variance(), 0.8);
  ASSERT_GE(space.components.size(), 2u);  // Glardon: two to four
  EXPECT_LT(space.variance() - space.components.back().share, 0.8);
  for (size_t i = 0; i < space.components.size(); ++i) {
    if (i > 0) {
      EXPECT_LE(space.components[i].share, space.components[i - 1].share);
    }
    for (size_t k = 0; k <= i; ++k) {
      const double dot =
          space.components[i].direction.cwiseProduct(space.components[k].direction).sum();
      EXPECT_NEAR(dot, i == k ? 1.0 : 0.0, 1e-6);
    }
  }
}

// Root mean squares of the clips that have others slower and faster: MANIFEST's CMU 07 and 08.
TEST(FitSpeedEngine, AClipThatItHasNotSeenIsMetBetterThanByTheClipNextToIt) {
  AMBLE_NEEDS_CAPTURES();
  LeftOut mean;
  int count = 0;
  for (const auto& clips : {kWalksOf07, kWalksOf08}) {
    const EngineData engine = fitSpeedEngine(engineRequestOf(clips));
    ASSERT_EQ(engine.walk->clips.size(), clips.size());
    for (const EngineClip& clip : engine.walk->clips) {
      ASSERT_TRUE(clip.left_out);
      EXPECT_LT(clip.left_out->legs, clip.left_out->nearest_legs) << clip.source.clip;
      if (!clip.left_out->between) continue;
      mean.joints += clip.left_out->joints;
      mean.legs += clip.left_out->legs;
      mean.nearest_joints += clip.left_out->nearest_joints;
      ++count;
    }
  }
  EXPECT_LT(mean.joints / count, 5.0 * kDegree);
  EXPECT_LT(mean.legs / count, 3.8 * kDegree);
  EXPECT_LT(mean.joints, mean.nearest_joints);
}

TEST(FitSpeedEngine, AnEngineOfOneWalkGivesTheCycleThatALibraryHasOfIt) {
  AMBLE_NEEDS_CAPTURES();
  MotionRequest request;
  request.name = "walk";
  request.file = sharedFolder() / "mocap/cmu_mb2/02_01.bvh";
  request.harmonics = kMaxHarmonics;
  MotionLibrary library;
  addMotion(library, request);
  const WalkCycle& cycle = library.find("walk")->cycle;
  const SpeedEngine engine(fitSpeedEngine(engineRequestOf({"cmu_mb2/02_01.bvh"})));
  const double speed = engine.fastest();
  EXPECT_NEAR(speed, cycle.speed, 0.005 * cycle.speed);
  EXPECT_NEAR(engine.frequency(speed), 1.0 / cycle.period, 0.005 / cycle.period);
  EXPECT_NEAR(engine.data().walk->step_width.at(speed), cycle.step_width, 1e-6);
  for (const Side side : {kLeft, kRight}) {
    EXPECT_NEAR(engine.data().walk->toe_out[side].at(speed), cycle.toe_out[side], 1e-6);
    // The second double support is at 0.5 exactly, as poses have it.
    EXPECT_TRUE(engine.planted(speed, cycle.feet[side].strike + 0.02, side));
    EXPECT_FALSE(engine.planted(speed, cycle.feet[side].strike - 0.02, side));
    EXPECT_TRUE(engine.planted(speed, cycle.feet[side].lift_off - 0.02, side));
    EXPECT_FALSE(engine.planted(speed, cycle.feet[side].lift_off + 0.02, side));
  }
  Eigen::MatrixXd samples;
  engine.cycleAt(speed, samples);
  for (const double phase : {0.0, 0.1, 0.2, 0.5, 0.71}) {
    const Eigen::VectorXd of_library = fourierAt(cycle.series, phase);
    const Eigen::VectorXd of_engine = samples.col(std::lround(phase * kEnginePhases));
    EXPECT_LT((of_engine - of_library).head<3>().norm(), 1e-3);
    for (int j = 0; j < engine.joints(); ++j) {
      const Eigen::Quaterniond a =
          library.stand().rotations[j] * expRotation(of_library.segment<3>(3 + 3 * j));
      const Eigen::Quaterniond b =
          engine.data().mean_posture[j] * expRotation(of_engine.segment<3>(3 + 3 * j));
      EXPECT_LT(a.angularDistance(b), 0.3 * kDegree) << j << " at " << phase;
    }
  }
}

// As games have them: who walked on from its last frame would walk it once more.
TEST(FitSpeedEngine, ALoopOfOneCycleIsACaptureAsAnyOther) {
  AMBLE_NEEDS_CAPTURES();
  for (const char* const clip : {"cmu_style_loops/142_08_EDIT_LOOP.bvh", "formats/mass_walk.bvh"}) {
    const LevelCapture capture = readForLibrary(sharedFolder() / "mocap" / clip, {});
    const Clip& level = capture.motion.clip;
    const int last = level.frames() - 1;
    const double period = last * level.frame_time;
    const double way = (level.poses.p_WR(last) - level.poses.p_WR(0)).head<2>().norm();
    const EngineData engine = fitSpeedEngine(engineRequestOf({clip}));
    ASSERT_TRUE(engine.walk) << clip;
    const GaitSpace& space = *engine.walk;
    ASSERT_EQ(space.clips.size(), 1u) << clip;
    EXPECT_NEAR(space.clips[0].frequency, 1.0 / period, 0.01 / period) << clip;
    EXPECT_NEAR(space.clips[0].speed, way / period, 0.02 * way / period) << clip;
    EXPECT_EQ(space.clips[0].source.frames[1], capture.first_frame + last) << clip;
  }
}

TEST(FitSpeedEngine, RunsFlyAndAreASpaceOfTheirOwn) {
  AMBLE_NEEDS_CAPTURES();
  const EngineData engine =
      fitSpeedEngine(engineRequestOf({"cmu_mb2/02_01.bvh", "cmu_mb2/02_03.bvh"}));
  ASSERT_TRUE(engine.walk && engine.run);
  EXPECT_NEAR(engine.walk->slowest(), 1.179, 0.03 * 1.179);  // MANIFEST: mean_speed_by_unit_mps
  EXPECT_NEAR(engine.run->slowest(), 2.641, 0.03 * 2.641);
  EXPECT_NEAR(0.5 / engine.run->clips[0].frequency, 0.381, 0.03 * 0.381);  // step_time_s
  for (int i = 0; i < 2; ++i) {
    EXPECT_GT(engine.walk->support[i].at(engine.walk->slowest()), 0.05);
    EXPECT_LT(engine.run->support[i].at(engine.run->slowest()), -0.05);
  }
}

TEST(FitSpeedEngine, ARunOfSomebodyElseIsCarriedOverAndSaid) {
  AMBLE_NEEDS_CAPTURES();
  std::vector<std::string> warnings;
  const EngineData engine =
      fitSpeedEngine(engineRequestOf({"cmu_mb2/07_01.bvh", "cmu_mb2/09_01.bvh"}), &warnings);
  ASSERT_TRUE(engine.run);
  EXPECT_NEAR(engine.run->slowest(), 3.595, 0.05 * 3.595);  // MANIFEST; smaller, he is slower
  EXPECT_TRUE(std::any_of(warnings.begin(), warnings.end(), [](const std::string& warning) {
    return warning.find("09_01.bvh: is of another person") != std::string::npos;
  }));
}

TEST(FitSpeedEngine, StandingIsThatOfTheCaptureWhereThereIsOne) {
  AMBLE_NEEDS_CAPTURES();
  const EngineData own = fitSpeedEngine(engineRequestOf(
      {"accad_female1/Female1_B03_Walk1.bvh", "accad_female1/Female1_A01_Stand.bvh"}));
  const EngineData borrowed = fitSpeedEngine(engineRequestOf({"cmu_mb2/02_01.bvh"}));
  for (const EngineData* engine : {&own, &borrowed}) {
    const double leg = engine->roles.meanLeg(engine->skeleton);
    EXPECT_GT(engine->stand.root_height, 0.95 * leg);
    EXPECT_LT(engine->stand.root_height, 1.2 * leg);
  }
}

}  // namespace
}  // namespace amble

// What is measured of a captured walk goes with the units of it and with nothing else: lengths with
// how tall the person is, rates with how fast the clip is played, and neither with where it was
// taken.

#include <gtest/gtest.h>

#include "animation/analysis/classify_clip.h"
#include "animation/analysis/gait_events.h"
#include "animation/analysis/gait_measures.h"
#include "animation/analysis/low_pass.h"
#include "animation/clips/resample_clip.h"
#include "base/rotation.h"
#include "tests/animation/level_walk.h"
#include "tests/animation/moved_clip.h"
#include "tests/animation/random_clip.h"
#include "tests/animation/taller_clip.h"

namespace amble {
namespace {

class AnyWalk : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    AMBLE_NEEDS_CAPTURES();
    walk = std::make_unique<LevelWalk>(std::string(GetParam()));
    plants = detectPlants(walk->clip, walk->roles);
    gait = measureGait(walk->clip, walk->roles, plants);
  }
  std::unique_ptr<LevelWalk> walk;
  FootPlants plants;
  GaitMeasures gait;
};

TEST_P(AnyWalk, PlayedTwiceAsFastHasItsLengthsAndTwiceItsRates) {
  Clip fast = walk->clip;
  fast.frame_time *= 0.5;
  const GaitMeasures twice = measureGait(fast, walk->roles, plants);
  EXPECT_NEAR(twice.step_length, gait.step_length, 1e-9);
  EXPECT_NEAR(twice.step_width, gait.step_width, 1e-9);
  EXPECT_NEAR(twice.lift, gait.lift, 1e-9);
  EXPECT_NEAR(twice.penetration, gait.penetration, 1e-9);
  EXPECT_NEAR(twice.double_support, gait.double_support, 1e-9);
  EXPECT_NEAR(twice.cadence, 2.0 * gait.cadence, 1e-6);
  EXPECT_NEAR(twice.cycle_frequency, 2.0 * gait.cycle_frequency, 1e-9);
  EXPECT_NEAR(2.0 * twice.step_time, gait.step_time, 1e-9);
  // Smoothed over half a second, which is then twice as much of the walk.
  EXPECT_NEAR(twice.speed, 2.0 * gait.speed, 0.03 * gait.speed);
}

TEST_P(AnyWalk, OfATallerPersonHasLongerLengthsAndTheSameTimes) {
  constexpr double kTaller = 1.2;
  const Clip tall = taller(walk->clip, kTaller);
  const GaitMeasures of_tall = measureGait(tall, walk->roles, plants);
  EXPECT_NEAR(of_tall.leg_length, kTaller * gait.leg_length, 1e-9);
  EXPECT_NEAR(of_tall.step_length, kTaller * gait.step_length, 1e-9);
  EXPECT_NEAR(of_tall.step_width, kTaller * gait.step_width, 1e-9);
  EXPECT_NEAR(of_tall.lift, kTaller * gait.lift, 1e-9);
  EXPECT_NEAR(of_tall.speed, kTaller * gait.speed, 1e-9);
  EXPECT_NEAR(of_tall.toe_skate, kTaller * gait.toe_skate, 1e-9);
  EXPECT_NEAR(of_tall.root_acceleration, kTaller * gait.root_acceleration, 1e-6);
  EXPECT_NEAR(of_tall.normalised_speed, gait.normalised_speed, 1e-9);
  EXPECT_NEAR(of_tall.cadence, gait.cadence, 1e-9);
  EXPECT_NEAR(of_tall.turn_rate, gait.turn_rate, 1e-9);
}

// Thresholds are in leg lengths; only the floor is fitted with a tolerance in metres.
TEST_P(AnyWalk, OfATallerPersonIsPlantedAtTheSameTimes) {
  const FootPlants of_tall = detectPlants(taller(walk->clip, 1.2), walk->roles);
  for (const Side side : {kLeft, kRight}) {
    ASSERT_EQ(of_tall.plants[side].size(), plants.plants[side].size());
    for (size_t i = 0; i < plants.plants[side].size(); ++i) {
      EXPECT_NEAR(of_tall.plants[side][i].strike, plants.plants[side][i].strike, 0.1);
      EXPECT_NEAR(of_tall.plants[side][i].lift_off, plants.plants[side][i].lift_off, 0.1);
    }
  }
}

TEST_P(AnyWalk, IsPlantedAtTheSameFramesWhereverItGoes) {
  const Clip there = moved(walk->clip, aboutZ(-2.4), {30.0, -20.0, 0.0});
  const FootPlants gone = detectPlants(there, walk->roles);
  for (const Side side : {kLeft, kRight}) EXPECT_EQ(gone.planted(side), plants.planted(side));
}

// Backwards strikes are lift-offs: the same frames are planted but for those that the leads of a
// strike and of a lift-off differ by.
TEST_P(AnyWalk, BackwardsIsPlantedAtNearlyTheSameFrames) {
  Clip back = walk->clip;
  const int last = back.frames() - 1;
  for (int i = 0; i <= last; ++i) {
    back.poses.p_WR(i) = walk->clip.poses.p_WR(last - i);
    const auto from = walk->clip.poses.rotations(last - i);
    std::copy(from.begin(), from.end(), back.poses.rotations(i).begin());
  }
  const FootPlants reversed = detectPlants(back, walk->roles);
  for (const Side side : {kLeft, kRight}) {
    int differ = 0;
    for (int i = 0; i <= last; ++i)
      differ += reversed.planted(side, last - i) != plants.planted(side, i);
    EXPECT_LT(differ, 0.2 * last);
  }
}

TEST_P(AnyWalk, HasStepsThatAddUpToItsPrints) {
  for (const Side side : {kLeft, kRight}) {
    const PlantMeasures* before = nullptr;
    for (const PlantMeasures& plant : gait.plants) {
      if (plant.side != side) continue;
      EXPECT_GE(plant.travel, 0.0);
      EXPECT_LE(plant.drift, plant.travel + 0.05);  // one is of medians
      if (before != nullptr) {
        EXPECT_GT(plant.plant.first, before->plant.last);
        EXPECT_GT((plant.at - before->at).head<2>().norm(), 0.2 * gait.step_length);
      }
      before = &plant;
    }
  }
}

TEST_P(AnyWalk, IsAWalkWhicheverWayItFacesAndHoweverTall) {
  const double frame_time = walk->clip.frame_time;
  EXPECT_EQ(classifyClip(plants, frame_time).largest(), MotionType::kWalk);
  const Clip there = moved(taller(walk->clip, 0.8), aboutZ(1.0), {1.0, 1.0, 0.0});
  const ClipClass kind = classifyClip(detectPlants(there, walk->roles), frame_time);
  EXPECT_EQ(kind.largest(), MotionType::kWalk);
}

TEST_P(AnyWalk, HasEventsInOrderThatDoNotKnowWhereItIs) {
  const GaitEvents here = findGaitEvents(walk->clip, walk->roles, plants);
  const Clip there = moved(walk->clip, aboutZ(0.7), {3.0, 4.0, 0.0});
  const GaitEvents gone = findGaitEvents(there, walk->roles, plants);
  for (const Side side : {kLeft, kRight}) {
    ASSERT_EQ(here.swings[side].size(), gone.swings[side].size());
    for (size_t i = 0; i < here.swings[side].size(); ++i) {
      const SwingEvents &a = here.swings[side][i], &b = gone.swings[side][i];
      for (const auto& [x, y] : {std::pair(a.lift, b.lift),
                                 {a.lift_off, b.lift_off},
                                 {a.strike, b.strike},
                                 {a.landing, b.landing}}) {
        if (std::isnan(x) && std::isnan(y)) continue;
        EXPECT_NEAR(x, y, 1e-6);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(, AnyWalk,
                         testing::Values("accad_female1/Female1_B03_Walk1.bvh",
                                         "accad_male1/Male1_B3_Walk.bvh", "cmu_mb2/07_01.bvh",
                                         "cmu_mb2/02_01.bvh"));

// A filter without delay neither knows the direction of time nor mixes channels.
TEST(LowPass, IsLinearAndTheSameBackwards) {
  Generator generator(3);
  Eigen::MatrixXd a(200, 2), b(200, 2);
  for (Eigen::Index i = 0; i < a.size(); ++i) a(i) = uniform(generator, -1.0, 1.0);
  for (Eigen::Index i = 0; i < b.size(); ++i) b(i) = uniform(generator, -1.0, 1.0);
  Eigen::MatrixXd both = 2.0 * a - 3.0 * b, back = a.colwise().reverse();
  const auto filtered = [](Eigen::MatrixXd rows) {
    lowPass(rows, 100.0, 6.0);
    return rows;
  };
  EXPECT_LT((filtered(both) - 2.0 * filtered(a) + 3.0 * filtered(b)).cwiseAbs().maxCoeff(), 1e-9);
  // The two runs start from different ends, which shows there and not within.
  const Eigen::MatrixXd gap = filtered(back).colwise().reverse() - filtered(a);
  EXPECT_LT(gap.middleRows(60, 80).cwiseAbs().maxCoeff(), 1e-3);
  Eigen::MatrixXd alone = a.col(0);
  lowPass(alone, 100.0, 6.0);
  EXPECT_EQ(alone, filtered(a).col(0));
}

TEST(Derivative, OfAParabolaIsExactWithinAndOfALineEverywhere) {
  constexpr int kRows = 50;
  constexpr double kRate = 30.0;
  Eigen::MatrixXd rows(kRows, 2);
  for (int i = 0; i < kRows; ++i) rows.row(i) << 3.0 * i / kRate, i / kRate * i / kRate;
  const Eigen::MatrixXd slopes = derivative(rows, kRate);
  for (int i = 0; i < kRows; ++i) {
    EXPECT_NEAR(slopes(i, 0), 3.0, 1e-9);
    if (i > 0 && i + 1 < kRows) {
      EXPECT_NEAR(slopes(i, 1), 2.0 * i / kRate, 1e-9);
    }
  }
}

}  // namespace
}  // namespace amble

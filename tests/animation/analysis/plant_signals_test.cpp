#include "animation/analysis/plant_signals.h"

#include <gtest/gtest.h>

#include "animation/clips/level_capture.h"
#include "tests/animation/captures.h"
#include "tests/animation/puppet.h"
#include "tests/animation/random_clip.h"

namespace amble {
namespace {

std::array<PlantTrace, 2> traceOf(const Clip& clip, const JointRoles& roles) {
  return tracePlants(footPaths(clip, roles), legLengths(clip, roles), clip.frame_time);
}

bool isLowAndSlow(const PlantTrace& trace, int frame) {
  for (const int joint : {0, 1}) {
    if (trace.signals.height(frame, joint) < trace.limits.height[joint] &&
        trace.signals.speed(frame, joint) < trace.limits.speed[joint])
      return true;
  }
  return false;
}

TEST(PlantTrace, HasARowAFrameAtAnyRate) {
  for (const double rate : {30.0, 59.0, 120.0}) {
    const Clip clip = Puppet{.rate = rate}.clip();
    for (const PlantTrace& trace : traceOf(clip, Puppet::roles())) {
      EXPECT_EQ(trace.signals.frames(), clip.frames());
      EXPECT_EQ(trace.signals.height.rows(), clip.frames());
    }
  }
}

TEST(PlantTrace, HeightsAreTheDrawnOnesOverTheFloorOfTheAnkles) {
  const Puppet puppet;
  const auto traces = traceOf(puppet.clip(), Puppet::roles());
  const int frame = static_cast<int>(
      std::lround(puppet.rate * (puppet.liftOff(kLeft, 1) + puppet.strike(kLeft, 2)) / 2.0));
  // The floor that is fitted lies at the standing ankles.
  EXPECT_NEAR(traces[kLeft].signals.height(frame, 0), puppet.lift, 0.01);
  const int standing = static_cast<int>(
      std::lround(puppet.rate * (puppet.strike(kLeft, 1) + puppet.liftOff(kLeft, 1)) / 2.0));
  EXPECT_NEAR(traces[kLeft].signals.height(standing, 0), 0.0, 0.002);
  EXPECT_NEAR(traces[kLeft].signals.height(standing, 1), Puppet::kToe - Puppet::kAnkle, 0.002);
  EXPECT_NEAR(traces[kLeft].signals.speed(standing, 0), 0.0, 0.01);
}

TEST(PlantTrace, MiddlesOfPlantsAreBelowTheThresholdsAndMiddlesOfSwingsAreNot) {
  AMBLE_NEEDS_CAPTURES();
  const LevelCapture level =
      readLevelCapture(sharedFolder() / "mocap/accad_female1/Female1_B03_Walk1.bvh");
  const Clip& clip = level.motion.clip;
  const auto traces = traceOf(clip, level.motion.roles);
  const FootPlants plants = detectPlants(clip, level.motion.roles);
  for (const Side side : {kLeft, kRight}) {
    ASSERT_GE(plants.plants[side].size(), 5u);
    for (size_t i = 0; i < plants.plants[side].size(); ++i) {
      const FootPlant& plant = plants.plants[side][i];
      EXPECT_TRUE(isLowAndSlow(traces[side], (plant.first + plant.last) / 2)) << side << " " << i;
      if (i == 0) continue;
      const int swing = (plants.plants[side][i - 1].last + plant.first) / 2;
      EXPECT_FALSE(isLowAndSlow(traces[side], swing)) << side << " " << i;
    }
  }
}

Eigen::MatrixXd anyRows(Generator& generator, int rows) {
  Eigen::MatrixXd x(rows, 6);
  for (double& value : x.reshaped()) value = uniform(generator, -1.0, 1.0);
  return x;
}

TEST(FinerRows, PassThroughTheRowsThatThereAre) {
  Generator generator(901);
  for (const int rows : {1, 2, 3, 20}) {
    const Eigen::MatrixXd x = anyRows(generator, rows);
    for (const int factor : {1, 2, 3, 5}) {
      const Eigen::MatrixXd fine = finerRows(x, factor);
      ASSERT_EQ(fine.rows(), (rows - 1) * factor + 1);
      for (int i = 0; i < rows; ++i) {
        EXPECT_LT((fine.row(i * factor) - x.row(i)).norm(), 1e-12) << rows << ' ' << factor;
      }
    }
  }
}

TEST(FinerRows, OfAParabolaAreTheParabolaInside) {
  Eigen::MatrixXd x(12, 1);
  const auto parabola = [](double t) { return 3.0 - 2.0 * t + 0.7 * t * t; };
  for (int i = 0; i < 12; ++i) x(i, 0) = parabola(i);
  const Eigen::MatrixXd fine = finerRows(x, 4);
  for (int i = 4; i <= 40; ++i) EXPECT_NEAR(fine(i, 0), parabola(0.25 * i), 1e-9) << i;
}

TEST(FinerRows, AreLinearAndTheSameFromTheOtherEnd) {
  Generator generator(902);
  const Eigen::MatrixXd x = anyRows(generator, 15), y = anyRows(generator, 15);
  EXPECT_LT((finerRows(2.0 * x + y, 3) - 2.0 * finerRows(x, 3) - finerRows(y, 3)).norm(), 1e-12);
  const Eigen::MatrixXd back = x.colwise().reverse();
  EXPECT_LT((finerRows(back, 3).colwise().reverse() - finerRows(x, 3)).norm(), 1e-12);
}

TEST(FinerRows, AFactorBringsEveryRateUpToThatOfPlantsAndNoFarther) {
  for (double rate = 5.0; rate < 300.0; rate *= 1.07) {
    const int factor = plantFactor(1.0 / rate, 100);
    EXPECT_GE(factor * rate, std::min(rate, kPlantRate) - 1e-9);
    if (factor > 1) {
      EXPECT_GE(factor * rate, kPlantRate - 1e-9);
      EXPECT_LT((factor - 1) * rate, kPlantRate);
    }
    EXPECT_EQ(plantFactor(1.0 / rate, 1), 1);
  }
}

// A foot that rises evenly over a tilted floor: heights and speeds by the formula.
TEST(PlantSignals, AreHeightsOverTheFloorAndSpeedsInLegs) {
  constexpr double kLeg = 0.8, kRate = 100.0;
  FloorFit floor;
  floor.normal = Eigen::Vector3d(0.05, -0.03, 1.0).normalized();
  floor.height = 0.2;
  const Eigen::Vector3d ankle(1.0, 2.0, 0.5), toe(1.1, 2.0, 0.4), way(0.3, 0.4, 0.2);
  Eigen::MatrixXd path(50, 6);
  for (int i = 0; i < 50; ++i) {
    path.row(i) << (ankle + i / kRate * way).transpose(), (toe + 2.0 * i / kRate * way).transpose();
  }
  const PlantSignals signals = plantSignals(path, floor, kLeg, kRate, 8.5);
  for (int i = 0; i < 50; ++i) {
    const Eigen::Vector3d a = ankle + i / kRate * way, t = toe + 2.0 * i / kRate * way;
    EXPECT_NEAR(signals.height(i, 0), (floor.normal.dot(a) - 0.2) / kLeg, 1e-9);
    EXPECT_NEAR(signals.height(i, 1), (floor.normal.dot(t) - 0.2) / kLeg, 1e-9);
    EXPECT_NEAR(signals.speed(i, 0), way.norm() / kLeg, 1e-9);
    EXPECT_NEAR(signals.speed(i, 1), 2.0 * way.norm() / kLeg, 1e-9);
    EXPECT_NEAR(signals.rise[i], 1.5 * floor.normal.dot(way) / kLeg, 1e-9);
  }
  EXPECT_NEAR(signals.swing[1], 2.0 * signals.swing[0], 1e-9);
}

TEST(PlantSignals, LimitsOfSpeedFollowTheSwingWithinTheirBounds) {
  const PlantOptions options;
  PlantSignals signals;
  signals.height = Eigen::MatrixXd::Zero(10, 2);
  signals.speed = Eigen::MatrixXd::Zero(10, 2);
  for (double swing = 0.1; swing < 12.0; swing *= 1.3) {
    signals.swing = {swing, 2.0 * swing};
    const PlantLimits limits = plantLimits(signals, options);
    for (const int joint : {0, 1}) {
      EXPECT_GE(limits.speed[joint], options.min_speed);
      EXPECT_LE(limits.speed[joint], options.max_speed);
      const double share = limits.speed[joint] / signals.swing[joint];
      if (limits.speed[joint] > options.min_speed && limits.speed[joint] < options.max_speed) {
        EXPECT_NEAR(share, options.speed_of_swing, 1e-12);
      }
      EXPECT_NEAR(limits.height[joint], options.height, 1e-12);
    }
  }
  signals.speed.setConstant(100.0);
  EXPECT_LT(plantLimits(signals, options).height[0], -1e9);  // it never stands
}

}  // namespace
}  // namespace amble

#include "animation/analysis/plant_signals.h"

#include <gtest/gtest.h>

#include "animation/clips/level_capture.h"
#include "tests/animation/captures.h"
#include "tests/animation/puppet.h"

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

}  // namespace
}  // namespace amble

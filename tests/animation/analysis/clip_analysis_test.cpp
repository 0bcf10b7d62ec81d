#include "animation/analysis/clip_analysis.h"

#include <gtest/gtest.h>

#include "tests/animation/puppet.h"

namespace amble {
namespace {

TEST(ClipAnalysis, OfAClipWithoutFramesIsEmpty) {
  Clip clip = Puppet().clip();
  clip.poses.clear();
  clip.joint_positions.clear();
  const ClipAnalysis analysis = analyseClip(clip, Puppet::roles());
  EXPECT_EQ(analysis.frames(), 0);
  EXPECT_EQ(analysis.frame_time, clip.frame_time);
  EXPECT_TRUE(analysis.events.swings[kLeft].empty());
}

TEST(ClipAnalysis, ItsPartsSpeakOfTheSamePlants) {
  const ClipAnalysis analysis = analyseClip(Puppet().clip(), Puppet::roles());
  size_t plants = 0;
  for (const Side side : {kLeft, kRight}) {
    plants += analysis.plants.plants[side].size();
    EXPECT_EQ(analysis.curves[side].heel_height.size(), analysis.frames());
    EXPECT_GE(analysis.events.swings[side].size() + 1, analysis.plants.plants[side].size());
  }
  EXPECT_EQ(analysis.gait.plants.size(), plants);
  EXPECT_EQ(analysis.kind.frames.size(), static_cast<size_t>(analysis.frames()));
  EXPECT_EQ(analysis.kind.type, MotionType::kWalk);
}

}  // namespace
}  // namespace amble

#include "animation/clips/resample_clip.h"

#include <gtest/gtest.h>

#include "tests/animation/random_clip.h"

namespace amble {
namespace {

/// A clip of a joint that moves as well.
Clip movingClip(int frames) {
  Generator generator(11);
  Clip clip = randomClip(generator, 5, frames);
  clip.frame_time = 1.0 / 30.0;
  for (int i = 0; i < 5 * frames; ++i) clip.joint_positions.push_back(randomVector(generator, 1.0));
  return clip;
}

void expectSameFrame(const Clip& a, int i, const Clip& b, int k) {
  const std::vector<JointFrame> x = jointFrames(a, i), y = jointFrames(b, k);
  for (size_t j = 0; j < x.size(); ++j) {
    EXPECT_LT((x[j].p_WJ - y[j].p_WJ).norm(), 1e-12);
    EXPECT_LT(x[j].q_WJ.angularDistance(y[j].q_WJ), 1e-7);
  }
}

TEST(ResampleClip, TheSameFrameTimeGivesTheSameClip) {
  const Clip clip = movingClip(6), same = resampleClip(clip, clip.frame_time);
  ASSERT_EQ(same.frames(), 6);
  for (int i = 0; i < 6; ++i) {
    EXPECT_EQ(same.poses.p_WR(i), clip.poses.p_WR(i));
    EXPECT_EQ(same.poses.rotations(i)[2].coeffs(), clip.poses.rotations(i)[2].coeffs());
  }
}

TEST(ResampleClip, AFinerClipPassesThroughTheFramesAndShowsWhatAPlayerDoesBetween) {
  const Clip clip = movingClip(6), fine = resampleClip(clip, clip.frame_time / 2.0);
  ASSERT_EQ(fine.frames(), 11);
  Pose between;
  for (int i = 0; i < 6; ++i) expectSameFrame(fine, 2 * i, clip, i);
  for (int i = 0; i < 5; ++i) {
    interpolatePose(clip.poses[i], clip.poses[i + 1], 0.5, between);
    EXPECT_LT((fine.poses.p_WR(2 * i + 1) - between.p_WR).norm(), 1e-12);
    EXPECT_LT(fine.poses.rotations(2 * i + 1)[3].angularDistance(between.rotations[3]), 1e-7);
    const Eigen::Vector3d middle =
        0.5 * (clip.joint_positions[5 * i + 4] + clip.joint_positions[5 * i + 9]);
    EXPECT_LT((fine.joint_positions[5 * (2 * i + 1) + 4] - middle).norm(), 1e-12);
  }
}

TEST(ResampleClip, ResamplingThereAndBackGivesTheFramesBack) {
  const Clip clip = movingClip(9);
  const Clip back = resampleClip(resampleClip(clip, clip.frame_time / 4.0), clip.frame_time);
  ASSERT_EQ(back.frames(), 9);
  for (int i = 0; i < 9; ++i) expectSameFrame(back, i, clip, i);
}

TEST(ResampleClip, WhatIsLeftOfALastFrameTimeIsCutOff) {
  EXPECT_EQ(resampleClip(movingClip(10), 2.0 / 30.0).frames(), 5);
  EXPECT_EQ(resampleClip(movingClip(11), 2.0 / 30.0).frames(), 6);
  EXPECT_EQ(resampleClip(movingClip(2), 1.0).frames(), 1);
}

TEST(ResampleClip, ClipsOfNoFrameOrOneStayAsTheyAre) {
  EXPECT_EQ(resampleClip(movingClip(0), 0.01).frames(), 0);
  EXPECT_EQ(resampleClip(movingClip(1), 0.01).frames(), 1);
}

}  // namespace
}  // namespace amble

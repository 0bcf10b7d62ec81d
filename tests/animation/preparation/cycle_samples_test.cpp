#include "animation/preparation/cycle_samples.h"

#include <gtest/gtest.h>

#include "base/rotation.h"
#include "tests/animation/level_walk.h"
#include "tests/animation/moved_clip.h"
#include "tests/animation/rig.h"

namespace amble {
namespace {

constexpr int kCount = 64;

std::vector<CycleSamples> sampled(const GaitTrack& track,
                                  const std::vector<Eigen::Quaterniond>& reference,
                                  Gait gait = Gait::kWalk) {
  std::vector<CycleSamples> all;
  for (const Stretch& stretch : findStretches(track, {"the clip", false, 0, {}}, gait))
    all.push_back(sampleCycle(track, stretch, gait, reference, kCount));
  return all;
}

class DrawnSamples : public testing::TestWithParam<double> {};

// Stretches begin with either foot: the columns do not tell which.
TEST_P(DrawnSamples, AreTheDrawingWhicheverFootLed) {
  const Rig rig;
  Puppet puppet;
  puppet.speed = GetParam();
  puppet.width = 0.12;
  const Clip clip = rig.walk(puppet);
  const GaitTrack track(clip, rig.roles, rig.feet);
  const std::vector<CycleSamples> all = sampled(track, rig.reference());
  ASSERT_GE(all.size(), 4u);
  for (const CycleSamples& one : all) {
    EXPECT_NEAR(one.speed, puppet.speed, 1e-4);
    EXPECT_NEAR(one.period, puppet.period, 1e-4);
    EXPECT_NEAR(one.step_width, puppet.width, 1e-4);
    EXPECT_LT((one.channels - all.front().channels).cwiseAbs().maxCoeff(), 5e-3);
    for (const Side side : {kLeft, kRight}) {
      // Thresholds of plants lie within some hundredths of a second of each drawn contact.
      EXPECT_NEAR(one.support[side], puppet.stance - 0.5, 0.055);
      EXPECT_NEAR(one.toe_out[side], 0.0, 1e-4);
      EXPECT_NEAR(one.foot_forward[side], all.front().foot_forward[side], 2e-3);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(, DrawnSamples, testing::Values(0.7, 1.0, 1.3));

TEST(CycleSamples, HeightsAreOverTheFootprints) {
  const Rig rig;
  const Clip level = rig.walk(Puppet());
  const Clip raised = moved(level, Eigen::Quaterniond::Identity(), {0, 0, 0.04});
  const GaitTrack low(level, rig.roles, rig.feet), high(raised, rig.roles, rig.feet);
  const CycleSamples a = sampled(low, rig.reference()).front();
  const CycleSamples b = sampled(high, rig.reference()).front();
  EXPECT_LT((a.channels.row(2) - b.channels.row(2)).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_NEAR(a.channels.row(2).mean(), Puppet::kHip, 1e-3);
}

class CapturedSamples : public testing::TestWithParam<const char*> {};

TEST_P(CapturedSamples, AreTheSameWhereverTheClipWalks) {
  AMBLE_NEEDS_CAPTURES();
  const LevelWalk walk{std::string(GetParam())};
  const LevelWalk there(moved(walk.clip, aboutZ(-1.9), {4.0, 2.0, 0.0}), walk.roles);
  const auto reference = walk.reference();
  const auto here = sampled(walk.track, reference), gone = sampled(there.track, reference);
  ASSERT_EQ(here.size(), gone.size());
  for (size_t i = 0; i < here.size(); ++i) {
    EXPECT_NEAR(here[i].speed, gone[i].speed, 1e-6);
    EXPECT_NEAR(here[i].step_width, gone[i].step_width, 1e-6);
    EXPECT_LT((here[i].channels - gone[i].channels).cwiseAbs().maxCoeff(), 1e-5);
    for (const Side side : {kLeft, kRight}) {
      EXPECT_NEAR(here[i].toe_out[side], gone[i].toe_out[side], 1e-6);
      EXPECT_NEAR(here[i].foot_forward[side], gone[i].foot_forward[side], 1e-6);
      EXPECT_NEAR(here[i].support[side], gone[i].support[side], 1e-6);
    }
  }
}

// Both feet are down for a part of a walk's cycle only, and each supports more than half of it.
TEST_P(CapturedSamples, OfAWalkHaveTwoDoubleSupportsAndStepsApart) {
  AMBLE_NEEDS_CAPTURES();
  const LevelWalk walk{std::string(GetParam())};
  for (const CycleSamples& one : sampled(walk.track, walk.reference())) {
    EXPECT_GT(one.support[kLeft], 0.0);
    EXPECT_GT(one.support[kRight], 0.0);
    EXPECT_LT(one.support[kLeft] + one.support[kRight], 0.6);
    EXPECT_GT(one.step_width, 0.0);
    EXPECT_LT(one.step_width, 0.35);
  }
}

INSTANTIATE_TEST_SUITE_P(, CapturedSamples,
                         testing::Values("accad_female1/Female1_B03_Walk1.bvh",
                                         "accad_male1/Male1_B3_Walk.bvh", "cmu_mb2/07_01.bvh",
                                         "cmu_mb2/08_03.bvh"));

TEST(CycleSamples, OfACapturedRunFlyTwiceACycle) {
  AMBLE_NEEDS_CAPTURES();
  const LevelWalk run("cmu_mb2/09_01.bvh");
  const auto all = sampled(run.track, run.reference(), Gait::kRun);
  ASSERT_FALSE(all.empty());
  for (const CycleSamples& one : all) {
    EXPECT_LT(one.support[kLeft], 0.0);
    EXPECT_LT(one.support[kRight], 0.0);
    EXPECT_GT(one.support[kLeft] + one.support[kRight], -0.8);
    EXPECT_GT(one.speed, 2.0);
  }
}

}  // namespace
}  // namespace amble

#include "animation/clips/loop_clip.h"

#include <gtest/gtest.h>

#include "animation/body/pelvis.h"
#include "base/rotation.h"
#include "tests/animation/puppet.h"
#include "tests/animation/random_clip.h"

namespace amble {
namespace {

/// A drawn walk whose feet hang on fixed joints, so that it is its skeleton's alone.
Clip drawn(const Puppet& puppet, int frames) {
  Clip clip = puppet.clip();
  clip.joint_positions.clear();
  std::vector<Joint> joints = clip.skeleton.joints();
  for (const Side side : {kLeft, kRight}) {
    joints[Puppet::roles().legs[side].up_leg].offset = {0, side == kLeft ? 0.09 : -0.09, 0};
  }
  clip.skeleton = Skeleton(joints);
  clip.poses.resize(frames);
  return clip;
}

TEST(LoopClip, AClipWithoutAWholeFrameToRepeatIsNone) {
  EXPECT_FALSE(repeatedLoop(drawn({}, 1), Puppet::roles(), 3).has_value());
}

TEST(LoopClip, AClipThatEndsInAnotherPoseIsNone) {
  Clip clip = drawn({}, 50);
  clip.poses.rotations(49)[1] = expRotation({0.0, 0.6, 0.0});
  EXPECT_FALSE(repeatedLoop(clip, Puppet::roles(), 3).has_value());
}

TEST(LoopClip, WalksOnAsTheLongerWalkDoes) {
  for (const double turn_rate : {0.0, 0.5, -0.8}) {
    const Puppet puppet{.turn_rate = turn_rate};
    const Clip whole = drawn(puppet, 331), part = drawn(puppet, 111);
    const auto loop = repeatedLoop(part, Puppet::roles(), 3);
    ASSERT_TRUE(loop.has_value());
    ASSERT_EQ(loop->frames(), 331);
    for (int i = 0; i < 331; i += 10) {
      EXPECT_LT((loop->poses.p_WR(i) - whole.poses.p_WR(i)).norm(), 1e-9);
      EXPECT_LT(loop->poses.rotations(i)[0].angularDistance(whole.poses.rotations(i)[0]), 1e-7);
    }
  }
}

TEST(LoopClip, ThePoseGapDoesNotDependOnPlaceAndHeading) {
  const Clip clip = drawn({}, 10);
  std::vector<JointFrame> a(clip.skeleton.size()), b(clip.skeleton.size());
  forwardKinematics(clip, 0, a);
  Clip moved = clip;
  moved.poses.p_WR(0) += Eigen::Vector3d(3.0, -2.0, 0.0);
  moved.poses.rotations(0)[0] = aboutZ(1.2) * moved.poses.rotations(0)[0];
  forwardKinematics(moved, 0, b);
  EXPECT_NEAR(poseGap(a, b, Puppet::roles()), 0.0, 1e-12);
  moved.poses.p_WR(0).z() += 0.02;  // heights count
  forwardKinematics(moved, 0, b);
  EXPECT_NEAR(poseGap(a, b, Puppet::roles()), 0.02, 1e-12);
}

// Of a drawn walk feet are moving joints; a period is a whole loop.
TEST(LoopClip, MovingJointsMoveOnInEveryRound) {
  for (const double turn_rate : {0.0, 0.5}) {
    Puppet puppet{.turn_rate = turn_rate};
    puppet.duration = 3.0 * puppet.period;
    const Clip whole = puppet.clip();
    puppet.duration = puppet.period;
    const auto loop = repeatedLoop(puppet.clip(), Puppet::roles(), 3);
    ASSERT_TRUE(loop.has_value());
    ASSERT_EQ(loop->frames(), whole.frames());
    for (int i = 0; i < whole.frames(); i += 7) {
      const std::vector<JointFrame> here = jointFrames(*loop, i), wanted = jointFrames(whole, i);
      for (size_t j = 0; j < wanted.size(); ++j) {
        EXPECT_LT((here[j].p_WJ - wanted[j].p_WJ).norm(), 1e-6) << i << ' ' << j;
      }
    }
  }
}

}  // namespace
}  // namespace amble

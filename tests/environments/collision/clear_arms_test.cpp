#include "environments/collision/clear_arms.h"

#include <gtest/gtest.h>

#include "tests/environments/test_walker.h"

namespace amble {
namespace {

Eigen::Index pairOf(const std::string& part, const std::string& other) {
  const auto& pairs = armPairs();
  for (size_t k = 0; k < pairs.size(); ++k) {
    if (pairs[k].first == part && pairs[k].second == other) return static_cast<Eigen::Index>(k);
  }
  return -1;
}

// Stands for a second and takes an arm across into the trunk and back: by `most` [rad] at half
// time, about the way that he faces.
Clip armIntoTrunk(const TestWalker& walker, Side side, double most) {
  Clip clip;
  clip.skeleton = walker.skeleton;
  clip.frame_time = 1.0 / 60.0;
  clip.poses = PoseArray(walker.skeleton.size());
  for (int i = 0; i <= 60; ++i) {
    Pose pose = walker.standing(0, 0, 0.7);
    const double inwards = (side == kLeft ? -1.0 : 1.0) * most * std::sin(kPi * i / 60.0);
    pose.rotations[walker.roles.arms[side].arm] =
        expRotation({0, 0, inwards}) * pose.rotations[walker.roles.arms[side].arm];
    clip.poses.append(pose);
  }
  return clip;
}

TEST(ArmDepths, AreTheCapsulesRadiiWithoutTheWayBetweenTheirAxes) {
  const TestWalker walker;
  Clip clip = armIntoTrunk(walker, kLeft, 0.0);
  const Eigen::MatrixXd apart = armDepths(walker.body, clip, 0, 0);
  EXPECT_LT(apart(0, pairOf("left hand", "head")), -0.5);
  clip = armIntoTrunk(walker, kLeft, 0.4);
  const Eigen::MatrixXd depths = armDepths(walker.body, clip, 0, 60);
  EXPECT_EQ(depths.rows(), 61);
  const Eigen::Index hand = pairOf("left hand", "left thigh");
  EXPECT_GT(depths(30, hand), depths(0, hand) + 0.05);
  EXPECT_DOUBLE_EQ(deepest(depths)[hand], std::max(0.0, depths.col(hand).maxCoeff()));
  EXPECT_NEAR(depths(30, hand), armDepths(walker.body, clip, 30, 30)(0, hand), 1e-12);
}

TEST(ClearArms, AnArmInTheBodyIsBroughtOutAndTheOtherStays) {
  const TestWalker walker;
  for (const Side side : {kLeft, kRight}) {
    const Clip before = armIntoTrunk(walker, side, 0.4);
    const Eigen::VectorXd allowed = deepest(armDepths(walker.body, before, 0, 0));
    ASSERT_GT((deepest(armDepths(walker.body, before, 0, 60)) - allowed).maxCoeff(), 0.05);
    Clip clip = before;
    const ArmClearing clearing = clearArms(walker.body, walker.roles, allowed, 0, 60, clip);
    EXPECT_LE((deepest(armDepths(walker.body, clip, 0, 60)) - allowed).maxCoeff(), 0.0);
    EXPECT_GT(clearing.turned[side], 0.05);
    EXPECT_LT(clearing.turned[side], kMostTurned);
    EXPECT_EQ(clearing.frames[other(side)], 0);
    for (int i = 0; i <= 60; ++i) {
      for (int j = 0; j < clip.skeleton.size(); ++j) {
        if (j == walker.roles.arms[side].arm) continue;
        EXPECT_EQ(clip.poses.rotations(i)[j].coeffs(), before.poses.rotations(i)[j].coeffs());
      }
    }
  }
}

// What it is turned by is as smooth as the time that it makes way in.
TEST(ClearArms, TheArmMakesWayWithoutAJerk) {
  const TestWalker walker;
  const Clip before = armIntoTrunk(walker, kLeft, 0.5);
  const Eigen::VectorXd allowed = deepest(armDepths(walker.body, before, 0, 0));
  Clip clip = before;
  const double most = clearArms(walker.body, walker.roles, allowed, 0, 60, clip).turned[kLeft];
  const int arm = walker.roles.arms[kLeft].arm;
  double last = 0.0;
  for (int i = 0; i <= 60; ++i) {
    const double turned =
        clip.poses.rotations(i)[arm].angularDistance(before.poses.rotations(i)[arm]);
    if (i > 0) {
      EXPECT_LT(std::abs(turned - last), most * 2.5 * clip.frame_time / kSmoothOver);
    }
    last = turned;
  }
}

TEST(ClearArms, WhatIsAllowedIsLeftToTheBit) {
  const TestWalker walker;
  const Clip before = armIntoTrunk(walker, kLeft, 0.4);
  Clip clip = before;
  const ArmClearing clearing = clearArms(
      walker.body, walker.roles, deepest(armDepths(walker.body, before, 0, 60)), 0, 60, clip);
  EXPECT_EQ(clearing.frames, (std::array<int, 2>{0, 0}));
  EXPECT_EQ(clip.poses.rotations(30)[walker.roles.arms[kLeft].arm].coeffs(),
            before.poses.rotations(30)[walker.roles.arms[kLeft].arm].coeffs());
}

}  // namespace
}  // namespace amble

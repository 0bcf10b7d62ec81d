#include "animation/analysis/motion_measures.h"

#include <gtest/gtest.h>

#include "animation/body/pelvis.h"
#include "base/rotation.h"
#include "tests/animation/puppet.h"
#include "tests/animation/random_clip.h"

namespace amble {
namespace {

/// One joint that goes and turns as told.
Clip mover(
    double rate, double duration, const std::function<Eigen::Vector3d(double)>& place,
    const std::function<double(double)>& angle = [](double) { return 0.0; }) {
  Clip clip;
  clip.skeleton = Skeleton({Joint()});
  clip.frame_time = 1.0 / rate;
  clip.poses = PoseArray(1);
  for (int i = 0; i <= std::lround(duration * rate); ++i) {
    Pose pose;
    pose.p_WR = place(i / rate);
    pose.rotations = {aboutZ(angle(i / rate))};
    clip.poses.append(pose);
  }
  return clip;
}

TEST(MotionMeasures, AClipOfAFrameOrNoneMeasuresNothing) {
  for (const double duration : {0.0, 0.01, 0.02}) {
    const Clip clip = mover(100.0, duration, [](double t) { return Eigen::Vector3d(t, 0, 0); });
    EXPECT_EQ(rootAcceleration(clip), 0.0);
    EXPECT_EQ(jointJerk(clip), 0.0);
    EXPECT_LE(pops(clip), 1.0);
  }
}

TEST(MotionMeasures, EvenMotionHasNoAccelerationAndNoJerk) {
  for (const double rate : {24.0, 30.0, 60.0, 120.0}) {
    const Clip clip =
        mover(rate, 5.0, [](double t) { return Eigen::Vector3d(1.2 * t, -0.3 * t, 1.0); });
    EXPECT_LT(rootAcceleration(clip), 1e-7) << rate;
    EXPECT_LT(jointJerk(clip), 1e-5) << rate;
  }
}

TEST(MotionMeasures, RootAccelerationIsThatOfTheFormulaAtAnyRate) {
  // A sway of 3 cm at 1.8 Hz; differences at 30 Hz take 1.2 % of it, the filter less.
  constexpr double kSize = 0.03, kOmega = 2.0 * kPi * 1.8;
  for (const double rate : {30.0, 60.0, 100.0, 120.0, 240.0}) {
    const Clip clip = mover(
        rate, 6.0, [](double t) { return Eigen::Vector3d(t, kSize * std::sin(kOmega * t), 1.0); });
    EXPECT_NEAR(rootAcceleration(clip), kSize * kOmega * kOmega, 0.03 * kSize * kOmega * kOmega)
        << rate;
  }
}

TEST(MotionMeasures, JointJerkIsThatOfTheFormulaAtAnyRate) {
  // The mean of |cos| is 2 / pi.
  constexpr double kSize = 0.1, kOmega = 2.0 * kPi * 1.5;
  const double expected = kSize * std::pow(kOmega, 3) * 2.0 / kPi;
  for (const double rate : {30.0, 60.0, 120.0, 240.0}) {
    const Clip clip = mover(
        rate, 10.0, [](double t) { return Eigen::Vector3d(t, kSize * std::sin(kOmega * t), 1.0); });
    EXPECT_NEAR(jointJerk(clip), expected, 0.03 * expected) << rate;
  }
}

TEST(MotionMeasures, AJumpOfOneFrameIsAPopAndASmoothTurnIsNone) {
  const auto still = [](double) { return Eigen::Vector3d(0, 0, 1); };
  const auto sway = [](double t) { return 0.4 * std::sin(2.0 * kPi * t); };
  EXPECT_NEAR(pops(mover(60.0, 5.0, still, sway)), 1.0, 0.01);
  const auto jump = [&](double t) { return sway(t) + (std::abs(t - 2.5) < 0.004 ? 0.1 : 0.0); };
  EXPECT_GT(pops(mover(60.0, 10.0, still, jump)), 10.0);
  EXPECT_LT(pops(mover(60.0, 5.0, still)), 1e-6);
}

/// A person of two legs who faces `heading` and bends both knees by `flexion` [rad].
Clip kneeBender(double heading, double flexion) {
  std::vector<Joint> joints(9);
  for (const int side : {0, 1}) {
    for (int i = 0; i < 4; ++i) joints[1 + 4 * side + i].parent = i == 0 ? 0 : 4 * side + i;
    joints[1 + 4 * side].offset = {0, side == 0 ? 0.1 : -0.1, 0};
    joints[2 + 4 * side].offset = {0, 0, -0.4};
    joints[3 + 4 * side].offset = {0, 0, -0.4};
    joints[4 + 4 * side].offset = {0.15, 0, -0.05};
  }
  Clip clip;
  clip.skeleton = Skeleton(joints);
  clip.poses = PoseArray(9);
  clip.poses.resize(10);
  for (int i = 0; i < 10; ++i) {
    clip.poses.rotations(i)[0] = aboutZ(heading);
    for (const int knee : {2, 6})
      clip.poses.rotations(i)[knee] = fromEuler({flexion, 0, 0}, {'Y', 'X', 'Z'});
  }
  return clip;
}

TEST(MotionMeasures, KneesBendForwardsInWhateverDirectionOneFaces) {
  for (double heading = -3.0; heading < 3.0; heading += 0.7) {
    EXPECT_EQ(kneeBackwardsShare(kneeBender(heading, 60 * kDegree), Puppet::roles()), 0.0);
    EXPECT_EQ(kneeBackwardsShare(kneeBender(heading, -7 * kDegree), Puppet::roles()), 0.0);
    EXPECT_EQ(kneeBackwardsShare(kneeBender(heading, -9 * kDegree), Puppet::roles()), 1.0);
    EXPECT_NEAR(pelvisHeadings(kneeBender(heading, 0.0), Puppet::roles())[0], heading, 1e-12);
  }
}

TEST(MotionMeasures, HeadingsDoNotJumpOverWholeTurns) {
  const Puppet puppet{.turn_rate = 1.5, .duration = 10.0};
  EXPECT_NEAR(pelvisHeadings(puppet.clip(), Puppet::roles()).back(), 15.0, 1e-9);
}

TEST(MotionMeasures, BonesOfFixedOffsetsDoNotChangeAndMovingOnesDo) {
  EXPECT_EQ(boneLengthChange(kneeBender(0.0, 0.1)), 0.0);
  Clip clip = Puppet().clip();
  clip.joint_positions.assign(clip.joint_positions.size(), Eigen::Vector3d(0, 0, 1));
  clip.joint_positions[100].z() = 1.25;
  EXPECT_NEAR(boneLengthChange(clip), 0.25, 1e-12);
}

TEST(MotionMeasures, SmoothingKeepsLinesAndEnds) {
  std::vector<Eigen::Vector3d> line;
  for (int i = 0; i < 50; ++i) line.emplace_back(0.1 * i, 1.0 - 0.02 * i, 0.0);
  const std::vector<Eigen::Vector3d> smooth = smoothed(line, 0.01, 0.2);
  for (int i = 0; i < 50; ++i) EXPECT_LT((smooth[i] - line[i]).norm(), 1e-12);
}

std::vector<PlannedPoint> planOf(const Puppet& puppet, double late, const Eigen::Vector2d& aside) {
  std::vector<PlannedPoint> plan;
  for (int i = 0; i <= std::lround(puppet.duration * puppet.rate); ++i) {
    const double t = i / puppet.rate + late;
    plan.push_back({puppet.pelvis(t).head<2>() + aside, puppet.heading(t)});
  }
  return plan;
}

TEST(MotionMeasures, ARootOnItsPathHasNoError) {
  for (const double turn_rate : {0.0, 0.8, -0.4}) {
    const Puppet puppet{.turn_rate = turn_rate};
    const PathError error = pathError(puppet.clip(), Puppet::roles(), planOf(puppet, 0.0, {0, 0}));
    EXPECT_LT(error.largest, 0.004);  // smoothing cuts the circle by v w (0.25 s)^2 / 24
    EXPECT_LT(error.end, 1e-12);
    EXPECT_LT(error.end_heading, 1e-9);
  }
}

TEST(MotionMeasures, ARootAsideOfItsPathIsAsFarOffAsItIsAside) {
  const Puppet puppet;
  const PathError error = pathError(puppet.clip(), Puppet::roles(), planOf(puppet, 0.0, {0, 0.05}));
  EXPECT_NEAR(error.mean, 0.05, 1e-12);
  EXPECT_NEAR(error.largest, 0.05, 1e-12);
  EXPECT_NEAR(error.end, 0.05, 1e-12);
}

TEST(MotionMeasures, BeingLateIsNoErrorOfThePathButOfItsEnd) {
  const Puppet puppet{.turn_rate = 0.5};
  const PathError error = pathError(puppet.clip(), Puppet::roles(), planOf(puppet, 0.1, {0, 0}));
  EXPECT_LT(error.mean, 0.005);
  EXPECT_NEAR(error.end, 0.12, 1e-3);
  EXPECT_NEAR(error.end_heading, 0.05, 1e-9);
}

}  // namespace
}  // namespace amble

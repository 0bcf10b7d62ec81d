#include "animation/library/speed_engine.h"

#include <gtest/gtest.h>

#include "tests/animation/drawn_engine.h"

namespace amble {
namespace {

const DrawnEngine kDrawn;

Pose poseOf(const SpeedEngine& engine, double speed, double phase) {
  Pose pose;
  pose.rotations.resize(engine.joints());
  engine.poseAt(speed, phase, pose);
  return pose;
}

/// Largest angle between the joints of two poses, and the way between their roots.
double angleBetween(const Pose& a, const Pose& b) {
  double most = 0.0;
  for (size_t j = 0; j < a.rotations.size(); ++j) {
    most = std::max(most, a.rotations[j].angularDistance(b.rotations[j]));
  }
  return most;
}

TEST(SpeedEngine, WalksAsPeopleWhoWereCapturedDoAtSpeedsBetweenTheirs) {
  const SpeedEngine engine(kDrawn.data({0.8, 1.2, 1.6}));
  const int thigh = kDrawn.rig.roles.legs[kRight].up_leg;
  for (const double speed : {0.8, 1.1, 1.37, 1.6}) {
    for (const double phase : {0.0, 0.123, 0.5, 0.9}) {
      const Pose pose = poseOf(engine, speed, phase);
      const Eigen::Quaterniond expected =
          engine.data().mean_posture[thigh] * expRotation({DrawnEngine::swing(speed, phase), 0, 0});
      EXPECT_LT(pose.rotations[thigh].angularDistance(expected), 1e-4);
      EXPECT_NEAR(pose.p_WR.z(), DrawnEngine::kHeight - 0.01 * speed * std::cos(4.0 * kPi * phase),
                  1e-5);
    }
  }
}

TEST(SpeedEngine, FrequencyIsThePersonsLaw) {
  const SpeedEngine engine(kDrawn.data({0.8, 1.2, 1.6}));
  for (const double speed : {0.3, 0.8, 1.1, 1.6}) {
    EXPECT_NEAR(engine.frequency(speed), kDrawn.frequency(speed), 1e-9);
    EXPECT_NEAR(engine.stepLength(speed), 0.5 * speed / kDrawn.frequency(speed), 1e-9);
  }
}

TEST(SpeedEngine, AtNoSpeedItStandsWhateverThePhase) {
  const SpeedEngine engine(kDrawn.data({0.8, 1.2}));
  for (const double phase : {0.0, 0.3, 0.77}) {
    const Pose pose = poseOf(engine, 0.0, phase);
    for (int j = 0; j < engine.joints(); ++j) {
      EXPECT_LT(pose.rotations[j].angularDistance(engine.data().stand.rotations[j]), 1e-9);
    }
    EXPECT_NEAR(pose.p_WR.z(), engine.data().stand.root_height, 1e-9);
  }
  EXPECT_TRUE(std::isfinite(engine.frequency(0.0)));
}

TEST(SpeedEngine, BelowTheSlowestWalkStridesShrinkAsTheRootGoesOnByThem) {
  const SpeedEngine engine(kDrawn.data({0.8, 1.2}));
  const double stride = engine.stepLength(0.8);
  for (const double speed : {0.05, 0.2, 0.5}) {
    EXPECT_NEAR(engine.walkShare(speed), engine.stepLength(speed) / stride, 1e-9);
  }
}

TEST(SpeedEngine, PosesAndTheirRateOfChangeDoNotJumpOverSpeed) {
  const SpeedEngine engine(kDrawn.data({0.8, 1.2}, {2.5, 3.0}));
  const double h = 1e-3;
  double before = 0.0;
  for (double speed = h; speed < 3.0; speed += h) {
    const double change = angleBetween(poseOf(engine, speed, 0.1), poseOf(engine, speed - h, 0.1));
    EXPECT_LT(change, 0.6 * h * 2.0) << speed;  // the thigh turns by 0.6 rad a m/s at most
    const bool at_top = speed > 1.19 && speed<1.21, at_bottom = speed> 2.49 && speed < 2.51;
    if (speed > h && !at_top && !at_bottom) {
      EXPECT_LT(std::abs(change - before), 0.02 * h) << speed;
    }
    before = change;
  }
}

TEST(SpeedEngine, TheWholeCycleIsItsPoses) {
  const SpeedEngine engine(kDrawn.data({0.8, 1.2}, {2.5}));
  Eigen::MatrixXd cycle;
  for (const double speed : {0.3, 1.0, 2.0, 2.5}) {
    engine.cycleAt(speed, cycle);
    ASSERT_EQ(cycle.rows(), engine.channels());
    ASSERT_EQ(cycle.cols(), kEnginePhases);
    for (const int i : {0, 37, 99}) {
      const Pose pose = poseOf(engine, speed, static_cast<double>(i) / kEnginePhases);
      EXPECT_LT((pose.p_WR - cycle.col(i).head<3>()).norm(), 1e-9);
      const Eigen::Vector3d last = cycle.col(i).tail<3>();
      const Eigen::Quaterniond q = engine.data().mean_posture.back() * expRotation(last);
      EXPECT_LT(pose.rotations.back().angularDistance(q), 1e-7);
    }
  }
}

TEST(SpeedEngine, FeetAreDownTogetherForAsLongAsWasCaptured) {
  const SpeedEngine engine(kDrawn.data({0.8, 1.2, 1.6}, {3.0}));
  for (const double speed : {1.0, 1.5, 3.0}) {
    int both = 0, neither = 0;
    constexpr int kTimes = 1000;
    for (int i = 0; i < kTimes; ++i) {
      const double phase = (i + 0.5) / kTimes;
      const bool left = engine.planted(speed, phase, kLeft);
      const bool right = engine.planted(speed, phase, kRight);
      both += left && right;
      neither += !left && !right;
    }
    // A run's is negative: it flies.
    const double support = 2.0 * kTimes * DrawnEngine::support(speed);
    EXPECT_NEAR(both - neither, support, 3.0) << speed;
    EXPECT_EQ(std::min(both, neither), 0);
  }
}

TEST(SpeedEngine, BeyondTheCapturedSpeedsItIsClamped) {
  const SpeedEngine walks(kDrawn.data({0.8, 1.6}));
  EXPECT_EQ(walks.clamped(3.0), 1.6);
  EXPECT_EQ(angleBetween(poseOf(walks, 3.0, 0.2), poseOf(walks, 1.6, 0.2)), 0.0);
  EXPECT_TRUE(walks.isCaptured(0.0));
  EXPECT_FALSE(walks.isCaptured(1.7));
  const SpeedEngine runs(kDrawn.data({}, {2.5, 3.0}));
  EXPECT_EQ(runs.clamped(1.0), 2.5);
  EXPECT_FALSE(runs.isCaptured(1.0));
  const SpeedEngine both(kDrawn.data({0.8, 1.6}, {2.5, 3.0}));
  EXPECT_EQ(both.clamped(2.0), 2.0);
  EXPECT_FALSE(both.isCaptured(2.0));
  EXPECT_TRUE(both.isCaptured(2.7));
}

TEST(SpeedEngine, OneWhoWalksAsFastAsHeRunsChangesInTheMiddle) {
  const SpeedEngine engine(kDrawn.data({1.0, 2.4}, {1.8, 3.0}));
  EXPECT_EQ(engine.runShare(1.9), 0.0);
  EXPECT_NEAR(engine.runShare(2.1), 0.5, 1e-9);
  EXPECT_EQ(engine.runShare(2.3), 1.0);
}

}  // namespace
}  // namespace amble

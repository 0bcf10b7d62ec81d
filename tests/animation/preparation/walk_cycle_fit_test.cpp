#include "animation/preparation/walk_cycle_fit.h"

#include <gtest/gtest.h>

#include "animation/captures/bvh.h"
#include "animation/clips/floor_fit.h"
#include "animation/clips/mirror_clip.h"
#include "animation/library/motion_library_reader.h"
#include "animation/library/walk_cycle.h"
#include "base/error.h"
#include "base/rotation.h"
#include "tests/animation/captures.h"
#include "tests/animation/rig.h"

namespace amble {
namespace {

WalkCycle cycleOf(const Rig& rig, const Clip& clip, bool turning) {
  return prepareWalkCycle(clip, rig.roles, rig.feet, rig.reference(), {"the clip", turning, 8, {}});
}

/// Channel of a joint's rotation vector.
int channelOf(int joint, int axis) { return 3 + 3 * joint + axis; }

TEST(WalkCycle, AClipWithoutAWholeCycleIsRefusedByName) {
  const Rig rig;
  Puppet puppet;
  puppet.duration = 1.0;
  for (const bool turning : {false, true}) {
    try {
      cycleOf(rig, rig.walk(puppet), turning);
      FAIL() << "a cycle was found in one second";
    } catch (const InputError& error) {
      EXPECT_EQ(error.file(), "the clip");
    }
  }
}

TEST(WalkCycle, AStandingClipHasNoCycle) {
  const Rig rig;
  Puppet puppet;
  puppet.speed = 0.0;
  EXPECT_THROW(cycleOf(rig, rig.walk(puppet), false), InputError);
}

TEST(WalkCycle, FramesThatHoldNoWholeCycleAreRefused) {
  const Rig rig;
  const Clip clip = rig.walk(Puppet());
  const CycleOptions options{"the clip", false, 8, std::pair(100, 180)};
  EXPECT_THROW(prepareWalkCycle(clip, rig.roles, rig.feet, rig.reference(), options), InputError);
}

TEST(WalkCycle, SpeedAndPeriodOfAStraightWalkAreFound) {
  const Rig rig;
  for (const double speed : {0.8, 1.2}) {
    for (const double period : {1.0, 1.25}) {
      Puppet puppet;
      puppet.speed = speed;
      puppet.period = period;
      const WalkCycle cycle = cycleOf(rig, rig.walk(puppet), false);
      EXPECT_NEAR(cycle.speed, speed, 1e-6);
      EXPECT_NEAR(cycle.period, period, 1e-6);
      EXPECT_EQ(cycle.turn_rate, 0.0);
      EXPECT_NEAR(cycle.stepLength(), 0.5 * speed * period, 1e-6);
      EXPECT_LT(cycle.closure, 1e-5);  // the largest of several cycles
      EXPECT_LT(cycle.slide, 1e-5);    // slerp between frames
    }
  }
}

TEST(WalkCycle, SpeedAndTurnRateOfAWalkOnACircleAreFoundLeftPositive) {
  const Rig rig;
  for (const double turn_rate : {0.5, -0.5}) {
    Puppet puppet;
    puppet.speed = 1.0;
    puppet.turn_rate = turn_rate;
    const WalkCycle cycle = cycleOf(rig, rig.walk(puppet), true);
    EXPECT_NEAR(cycle.speed, 1.0, 1e-5);  // chords of a circle between frames
    EXPECT_NEAR(cycle.turn_rate, turn_rate, 1e-6);
    EXPECT_NEAR(cycle.period, puppet.period, 1e-6);
    EXPECT_LT(cycle.closure, 1e-5);  // the largest of several cycles
  }
}

TEST(WalkCycle, PhaseZeroIsTheMiddleOfTheDoubleSupportWithTheLeftFootInFront) {
  const Rig rig;
  const Puppet puppet;
  const WalkCycle cycle = cycleOf(rig, rig.walk(puppet), false);
  // The chest swings by the sine of the puppet's own phase, which is 0 as the left foot strikes.
  const int chest = channelOf(9, 1);
  const double shift =
      std::atan2(cycle.series.alpha(chest, 1), cycle.series.beta(chest, 1)) / (2.0 * kPi);
  EXPECT_NEAR(shift, 0.5 * (puppet.stance - 0.5), 0.01);
  EXPECT_NEAR(cycle.feet[kLeft].strike, 1.0 - 0.06, 0.03);
  EXPECT_NEAR(cycle.feet[kRight].strike, 0.5 - 0.06, 0.03);
  EXPECT_NEAR(cycle.feet[kRight].lift_off, 0.06, 0.03);
  EXPECT_NEAR(cycle.feet[kLeft].lift_off, 0.56, 0.03);
}

TEST(WalkCycle, TheSeriesIsTheMotionThatTheWalkWasDrawnFrom) {
  const Rig rig;
  const WalkCycle cycle = cycleOf(rig, rig.walk(Puppet()), false);
  const auto amplitude = [&](int channel, int k) {
    return std::hypot(cycle.series.alpha(channel, k), cycle.series.beta(channel, k));
  };
  EXPECT_NEAR(amplitude(channelOf(9, 1), 1), Rig::kChestSwing, 1e-4);
  EXPECT_NEAR(amplitude(2, 2), Rig::kBob, 2e-4);  // fitHeelRise moves the pelvis by as little
  EXPECT_NEAR(cycle.series.alpha(2, 0), Puppet::kHip, 1e-4);
  for (const int still : {channelOf(0, 0), channelOf(0, 1), channelOf(0, 2), channelOf(9, 0)}) {
    for (int k = 0; k <= 8; ++k) EXPECT_LT(amplitude(still, k), 1e-4);
  }
}

TEST(WalkCycle, FootprintsAreAsWideAndAsFarAheadAsTheyWereDrawn) {
  const Rig rig;
  Puppet puppet;
  puppet.width = 0.13;
  const WalkCycle cycle = cycleOf(rig, rig.walk(puppet), false);
  EXPECT_NEAR(cycle.step_width, 0.13, 1e-6);
  // Soles reach farther ahead of the ankle than behind it.
  for (const double forward : cycle.foot_forward)
    EXPECT_NEAR(forward, -rig.feet[kLeft].ankle_x, 0.01);
  EXPECT_NEAR(cycle.toe_out[kLeft], 0.0, 1e-6);
  EXPECT_NEAR(cycle.toe_out[kRight], 0.0, 1e-6);
}

TEST(WalkCycle, AMirroredWalkIsTheMirrorImage) {
  const Rig rig;
  Puppet puppet;
  puppet.speed = 1.0;
  puppet.turn_rate = 0.5;
  const Clip clip = rig.walk(puppet);
  const WalkCycle one = cycleOf(rig, clip, true);
  const WalkCycle other = cycleOf(rig, mirrorClip(clip, rig.roles), true);
  EXPECT_NEAR(other.turn_rate, -one.turn_rate, 1e-9);
  EXPECT_NEAR(other.speed, one.speed, 1e-9);
  EXPECT_NEAR(other.step_width, one.step_width, 1e-6);
  // What the left foot does at a phase, the right one of the mirrored walk does half a cycle later.
  const auto ahead = [](double a, double b) { return std::abs(std::remainder(a - b, 1.0)); };
  EXPECT_LT(ahead(other.feet[kRight].strike, one.feet[kLeft].strike + 0.5), 1e-6);
  EXPECT_LT(ahead(other.feet[kLeft].lift_off, one.feet[kRight].lift_off + 0.5), 1e-6);
}

TEST(WalkCycle, ACapturedWalkClosesAndHasItsSpeed) {
  AMBLE_NEEDS_CAPTURES();
  const MotionLibrary library = openMotionLibrary("default");
  Clip clip = readBvh(sharedFolder() / "mocap/accad_female1/Female1_B03_Walk1.bvh",
                      {.metres_per_unit = 0.01});
  const JointRoles roles = guessJointRoles(clip.skeleton, clip.name);
  clip = levelClip(clip, fitFloor(clip, roles), library.feet()[kLeft].ankle_height);
  const WalkCycle cycle = prepareWalkCycle(clip, roles, library.feet(), library.stand().rotations,
                                           {"B03", false, 8, {}});
  EXPECT_LT(cycle.closure, 0.03);                        // the largest of several cycles
  EXPECT_NEAR(cycle.speed, 1.061, 0.05 * 1.061);         // MANIFEST: mean_speed_by_unit_mps
  EXPECT_NEAR(0.5 * cycle.period, 0.623, 0.05 * 0.623);  // step_time_s
}

TEST(Posture, AStandingPoseIsTheMeanOfItsFrames) {
  const Rig rig;
  Puppet puppet;
  puppet.speed = 0.0;
  puppet.stance = 1.0;
  puppet.lift = 0.0;
  puppet.width = 0.2;
  puppet.duration = 1.09;  // whole swings of the chest, their first frame not twice
  const Clip clip = rig.walk(puppet);
  const Posture posture = preparePosture(clip, rig.roles, rig.feet, 0, clip.frames() - 1);
  EXPECT_NEAR(posture.root_height, Puppet::kHip, 1e-6);
  EXPECT_NEAR(posture.root_forward, rig.feet[kLeft].ankle_x, 1e-6);
  EXPECT_NEAR(posture.step_width, 0.2, 1e-6);
  EXPECT_NEAR(posture.toe_out[kLeft], 0.0, 1e-6);
  EXPECT_LT(posture.rotations[9].angularDistance(Eigen::Quaterniond::Identity()), 1e-6);
}

}  // namespace
}  // namespace amble

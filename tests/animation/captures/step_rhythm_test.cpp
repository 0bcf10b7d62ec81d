#include "animation/captures/step_rhythm.h"

#include <gtest/gtest.h>

#include "animation/captures/motion_reader.h"
#include "tests/animation/captures.h"
#include "tests/animation/person.h"

namespace amble {
namespace {

Clip walkOf(const Puppet& puppet) { return Rig().walk(puppet); }

TEST(StepRhythm, AClipWithoutStepsHasNone) {
  Puppet still;
  Clip clip = walkOf(still);
  clip.poses.resize(1);
  EXPECT_EQ(stepRhythm(clip, Rig().roles).steps, 0);
  EXPECT_EQ(stepRhythm(clip, Rig().roles).cadence, 0.0);
}

TEST(StepRhythm, IsTheWalkersInAnyUnitAndUnderAnyHeading) {
  for (const double turn_rate : {0.0, 0.4}) {
    Puppet puppet;
    puppet.turn_rate = turn_rate;
    Clip clip = walkOf(puppet);
    const StepRhythm metres = stepRhythm(clip, Rig().roles);
    EXPECT_NEAR(metres.cadence, 2.0 / puppet.period, 0.03);
    EXPECT_NEAR(metres.speed, puppet.speed / (Rig::kThigh + Rig::kShank), 0.03);
    EXPECT_NEAR(metres.ground_speed, metres.speed, 0.05 * metres.speed);
    clip.skeleton = clip.skeleton.scaled(100.0);
    for (int i = 0; i < clip.frames(); ++i) clip.poses.p_WR(i) *= 100.0;
    EXPECT_NEAR(stepRhythm(clip, Rig().roles).speed, metres.speed, 1e-9);
  }
}

TEST(StepRhythm, OnTheSpotTheGroundMoves) {
  Puppet puppet;
  Clip clip = walkOf(puppet);
  const StepRhythm walk = stepRhythm(clip, Rig().roles);
  for (int i = 0; i < clip.frames(); ++i) clip.poses.p_WR(i).x() = 0.0;
  const StepRhythm spot = stepRhythm(clip, Rig().roles);
  EXPECT_LT(spot.speed, 0.05);
  EXPECT_NEAR(spot.ground_speed, walk.ground_speed, 1e-9);
  EXPECT_NEAR(spot.cadence, walk.cadence, 1e-9);
}

TEST(StepRhythm, AFrameTimeKTimesTooShortMakesTheCadenceRootKTimesTheUsual) {
  Clip clip = walkOf(Puppet());
  const double right = cadenceOverUsual(stepRhythm(clip, Rig().roles), 0.92);
  clip.frame_time /= 4.0;
  EXPECT_NEAR(cadenceOverUsual(stepRhythm(clip, Rig().roles), 0.92), 2.0 * right, 1e-9);
}

TEST(StepRhythmOfCaptures, TheGroundGoesBackAsFastAsTheWalkerGoesOn) {
  AMBLE_NEEDS_CAPTURES();
  for (const Capture& capture : captures()) {
    if (capture.kind != "walk" && capture.kind != "walk_backward") continue;
    const CapturedMotion motion = readMotion(capture.file);
    const StepRhythm rhythm = stepRhythm(motion.clip, motion.roles);
    const double forwards = capture.kind == "walk" ? 1.0 : -1.0;
    // Feet are set down with their toes up, and roll on a little.
    EXPECT_NEAR(forwards * rhythm.ground_speed, 0.96 * rhythm.speed, 0.05 * rhythm.speed)
        << capture.path;
  }
}

}  // namespace
}  // namespace amble

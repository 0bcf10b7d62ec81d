#include "animation/synthesis/carriage_fit.h"

#include <gtest/gtest.h>

#include <cmath>

#include "animation/body/reference_pose.h"
#include "animation/synthesis/leg_reach.h"
#include "tests/animation/step_character.h"

namespace amble {
namespace {

/// The default library's character with its hips fitted.
struct Fitted {
  const StepCharacter& c = stepCharacter();
  const std::vector<Eigen::Quaterniond>& reference = c.library.stand().rotations;
  FootController feet{
      c.library.skeleton, c.library.roles, c.feet, c.blend,
      kneeAxes(c.library.roles, referenceOf(c.library.skeleton, c.library.roles, reference))};
  CarriageBody body{c.blend, reference, feet, c.settings().placement, 1.0};
  CarriageFit fit = fitCarriage(body, c.library.stand().root_height);
  WalkController walk{c.blend, reference, fit.stand_channels, fit.carriage};

  /// Distances from hip to ankle over the leg's length, the longer of both.
  double longestReach(const FrameState& state) const {
    AnimationBuffer buffer;
    buffer.poses = PoseArray(body.joints());
    buffer.poses.resize(1);
    buffer.states = {state};
    walk.apply(buffer);
    EXPECT_TRUE(feet.apply(buffer));
    std::vector<JointFrame> joints(body.joints());
    forwardKinematics(c.library.skeleton, buffer.poses[0], joints);
    double longest = 0.0;
    for (const Side side : {kLeft, kRight}) {
      const LegJoints& leg = c.library.roles.legs[side];
      longest = std::max(longest, (joints[leg.foot].p_WJ - joints[leg.up_leg].p_WJ).norm() /
                                      c.library.roles.legLength(c.library.skeleton, side));
    }
    return longest;
  }
};

TEST(CarriageFit, StandingKneesAreBentAsMuchAsTheyAreToBe) {
  const Fitted f;
  FrameState standing;
  standing.standing = 1.0;
  standing.feet = Footsteps::atStance(f.body.placement, {});
  EXPECT_LE(f.longestReach(standing), LegReach::kStanding + 1e-6);
  EXPECT_LE(f.fit.stand_channels[2], f.c.library.stand().root_height);
}

TEST(CarriageFit, NoLegOfTheStraightWalkIsStraighterThanItIsToBe) {
  const Fitted f;
  const double step = f.body.placement.step_length;
  for (const Side leading : {kLeft, kRight}) {
    const Stance stance{Eigen::Vector3d::Zero(), 0.0, false, leading};
    FrameState state;
    state.phase = leading == kLeft ? 0.0 : 0.5;
    state.step_length = step;
    state.feet = Footsteps::atStance(f.body.placement, stance);
    EXPECT_LE(f.longestReach(state), LegReach::kHeel + 1e-3);
  }
}

TEST(CarriageFit, LongerStepsLowerTheHipsNoLessAndTheShortestNotAtAll) {
  const Fitted f;
  const std::vector<double>& lowering = f.fit.carriage.lowering;
  ASSERT_EQ(lowering.size(), CarriageTuning::kLoweringSteps + 1u);
  EXPECT_EQ(lowering.front(), 0.0);
  for (const double lower : lowering) EXPECT_GE(lower, 0.0);
  EXPECT_GT(lowering.back(), lowering[lowering.size() / 2]);
}

TEST(CarriageFit, TheRootLeadsAtMostByTheLongestLeanBeyondTheCaptured) {
  const Fitted f;
  const double captured = f.body.placement.forward - f.c.blend.footForward();
  EXPECT_GE(f.fit.carriage.lead, captured);
  EXPECT_LE(f.fit.carriage.lead, captured + CarriageTuning::kLongestLean + 1e-12);
}

TEST(StrideCrouch, KeepsTheHipsRiseToWhatHipsDo) {
  const Fitted f;
  constexpr int kPhases = 48;
  for (const double share : {0.6, 1.0, 1.4}) {
    FrameState state;
    state.step_length = share * f.c.blend.law().capturedStep();
    double lowest = 1e9, highest = -1e9;
    for (int i = 0; i < kPhases; ++i) {
      state.phase = static_cast<double>(i) / kPhases;
      const double crouch = strideCrouch(f.walk, state, 1.0);
      // Exactly at the 24 phases that the fit goes by, within a millimetre between them.
      EXPECT_GE(crouch, i % 2 == 0 ? -1e-12 : -1e-3);
      const double height = f.walk.height(state.phase, state.step_length) - crouch;
      lowest = std::min(lowest, height);
      highest = std::max(highest, height);
    }
    EXPECT_GE(highest - lowest, CarriageTuning::kLeastRise - 2e-4) << share;
    EXPECT_LE(highest - lowest, CarriageTuning::kMostRise + 1e-3) << share;
    state.standing = 1.0;
    EXPECT_EQ(strideCrouch(f.walk, state, 1.0), 0.0);
  }
}

}  // namespace
}  // namespace amble

#include "animation/preparation/foot_cycle_fit.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/rotation.h"
#include "tests/animation/rig.h"

namespace amble {
namespace {

/// A rig's straight walk, and its left foot's cycle from frame 110 on (a strike) to 220.
struct FittedWalk {
  Rig rig;
  Puppet puppet;
  Clip clip;
  FootCycle foot;

  explicit FittedWalk(const Puppet& the_puppet = {}) : puppet(the_puppet), clip(rig.walk(puppet)) {
    const GaitTrack track(clip, rig.roles, rig.feet);
    foot = fitFootCycle(track, kLeft, rig.feet[kLeft], 110.0, 220.0, "the clip");
  }
};

TEST(FootCycleFit, AClipWithoutASwingIsRefusedByName) {
  const Rig rig;
  Puppet puppet;
  puppet.speed = 0.0;
  puppet.stance = 1.0;
  puppet.lift = 0.0;
  const Clip clip = rig.walk(puppet);
  const GaitTrack track(clip, rig.roles, rig.feet);
  try {
    fitFootCycle(track, kRight, rig.feet[kRight], 110.0, 220.0, "the clip");
    FAIL() << "a swing was found";
  } catch (const InputError& error) {
    EXPECT_EQ(error.file(), "the clip");
    EXPECT_NE(error.problem().find("right"), std::string::npos);
  }
}

TEST(FootCycleFit, StrikeAndLiftOffAreTheDrawnPhases) {
  const FittedWalk walk;
  EXPECT_NEAR(std::remainder(walk.foot.strike, 1.0), 0.0, 0.03);
  EXPECT_NEAR(walk.foot.lift_off, walk.puppet.stance, 0.03);
}

TEST(FootCycleFit, SwingsBeginAndEndAtRestOnTheirPrints) {
  const FittedWalk walk;
  const FootCycle& foot = walk.foot;
  EXPECT_EQ(swingProgress(foot, 0.0), 0.0);
  EXPECT_EQ(swingProgress(foot, 1.0), 1.0);
  for (const auto* c : {&foot.height, &foot.sideways, &foot.roll, &foot.yaw}) {
    EXPECT_EQ(swingPolynomial(*c, 0.0), 0.0);
    EXPECT_EQ(swingPolynomial(*c, 1.0), 0.0);
    EXPECT_NEAR(swingPolynomial(*c, 1e-6) / 1e-6, 0.0, 1e-4);
    EXPECT_NEAR(swingPolynomial(*c, 1.0 - 1e-6) / 1e-6, 0.0, 1e-4);
  }
  EXPECT_NEAR(swingProgress(foot, 1e-6) / 1e-6, 0.0, 1e-4);
}

TEST(FootCycleFit, ASwingFollowsTheDrawnFoot) {
  const FittedWalk walk;
  for (double tau = 0.1; tau < 0.95; tau += 0.1) {
    // Drawn: a smoothstep from print to print, lifted by a half sine above the ankle's height.
    EXPECT_NEAR(swingProgress(walk.foot, tau), tau * tau * (3.0 - 2.0 * tau), 0.05);
    EXPECT_NEAR(swingPolynomial(walk.foot.sideways, tau), 0.0, 1e-3);
    EXPECT_NEAR(swingPolynomial(walk.foot.yaw, tau), 0.0, 1e-3);
    EXPECT_NEAR(swingPolynomial(walk.foot.roll, tau), 0.0, 1e-3);
  }
  // Lifted over the line between where the plants found end and begin.
  const auto heightAt = [&](double phase) {
    return walk.puppet.ankle(kLeft, phase * walk.puppet.period).first.z() - Puppet::kAnkle;
  };
  const double ends = 0.5 * (heightAt(walk.foot.lift_off) + heightAt(walk.foot.strike));
  EXPECT_NEAR(swingPolynomial(walk.foot.height, 0.5), walk.puppet.lift - ends, 0.02);
}

TEST(FootCycleFit, AFlatFootHasNoPitch) {
  const FittedWalk walk;
  ASSERT_EQ(walk.foot.pitch.size(),
            static_cast<size_t>(FootCycle::kStanceSamples + FootCycle::kSwingSamples));
  for (const double pitch : walk.foot.pitch) EXPECT_NEAR(pitch, 0.0, 1e-4);
}

TEST(FootCycleFit, EverySwingClearsTheGround) {
  Puppet puppet;
  puppet.lift = 0.001;  // it shuffles
  const FittedWalk walk(puppet);
  for (double tau = 0.3; tau < 0.71; tau += 0.05) {
    EXPECT_GT(swingPolynomial(walk.foot.height, tau), 0.005);
  }
}

TEST(FootCycleFit, SlipIsHowFarTheFootMovesFromStrikeToLiftOff) {
  for (const double speed : {0.9, 1.1, 1.2}) {
    Puppet puppet;
    puppet.speed = speed;
    const FittedWalk walk(puppet);
    const auto placeAt = [&](double phase) {
      return puppet.ankle(kLeft, phase * puppet.period).first.x();
    };
    const double strike = walk.foot.strike > 0.5 ? walk.foot.strike - 1.0 : walk.foot.strike;
    EXPECT_NEAR(walk.foot.slip, placeAt(walk.foot.lift_off) - placeAt(strike), 0.004) << speed;
  }
}

class FootPlacings : public testing::TestWithParam<double> {};

// On a circle as on a line, since prints are seen from the points of the path beside them.
TEST_P(FootPlacings, AreWhatWasDrawn) {
  Puppet puppet;
  puppet.width = 0.14;
  puppet.turn_rate = GetParam();
  const FittedWalk walk(puppet);
  const GaitTrack track(walk.clip, walk.rig.roles, walk.rig.feet);
  const double middle = 110.0 + 0.5 * (puppet.stance - 0.5) * 110.0;  // of a double support
  const FittedPath path{puppet.pelvis(middle / puppet.rate).head<2>(),
                        puppet.heading(middle / puppet.rate), puppet.speed * puppet.period,
                        puppet.turn_rate * puppet.period};
  const FootPlacing placing = measurePlacing(track, middle, path, kLeft);
  EXPECT_NEAR(placing.width, 0.14, 1e-4);
  EXPECT_NEAR(placing.left, 0.0, 1e-4);
  EXPECT_NEAR(0.5 * (placing.forward[kLeft] + placing.forward[kRight]),
              -walk.rig.feet[kLeft].ankle_x, 1e-3);
  EXPECT_NEAR(placing.toe_out[kLeft], 0.0, 1e-4);
  EXPECT_LT(placing.slide, 1e-4);
}

INSTANTIATE_TEST_SUITE_P(, FootPlacings, testing::Values(0.0, 0.6, -0.9));

TEST(FootPitch, PassesThroughItsSamplesWithPeriodTwoAndNoJump) {
  FootCycle foot;
  constexpr int kStance = FootCycle::kStanceSamples, kSwing = FootCycle::kSwingSamples;
  for (int i = 0; i < kStance + kSwing; ++i) foot.pitch.push_back(std::sin(0.3 * i * i));
  for (int i = 0; i < kStance; ++i) {
    EXPECT_NEAR(footPitch(foot, static_cast<double>(i) / kStance), foot.pitch[i], 1e-12);
  }
  for (int i = 0; i < kSwing; ++i) {
    EXPECT_NEAR(footPitch(foot, 1.0 + static_cast<double>(i) / kSwing), foot.pitch[kStance + i],
                1e-12);
  }
  EXPECT_NEAR(footPitch(foot, 2.0), footPitch(foot, 0.0), 1e-12);
  for (double x = 0.0; x < 2.0; x += 0.001) {
    EXPECT_LT(std::abs(footPitch(foot, x + 1e-7) - footPitch(foot, x)), 1e-5);
  }
}

}  // namespace
}  // namespace amble

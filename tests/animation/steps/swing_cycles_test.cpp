#include "animation/steps/swing_cycles.h"

#include <gtest/gtest.h>

#include "tests/animation/step_character.h"

namespace amble {
namespace {

const SwingCycles& cycles() { return stepCharacter().blend.feet(); }

FootState walking(double turn_rate) {
  FootState state;
  state.turn_rate = turn_rate;
  return state;
}

/// What a foot does at a moment of its cycle and of its swing.
std::array<double, 4> doing(const FootBlend& foot, double x, double tau) {
  return {foot.pitch(x), foot.progress(tau), foot.polynomial(&FootCycle::height, tau),
          foot.polynomial(&FootCycle::yaw, tau)};
}

void expectSame(const FootBlend& a, const FootBlend& b, double tolerance) {
  for (double tau = 0.0; tau <= 1.0; tau += 0.05) {
    const auto here = doing(a, 2.0 * tau, tau), there = doing(b, 2.0 * tau, tau);
    for (size_t i = 0; i < here.size(); ++i) EXPECT_NEAR(here[i], there[i], tolerance) << i;
  }
}

TEST(SwingCycles, FeetAreTheTurnsAtItsRateAndTheStraightWalksOnTheStraight) {
  for (const Side side : {kLeft, kRight}) {
    expectSame(cycles().of(side, walking(0.0)), cycles().walk[side], 0.0);
    for (const int way : {0, 1}) {
      const double sign = way == 0 ? 1.0 : -1.0;
      ASSERT_FALSE(cycles().turns[way].empty());
      const std::vector<double>& rates = cycles().departures.turns[way];
      ASSERT_EQ(rates.size(), cycles().turns[way].size());
      for (size_t i = 0; i < rates.size(); ++i) {
        const FootCycle& turn = cycles().turns[way][i].cycles[side];
        expectSame(cycles().of(side, walking(sign * rates[i])), turn, 1e-12);
      }
      // The fastest is held.
      const FootCycle& last = cycles().turns[way].back().cycles[side];
      expectSame(cycles().of(side, walking(2.0 * sign * rates.back())), last, 0.0);
    }
  }
}

TEST(SwingCycles, FeetGoOverFromRateToRateWithoutAJump) {
  for (double rate = -1.3; rate < 1.3; rate += 0.01)
    expectSame(cycles().of(kLeft, walking(rate)), cycles().of(kLeft, walking(rate + 1e-6)), 1e-5);
}

// The default library's at 1.7 m/s: three paces are slower.
TEST(SwingCycles, FeetAndPrintsAreTheSlowerPacesAtTheirSpeeds) {
  const GaitBlend blend(stepCharacter().library, 1.0, 1.7);
  const SwingCycles& feet = blend.feet();
  const PrintPlace plans{0.01, 0.05, 0.1};
  ASSERT_EQ(feet.slower.size(), 3u);
  for (const Side side : {kLeft, kRight}) {
    for (size_t i = 0; i < feet.slower.size(); ++i) {
      FootState state = walking(0.0);
      state.slower = feet.departures.slower[i];
      expectSame(feet.of(side, state), feet.slower[i].cycles[side], 1e-12);
      const PrintPlace print = feet.print(side, plans, state.slower, 0.0);
      EXPECT_NEAR(print.forward, feet.slower[i].prints[side].forward, 1e-12);
      EXPECT_NEAR(print.left, feet.slower[i].prints[side].left, 1e-12);
      EXPECT_NEAR(print.toe_out, feet.slower[i].prints[side].toe_out, 1e-12);
    }
    // Of a captured turn nothing is left of either walk.
    FootState state = walking(feet.departures.turns[0].back());
    state.slower = feet.departures.slower[1];
    expectSame(feet.of(side, state), feet.turns[0].back().cycles[side], 1e-12);
  }
}

// A walk that is planned at a captured pace has the feet of one that slows to it.
TEST(SwingCycles, WhoSlowsToACapturedPaceHasTheFeetOfWhoAlwaysGoesAtIt) {
  const GaitBlend fast(stepCharacter().library, 1.0, 1.7);
  for (const double slower : fast.feet().departures.slower) {
    const GaitBlend slow(stepCharacter().library, 1.0, fast.feet().departures.steady - slower);
    FootState state;
    state.slower = slower;
    for (const Side side : {kLeft, kRight})
      expectSame(fast.feet().of(side, state), slow.foot(side), 1e-9);
  }
}

TEST(SwingCycles, StartsAndStopsAreTheirOwnWhateverTheTurn) {
  FootState state = walking(1.0);
  state.kind = SwingKind::kFirst;
  expectSame(cycles().of(kRight, state), cycles().first[kRight], 0.0);
  state.kind = SwingKind::kLast;
  expectSame(cycles().of(kRight, state), cycles().last[kRight], 0.0);
}

// A body that leans into a turn has its feet outside of its path.
TEST(SwingCycles, PrintsAreTheTurnsAtItsRate) {
  const PrintPlace straight{0.01, 0.05, 0.1};
  for (const int way : {0, 1}) {
    const double sign = way == 0 ? 1.0 : -1.0;
    for (size_t i = 0; i < cycles().turns[way].size(); ++i) {
      const OtherFeet& turn = cycles().turns[way][i];
      for (const Side side : {kLeft, kRight}) {
        const double rate = sign * cycles().departures.turns[way][i];
        const PrintPlace print = cycles().print(side, straight, 0.0, rate);
        EXPECT_NEAR(print.forward, turn.prints[side].forward, 1e-12);
        EXPECT_NEAR(print.left, turn.prints[side].left, 1e-12);
        EXPECT_NEAR(print.toe_out, turn.prints[side].toe_out, 1e-12);
      }
      EXPECT_LT(sign * (turn.prints[kLeft].left + turn.prints[kRight].left), 0.0);
    }
  }
  EXPECT_EQ(cycles().print(kLeft, straight, 0.0, 0.0).left, straight.left);
}

}  // namespace
}  // namespace amble

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
      for (const TurnFeet& turn : cycles().turns[way])
        expectSame(cycles().of(side, walking(sign * turn.rate)), turn.cycles[side], 1e-12);
      // The fastest is held.
      const TurnFeet& last = cycles().turns[way].back();
      expectSame(cycles().of(side, walking(2.0 * sign * last.rate)), last.cycles[side], 0.0);
    }
  }
}

TEST(SwingCycles, FeetGoOverFromRateToRateWithoutAJump) {
  for (double rate = -1.3; rate < 1.3; rate += 0.01)
    expectSame(cycles().of(kLeft, walking(rate)), cycles().of(kLeft, walking(rate + 1e-6)), 1e-5);
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
    for (const TurnFeet& turn : cycles().turns[way]) {
      for (const Side side : {kLeft, kRight}) {
        const PrintPlace print = cycles().print(side, straight, sign * turn.rate);
        EXPECT_NEAR(print.forward, turn.prints[side].forward, 1e-12);
        EXPECT_NEAR(print.left, turn.prints[side].left, 1e-12);
        EXPECT_NEAR(print.toe_out, turn.prints[side].toe_out, 1e-12);
      }
      EXPECT_LT(sign * (turn.prints[kLeft].left + turn.prints[kRight].left), 0.0);
    }
  }
  EXPECT_EQ(cycles().print(kLeft, straight, 0.0).left, straight.left);
}

}  // namespace
}  // namespace amble

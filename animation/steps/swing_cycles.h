/// Whose captured swing a foot follows, and where it is put down: the straight walk's, those of
/// turns, or those of a captured start or stop.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "animation/body/joint_roles.h"
#include "animation/steps/foot_blend.h"
#include "animation/steps/foot_state.h"
#include "animation/steps/print_place.h"
#include "animation/steps/turn_shares.h"

namespace amble {

/// The feet of a captured turn.
struct TurnFeet {
  double rate = 0.0;  ///< [rad/s, > 0], whichever way
  std::array<FootCycle, 2> cycles;
  std::array<PrintPlace, 2> prints;
};

/// All by Side. Where nothing is captured of first and last steps, they are the walk's.
struct SwingCycles {
  std::array<FootCycle, 2> walk, first, last;
  FootCycle spot;                              ///< of either foot (spotStep)
  std::array<std::vector<TurnFeet>, 2> turns;  ///< to the left, to the right; by growing rate

  FootBlend of(Side side, const FootState& state) const {
    switch (state.kind) {
      case SwingKind::kFirst:
        return first[side];
      case SwingKind::kLast:
        return last[side];
      case SwingKind::kSpot:
        return spot;
      case SwingKind::kWalk:
        break;
    }
    FootBlend blend;
    const TurnShares shares = sharesAt(state.turn_rate);
    const double straight = 1.0 - shares.of_low - shares.of_next;
    if (straight > 0.0) blend.add(walk[side], straight);
    const std::vector<TurnFeet>& all = turnsAt(state.turn_rate);
    if (shares.of_low > 0.0) blend.add(all[shares.low].cycles[side], shares.of_low);
    if (shares.of_next > 0.0) blend.add(all[shares.low + 1].cycles[side], shares.of_next);
    return blend;
  }

  /// Where a foot is put down at a turn rate [rad/s, left positive], that is put down at `straight`
  /// where the path is.
  PrintPlace print(Side side, const PrintPlace& straight, double turn_rate) const {
    PrintPlace place = straight;
    const TurnShares shares = sharesAt(turn_rate);
    const std::vector<TurnFeet>& all = turnsAt(turn_rate);
    const auto add = [&](size_t turn, double share) {
      if (share == 0.0) return;
      const PrintPlace& there = all[turn].prints[side];
      place.forward += share * (there.forward - straight.forward);
      place.left += share * (there.left - straight.left);
      place.toe_out += share * (there.toe_out - straight.toe_out);
    };
    add(shares.low, shares.of_low);
    add(shares.low + 1, shares.of_next);
    return place;
  }

 private:
  const std::vector<TurnFeet>& turnsAt(double rate) const { return turns[rate > 0.0 ? 0 : 1]; }
  TurnShares sharesAt(double rate) const {
    const std::vector<TurnFeet>& all = turnsAt(rate);
    return turnShares(
        all.size(), [&](size_t i) { return all[i].rate; }, std::abs(rate));
  }
};

}  // namespace amble

/// Whose captured swing a foot follows, and where it is put down: the straight walk's at the plan's
/// speed, a slower one's, those of turns, or those of a captured start or stop.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "animation/body/joint_roles.h"
#include "animation/steps/foot_blend.h"
#include "animation/steps/foot_state.h"
#include "animation/steps/print_place.h"
#include "animation/steps/walk_shares.h"

namespace amble {

/// The feet of a captured walk other than the plan's.
struct OtherFeet {
  std::array<FootCycle, 2> cycles;
  std::array<PrintPlace, 2> prints;
};

/// All by Side. Where nothing is captured of first and last steps, they are the walk's.
struct SwingCycles {
  std::array<FootCycle, 2> walk, first, last;
  FootCycle spot;  ///< of either foot (spotStep)
  WalkDepartures departures;
  std::vector<OtherFeet> slower;                ///< as WalkDepartures::slower
  std::array<std::vector<OtherFeet>, 2> turns;  ///< as WalkDepartures::turns

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
    if (state.slower == 0.0 && state.turn_rate == 0.0) return walk[side];
    FootBlend blend;
    const auto addOthers = [&](const std::vector<OtherFeet>& all, const CapturedShares& shares,
                               double of) {
      if (of * shares.of_low > 0.0) blend.add(all[shares.low].cycles[side], of * shares.of_low);
      if (of * shares.of_next > 0.0)
        blend.add(all[shares.low + 1].cycles[side], of * shares.of_next);
    };
    const WalkShares shares = departures.at(state.slower, state.turn_rate);
    const double plans = shares.straight * shares.plans;
    if (plans > 0.0) blend.add(walk[side], plans);
    addOthers(slower, shares.slower, shares.straight);
    addOthers(turns[shares.way], shares.turning, 1.0);
    return blend;
  }

  /// The highest that a function of a cycle is, of all that walks' swings are blended of.
  template <typename Of>
  double most(const Of& of) const {
    double highest = -HUGE_VAL;
    const auto look = [&](const std::array<FootCycle, 2>& feet) {
      for (const FootCycle& foot : feet) highest = std::max(highest, of(foot));
    };
    for (const auto* feet : {&walk, &first, &last}) look(*feet);
    for (const auto* others : {&slower, &turns[0], &turns[1]})
      for (const OtherFeet& other : *others) look(other.cycles);
    return highest;
  }

  /// Where a foot is put down that is at `plans` in the plan's straight walk, where the path is.
  /// @param slower_by  [m/s, >= 0]; @param turn_rate  [rad/s, left positive]
  PrintPlace print(Side side, const PrintPlace& plans, double slower_by, double turn_rate) const {
    const WalkShares shares = departures.at(slower_by, turn_rate);
    PrintPlace place = moved(plans, slower, shares.slower, side);
    return moved(place, turns[shares.way], shares.turning, side);
  }

 private:
  // Towards the prints of other walks, by their shares.
  static PrintPlace moved(const PrintPlace& from, const std::vector<OtherFeet>& others,
                          const CapturedShares& shares, Side side) {
    PrintPlace place = from;
    const auto add = [&](size_t i, double share) {
      if (share == 0.0) return;
      const PrintPlace& there = others[i].prints[side];
      place.forward += share * (there.forward - from.forward);
      place.left += share * (there.left - from.left);
      place.toe_out += share * (there.toe_out - from.toe_out);
    };
    add(shares.low, shares.of_low);
    add(shares.low + 1, shares.of_next);
    return place;
  }
};

}  // namespace amble

/// Of which captured walks a walk is made where it goes so fast and turns so fast: body and feet
/// alike.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "animation/steps/captured_shares.h"

namespace amble {

/// Turns have their shares of a walk; of the straight rest, the plan's walk and slower paces
/// theirs.
struct WalkShares {
  CapturedShares turning;  ///< of WalkDepartures::turns[way]
  int way = 0;             ///< 0 to the left, 1 to the right
  double straight = 1.0;   ///< what turns leave [0, 1]
  CapturedShares slower;   ///< of the straight rest: of WalkDepartures::slower
  double plans = 1.0;      ///< of the straight rest: the plan's straight walk [0, 1]
};

/// How far the captured walks of a library depart from the straight walk at the plan's speed.
struct WalkDepartures {
  /// Speeds that differ from the plan's by less than this share are the plan's: whole steps and
  /// whole frames take as much; half of the way to the next slower pace at most [1].
  static constexpr double kSteady = 0.02;

  double steady = 0.0;  ///< from so fast on the walk is the plan's [m/s]
  /// By how much the slower captured paces are below that, growing [m/s, > 0].
  std::vector<double> slower;
  std::array<std::vector<double>, 2> turns;  ///< to the left, to the right, growing [rad/s, > 0]

  /// The captured paces below the plan's speed. @param paces  growing [m/s, > 0]
  void setPaces(const std::vector<double>& paces, double plans_speed) {
    const double speed = std::min(plans_speed, paces.back());
    const auto below = std::lower_bound(paces.begin(), paces.end(), speed);
    slower.clear();
    if (below == paces.begin()) return;
    const double next = *(below - 1);
    steady = speed - std::min(kSteady * speed, 0.5 * (speed - next));
    for (auto pace = below; pace != paces.begin();) slower.push_back(steady - *--pace);
  }

  /// How much slower than the plan's a walk of a speed [m/s] is; no slower than the slowest
  /// captured pace [m/s, >= 0].
  double slowerBy(double speed) const {
    return slower.empty() ? 0.0 : std::clamp(steady - speed, 0.0, slower.back());
  }

  /// @param slower_by  slowerBy() [m/s]; @param turn_rate  [rad/s, left positive]
  WalkShares at(double slower_by, double turn_rate) const {
    WalkShares shares;
    shares.way = turn_rate > 0.0 ? 0 : 1;
    shares.turning = of(turns[shares.way], std::abs(turn_rate));
    shares.straight = 1.0 - shares.turning.of_low - shares.turning.of_next;
    shares.slower = of(slower, slower_by);
    const bool all_slower = shares.slower.low > 0 || shares.slower.of_next > 0.0;
    shares.plans = all_slower ? 0.0 : 1.0 - shares.slower.of_low;
    return shares;
  }

 private:
  static CapturedShares of(const std::vector<double>& walks, double departure) {
    return capturedShares(
        walks.size(), [&](size_t i) { return walks[i]; }, departure);
  }
};

}  // namespace amble

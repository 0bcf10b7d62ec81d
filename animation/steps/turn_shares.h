/// How much of which captured turn there is in a walk that turns at a rate.
#pragma once

#include <cmath>
#include <cstddef>

#include "base/ease.h"

namespace amble {

/// Of turns by growing rate [rad/s, > 0]: of turn `low` and of the one after it; what is left to 1
/// is the straight walk's. Without a kink: rates change quickly where a curve begins.
struct TurnShares {
  std::size_t low = 0;
  double of_low = 0.0, of_next = 0.0;  ///< [0, 1]
};

/// @param count  of turns; @param rate_of  of turn i [rad/s]; @param rate  [rad/s, >= 0]. Slower
/// than the slowest turn there is a part of that; the fastest is held.
template <typename RateOf>
TurnShares turnShares(std::size_t count, const RateOf& rate_of, double rate) {
  if (count == 0 || rate == 0.0) return {};
  if (rate <= rate_of(0)) return {0, smoothstep(rate / rate_of(0)), 0.0};
  for (std::size_t i = 1; i < count; ++i) {
    if (rate >= rate_of(i)) continue;
    const double share = smoothstep((rate - rate_of(i - 1)) / (rate_of(i) - rate_of(i - 1)));
    return {i - 1, 1.0 - share, share};
  }
  return {count - 1, 1.0, 0.0};
}

}  // namespace amble

/// How much of which captured walk there is in one that departs from the plan's straight walk by so
/// much: that turns at a rate, or that is slower.
#pragma once

#include <cmath>
#include <cstddef>

#include "base/ease.h"

namespace amble {

/// Of walks by growing departure [> 0]: of walk `low` and of the one after it; what is left to 1 is
/// the plan's straight walk's. Without a kink: rates change quickly where a curve begins.
struct CapturedShares {
  std::size_t low = 0;
  double of_low = 0.0, of_next = 0.0;  ///< [0, 1]
};

/// @param count  of walks; @param departure_of  of walk i [rad/s or m/s, > 0]; @param departure the
/// same [>= 0]. Below the least there is a part of that walk; the farthest is held.
template <typename DepartureOf>
CapturedShares capturedShares(std::size_t count, const DepartureOf& departure_of,
                              double departure) {
  if (count == 0 || departure == 0.0) return {};
  if (departure <= departure_of(0)) return {0, smoothstep(departure / departure_of(0)), 0.0};
  for (std::size_t i = 1; i < count; ++i) {
    const double from = departure_of(i - 1), to = departure_of(i);
    if (departure >= to) continue;
    const double share = smoothstep((departure - from) / (to - from));
    return {i - 1, 1.0 - share, share};
  }
  return {count - 1, 1.0, 0.0};
}

}  // namespace amble

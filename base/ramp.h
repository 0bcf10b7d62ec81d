/// A value that may change over a walk.
#pragma once

namespace amble {

/// `0.5`, or `0.5..0.9` from its begin to its end.
struct Ramp {
  double from = 0.0, to = 0.0;

  double at(double share) const { return from + share * (to - from); }  ///< share [0, 1]
};
}  // namespace amble

/// Equal parts of a length, as many wherever the length lies.
#pragma once

#include <algorithm>
#include <cmath>

namespace amble {

/// The fewest equal parts that are no longer than `longest`, at least one. Of a length that is a
/// whole number of them by a billionth as many: one and the same path has as many parts wherever it
/// lies, though its length comes out rounded otherwise.
/// @param length  [>= 0] @param longest  [> 0, same unit]
inline int partsOf(double length, double longest) {
  return std::max(1, static_cast<int>(std::ceil(length / longest - 1e-9)));
}

}  // namespace amble

/// Curves from 0 to 1 that begin and end at rest.
#pragma once

#include <algorithm>

namespace amble {

/// 3 t^2 - 2 t^3, its slope 0 at both ends. t is clamped to [0, 1].
inline double smoothstep(double t) {
  t = std::clamp(t, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

/// Minimum jerk from rest to rest (Flash & Hogan 1985): slope and curvature 0 at both ends. t is
/// clamped to [0, 1].
inline double minimumJerk(double t) {
  t = std::clamp(t, 0.0, 1.0);
  return t * t * t * (10.0 + t * (-15.0 + 6.0 * t));
}

}  // namespace amble

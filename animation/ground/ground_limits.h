/// The steepest ground and the highest steps that a character takes: asked by what chooses
/// footholds, by what finds a scene's ground and by what plans on it.
#pragma once

#include "base/rotation.h"

namespace amble {

struct GroundLimits {
  /// Steepest ground, up or down: public ramps end at 1:12, 4.8 degrees (ADA), hillside paths near
  /// 20 [rad, 0 to 45 degrees].
  double max_slope = 20.0 * kDegree;
  /// Highest step up and down: stairs of dwellings rise by 0.14 to 0.20 m (DIN 18065) [m, 0 to 1].
  double max_climb = 0.25;
  double max_drop = 0.25;

  /// The higher of the two: where steps lead at all [m].
  double highestStep() const { return max_climb > max_drop ? max_climb : max_drop; }

  bool operator==(const GroundLimits& other) const = default;
};

}  // namespace amble

/// The small step in which people turn where they stand. Of captured turns the feet are not taken:
/// they pivot. Here the heel rises first, the foot goes up and down once and is put down flat.
#pragma once

#include "animation/library/foot_cycle.h"
#include "base/rotation.h"

namespace amble {

struct SpotStep {
  /// Of the sole, for a captured subject; grows with scale. Captured small steps lift toes by 4 to
  /// 5 cm and ankles by 6 to 11; who lifts both by less than a fifteenth of a leg is told to slide
  /// by those who look for planted feet (PlantOptions::height) [m].
  static constexpr double kLift = 0.06;
  /// Highest pitch, toes down, a third of the way through the swing [rad].
  static constexpr double kPitch = 12.0 * kDegree;
};

/// Swing and roll of either foot in such a step. @param scale  of the character to the captured
/// subject [> 0]
FootCycle spotStep(double scale);

}  // namespace amble

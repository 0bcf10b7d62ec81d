#include "animation/steps/slope_gait.h"

#include <algorithm>
#include <cmath>

#include "base/ease.h"

namespace amble {

using Gait = SlopeGait;

double slopePace(double slope) {
  return std::min(1.0, std::exp(-Gait::kOnSight * Gait::kSlowing *
                                (std::abs(slope + Gait::kFastest) - Gait::kFastest)));
}

double slopeLean(double slope) {
  return (slope > 0.0 ? Gait::kLeanUp : Gait::kLeanDown) * std::atan(slope);
}

double slopeStrike(const FootPlace& place) {
  const double rise = tiltAlong(place, {std::cos(place.heading), std::sin(place.heading)});
  return std::clamp(1.0 - rise / Gait::kFlatStrike, 0.0, 1.0);
}

double climbStrike(double strike, double height, double scale) {
  const double flat = smoothstep(std::abs(height) / (Gait::kFlatLanding * scale));
  strike *= 1.0 - flat;
  return height < 0.0 ? strike - flat : strike;
}

double climbTime(double height, double scale) {
  const double rises = height / (Gait::kStairRise * scale);
  return 1.0 + std::abs(rises) * (rises > 0.0 ? Gait::kSlowerUp : Gait::kSlowerDown);
}

double climbStep(double level, double height) {
  return level / (1.0 + height * height / (Gait::kHalvingHeight * Gait::kHalvingHeight));
}

}  // namespace amble

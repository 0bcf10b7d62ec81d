#include "animation/slope_ground.h"

namespace amble {

SlopeGround::SlopeGround(double incline, double heading)
    : cos_heading_(std::cos(heading)),
      sin_heading_(std::sin(heading)),
      rise_(std::tan(incline)),
      normal_(-std::sin(incline) * cos_heading_, -std::sin(incline) * sin_heading_,
              std::cos(incline)) {}

std::optional<SurfacePoint> SlopeGround::surface(double x, double y, double z, double reach) const {
  const double height = rise_ * (cos_heading_ * x + sin_heading_ * y);
  if (!(std::abs(height - z) <= reach)) return std::nullopt;
  return SurfacePoint{height, normal_};
}

}  // namespace amble

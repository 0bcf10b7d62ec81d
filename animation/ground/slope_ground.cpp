#include "animation/ground/slope_ground.h"

#include <algorithm>

namespace amble {

SlopeGround::SlopeGround(double from, double to, double length, double heading)
    : from_(from),
      to_(to),
      length_(length),
      cos_heading_(std::cos(heading)),
      sin_heading_(std::sin(heading)) {}

double SlopeGround::incline(double along) const {
  return from_ + (to_ - from_) * std::clamp(along / length_, 0.0, 1.0);
}

// The integral of tan(a + b s) over s is -ln(cos(a + b s)) / b; planes before and behind.
double SlopeGround::height(double along) const {
  if (from_ == to_ || along <= 0.0) return std::tan(from_) * along;
  const double within = std::min(along, length_), bend = (to_ - from_) / length_;
  const double bent = std::log(std::cos(from_) / std::cos(incline(within))) / bend;
  return bent + std::tan(to_) * (along - within);
}

std::optional<SurfacePoint> SlopeGround::surface(double x, double y, double z, double reach) const {
  const double along = cos_heading_ * x + sin_heading_ * y, level = height(along);
  if (!(std::abs(level - z) <= reach)) return std::nullopt;
  const double sine = std::sin(incline(along));
  return SurfacePoint{level,
                      {-sine * cos_heading_, -sine * sin_heading_, std::cos(incline(along))}};
}

}  // namespace amble

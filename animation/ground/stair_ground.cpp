#include "animation/ground/stair_ground.h"

#include <algorithm>

namespace amble {

StairGround::StairGround(const Stairs& stairs)
    : stairs_(stairs),
      cos_heading_(std::cos(stairs.heading)),
      sin_heading_(std::sin(stairs.heading)) {}

std::optional<SurfacePoint> StairGround::surface(double x, double y, double z, double reach) const {
  const double along = cos_heading_ * x + sin_heading_ * y;
  // Risers passed, as many as lie behind; on a riser itself, those that leave the higher tread.
  const double risers = (along - stairs_.start) / stairs_.going;
  const double passed = stairs_.rise > 0.0 ? std::floor(risers) + 1.0 : std::ceil(risers);
  const double height = stairs_.rise * std::clamp(passed, 0.0, static_cast<double>(stairs_.count));
  if (!(std::abs(height - z) <= reach)) return std::nullopt;
  return SurfacePoint{height, Eigen::Vector3d::UnitZ()};
}

}  // namespace amble

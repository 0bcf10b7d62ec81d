/// An inclined plane without end, through the origin: what walks on slopes are measured on.
#pragma once

#include "animation/ground.h"

namespace amble {

class SlopeGround : public Ground {
 public:
  /// @param incline  climbs by it along `heading` [rad, above -90 and below 90 degrees]
  explicit SlopeGround(double incline, double heading = 0.0);

  std::optional<SurfacePoint> surface(double x, double y, double z, double reach) const override;

 private:
  double cos_heading_, sin_heading_;
  double rise_;  // per metre along the heading [1]
  Eigen::Vector3d normal_;
};

}  // namespace amble

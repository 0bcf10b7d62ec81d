/// An inclined plane without end, or ground whose incline changes: what walks on slopes are
/// measured on.
#pragma once

#include "animation/ground/ground.h"

namespace amble {

/// Level across the heading, z = 0 at the origin.
class SlopeGround : public Ground {
 public:
  /// @param incline  climbs by it along `heading` [rad, above -90 and below 90 degrees]
  explicit SlopeGround(double incline, double heading = 0.0)
      : SlopeGround(incline, incline, 1.0, heading) {}
  /// The incline goes evenly from one value at the origin to another after `length` [m, > 0], and
  /// stays beyond.
  SlopeGround(double from, double to, double length, double heading = 0.0);

  std::optional<SurfacePoint> surface(double x, double y, double z, double reach) const override;
  double incline(double along) const;  ///< [rad]
  double height(double along) const;   ///< [m]
  using Ground::height;

 private:
  double from_, to_, length_;
  double cos_heading_, sin_heading_;
};

}  // namespace amble

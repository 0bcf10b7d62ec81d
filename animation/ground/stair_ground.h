/// A straight flight of stairs between two level floors, without end to the sides: what walks on
/// stairs are measured on.
#pragma once

#include "animation/ground/ground.h"

namespace amble {

struct Stairs {
  double rise = 0.17;    ///< from tread to tread; negative: the flight goes down [m]
  double going = 0.29;   ///< from nosing to nosing [m, > 0]
  int count = 10;        ///< risers: one more than treads between the two floors [>= 1]
  double start = 0.0;    ///< of the first riser, along the heading [m]
  double heading = 0.0;  ///< in which it is walked [rad]
};

/// The floor before the first riser is z = 0, that behind the last is z = count * rise. Risers are
/// upright; on one, the higher tread counts.
class StairGround : public Ground {
 public:
  explicit StairGround(const Stairs& stairs);

  const Stairs& stairs() const { return stairs_; }
  std::optional<SurfacePoint> surface(double x, double y, double z, double reach) const override;

 private:
  Stairs stairs_;
  double cos_heading_, sin_heading_;
};

}  // namespace amble

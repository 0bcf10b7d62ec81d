/// A capsule in World: all points no farther than `radius` from the segment of its axis.
#pragma once

#include <Eigen/Geometry>

namespace amble {

struct Capsule {
  Eigen::Vector3d from;  ///< ends of the axis [m]
  Eigen::Vector3d to;
  double radius = 0.0;  ///< [m, >= 0]

  Eigen::AlignedBox3d bounds() const {
    const Eigen::Vector3d r = Eigen::Vector3d::Constant(radius);
    return {from.cwiseMin(to) - r, from.cwiseMax(to) + r};
  }
  /// Height of its lowest point [m].
  double lowest() const { return std::min(from.z(), to.z()) - radius; }
  Capsule inflated(double by) const { return {from, to, radius + by}; }
};

}  // namespace amble

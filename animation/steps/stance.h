/// A stance: what a node of the roadmap is (DESIGN.md, section 3).
#pragma once

#include <Eigen/Core>

#include "animation/body/joint_roles.h"

namespace amble {

/// Standing, or the middle of a double support of the straight walk.
struct Stance {
  /// The root path's point, on the ground [m, World].
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  double heading = 0.0;  ///< 0 faces +x, left positive [rad]
  bool standing = true;
  /// The foot in front: phase 0 for left, 0.5 for right. Without meaning while standing.
  Side leading = kLeft;
  /// The walk's speed there, of the plan's on such ground: people slow down for a tight curve
  /// before they are in it. Without meaning while standing. [> 0, at most 1]
  double pace = 1.0;
};

}  // namespace amble

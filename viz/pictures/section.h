/// A scene cut by an upright plane: what a walk seen from the side goes over and under.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "environments/scene/scene.h"

namespace amble {

/// From the point that was asked for: how far along the plane, and the height [m].
struct SectionLine {
  Eigen::Vector2d from, to;
};

/// Triangles of a scene in World, and where a plane goes through them.
class SceneSection {
 public:
  /// Of all things that may be walked on or into.
  explicit SceneSection(const Scene& scene);

  /// The lines in which the upright plane through `point` and `along` cuts them, as far as `reach`
  /// to both sides. Cost: linear in triangles.
  /// @param point  [m, World] @param along  unit, level
  std::vector<SectionLine> cut(const Eigen::Vector3d& point, const Eigen::Vector3d& along,
                               double reach) const;

 private:
  std::vector<Eigen::Vector3d> corners_;  // three a triangle
};

}  // namespace amble

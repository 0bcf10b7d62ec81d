/// Things that a capsule may touch, exactly: meshes as surfaces with their closed components solid,
/// primitives solid.
///
/// Meshes and boxes are trees of triangles (TriangleTree), spheres and capsules axes with a radius;
/// FCL answers for cylinders (fcl_surface.h) and, where it is asked for as the checker, for
/// everything. Which obstacles are asked at all a tree of their boxes says (BoxTree).
#pragma once

#include <Eigen/Geometry>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "environments/body/capsule.h"
#include "environments/collision/contact.h"
#include "environments/scene/parity.h"
#include "environments/scene/scene.h"

namespace amble {

/// One rigid thing of the set.
struct Obstacle {
  int object = 0;  ///< of the scene; obstacles are given in ascending order of it
  Shape shape;
  Eigen::Isometry3d X_WO = Eigen::Isometry3d::Identity();
  /// World; what is solid. Empty for primitives, which are anyway.
  SolidMesh solid;
  std::shared_ptr<const Parity> inside = {};  ///< of `solid`, where it is made already
};

/// Inside of what is solid: the obstacle's own, or made for who asks.
std::shared_ptr<const Parity> insideOf(const Obstacle& obstacle);

class ObstacleSet {
 public:
  /// Memory of one thread's queries.
  class Scratch;
  struct ScratchDeleter {
    void operator()(Scratch*) const;
  };
  using ScratchPtr = std::unique_ptr<Scratch, ScratchDeleter>;

  /// @throws Stopped if that is asked for.
  explicit ObstacleSet(const std::vector<Obstacle>& obstacles, const StopRequest& stop = {},
                       Checker checker = Checker::kFast);
  ~ObstacleSet();
  ObstacleSet(ObstacleSet&&) noexcept;

  static ScratchPtr makeScratch();

  /// Of all obstacles [m]; empty for none.
  const Eigen::AlignedBox3d& bounds() const;
  /// The first object, by number, that the capsule touches or lies in, of those behind number
  /// `after`; -1 for none.
  int touched(const Capsule& capsule, Scratch& scratch, int after = -1) const;

  struct Nearest {
    double distance = 0.0;  ///< [m], 0 where it touches or lies inside
    int object = -1;        ///< -1 where nothing is nearer than the limit
  };
  /// Distance to the nearest obstacle, if it is less than `limit` [m]; else `limit` and no object.
  Nearest nearest(const Capsule& capsule, double limit, Scratch& scratch) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace amble

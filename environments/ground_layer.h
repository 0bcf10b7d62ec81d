/// The ground as a thing to touch: a layer of its own, apart from the obstacles, since feet are
/// always near it.
///
/// A capsule is free of it if it neither touches its surfaces nor lies under them. What is allowed
/// to sink in is lifted by that depth first. Most questions are answered by a height: the layer's
/// ceiling where the capsule is.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "environments/capsule.h"
#include "environments/obstacle_set.h"
#include "environments/scene_ground.h"

namespace amble {

class GroundLayer {
 public:
  /// @param surfaces  of ground objects, all below the floor's height + SceneGround::kLevel; meshes
  /// in World
  /// @pre `ground` outlives the layer.
  GroundLayer(std::vector<Obstacle> surfaces, const SceneGround& ground);

  double highest() const { return highest_; }  ///< of all; -infinity for none [m]
  /// No surface over or under the box's footprint is higher than this; -infinity where there is
  /// none [m].
  double ceiling(const Eigen::AlignedBox3d& box) const;
  /// The object that the capsule touches or lies under, when it is lifted by `depth` [m, >= 0]; -1
  /// for none.
  int touched(const Capsule& capsule, double depth, ObstacleSet::Scratch& scratch) const;

 private:
  static constexpr double kCell = 0.1;  // [m]; larger for scenes beyond kMostCells
  static constexpr int kMostCells = 2000;
  struct Footprint {
    int object;
    Eigen::AlignedBox2d box;
  };

  void raise(const Obstacle& surface);
  Eigen::Vector2i cellOf(const Eigen::Vector2d& p) const;

  const SceneGround& ground_;
  ObstacleSet surfaces_;
  std::vector<Footprint> footprints_;
  Eigen::AlignedBox2d extent_;
  double cell_ = kCell, highest_;
  Eigen::Vector2i count_{0, 0};
  std::vector<double> ceiling_;  // x fastest [m]
};

}  // namespace amble

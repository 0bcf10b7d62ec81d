/// How high and how low ground is around a place: between what both feet of somebody there stand
/// on.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "environments/ground/scene_ground.h"
#include "planner/steering/ground_reach.h"

namespace amble {

class GroundRange {
 public:
  /// Of ground in one layer that is reached; of others it knows nothing anywhere. @param far  to
  /// each side [m, > 0]. Cost: linear in the squares of GroundCells; nothing where the ground is
  /// level.
  GroundRange(const SceneGround& ground, const ReachedGround& reached, double far);

  bool isKnown() const { return is_level_ || !ranges_.empty(); }
  /// Empty where there is no ground around, or none is known [m, World].
  Eigen::AlignedBox1d around(const Eigen::Vector2d& p) const;

 private:
  using Ranges = std::vector<Eigen::AlignedBox1d>;
  const GroundCells& cells_;
  bool is_level_;
  Eigen::AlignedBox1d level_;
  Ranges ranges_;  // by square, x fastest; empty where the ground is level
};

}  // namespace amble

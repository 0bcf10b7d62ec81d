/// How high a body's middle may be carried at a place: between the lowest and the highest line from
/// ground to ground that passes there.
///
/// The root is midway between both feet at each step, in plan and in height, and on a smooth curve
/// through these middles between them. So over stairs and slopes it keeps to lines between places
/// where feet stand, before and behind it, and not to the lowest or the highest ground that a foot
/// may be on there: on a flight by decimetres.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "environments/ground/scene_ground.h"
#include "planner/steering/ground_reach.h"

namespace amble {

class GroundChords {
 public:
  /// Of ground that is reached. @param longest  of such a line, in plan [m, > 0]. Cost: linear in
  /// the squares of GroundCells; nothing where the ground is level. @pre the ground outlives it
  GroundChords(const SceneGround& ground, const ReachedGround& reached, double longest);

  /// Between the heights of all lines through the middle of p's square, of the ground itself there
  /// too [m, World]. Beyond an edge, where none passes, of the nearest squares that have some, up
  /// to kFarthest away; else empty. Cost: some microseconds.
  Eigen::AlignedBox1d through(const Eigen::Vector2d& p) const;
  static constexpr int kFarthest = 6;  ///< squares

 private:
  Eigen::AlignedBox1d linesAt(const Eigen::Vector2i& here) const;
  Eigen::AlignedBox1d at(const Eigen::Vector2i& square) const;

  const GroundCells& cells_;
  double longest_;
  std::vector<Eigen::AlignedBox1d> heights_;  // by square, x fastest; empty where all is level
  Eigen::AlignedBox1d level_;
};

}  // namespace amble

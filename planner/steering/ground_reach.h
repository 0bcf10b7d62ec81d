/// Whether ground leads from one place to another: a proof of "no" that is there before any search.
///
/// Asked of the squares of GroundCells. Feet are put down on ground in turn, no farther apart than
/// the longest step, no higher than is climbed and no lower than is stepped down, so from a square
/// of ground only those squares are reached that lie so near. Ground that steps lead over both ways
/// is one floor; where a step between two is taken one way only, as down a kerb by who climbs less,
/// that way alone leads. All doubts are decided for the walker: a square counts whether or
/// not a foot has room there, distances are widened by the squares' size, and heights by what the
/// steepest slope explains, wherever ground is not flat. What is narrower than a square and not
/// said to be ground is none (GroundCells). So "no ground leads there" is certain, and "it leads
/// there" says little.
#pragma once

#include <Eigen/Geometry>
#include <functional>
#include <optional>
#include <vector>

#include "environments/ground/ground_cells.h"
#include "environments/ground/scene_ground.h"

namespace amble {

/// Where the ground ends that one walks on from the start, and where that of the goal begins.
struct GroundGap {
  Eigen::Vector3d near, far;  ///< middles of squares [m, World]

  double width() const { return (far - near).head<2>().norm(); }  ///< in plan [m]
  double rise() const { return far.z() - near.z(); }              ///< [m]
};

/// The gap between the ground at two places, or none where ground leads from one to the other or
/// nothing is known of either. @param longest_step  of the middles of two feet [m, > 0]. Cost: next
/// to nothing where both are on one floor; else all squares at the edges of floors are looked at.
std::optional<GroundGap> findGap(const SceneGround& ground, const Eigen::Vector3d& from,
                                 const Eigen::Vector3d& to, double longest_step);

/// The ground on which feet may come down on a walk from a place, as findGap has it: tops of walls
/// and of wardrobes are none of it. Cost: as findGap's between two floors.
class ReachedGround {
 public:
  /// @param from  [m, World]; @param longest_step  [m, > 0] @pre the ground outlives it
  ReachedGround(const SceneGround& ground, const Eigen::Vector3d& from, double longest_step);
  /// Of a surface over a square; true of all where nothing is known.
  bool has(int column, int row, const GroundCells::Span& span) const;
  /// Of all of it over each square of GroundCells, x fastest [m, World]; empty where there is none.
  std::vector<Eigen::AlignedBox1d> heights() const;

 private:
  const GroundCells& cells_;
  std::function<bool(int column, int row, const GroundCells::Span& span)> is_apart_;
};

}  // namespace amble

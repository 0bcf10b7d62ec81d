/// Where parts of a walking body may be in plan: over ground that is walked on, between places of
/// it, and a little beyond its open edges.
///
/// Feet stand on ground, and the body is over them or on its way from one to the next. So a place
/// is between feet where ground that is no farther than a step lies all around it, by more than
/// half of all directions: over a break in the ground, in the corner of an L, beneath a wall that
/// steps lead past. Whatever else of a body's is over no ground leans out over an edge.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <span>
#include <vector>

#include "environments/ground/scene_ground.h"
#include "planner/steering/ground_reach.h"

namespace amble {

class NearGround {
 public:
  /// @param longest_step  of the middles of two feet [m, > 0]; @param beyond  edges, that parts
  /// lean out [m, >= 0]. Beside ground exact; beside places between it to the grid's squares, of
  /// 0.1 m: none counts as too far that is as near as this. Cost: linear in the squares of
  /// GroundCells. @pre the ground outlives it
  NearGround(const SceneGround& ground, const ReachedGround& reached, double longest_step,
             double beyond);

  static constexpr double kMostAround = 0.05;  ///< [m]
  /// Whether any place is that is so far from p at most [m, 0 to kMostAround]. Cost: some
  /// nanoseconds, beyond an edge some hundred.
  bool has(const Eigen::Vector2d& p, double around = 0.0) const;
  /// Whether p's square is of ground, or near a place between it.
  bool isOver(const Eigen::Vector2d& p) const { return squareOf(p) == kNear; }

  /// The squares, as large as those of GroundCells, some of them around these; none where all is
  /// near. From the corner of the first of them [m, World].
  const Eigen::Vector2i& squares() const { return count_; }
  Eigen::Vector2d corner() const;
  /// Whether a square is beyond the ground, with ground perhaps as near as parts lean out.
  bool isBeside(int x, int y) const { return at(x, y) == kBeside; }
  /// Whether it is over ground, and one beside it is not.
  bool isGroundBesideOther(int x, int y) const;

 private:
  // Of squares: nothing is near; perhaps ground is; or they are ground, or near a place between.
  enum Square : std::uint8_t { kFar = 0, kBeside = 1, kNear = 2 };
  void markBridges(int reach);
  void widen(double by);
  bool isWithin(const Eigen::Vector2d& p, double distance) const;
  bool isReached(const Eigen::Vector3d& surface) const;
  bool isBetween(int x, int y, int reach, std::span<const std::uint64_t> bins) const;
  std::uint8_t squareOf(const Eigen::Vector2d& p) const;
  std::uint8_t at(int x, int y) const { return on_[static_cast<size_t>(y) * count_.x() + x]; }
  bool isOn(int x, int y) const {
    return x >= 0 && y >= 0 && x < count_.x() && y < count_.y() &&
           on_[static_cast<size_t>(y) * count_.x() + x];
  }

  const SceneGround& ground_;
  const GroundCells& cells_;
  double beyond_;
  std::vector<Eigen::AlignedBox1d> heights_;  // of reached ground, by square of the cells
  int margin_ = 0;                            // squares around those of the cells
  Eigen::Vector2i count_{0, 0};   // with them; 0: nothing is known, and all counts as near
  std::vector<std::uint8_t> on_;  // by square, x fastest
};

}  // namespace amble

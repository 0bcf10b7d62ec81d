/// The way of a walk along the floor: its root without the sway, and where edits put it.
///
/// The thesis (§6.2.3) scales the displacements of root and feet from a double support on, each
/// from where it is. Read to the letter that limps: the step that the feet stand apart in at first
/// is never scaled, so every other step keeps its length, and in a turn feet come nearer to one
/// another or go apart. Here the path is scaled, and everything is moved as the path is where it
/// passes: a print goes with the place at which the root is over it, so that each step gets longer
/// by what the path does and keeps its width.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

namespace amble {

class WalkPath {
 public:
  /// @param root  at each frame [m, World]; at least one; frame time [s, > 0]
  WalkPath(const std::vector<Eigen::Vector3d>& root, double frame_time);

  int frames() const { return static_cast<int>(points_.size()); }
  double length() const { return arcs_.back(); }  ///< [m]
  double share(int frame) const;                  ///< of its length that lies behind [0, 1]
  const Eigen::Vector2d& at(int frame) const { return points_[frame]; }
  /// When it is nearest to a point, between two frames and, straight on, somewhat beyond the clip's
  /// ends [frames].
  double passing(const Eigen::Vector2d& point, int first, int last) const;

  /// How far each frame is moved when the displacements are scaled by a factor that depends on the
  /// share of the way [m]; the first stays (thesis, §6.2.3).
  std::vector<Eigen::Vector2d> scaled(const std::function<double(double share)>& factor) const;
  /// Such a shift between frames; beyond the ends it goes on as it does near them.
  Eigen::Vector2d between(const std::vector<Eigen::Vector2d>& shifts, double frame) const;

 private:
  std::vector<Eigen::Vector2d> points_;
  std::vector<double> arcs_;
  int near_end_ = 1;  // frames over which the path is straight at its ends
};

}  // namespace amble

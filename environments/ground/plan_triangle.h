/// A triangle as it is seen from above: which points and boxes of the plane it holds for certain,
/// and which it may meet, against how heightOver() decides.
#pragma once

#include <Eigen/Geometry>
#include <array>

#include "environments/scene/triangle_grid.h"

namespace amble {

/// Whether its corners are at one height, to the bit.
inline bool isLevel(const Triangle3& t) { return t[0].z() == t[1].z() && t[1].z() == t[2].z(); }

using BoxCorners = std::array<Eigen::Vector2d, 4>;  ///< one after another around a box [m]
BoxCorners cornersOf(const Eigen::AlignedBox2d& box);

/// What it holds is convex, but for rounding that is much less than a seam: it holds all between
/// points that it holds.
class PlanTriangle {
 public:
  /// It holds what is no farther outside of its sides than rounding, and may be found where what is
  /// no farther outside than a seam and that [m].
  static constexpr double kHeld = 1e-7, kSeen = 1.01 * kSeam;
  /// Triangles of less area, doubled, have no sides to speak of: they hold nothing [m^2].
  static constexpr double kThin = 1e-8;

  explicit PlanTriangle(const Triangle3& t);

  const Eigen::AlignedBox2d& box() const { return box_; }
  /// Then heightOver() has a height there.
  bool holds(const Eigen::Vector2d& p) const;
  /// Where not, heightOver() has no height over any of it, and clipping leaves nothing.
  bool mayMeet(const Eigen::AlignedBox2d& box) const;
  /// Whether this and another that shares a side, one on either side of it, hold all of a box: each
  /// the corners on its side, and both where the box's border crosses it.
  bool holdsWith(const PlanTriangle& other, const BoxCorners& box) const;

 private:
  const Eigen::Vector2d& corner(int k) const { return corners_[k % 3]; }
  double inside(int k, const Eigen::Vector2d& edge, const Eigen::Vector2d& p) const;
  bool holdsAcross(int k, const PlanTriangle& other, int other_k, const BoxCorners& box) const;

  std::array<Eigen::Vector2d, 3> corners_;
  double twice_area_;
  Eigen::AlignedBox2d box_;
};

}  // namespace amble

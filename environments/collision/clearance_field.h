/// A grid of lower bounds of the distance to obstacles: a cheap sufficient test before the exact
/// one.
///
/// Surfaces are put into voxels conservatively and closed solids are filled. Of two voxels i, j
/// apart by d whole steps along an axis, points are at least max(0, |d| - 1) steps apart; the value
/// of a voxel is the least of these distances over all occupied ones, found axis after axis (as
/// Felzenszwalb and Huttenlocher's distance transform, over a window: values end at kFarthest),
/// rounded down to a byte. So the bound holds for every point of a voxel, and no answer changes by
/// asking it first.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "environments/body/capsule.h"
#include "environments/collision/obstacle_set.h"

namespace amble {

/// Cubes that fill a region of World.
struct VoxelGrid {
  Eigen::Vector3d min{0, 0, 0};    ///< corner of voxel (0, 0, 0) [m]
  Eigen::Vector3i count{0, 0, 0};  ///< voxels along each axis
  double size = 1.0;               ///< length of an edge [m]

  size_t total() const { return index(0, 0, count.z()); }
  /// In memory x runs fastest.
  size_t index(int i, int j, int k) const {
    return (static_cast<size_t>(k) * count.y() + j) * count.x() + i;
  }
  Eigen::Vector3d centre(int i, int j, int k) const {
    return min + size * Eigen::Vector3d(i + 0.5, j + 0.5, k + 0.5);
  }
};

class ClearanceField {
 public:
  static constexpr double kFarthest = 0.637;     ///< larger distances are not told apart [m]
  static constexpr double kFinestVoxel = 0.025;  ///< [m]
  /// Coarser voxels where there would be more: 5 MB.
  static constexpr double kMostVoxels = 5e6;

  /// The part of space in which it answers; obstacles outside are taken care of. An empty region
  /// answers nowhere.
  /// @throws Stopped if that is asked for.
  ClearanceField(const std::vector<Obstacle>& obstacles, const Eigen::AlignedBox3d& region,
                 const StopRequest& stop = {});

  double voxel() const { return grid_.size; }  ///< length of a voxel's edge [m]
  /// Nothing is nearer to p than this; 0 outside the region [m].
  double lowerBound(const Eigen::Vector3d& p) const {
    const Eigen::Vector3d q = (p - grid_.min) * per_voxel_;
    // Compared as numbers first: a far point's index does not fit an int.
    if (!(q.x() >= 0.0 && q.y() >= 0.0 && q.z() >= 0.0 && q.x() < grid_.count.x() &&
          q.y() < grid_.count.y() && q.z() < grid_.count.z()))
      return 0.0;
    return kQuantum * bound_[grid_.index(static_cast<int>(q.x()), static_cast<int>(q.y()),
                                         static_cast<int>(q.z()))];
  }
  /// True only if the capsule touches nothing; false says nothing.
  bool isFree(const Capsule& capsule) const {
    // Mostly the ball about the whole of it is free.
    const double room = lowerBound(0.5 * (capsule.from + capsule.to)) - capsule.radius;
    if (room <= 0.0) return false;
    const double square = (capsule.to - capsule.from).squaredNorm();
    return 4.0 * room * room > square || halvesAreFree(capsule, square);
  }

 private:
  static constexpr double kQuantum = kFarthest / 255.0;  // [m] of a byte

  static std::vector<uint8_t> quantaOfSquares(double voxel, int window);
  // @param square  of its axis' length [m^2]
  bool halvesAreFree(const Capsule& capsule, double square) const;

  VoxelGrid grid_;
  double per_voxel_ = 1.0;
  std::vector<uint8_t> bound_;  // of each voxel, in quanta
};

}  // namespace amble

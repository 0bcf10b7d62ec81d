/// Triangles by the squares of the plane that they lie over: what is above and below a point, and
/// what is near one.
///
/// A grid over (x, y) with the triangles of each square in one list (counting sort). Heights at a
/// point cost O(triangles over its square): a fraction of a microsecond where the squares are about
/// as large as the triangles, as they are chosen to be. Triangles that lie over one another many
/// times have larger squares: memory is O(triangles).
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace amble {

using Triangle3 = std::array<Eigen::Vector3d, 3>;  ///< corners [m, World]

/// Points this near to a triangle's edge are on it: meshes have seams, and their numbers are often
/// floats [m].
inline constexpr double kSeam = 1e-4;
/// Surfaces this near to one another meet [m].
inline constexpr double kTouching = 1e-3;

/// Height of the triangle over (x, y), or none beside it. One that stands upright has none [m].
std::optional<double> heightOver(const Triangle3& t, double x, double y);

/// Whether all of the triangle is beside a box of the plane, beyond one of its sides.
inline bool isBeside(const Triangle3& t, const Eigen::AlignedBox2d& box) {
  const auto isBeyond = [&](int axis) {
    const double a = t[0][axis], b = t[1][axis], c = t[2][axis];
    return std::max(a, std::max(b, c)) < box.min()[axis] ||
           std::min(a, std::min(b, c)) > box.max()[axis];
  };
  return isBeyond(0) || isBeyond(1);
}

/// Extent of what of the triangle is within a box of the plane; none where they are apart [m].
std::optional<Eigen::AlignedBox3d> boundsWithin(const Triangle3& t, const Eigen::AlignedBox2d& box);
/// Highest and lowest point of that [m].
struct HeightRange {
  double low, high;
};
std::optional<HeightRange> heightsWithin(const Triangle3& t, const Eigen::AlignedBox2d& box);
/// Area, seen from above, of what of the triangle is within a box of the plane [m^2].
double areaWithin(const Triangle3& t, const Eigen::AlignedBox2d& box);

class TriangleGrid {
 public:
  TriangleGrid() = default;
  explicit TriangleGrid(std::vector<Triangle3> triangles);

  const std::vector<Triangle3>& triangles() const { return triangles_; }
  /// Of all triangles, in the plane [m].
  const Eigen::AlignedBox2d& extent() const { return extent_; }

  /// Calls visit_one(triangle) for every triangle over (x, y), and some beside it.
  template <typename Visit>
  void visitAt(double x, double y, Visit visit_one) const {
    if (start_.empty() || beyond(x, 0) || beyond(y, 1)) return;
    const size_t cell = static_cast<size_t>(column(y, 1)) * count_[0] + column(x, 0);
    for (int k = start_[cell]; k < start_[cell + 1]; ++k) visit_one(items_[k]);
  }

  /// The same for a box of the plane; a triangle over several squares is visited in each.
  template <typename Visit>
  void visitBox(const Eigen::AlignedBox2d& box, Visit visit_one) const {
    if (start_.empty() || !extent_.intersects(box)) return;
    const Range range = rangeOf(box);
    for (int j = range.low[1]; j <= range.high[1]; ++j) {
      const size_t row = static_cast<size_t>(j) * count_[0];
      for (int k = start_[row + range.low[0]]; k < start_[row + range.high[0] + 1]; ++k)
        visit_one(items_[k]);
    }
  }

 private:
  static constexpr double kSmallestCell = 0.05;  // [m]
  static constexpr double kLargestCell = 0.5;    // [m], unless there would be more than kMostCells
  static constexpr double kMostCells = 2000.0;   // along a side
  // Of the lists of all squares: so much, and as much more for each triangle; 4 bytes each.
  static constexpr double kMostItems = 2e6, kItemsOfTriangle = 16.0;

  struct Range {
    std::array<int, 2> low, high;
  };
  bool beyond(double value, int axis) const {
    return !(value >= extent_.min()[axis] - kSeam && value <= extent_.max()[axis] + kSeam);
  }
  // Held in range as a number: a far point's column does not fit an int.
  int column(double value, int axis) const {
    return static_cast<int>(
        std::clamp((value - extent_.min()[axis]) / cell_, 0.0, count_[axis] - 1.0));
  }
  Range rangeOf(const Eigen::AlignedBox2d& box) const {
    return {{column(box.min().x(), 0), column(box.min().y(), 1)},
            {column(box.max().x(), 0), column(box.max().y(), 1)}};
  }
  double leastCell() const;
  Eigen::AlignedBox2d squareOf(int i, int j) const;
  // Squares of a row that one triangle lies over, last included.
  struct Run {
    int triangle, row, first, last;
  };
  std::pair<int, int> columnsWithin(const Triangle3& t, const Range& range, int row) const;
  void findRunsOf(int triangle, std::vector<Run>& runs) const;
  std::vector<std::vector<Run>> findRuns() const;

  std::vector<Triangle3> triangles_;
  Eigen::AlignedBox2d extent_;
  double cell_ = kSmallestCell;
  std::array<int, 2> count_ = {0, 0};
  std::vector<int> start_;  // of each square in items_, and the end
  std::vector<int> items_;  // triangles
};

}  // namespace amble

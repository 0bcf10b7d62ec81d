#include "environments/scene/triangle_grid.h"

#include <limits>
#include <utility>

#include "base/parallel.h"

namespace amble {
namespace {

constexpr double kTrianglesPerCell = 1.0;  // aimed at, for the middle of the triangles; by trial

Eigen::AlignedBox2d planOf(const Triangle3& t) {
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector3d& corner : t) box.extend(Eigen::Vector2d(corner.head<2>()));
  return box;
}

Eigen::AlignedBox2d grown(const Eigen::AlignedBox2d& box, double by) {
  return {box.min().array() - by, box.max().array() + by};
}

struct Corner {
  double at[3];
};

// What of a triangle is within a box has a corner more for each of its sides, at most.
struct Polygon {
  std::array<Corner, 8> corners;
  int count = 0;
};

// What of a polygon is on the one side of a line across an axis, where sign * x >= limit there.
// @return false where all of it is, and `out` is not written
bool cut(const Polygon& in, int axis, double sign, double limit, Polygon& out) {
  std::array<double, 8> inside;  // by corner [m]
  bool all = true;
  for (int k = 0; k < in.count; ++k) {
    inside[k] = sign * in.corners[k].at[axis] - limit;
    all = all && inside[k] >= 0.0;
  }
  if (all) return false;
  out.count = 0;
  for (int k = 0; k < in.count; ++k) {
    const int next = k + 1 < in.count ? k + 1 : 0;
    const Corner &a = in.corners[k], &b = in.corners[next];
    const double da = inside[k], db = inside[next];
    if (da >= 0.0) out.corners[out.count++] = a;
    if ((da >= 0.0) == (db >= 0.0)) continue;
    const double share = da / (da - db);
    Corner& on = out.corners[out.count++];
    for (int i = 0; i < 3; ++i) on.at[i] = a.at[i] + share * (b.at[i] - a.at[i]);
  }
  return true;
}

// What of a triangle is within a box of the plane: Sutherland and Hodgman's clipping, side by side
// of the box. Most sides cut nothing off, which is told by the triangle's extent.
Polygon clip(const Triangle3& t, const Eigen::AlignedBox2d& box) {
  Polygon polygons[2];
  int in = 0;
  double low[2], high[2];
  for (int axis = 0; axis < 2; ++axis) {
    const double a = t[0][axis], b = t[1][axis], c = t[2][axis];
    low[axis] = std::min(a, std::min(b, c));
    high[axis] = std::max(a, std::max(b, c));
    if (high[axis] < box.min()[axis] || low[axis] > box.max()[axis]) return polygons[in];
  }
  for (int k = 0; k < 3; ++k) polygons[in].corners[k] = {t[k].x(), t[k].y(), t[k].z()};
  polygons[in].count = 3;
  bool is_whole = true;
  for (int axis = 0; axis < 2; ++axis) {
    const auto cutAt = [&](double sign, double limit, bool cuts) {
      if (is_whole && !cuts) return;
      if (!cut(polygons[in], axis, sign, limit, polygons[1 - in])) return;
      in = 1 - in;
      is_whole = false;
    };
    cutAt(1.0, box.min()[axis], low[axis] < box.min()[axis]);
    cutAt(-1.0, -box.max()[axis], high[axis] > box.max()[axis]);
  }
  return polygons[in];
}

}  // namespace

std::optional<double> heightOver(const Triangle3& t, double x, double y) {
  // Most of those asked are beside it; and a sliver's corner may be farther than a seam from all
  // that is between its edges.
  const auto isBeyond = [&](int axis, double value) {
    const double a = t[0][axis], b = t[1][axis], c = t[2][axis];
    return value < std::min(a, std::min(b, c)) - kSeam ||
           value > std::max(a, std::max(b, c)) + kSeam;
  };
  if (isBeyond(0, x) || isBeyond(1, y)) return std::nullopt;
  const auto sideOf = [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return (b.x() - a.x()) * (y - a.y()) - (b.y() - a.y()) * (x - a.x());
  };
  const std::array side = {sideOf(t[0], t[1]), sideOf(t[1], t[2]), sideOf(t[2], t[0])};
  const double twice_area = side[0] + side[1] + side[2];
  if (twice_area == 0.0) return std::nullopt;
  const double sign = twice_area < 0.0 ? -1.0 : 1.0;
  for (int k = 0; k < 3; ++k) {
    if (sign * side[k] >= 0.0) continue;
    const Eigen::Vector2d edge = (t[k < 2 ? k + 1 : 0] - t[k]).head<2>();
    if (sign * side[k] < -kSeam * edge.lpNorm<1>()) return std::nullopt;  // no root is needed
    if (sign * side[k] < -kSeam * edge.norm()) return std::nullopt;
  }
  const double low = std::min(t[0].z(), std::min(t[1].z(), t[2].z()));
  const double high = std::max(t[0].z(), std::max(t[1].z(), t[2].z()));
  if (low == high) return low;
  // side[k] weighs the corner opposite to edge k.
  const double z = (side[0] * t[2].z() + side[1] * t[0].z() + side[2] * t[1].z()) / twice_area;
  return std::clamp(z, low, high);
}

std::optional<Eigen::AlignedBox3d> boundsWithin(const Triangle3& t,
                                                const Eigen::AlignedBox2d& box) {
  const Polygon part = clip(t, box);
  if (part.count == 0) return std::nullopt;
  Eigen::AlignedBox3d bounds;
  for (int k = 0; k < part.count; ++k) bounds.extend(Eigen::Vector3d(part.corners[k].at));
  return bounds;
}

std::optional<HeightRange> heightsWithin(const Triangle3& t, const Eigen::AlignedBox2d& box) {
  const Polygon part = clip(t, box);
  if (part.count == 0) return std::nullopt;
  HeightRange range{part.corners[0].at[2], part.corners[0].at[2]};
  for (int k = 1; k < part.count; ++k) {
    range.low = std::min(range.low, part.corners[k].at[2]);
    range.high = std::max(range.high, part.corners[k].at[2]);
  }
  return range;
}

double areaWithin(const Triangle3& t, const Eigen::AlignedBox2d& box) {
  const Polygon part = clip(t, box);
  double twice = 0.0;
  for (int k = 2; k < part.count; ++k) {
    const auto &origin = part.corners[0].at, &before = part.corners[k - 1].at,
               &corner = part.corners[k].at;
    twice += (before[0] - origin[0]) * (corner[1] - origin[1]) -
             (before[1] - origin[1]) * (corner[0] - origin[0]);
  }
  return 0.5 * std::abs(twice);
}

TriangleGrid::TriangleGrid(std::vector<Triangle3> triangles) : triangles_(std::move(triangles)) {
  if (triangles_.empty()) return;
  for (const Triangle3& t : triangles_) extent_.extend(planOf(t));
  const double per_triangle = extent_.volume() / static_cast<double>(triangles_.size());
  cell_ = std::clamp(std::sqrt(kTrianglesPerCell * per_triangle), kSmallestCell, kLargestCell);
  cell_ = std::max({cell_, extent_.sizes().maxCoeff() / kMostCells, leastCell()});
  for (int k = 0; k < 2; ++k) count_[k] = 1 + static_cast<int>(extent_.sizes()[k] / cell_);
  // Counting sort: once to count, once to place.
  const std::vector<std::vector<Run>> shares = findRuns();
  const auto eachSquare = [&](auto visit_one) {
    for (const std::vector<Run>& runs : shares) {
      for (const Run& run : runs) {
        const size_t row = static_cast<size_t>(run.row) * count_[0];
        for (int i = run.first; i <= run.last; ++i) visit_one(row + i, run.triangle);
      }
    }
  };
  start_.assign(static_cast<size_t>(count_[0]) * count_[1] + 1, 0);
  eachSquare([&](size_t cell, int) { ++start_[cell + 1]; });
  for (size_t c = 1; c < start_.size(); ++c) start_[c] += start_[c - 1];
  items_.resize(start_.back());
  std::vector<int> next(start_.begin(), start_.end() - 1);
  eachSquare([&](size_t cell, int triangle) { items_[next[cell]++] = triangle; });
}

// That of which the lists have room for all triangles: one of area A, w long and h wide, lies over
// about A / cell^2 + (w + h) / cell + 1 squares.
double TriangleGrid::leastCell() const {
  double area = 0.0, around = 0.0;
  for (const Triangle3& t : triangles_) {
    const Eigen::Vector2d a = (t[1] - t[0]).head<2>(), b = (t[2] - t[0]).head<2>();
    area += 0.5 * std::abs(a.x() * b.y() - a.y() * b.x());
    around += planOf(t).sizes().sum();
  }
  const double room =
      kMostItems + (kItemsOfTriangle - 1.0) * static_cast<double>(triangles_.size());
  return (around + std::sqrt(around * around + 4.0 * area * room)) / (2.0 * room);
}

Eigen::AlignedBox2d TriangleGrid::squareOf(int i, int j) const {
  const Eigen::Vector2d low = extent_.min() + cell_ * Eigen::Vector2d(i, j);
  return grown({low, low.array() + cell_}, kSeam + 1e-9 * cell_);
}

// The squares of a row that a triangle overlaps, first and last: what of it is in the row is
// convex.
std::pair<int, int> TriangleGrid::columnsWithin(const Triangle3& t, const Range& range,
                                                int row) const {
  const Eigen::AlignedBox2d strip =
      squareOf(range.low[0], row).merged(squareOf(range.high[0], row));
  const Polygon part = clip(t, strip);
  if (part.count == 0) return {0, -1};
  const auto begin = part.corners.begin();
  const auto [low, high] = std::minmax_element(
      begin, begin + part.count, [](const auto& a, const auto& b) { return a.at[0] < b.at[0]; });
  const double margin = kSeam + 1e-9 * cell_;
  return {column(low->at[0] - margin, 0), column(high->at[0] + margin, 0)};
}

// By triangle. A large one's bounds hold squares that it does not overlap: most of them for a
// slanted sliver.
void TriangleGrid::findRunsOf(int triangle, std::vector<Run>& runs) const {
  constexpr int kFewSquares = 4;
  const Range range = rangeOf(grown(planOf(triangles_[triangle]), kSeam));
  const bool few =
      range.high[0] - range.low[0] < kFewSquares && range.high[1] - range.low[1] < kFewSquares;
  for (int j = range.low[1]; j <= range.high[1]; ++j) {
    const auto [first, last] = few ? std::pair(range.low[0], range.high[0])
                                   : columnsWithin(triangles_[triangle], range, j);
    if (first <= last) runs.push_back({triangle, j, first, last});
  }
}

// In shares of many triangles.
std::vector<std::vector<TriangleGrid::Run>> TriangleGrid::findRuns() const {
  constexpr int kAtATime = 2048;
  const int count = static_cast<int>(triangles_.size());
  std::vector<std::vector<Run>> shares((count + kAtATime - 1) / kAtATime);
  parallelFor(static_cast<int>(shares.size()), usualThreads(), [&](int share, int) {
    const int end = std::min(count, (share + 1) * kAtATime);
    shares[share].reserve(kAtATime);
    for (int t = share * kAtATime; t < end; ++t) findRunsOf(t, shares[share]);
  });
  return shares;
}

}  // namespace amble

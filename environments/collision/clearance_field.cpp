#include "environments/collision/clearance_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>

#include "base/parallel.h"
#include "environments/collision/distance_transform.h"
#include "environments/scene/parity.h"

namespace amble {
namespace {

constexpr uint8_t kSurface = 1, kInside = 2;
static_assert(ClearanceField::kFarthest / ClearanceField::kFinestVoxel < kLongestWindow - 2);

using Triangle = std::array<Eigen::Vector3d, 3>;

Eigen::AlignedBox3d boundsOf(const Triangle& t) {
  Eigen::AlignedBox3d box(t[0]);
  box.extend(t[1]);
  box.extend(t[2]);
  return box;
}

// Which boxes of a size a triangle overlaps, by the separating axes of both (Akenine-Moeller 2001),
// the box's own left out: the caller looks in the triangle's bounds only.
class BoxTest {
 public:
  // @param half  of the boxes' lengths [m]
  BoxTest(const Triangle& t, const Eigen::Vector3d& half) : origin_(t[0]) {
    const Triangle edges = {t[1] - t[0], t[2] - t[1], t[0] - t[2]};
    int next = 0;
    const auto add = [&](const Eigen::Vector3d& axis) {
      const double b = axis.dot(edges[0]),
                   c = -axis.dot(edges[2]);  // of the corners; of the first 0
      const double reach = half.dot(axis.cwiseAbs());
      slabs_[next++] = {axis, std::min({0.0, b, c}) - reach, std::max({0.0, b, c}) + reach};
    };
    add(edges[0].cross(edges[1]));
    for (const Eigen::Vector3d& edge : edges)
      for (int k = 0; k < 3; ++k) add(edge.cross(Eigen::Vector3d::Unit(k)));
  }

  bool overlaps(const Eigen::Vector3d& centre) const {
    const Eigen::Vector3d p = centre - origin_;
    return std::all_of(slabs_.begin(), slabs_.end(), [&](const Slab& slab) {
      const double at = slab.axis.dot(p);
      return at >= slab.low && at <= slab.high;
    });
  }

 private:
  // Middles of boxes that are not apart from it along the axis.
  struct Slab {
    Eigen::Vector3d axis;
    double low, high;
  };
  Eigen::Vector3d origin_;
  std::array<Slab, 10> slabs_;
};

// Signed distance to a primitive's surface, in its frame; a lower bound outside is enough [m].
struct SignedDistance {
  const Eigen::Vector3d& p;
  double operator()(const Box& s) const {
    const Eigen::Vector3d q = p.cwiseAbs() - 0.5 * s.size;
    return q.cwiseMax(0.0).norm() + std::min(q.maxCoeff(), 0.0);
  }
  double operator()(const Cylinder& s) const {
    const double side = p.head<2>().norm() - s.radius, end = std::abs(p.z()) - 0.5 * s.height;
    return std::hypot(std::max(side, 0.0), std::max(end, 0.0)) + std::min(std::max(side, end), 0.0);
  }
  double operator()(const Sphere& s) const { return p.norm() - s.radius; }
  double operator()(const CapsuleShape& s) const {
    const double half = 0.5 * s.height - s.radius;
    const double z = p.z() - std::clamp(p.z(), -half, half);
    return std::hypot(p.head<2>().norm(), z) - s.radius;
  }
  double operator()(const TriangleMesh&) const { return std::numeric_limits<double>::infinity(); }
};

Eigen::AlignedBox3d boundsOf(const Obstacle& obstacle) {
  Eigen::AlignedBox3d box = worldBounds(obstacle.shape, obstacle.X_WO);
  for (const Eigen::Vector3d& v : obstacle.solid.mesh.vertices) box.extend(v);
  return box;
}

// The voxels that a box overlaps, the last one included; a little more where rounding might matter.
struct VoxelRange {
  VoxelRange(const VoxelGrid& grid, const Eigen::AlignedBox3d& box) {
    for (int k = 0; k < 3; ++k) {
      const double first = std::floor((box.min()[k] - grid.min[k]) / grid.size - 1e-6);
      const double last = std::floor((box.max()[k] - grid.min[k]) / grid.size + 1e-6);
      low[k] = static_cast<int>(std::clamp(first, 0.0, static_cast<double>(grid.count[k])));
      high[k] = static_cast<int>(std::clamp(last, -1.0, grid.count[k] - 1.0));
    }
  }
  Eigen::Vector3i low, high;
};

// Marks the voxels of a box whose centres pass a test.
template <typename Test>
void markWhere(const VoxelGrid& grid, const Eigen::AlignedBox3d& box,
               std::vector<uint8_t>& occupied, Test test) {
  const VoxelRange range(grid, box);
  for (int k = range.low.z(); k <= range.high.z(); ++k) {
    for (int j = range.low.y(); j <= range.high.y(); ++j) {
      for (int i = range.low.x(); i <= range.high.x(); ++i) {
        uint8_t& cell = occupied[grid.index(i, j, k)];
        if (cell == 0 && test(grid.centre(i, j, k))) cell = kSurface;
      }
    }
  }
}

void markPrimitive(const VoxelGrid& grid, const Obstacle& obstacle,
                   std::vector<uint8_t>& occupied) {
  const Eigen::Isometry3d X_OW = obstacle.X_WO.inverse();
  const double half_diagonal = 0.5 * std::sqrt(3.0) * grid.size * (1.0 + 1e-6);
  markWhere(grid, boundsOf(obstacle), occupied, [&](const Eigen::Vector3d& c) {
    const Eigen::Vector3d p = X_OW * c;
    return std::visit(SignedDistance{p}, obstacle.shape) <= half_diagonal;
  });
}

// A large triangle is cut into four until its bounds are small: those of a slanted wall hold mostly
// air.
void markTriangle(const VoxelGrid& grid, const Triangle& triangle, std::vector<uint8_t>& occupied) {
  constexpr double kFewVoxels = 64.0;
  const Eigen::Vector3d half = Eigen::Vector3d::Constant(0.5 * grid.size * (1.0 + 1e-6) + 1e-9);
  const Eigen::AlignedBox3d box = boundsOf(triangle);
  const VoxelRange range(grid, box);
  const Eigen::Array3i size = (range.high - range.low).array() + 1;
  if ((size <= 0).any()) return;
  if (size.cast<double>().prod() <= kFewVoxels || size.minCoeff() == 1) {
    std::optional<BoxTest> test;  // only where a voxel is not occupied yet
    markWhere(grid, box, occupied, [&](const Eigen::Vector3d& c) {
      if (!test) test.emplace(triangle, half);
      return test->overlaps(c);
    });
    return;
  }
  const auto& [a, b, c] = triangle;
  const Eigen::Vector3d ab = 0.5 * (a + b), bc = 0.5 * (b + c), ca = 0.5 * (c + a);
  for (const Triangle& quarter : {Triangle{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}})
    markTriangle(grid, quarter, occupied);
}

void markSurface(const VoxelGrid& grid, const Obstacle& obstacle, std::vector<uint8_t>& occupied) {
  const auto* mesh = std::get_if<TriangleMesh>(&obstacle.shape);
  if (!mesh) return markPrimitive(grid, obstacle, occupied);
  for (const std::array<int, 3>& t : mesh->triangles)
    markTriangle(grid,
                 {obstacle.X_WO * mesh->vertices[t[0]], obstacle.X_WO * mesh->vertices[t[1]],
                  obstacle.X_WO * mesh->vertices[t[2]]},
                 occupied);
}

// Voxels in a row without a surface between them are on one side of it: one test for all.
void fillPlane(const VoxelGrid& grid, int k, const Parity& solid, std::vector<uint8_t>& occupied) {
  const VoxelRange range(grid, solid.bounds());
  if (k < range.low.z() || k > range.high.z()) return;
  for (int j = range.low.y(); j <= range.high.y(); ++j) {
    uint8_t* row = &occupied[grid.index(0, j, k)];
    for (int begin = range.low.x(), end; begin <= range.high.x(); begin = end) {
      end = begin + 1;
      if (row[begin] == kSurface) continue;
      while (end <= range.high.x() && row[end] != kSurface) ++end;
      if (solid.inside(grid.centre(begin, j, k))) std::fill(row + begin, row + end, kInside);
    }
  }
}

void fillSolids(const VoxelGrid& grid, const std::vector<Obstacle>& obstacles,
                const StopRequest& stop, std::vector<uint8_t>& occupied) {
  std::vector<std::shared_ptr<const Parity>> solids;
  for (const Obstacle& obstacle : obstacles) {
    stop.check();
    solids.push_back(insideOf(obstacle));
    if (solids.back()->empty()) solids.pop_back();
  }
  parallelFor(grid.count.z(), usualThreads(), [&](int k, int) {
    stop.check();
    for (const auto& solid : solids) fillPlane(grid, k, *solid, occupied);
  });
}

// What lies outside the grid is not in it: where there is something, the border is taken for
// occupied.
void markBeyond(const VoxelGrid& grid, const Eigen::AlignedBox3d& obstacles,
                std::vector<uint8_t>& occupied) {
  if (obstacles.isEmpty()) return;
  const Eigen::Vector3d max = grid.min + grid.size * grid.count.cast<double>();
  for (int axis = 0; axis < 3; ++axis) {
    for (const bool upper : {false, true}) {
      if (upper ? obstacles.max()[axis] <= max[axis] : obstacles.min()[axis] >= grid.min[axis])
        continue;
      Eigen::Vector3i low(0, 0, 0), high = grid.count.array() - 1;
      (upper ? low : high)[axis] = upper ? grid.count[axis] - 1 : 0;
      for (int k = low.z(); k <= high.z(); ++k)
        for (int j = low.y(); j <= high.y(); ++j)
          std::fill(&occupied[grid.index(low.x(), j, k)], &occupied[grid.index(high.x(), j, k)] + 1,
                    kSurface);
    }
  }
}

}  // namespace

ClearanceField::ClearanceField(const std::vector<Obstacle>& obstacles,
                               const Eigen::AlignedBox3d& region, const StopRequest& stop) {
  if (region.isEmpty()) return;
  grid_.size = std::max(kFinestVoxel, std::cbrt(region.volume() / kMostVoxels));
  per_voxel_ = 1.0 / grid_.size;
  grid_.min = region.min();
  for (int k = 0; k < 3; ++k)
    grid_.count[k] = std::max(1, static_cast<int>(std::floor(region.sizes()[k] / grid_.size)));
  bound_.assign(grid_.total(), 0);  // at first, what is occupied
  Eigen::AlignedBox3d all;
  for (const Obstacle& obstacle : obstacles) {
    stop.check();
    markSurface(grid_, obstacle, bound_);
    all.extend(boundsOf(obstacle));
  }
  fillSolids(grid_, obstacles, stop, bound_);
  markBeyond(grid_, all, bound_);
  // Farther than this many voxels is kFarthest anyway.
  const int window = 1 + static_cast<int>(std::ceil(kFarthest / grid_.size));
  transformDistances(bound_, grid_.count, window, quantaOfSquares(grid_.size, window));
}

// Distances of so many squared voxels, rounded down, with a thousandth of a voxel against the
// rounding of places.
std::vector<uint8_t> ClearanceField::quantaOfSquares(double voxel, int window) {
  std::vector<uint8_t> table(static_cast<size_t>(window) * window + 1);
  for (size_t i = 0; i < table.size(); ++i) {
    const double distance = std::max(0.0, (std::sqrt(static_cast<double>(i)) - 1e-3) * voxel);
    table[i] = static_cast<uint8_t>(std::min(255.0, std::floor(distance / kQuantum)));
  }
  return table;
}

bool ClearanceField::halvesAreFree(const Capsule& capsule, double square) const {
  // Half a capsule is as hard as the whole once it is shorter than what the grid can tell.
  if (square < grid_.size * grid_.size) return false;
  const Eigen::Vector3d middle = 0.5 * (capsule.from + capsule.to);
  return isFree({capsule.from, middle, capsule.radius}) &&
         isFree({middle, capsule.to, capsule.radius});
}

}  // namespace amble

#include "environments/collision/clearance_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>

#include "base/parallel.h"
#include "base/processor.h"
#include "environments/scene/parity.h"

namespace amble {
namespace {

constexpr uint8_t kSurface = 1, kInside = 2;
// Squared voxels. Windows are shorter than 50 voxels: adding their squares stays below an int16_t's
// end.
constexpr int16_t kFarSquared = 30000;
static_assert(ClearanceField::kFarthest / ClearanceField::kFinestVoxel < 48.0);

using Triangle = std::array<Eigen::Vector3d, 3>;

Eigen::AlignedBox3d boundsOf(const Triangle& t) {
  Eigen::AlignedBox3d box(t[0]);
  box.extend(t[1]);
  box.extend(t[2]);
  return box;
}

// Whether a triangle and an axis-aligned box about the origin of these half lengths are apart along
// `axis`.
bool apartAlong(const Eigen::Vector3d& axis, const Triangle& t, const Eigen::Vector3d& half) {
  const double a = axis.dot(t[0]), b = axis.dot(t[1]), c = axis.dot(t[2]);
  const double reach = half.dot(axis.cwiseAbs());
  return std::min({a, b, c}) > reach || std::max({a, b, c}) < -reach;
}

// Separating axes of triangle and box (Akenine-Moeller 2001), the box's own axes left out: the
// caller looks in the triangle's bounds only.
bool overlaps(const Triangle& t, const Eigen::Vector3d& centre, const Eigen::Vector3d& half) {
  const Triangle local = {t[0] - centre, t[1] - centre, t[2] - centre};
  const Triangle edges = {t[1] - t[0], t[2] - t[1], t[0] - t[2]};
  if (apartAlong(edges[0].cross(edges[1]), local, half)) return false;
  for (const Eigen::Vector3d& edge : edges)
    for (int k = 0; k < 3; ++k)
      if (apartAlong(edge.cross(Eigen::Vector3d::Unit(k)), local, half)) return false;
  return true;
}

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
    markWhere(grid, box, occupied,
              [&](const Eigen::Vector3d& c) { return overlaps(triangle, c, half); });
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
void fillSolid(const VoxelGrid& grid, const Obstacle& obstacle, std::vector<uint8_t>& occupied) {
  const Parity solid(obstacle.solid);
  if (solid.empty()) return;
  const VoxelRange range(grid, solid.bounds());
  for (int k = range.low.z(); k <= range.high.z(); ++k) {
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

// Rows of the transform are so many voxels at a time, which compilers keep in registers; what is
// over at a row's end is far from everything.
constexpr size_t kBlock = 32;

// Lines of voxels along one axis, where its next voxel is `stride` numbers on.
struct Axis {
  int count;
  size_t stride;
};

// The first axis, x: squared distance in voxels of each voxel to the last and the next occupied one
// in its row.
void measureRow(const uint8_t* in, int16_t* out, size_t length, int window) {
  const int far = window + 1;
  int since = far;
  for (size_t x = 0; x < length; ++x) {
    since = in[x] ? 0 : std::min(since + 1, far);
    out[x] = static_cast<int16_t>(since);
  }
  since = far;
  for (size_t x = length; x-- > 0;) {
    since = in[x] ? 0 : std::min(since + 1, far);
    const int d = std::min<int>(out[x], since), apart = std::max(0, d - 1);
    out[x] = d >= far ? kFarSquared : static_cast<int16_t>(apart * apart);
  }
}

// A run of `out`, `at` along the axis: the least of `in` over a window of voxels, with the squared
// distance in voxels added that points of the two voxels are apart at least. Outwards, until no
// voxel of the block can gain.
AMBLE_FOR_EACH_PROCESSOR
void spreadRun(const int16_t* in, int16_t* out, size_t run, const Axis& axis, int at, int window) {
  for (size_t x = 0; x < run; x += kBlock) {
    std::array<int16_t, kBlock> least;
    const int16_t* const own = in + x + at * axis.stride;
    std::copy_n(own, kBlock, least.data());
    for (int d = 1; d <= window; ++d) {
      const int16_t add = static_cast<int16_t>((d - 1) * (d - 1));
      int16_t most = 0;
      for (size_t k = 0; k < kBlock; ++k) most = std::max(most, least[k]);
      if (most <= add) break;
      for (const int side : {-d, d}) {
        if (at + side < 0 || at + side >= axis.count) continue;
        const int16_t* const other = own + side * static_cast<ptrdiff_t>(axis.stride);
        for (size_t k = 0; k < kBlock; ++k) {
          const int16_t sum = static_cast<int16_t>(other[k] + add);
          least[k] = std::min(least[k], sum);
        }
      }
    }
    std::copy_n(least.data(), kBlock, out + x);
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
  std::vector<uint8_t> occupied(grid_.total(), 0);
  Eigen::AlignedBox3d all;
  for (const Obstacle& obstacle : obstacles) {
    stop.check();
    markSurface(grid_, obstacle, occupied);
    all.extend(boundsOf(obstacle));
  }
  for (const Obstacle& obstacle : obstacles) {
    stop.check();
    fillSolid(grid_, obstacle, occupied);
  }
  markBeyond(grid_, all, occupied);
  transform(occupied);
}

void ClearanceField::transform(const std::vector<uint8_t>& occupied) {
  const size_t nx = grid_.count.x(), ny = grid_.count.y(), nz = grid_.count.z();
  const size_t row = (nx + kBlock - 1) / kBlock * kBlock, plane = row * ny;
  // Farther than this many voxels is kFarthest anyway.
  const int window = 1 + static_cast<int>(std::ceil(kFarthest / grid_.size));
  const auto squared = std::make_unique_for_overwrite<int16_t[]>(plane * nz);
  // By height along x and y, in a plane for each thread.
  std::vector<std::vector<int16_t>> rows(usualThreads());
  parallelFor(grid_.count.z(), usualThreads(), [&](int k, int thread) {
    rows[thread].resize(plane, kFarSquared);
    int16_t* const own = rows[thread].data();
    for (size_t j = 0; j < ny; ++j)
      measureRow(&occupied[grid_.index(0, static_cast<int>(j), k)], own + j * row, nx, window);
    const Axis axis{grid_.count.y(), row};
    for (size_t j = 0; j < ny; ++j)
      spreadRun(own, &squared[k * plane + j * row], row, axis, static_cast<int>(j), window);
  });
  // Along z.
  const std::vector<uint8_t> quanta = quantaOfSquares(grid_.size);
  bound_.resize(occupied.size());
  parallelFor(grid_.count.y(), usualThreads(), [&](int j, int) {
    std::vector<int16_t> least(row);
    const Axis axis{grid_.count.z(), plane};
    for (int k = 0; k < grid_.count.z(); ++k) {
      spreadRun(&squared[j * row], least.data(), row, axis, k, window);
      uint8_t* const bound = &bound_[grid_.index(0, j, k)];
      for (size_t i = 0; i < nx; ++i) bound[i] = quanta[least[i]];
    }
  });
}

// Distances of so many squared voxels, rounded down, with a thousandth of a voxel against the
// rounding of places.
std::vector<uint8_t> ClearanceField::quantaOfSquares(double voxel) {
  std::vector<uint8_t> table(static_cast<size_t>(kFarSquared) + 1);
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

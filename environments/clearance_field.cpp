#include "environments/clearance_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "environments/solid_test.h"

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
  Eigen::AlignedBox3d box;
  if (const auto* mesh = std::get_if<TriangleMesh>(&obstacle.shape)) {
    for (const Eigen::Vector3d& v : mesh->vertices) box.extend(obstacle.X_WO * v);
  } else {
    // Round shapes are meshed a little too small: by the cosine of half a segment.
    const TriangleMesh round = worldMesh({"", "", obstacle.shape, obstacle.X_WO, Role::kAuto});
    for (const Eigen::Vector3d& v : round.vertices) box.extend(v);
    const Eigen::Vector3d more = 0.01 * box.sizes();
    box = {box.min() - more, box.max() + more};
  }
  for (const Eigen::Vector3d& v : obstacle.solid.vertices) box.extend(v);
  return box;
}

// Where `outer` slabs of `count` runs of `run` neighbouring voxels lie in memory, along one axis.
struct Axis {
  int count;
  size_t stride, outer, outer_step, run;
};

// Least of `in` over a window of voxels along an axis, with the squared distance in voxels added
// that points of the two voxels are apart at least. In blocks of a fixed size, which compilers keep
// in registers.
void spread(const std::vector<int16_t>& in, std::vector<int16_t>& out, const Axis& axis,
            int window) {
  constexpr size_t kBlock = 32;
  for (size_t o = 0; o < axis.outer; ++o) {
    for (int c = 0; c < axis.count; ++c) {
      const int first = std::max(-window, -c), last = std::min(window, axis.count - 1 - c);
      const size_t row = o * axis.outer_step + c * axis.stride;
      for (size_t x = 0; x < axis.run; x += kBlock) {
        const size_t width = std::min(kBlock, axis.run - x);
        std::array<int16_t, kBlock> least, from;
        least.fill(kFarSquared);
        from.fill(kFarSquared);
        for (int d = first; d <= last; ++d) {
          const int apart = std::max(0, std::abs(d) - 1);
          const int16_t add = static_cast<int16_t>(apart * apart);
          const int16_t* source = &in[row + x] + d * static_cast<ptrdiff_t>(axis.stride);
          if (width == kBlock)
            std::copy_n(source, kBlock, from.data());
          else
            std::copy_n(source, width, from.data());
          for (size_t k = 0; k < kBlock; ++k) {
            const int16_t sum = static_cast<int16_t>(from[k] + add);
            least[k] = sum < least[k] ? sum : least[k];
          }
        }
        std::copy_n(least.data(), width, &out[row + x]);
      }
    }
  }
}

}  // namespace

ClearanceField::ClearanceField(const std::vector<Obstacle>& obstacles,
                               const Eigen::AlignedBox3d& region) {
  if (region.isEmpty()) return;
  voxel_ = std::max(kFinestVoxel, std::cbrt(region.volume() / kMostVoxels));
  per_voxel_ = 1.0 / voxel_;
  min_ = region.min();
  for (int k = 0; k < 3; ++k)
    count_[k] = std::max(1, static_cast<int>(std::floor(region.sizes()[k] * per_voxel_)));
  std::vector<uint8_t> occupied(index(0, 0, count_.z()), 0);
  Eigen::AlignedBox3d all;
  for (const Obstacle& obstacle : obstacles) {
    mark(obstacle, occupied);
    all.extend(boundsOf(obstacle));
  }
  fillSolids(obstacles, occupied);
  markBeyond(all, occupied);
  transform(occupied);
}

void ClearanceField::mark(const Obstacle& obstacle, std::vector<uint8_t>& occupied) const {
  const auto cells = [&](const Eigen::AlignedBox3d& box) {
    // One voxel more than needed where rounding might matter.
    std::pair<Eigen::Vector3i, Eigen::Vector3i> range;
    for (int k = 0; k < 3; ++k) {
      const double low = std::floor((box.min()[k] - min_[k]) * per_voxel_ - 1e-6);
      const double high = std::floor((box.max()[k] - min_[k]) * per_voxel_ + 1e-6);
      range.first[k] = static_cast<int>(std::clamp(low, 0.0, static_cast<double>(count_[k])));
      range.second[k] = static_cast<int>(std::clamp(high, -1.0, count_[k] - 1.0));
    }
    return range;
  };
  const auto eachCell = [&](const Eigen::AlignedBox3d& box, auto test) {
    const auto [low, high] = cells(box);
    for (int k = low.z(); k <= high.z(); ++k)
      for (int j = low.y(); j <= high.y(); ++j)
        for (int i = low.x(); i <= high.x(); ++i)
          if (uint8_t& cell = occupied[index(i, j, k)]; cell == 0 && test(centre(i, j, k)))
            cell = kSurface;
  };
  const auto* mesh = std::get_if<TriangleMesh>(&obstacle.shape);
  if (!mesh) {
    const Eigen::Isometry3d X_OW = obstacle.X_WO.inverse();
    const double half_diagonal = 0.5 * std::sqrt(3.0) * voxel_ * (1.0 + 1e-6);
    return eachCell(boundsOf(obstacle), [&](const Eigen::Vector3d& c) {
      const Eigen::Vector3d p = X_OW * c;
      return std::visit(SignedDistance{p}, obstacle.shape) <= half_diagonal;
    });
  }
  const Eigen::Vector3d half = Eigen::Vector3d::Constant(0.5 * voxel_ * (1.0 + 1e-6) + 1e-9);
  // Large triangles are cut into four until their bounds are small: those of a slanted wall hold
  // mostly air.
  std::vector<Triangle> stack;
  for (const std::array<int, 3>& t : mesh->triangles) {
    stack.push_back({obstacle.X_WO * mesh->vertices[t[0]], obstacle.X_WO * mesh->vertices[t[1]],
                     obstacle.X_WO * mesh->vertices[t[2]]});
    while (!stack.empty()) {
      const Triangle piece = stack.back();
      stack.pop_back();
      const auto [low, high] = cells(boundsOf(piece));
      const Eigen::Array3i size = (high - low).array() + 1;
      if ((size <= 0).any()) continue;
      if (size.cast<double>().prod() <= 64.0 || size.minCoeff() == 1) {
        eachCell(boundsOf(piece),
                 [&](const Eigen::Vector3d& c) { return overlaps(piece, c, half); });
        continue;
      }
      const Eigen::Vector3d ab = 0.5 * (piece[0] + piece[1]), bc = 0.5 * (piece[1] + piece[2]),
                            ca = 0.5 * (piece[2] + piece[0]);
      stack.push_back({piece[0], ab, ca});
      stack.push_back({ab, piece[1], bc});
      stack.push_back({ca, bc, piece[2]});
      stack.push_back({ab, bc, ca});
    }
  }
}

// Voxels in a row without a surface between them are on one side of it: one test for all.
void ClearanceField::fillSolids(const std::vector<Obstacle>& obstacles,
                                std::vector<uint8_t>& occupied) const {
  for (const Obstacle& obstacle : obstacles) {
    const SolidTest solid(obstacle.solid);
    if (solid.empty()) continue;
    Eigen::Vector3i low, high;
    for (int k = 0; k < 3; ++k) {
      low[k] =
          std::clamp(static_cast<int>(std::floor((solid.bounds().min()[k] - min_[k]) * per_voxel_)),
                     0, count_[k]);
      high[k] =
          std::clamp(static_cast<int>(std::floor((solid.bounds().max()[k] - min_[k]) * per_voxel_)),
                     -1, count_[k] - 1);
    }
    for (int k = low.z(); k <= high.z(); ++k) {
      if (centre(0, 0, k).z() <= obstacle.solid_above) continue;
      for (int j = low.y(); j <= high.y(); ++j) {
        uint8_t* row = &occupied[index(0, j, k)];
        for (int begin = low.x(), end; begin <= high.x(); begin = end) {
          end = begin + 1;
          if (row[begin] == kSurface) continue;
          while (end <= high.x() && row[end] != kSurface) ++end;
          if (solid.inside(centre(begin, j, k))) std::fill(row + begin, row + end, kInside);
        }
      }
    }
  }
}

// What lies outside the grid is not in it: where there is something, the border is taken for
// occupied.
void ClearanceField::markBeyond(const Eigen::AlignedBox3d& obstacles,
                                std::vector<uint8_t>& occupied) const {
  if (obstacles.isEmpty()) return;
  const Eigen::Vector3d max = min_ + voxel_ * count_.cast<double>();
  for (int axis = 0; axis < 3; ++axis) {
    for (const bool upper : {false, true}) {
      if (upper ? obstacles.max()[axis] <= max[axis] : obstacles.min()[axis] >= min_[axis])
        continue;
      Eigen::Vector3i low(0, 0, 0), high = count_.array() - 1;
      (upper ? low : high)[axis] = upper ? count_[axis] - 1 : 0;
      for (int k = low.z(); k <= high.z(); ++k)
        for (int j = low.y(); j <= high.y(); ++j)
          std::fill(&occupied[index(low.x(), j, k)], &occupied[index(high.x(), j, k)] + 1,
                    kSurface);
    }
  }
}

void ClearanceField::transform(const std::vector<uint8_t>& occupied) {
  const size_t total = occupied.size();
  const size_t nx = count_.x(), ny = count_.y(), nz = count_.z();
  // Farther than this many voxels is kFarthest anyway.
  const int window = 1 + static_cast<int>(std::ceil(kFarthest * per_voxel_));
  std::vector<int16_t> a(total), b(total);
  for (size_t row = 0; row < ny * nz;
       ++row) {  // along x: distance to the last and to the next occupied voxel
    const uint8_t* in = &occupied[row * nx];
    int16_t* out = &a[row * nx];
    const int far = window + 1;
    int since = far;
    for (size_t x = 0; x < nx; ++x) {
      since = in[x] ? 0 : std::min(since + 1, far);
      out[x] = static_cast<int16_t>(since);
    }
    since = far;
    for (size_t x = nx; x-- > 0;) {
      since = in[x] ? 0 : std::min(since + 1, far);
      const int d = std::min<int>(out[x], since), apart = std::max(0, d - 1);
      out[x] = d >= far ? kFarSquared : static_cast<int16_t>(apart * apart);
    }
  }
  spread(a, b, {count_.y(), nx, nz, nx * ny, nx}, window);
  spread(b, a, {count_.z(), nx * ny, 1, 0, nx * ny}, window);
  // Rounded down, with a thousandth of a voxel against the rounding of places.
  const auto toByte = [&](int squared) {
    const double distance =
        std::max(0.0, (std::sqrt(static_cast<double>(squared)) - 1e-3) * voxel_);
    return static_cast<uint8_t>(std::min(255.0, std::floor(distance / kQuantum)));
  };
  std::vector<uint8_t> table(static_cast<size_t>(std::numeric_limits<int16_t>::max()) + 1);
  for (size_t i = 0; i < table.size(); ++i) table[i] = toByte(static_cast<int>(i));
  bound_.resize(total);
  for (size_t i = 0; i < total; ++i) bound_[i] = table[a[i]];
}

double ClearanceField::lowerBound(const Eigen::Vector3d& p) const {
  const Eigen::Vector3d q = (p - min_) * per_voxel_;
  // Compared as numbers first: a far point's index does not fit an int.
  if (!(q.x() >= 0.0 && q.y() >= 0.0 && q.z() >= 0.0 && q.x() < count_.x() && q.y() < count_.y() &&
        q.z() < count_.z()))
    return 0.0;
  return kQuantum *
         bound_[index(static_cast<int>(q.x()), static_cast<int>(q.y()), static_cast<int>(q.z()))];
}

bool ClearanceField::isFree(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                            double radius) const {
  const Eigen::Vector3d middle = 0.5 * (from + to);
  const double bound = lowerBound(middle);
  if (bound <= radius) return false;
  const double half = 0.5 * (to - from).norm();
  if (bound > half + radius) return true;
  // Half a capsule is as hard as the whole once it is shorter than what the grid can tell.
  if (half < 0.5 * voxel_) return false;
  return isFree(from, middle, radius) && isFree(middle, to, radius);
}

}  // namespace amble

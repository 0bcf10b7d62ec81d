#include "environments/scene_ground.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

#include "animation/rotation.h"

namespace amble {
namespace {

// Steeper than this is no floor, whatever the character climbs [1].
const double kFlatNormal = std::cos(20.0 * kDegree);
// Points this near to a triangle's edge are on it: floors have seams [m].
constexpr double kSeam = 1e-6;
// Of the grid that floor regions are measured on [m].
constexpr double kFloorCell = 0.1;
// A level surface smaller than this is furniture: larger than tables and beds, smaller than rooms
// [m^2].
constexpr double kFloorArea = 4.0;

struct UpFacing {
  std::array<Eigen::Vector3d, 3> corners;  // [m, World]
  int object = 0;

  double lowest() const { return std::min({corners[0].z(), corners[1].z(), corners[2].z()}); }
  double highest() const { return std::max({corners[0].z(), corners[1].z(), corners[2].z()}); }

  // Unit, upwards.
  Eigen::Vector3d normal() const {
    const Eigen::Vector3d n = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized();
    return n.z() < 0.0 ? Eigen::Vector3d(-n) : n;
  }

  // Its height over (x, y), or none beside it.
  std::optional<double> heightAt(double x, double y) const {
    const Eigen::Vector2d p(x, y);
    std::array<double, 3> side;
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector2d a = corners[k].head<2>(), edge = corners[(k + 1) % 3].head<2>() - a;
      side[k] = edge.x() * (p.y() - a.y()) - edge.y() * (p.x() - a.x());
    }
    const double twice_area = side[0] + side[1] + side[2];
    const double sign = twice_area < 0.0 ? -1.0 : 1.0;
    for (int k = 0; k < 3; ++k) {
      const double length = (corners[(k + 1) % 3] - corners[k]).head<2>().norm();
      if (sign * side[k] < -kSeam * length) return std::nullopt;
    }
    // side[k] weighs the corner opposite to edge k.
    const double z =
        (side[0] * corners[2].z() + side[1] * corners[0].z() + side[2] * corners[1].z()) /
        twice_area;
    return std::clamp(z, lowest(), highest());
  }
};

double signedVolume(const TriangleMesh& mesh) {
  double volume = 0.0;
  const Eigen::Vector3d origin = mesh.vertices.front();
  for (const std::array<int, 3>& t : mesh.triangles)
    volume += (mesh.vertices[t[0]] - origin)
                  .dot((mesh.vertices[t[1]] - origin).cross(mesh.vertices[t[2]] - origin));
  return volume;
}

// Closed pieces are turned outside out, open ones face as they are wound; `ground` is ground from
// either side.
void addUpFacing(const SceneObject& object, int index, std::vector<UpFacing>& out) {
  for (const MeshComponent& piece : splitComponents(worldMesh(object))) {
    const double sign = piece.closed && signedVolume(piece.mesh) < 0.0 ? -1.0 : 1.0;
    for (const std::array<int, 3>& t : piece.mesh.triangles) {
      UpFacing triangle{
          {piece.mesh.vertices[t[0]], piece.mesh.vertices[t[1]], piece.mesh.vertices[t[2]]}, index};
      const auto& [a, b, c] = triangle.corners;
      const double nz = sign * (b - a).cross(c - a).normalized().z();
      const bool either_side = object.role == Role::kGround && !piece.closed;
      if ((either_side ? std::abs(nz) : nz) >= kFlatNormal) out.push_back(triangle);
    }
  }
}

std::vector<UpFacing> upFacing(const Scene& scene) {
  std::vector<UpFacing> result;
  for (size_t i = 0; i < scene.objects.size(); ++i) {
    const SceneObject& object = scene.objects[i];
    if (object.role == Role::kAuto || object.role == Role::kGround)
      addUpFacing(object, static_cast<int>(i), result);
  }
  return result;
}

// Triangles by the squares of the plane that they overlap.
class Buckets {
 public:
  explicit Buckets(std::vector<UpFacing> triangles) : triangles_(std::move(triangles)) {
    for (const UpFacing& t : triangles_)
      for (const Eigen::Vector3d& corner : t.corners)
        extent_.extend(Eigen::Vector2d(corner.head<2>()));
    if (triangles_.empty()) return;
    cell_ = std::max(kSmallestCell, extent_.sizes().maxCoeff() / kMostCells);
    for (int k = 0; k < 2; ++k) count_[k] = 1 + static_cast<int>(extent_.sizes()[k] / cell_);
    fill();
  }

  const Eigen::AlignedBox2d& extent() const { return extent_; }
  const std::vector<UpFacing>& triangles() const { return triangles_; }

  // Calls visit(height, triangle) for every triangle over or under (x, y).
  template <typename Visit>
  void visit(double x, double y, Visit visit_one) const {
    if (triangles_.empty()) return;
    const int i = column(x, 0), j = column(y, 1);
    const double slack = cell_;
    if (x < extent_.min().x() - slack || x > extent_.max().x() + slack ||
        y < extent_.min().y() - slack || y > extent_.max().y() + slack)
      return;
    const int cell = j * count_[0] + i;
    for (int k = start_[cell]; k < start_[cell + 1]; ++k)
      if (const auto z = triangles_[items_[k]].heightAt(x, y)) visit_one(*z, triangles_[items_[k]]);
  }

 private:
  static constexpr double kSmallestCell = 0.25;  // [m]
  static constexpr double kMostCells = 1000.0;   // along a side

  int column(double value, int axis) const {
    // Held in range as a number: a far point's column does not fit an int.
    const double offset = (value - extent_.min()[axis]) / cell_;
    return static_cast<int>(std::clamp(offset, 0.0, count_[axis] - 1.0));
  }

  // Counting sort: once to count, once to place.
  void fill() {
    start_.assign(static_cast<size_t>(count_[0]) * count_[1] + 1, 0);
    eachCell([&](int cell, int) { ++start_[cell + 1]; });
    for (size_t c = 1; c < start_.size(); ++c) start_[c] += start_[c - 1];
    items_.resize(start_.back());
    std::vector<int> next(start_.begin(), start_.end() - 1);
    eachCell([&](int cell, int triangle) { items_[next[cell]++] = triangle; });
  }

  template <typename Visit>
  void eachCell(Visit visit_one) const {
    for (size_t t = 0; t < triangles_.size(); ++t) {
      Eigen::AlignedBox2d box;
      for (const Eigen::Vector3d& c : triangles_[t].corners)
        box.extend(Eigen::Vector2d(c.head<2>()));
      for (int j = column(box.min().y() - kSeam, 1); j <= column(box.max().y() + kSeam, 1); ++j)
        for (int i = column(box.min().x() - kSeam, 0); i <= column(box.max().x() + kSeam, 0); ++i)
          visit_one(j * count_[0] + i, static_cast<int>(t));
    }
  }

  std::vector<UpFacing> triangles_;
  Eigen::AlignedBox2d extent_;
  double cell_ = kSmallestCell;
  std::array<int, 2> count_ = {0, 0};
  std::vector<int> start_;  // of each cell in items_, and the end
  std::vector<int> items_;  // triangles
};

bool levelAt(const Buckets& buckets, double x, double y, double z) {
  bool found = false;
  buckets.visit(x, y, [&](double height, const UpFacing&) {
    found = found || std::abs(height - z) <= SceneGround::kLevel;
  });
  return found;
}

// Whether the surface of height z at (x, y) goes on at that level for kFloorArea or more.
bool isLarge(const Buckets& buckets, double x, double y, double z) {
  const int enough = static_cast<int>(std::ceil(kFloorArea / (kFloorCell * kFloorCell)));
  std::set<std::pair<int, int>> seen = {{0, 0}};
  std::vector<std::pair<int, int>> open = {{0, 0}};
  for (size_t next = 0; next < open.size(); ++next) {
    if (static_cast<int>(open.size()) >= enough) return true;
    const auto [i, j] = open[next];
    for (const auto& cell : {std::pair(i + 1, j), {i - 1, j}, {i, j + 1}, {i, j - 1}}) {
      if (!seen.insert(cell).second) continue;
      if (levelAt(buckets, x + cell.first * kFloorCell, y + cell.second * kFloorCell, z))
        open.push_back(cell);
    }
  }
  return false;
}

}  // namespace

struct SceneGround::Grid {
  Buckets buckets;
};

SceneGround::SceneGround(const Scene& scene, double floor)
    : floor_(floor), ground_objects_(scene.objects.size(), false) {
  std::vector<UpFacing> level;
  for (const UpFacing& triangle : upFacing(scene)) {
    if (triangle.lowest() < floor - kLevel || triangle.highest() > floor + kLevel) continue;
    ground_objects_[triangle.object] = true;
    level.push_back(triangle);
  }
  grid_ = std::make_unique<Grid>(Grid{Buckets(std::move(level))});
  extent_ = grid_->buckets.extent();
}

SceneGround::~SceneGround() = default;

std::optional<SurfacePoint> SceneGround::surface(double x, double y, double z, double reach) const {
  std::optional<SurfacePoint> best;
  grid_->buckets.visit(x, y, [&](double height, const UpFacing& triangle) {
    if (std::abs(height - z) > reach || (best && height <= best->height)) return;
    best = SurfacePoint{height, triangle.normal()};
  });
  return best;
}

std::vector<double> floors(const Scene& scene, double x, double y) {
  const Buckets buckets(upFacing(scene));
  std::vector<std::pair<double, bool>> found;  // height, said to be ground
  buckets.visit(x, y, [&](double height, const UpFacing& triangle) {
    found.emplace_back(height, scene.objects[triangle.object].role == Role::kGround);
  });
  std::sort(found.begin(), found.end());
  std::vector<double> large, all;
  const auto append = [](std::vector<double>& list, double height) {
    if (list.empty() || height - list.back() > SceneGround::kLevel) list.push_back(height);
  };
  for (const auto& [height, said] : found) {
    append(all, height);
    if (said || isLarge(buckets, x, y, height)) append(large, height);
  }
  return large.empty() ? all : large;
}

}  // namespace amble

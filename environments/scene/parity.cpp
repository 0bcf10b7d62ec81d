#include "environments/scene/parity.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace amble {
namespace {

// The ray is (kShearX, kShearY, 1): far enough from the vertical that walls are wide seen along it,
// and of no simple ratio.
constexpr double kShearX = Parity::kShear, kShearY = 0.007919;
static_assert(kShearY < kShearX);
constexpr int kMostCells = 256;  // along a side

Eigen::Vector3d sheared(const Eigen::Vector3d& p) {
  return {p.x() - kShearX * p.z(), p.y() - kShearY * p.z(), p.z()};
}

// Whether the edge from a to b crosses the line from p towards +x, p itself being below a vertex of
// its own y. Both triangles at an edge get the same answer to the bit: the ends are put in one
// order first.
bool crosses(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& p) {
  if ((a.y() > p.y()) == (b.y() > p.y())) return false;
  const Eigen::Vector3d& low = a.y() < b.y() ? a : b;
  const Eigen::Vector3d& high = a.y() < b.y() ? b : a;
  const double x = low.x() + (p.y() - low.y()) / (high.y() - low.y()) * (high.x() - low.x());
  return x > p.x();
}

// Where the ray through p crosses a triangle; for one seen by its edge, above all.
std::optional<double> crossing(const std::array<Eigen::Vector3d, 3>& t, const Eigen::Vector3d& p) {
  if (!(crosses(t[0], t[1], p) ^ crosses(t[1], t[2], p) ^ crosses(t[2], t[0], p))) return {};
  const Eigen::Vector3d normal = (t[1] - t[0]).cross(t[2] - t[0]);
  const double low = std::min({t[0].z(), t[1].z(), t[2].z()});
  const double high = std::max({t[0].z(), t[1].z(), t[2].z()});
  const double z =
      t[0].z() - (normal.x() * (p.x() - t[0].x()) + normal.y() * (p.y() - t[0].y())) / normal.z();
  return std::isnan(z) ? std::numeric_limits<double>::infinity() : std::clamp(z, low, high);
}

}  // namespace

void appendMesh(TriangleMesh& to, const TriangleMesh& from) {
  const int base = static_cast<int>(to.vertices.size());
  to.vertices.insert(to.vertices.end(), from.vertices.begin(), from.vertices.end());
  for (const std::array<int, 3>& t : from.triangles)
    to.triangles.push_back({t[0] + base, t[1] + base, t[2] + base});
}

TriangleMesh closedPart(const TriangleMesh& mesh) {
  TriangleMesh closed;
  for (const MeshComponent& piece : splitComponents(mesh))
    if (piece.closed) appendMesh(closed, piece.mesh);
  return closed;
}

Parity Parity::ofClosed(const TriangleMesh& mesh) {
  Parity solid;
  solid.corners_.reserve(mesh.triangles.size());
  for (const std::array<int, 3>& t : mesh.triangles) {
    for (const int v : t) solid.bounds_.extend(mesh.vertices[v]);
    solid.corners_.push_back(
        {sheared(mesh.vertices[t[0]]), sheared(mesh.vertices[t[1]]), sheared(mesh.vertices[t[2]])});
  }
  if (!solid.empty()) solid.sortIntoCells();
  return solid;
}

void Parity::sortIntoCells() {
  Eigen::AlignedBox2d extent;
  for (const std::array<Eigen::Vector3d, 3>& corners : corners_)
    for (const Eigen::Vector3d& c : corners) extent.extend(Eigen::Vector2d(c.head<2>()));
  min_ = extent.min();
  const int side =
      std::clamp(static_cast<int>(std::sqrt(static_cast<double>(corners_.size()))), 1, kMostCells);
  count_ = {side, side};
  cell_ = (extent.sizes() / side).cwiseMax(1e-9);
  start_.assign(static_cast<size_t>(side) * side + 1, 0);
  const auto eachCell = [&](auto visit) {
    for (size_t t = 0; t < corners_.size(); ++t) {
      Eigen::AlignedBox2d box;
      for (const Eigen::Vector3d& c : corners_[t]) box.extend(Eigen::Vector2d(c.head<2>()));
      const Eigen::Vector2i low = cellOf(box.min().x(), box.min().y()),
                            high = cellOf(box.max().x(), box.max().y());
      for (int j = low.y(); j <= high.y(); ++j)
        for (int i = low.x(); i <= high.x(); ++i) visit(j * count_.x() + i, static_cast<int>(t));
    }
  };
  eachCell([&](int cell, int) { ++start_[cell + 1]; });
  for (size_t c = 1; c < start_.size(); ++c) start_[c] += start_[c - 1];
  items_.resize(start_.back());
  std::vector<int> next(start_.begin(), start_.end() - 1);
  eachCell([&](int cell, int t) { items_[next[cell]++] = t; });
}

Eigen::Vector2i Parity::cellOf(double u, double v) const {
  return {std::clamp(static_cast<int>((u - min_.x()) / cell_.x()), 0, count_.x() - 1),
          std::clamp(static_cast<int>((v - min_.y()) / cell_.y()), 0, count_.y() - 1)};
}

template <typename Visit>
void Parity::visitCrossings(const Eigen::Vector3d& p, Visit visit) const {
  if (empty()) return;
  const Eigen::Vector3d q = sheared(p);
  const Eigen::Vector2i cell = cellOf(q.x(), q.y());
  const int c = cell.y() * count_.x() + cell.x();
  for (int k = start_[c]; k < start_[c + 1]; ++k)
    if (const auto height = crossing(corners_[items_[k]], q)) visit(*height);
}

bool Parity::inside(const Eigen::Vector3d& p) const {
  if (empty() || !bounds_.contains(p)) return false;
  bool odd = false;
  visitCrossings(p, [&](double height) { odd ^= height >= p.z(); });
  return odd;
}

void Parity::addCrossings(const Eigen::Vector3d& p, std::vector<double>& heights) const {
  visitCrossings(p, [&](double height) { heights.push_back(height); });
}

}  // namespace amble

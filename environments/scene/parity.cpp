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

void SolidMesh::add(const TriangleMesh& closed, bool hollow) {
  parts.push_back({static_cast<int>(mesh.triangles.size()), hollow});
  appendMesh(mesh, closed);
}

Parity::Parity(const SolidMesh& solid) {
  const TriangleMesh& mesh = solid.mesh;
  corners_.reserve(mesh.triangles.size());
  for (const std::array<int, 3>& t : mesh.triangles) {
    for (const int v : t) bounds_.extend(mesh.vertices[v]);
    corners_.push_back(
        {sheared(mesh.vertices[t[0]]), sheared(mesh.vertices[t[1]]), sheared(mesh.vertices[t[2]])});
  }
  part_of_.assign(corners_.size(), 0);
  for (size_t k = 0; k < solid.parts.size(); ++k) {
    std::fill(part_of_.begin() + solid.parts[k].first, part_of_.end(), static_cast<int>(k));
    depth_in_.push_back(solid.parts[k].hollow ? -1 : 1);
  }
  if (!empty()) sortIntoCells();
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
  struct Range {
    Eigen::Vector2i low, high;
  };
  std::vector<Range> ranges;  // of each triangle's cells
  ranges.reserve(corners_.size());
  for (const auto& [a, b, c] : corners_) {
    const Eigen::Vector3d low = a.cwiseMin(b).cwiseMin(c), high = a.cwiseMax(b).cwiseMax(c);
    ranges.push_back({cellOf(low.x(), low.y()), cellOf(high.x(), high.y())});
  }
  const auto eachCell = [&](auto visit) {
    for (size_t t = 0; t < ranges.size(); ++t)
      for (int j = ranges[t].low.y(); j <= ranges[t].high.y(); ++j)
        for (int i = ranges[t].low.x(); i <= ranges[t].high.x(); ++i)
          visit(j * count_.x() + i, static_cast<int>(t));
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

// Triangles of a cell are in ascending order, and so are parts.
template <typename Visit>
void Parity::visitCrossings(const Eigen::Vector3d& p, Visit visit) const {
  if (empty()) return;
  const Eigen::Vector3d q = sheared(p);
  const Eigen::Vector2i cell = cellOf(q.x(), q.y());
  const int c = cell.y() * count_.x() + cell.x();
  for (int k = start_[c]; k < start_[c + 1]; ++k)
    if (const auto height = crossing(corners_[items_[k]], q)) visit(*height, part_of_[items_[k]]);
}

bool Parity::inside(const Eigen::Vector3d& p) const {
  if (empty() || !bounds_.contains(p)) return false;
  int depth = 0, last = 0;
  bool odd = false;  // crossings of the last part that are not below
  visitCrossings(p, [&](double height, int part) {
    if (part != last) {
      if (odd) depth += depth_in_[last];
      odd = false;
      last = part;
    }
    odd ^= height >= p.z();
  });
  if (odd) depth += depth_in_[last];
  return depth > 0;
}

int Parity::addCrossings(const Eigen::Vector3d& p, std::vector<Crossing>& crossings) const {
  int below = 0, last = -1;
  size_t begin = crossings.size();
  // From above a part is outside at first, and every crossing changes that.
  const auto finish = [&] {
    std::sort(crossings.begin() + begin, crossings.end(),
              [](const Crossing& a, const Crossing& b) { return a.height > b.height; });
    bool inside = false;
    for (; begin < crossings.size(); ++begin, inside = !inside)
      crossings[begin].change = inside ? depth_in_[last] : -depth_in_[last];
    if (inside) below += depth_in_[last];
  };
  visitCrossings(p, [&](double height, int part) {
    if (part != last) finish();
    last = part;
    crossings.push_back({height, 0});
  });
  finish();
  return below;
}

}  // namespace amble

#include "viz/pictures/thin_mesh.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace amble {
namespace {

constexpr double kCoarsest = 10.0;  // where even this is not enough there are too many things [m]

using Cell = std::array<std::int64_t, 3>;

// By corner of the mesh: the number of its cell, in the order of cells.
std::vector<int> cellsOf(const TriangleMesh& mesh, double cell, int& count) {
  std::vector<std::pair<Cell, int>> corners;
  corners.reserve(mesh.vertices.size());
  for (size_t i = 0; i < mesh.vertices.size(); ++i) {
    Cell at;
    for (int a = 0; a < 3; ++a)
      at[a] = static_cast<std::int64_t>(std::floor(mesh.vertices[i][a] / cell));
    corners.emplace_back(at, static_cast<int>(i));
  }
  std::sort(corners.begin(), corners.end());
  std::vector<int> number(corners.size());
  count = 0;
  for (size_t i = 0; i < corners.size(); ++i) {
    if (i > 0 && corners[i].first != corners[i - 1].first) ++count;
    number[corners[i].second] = count;
  }
  if (!corners.empty()) ++count;
  return number;
}

// Triangles that keep three corners, each once, begun at their lowest.
std::vector<std::array<int, 3>> keptTriangles(const TriangleMesh& mesh,
                                              const std::vector<int>& number) {
  std::vector<std::array<int, 3>> kept;
  for (const auto& t : mesh.triangles) {
    std::array<int, 3> n = {number[t[0]], number[t[1]], number[t[2]]};
    if (n[0] == n[1] || n[1] == n[2] || n[2] == n[0]) continue;
    std::rotate(n.begin(), std::min_element(n.begin(), n.end()), n.end());
    kept.push_back(n);
  }
  std::sort(kept.begin(), kept.end());
  kept.erase(std::unique(kept.begin(), kept.end()), kept.end());
  return kept;
}

double areaOf(const TriangleMesh& mesh) {
  double area = 0.0;
  for (const auto& t : mesh.triangles) {
    const Eigen::Vector3d& a = mesh.vertices[t[0]];
    area += 0.5 * (mesh.vertices[t[1]] - a).cross(mesh.vertices[t[2]] - a).norm();
  }
  return area;
}

}  // namespace

TriangleMesh thinMesh(const TriangleMesh& mesh, double cell) {
  int count = 0;
  const std::vector<int> number = cellsOf(mesh, cell, count);
  TriangleMesh thin;
  thin.vertices.assign(count, Eigen::Vector3d::Zero());
  std::vector<int> corners(count, 0);
  for (size_t i = 0; i < number.size(); ++i) {
    thin.vertices[number[i]] += mesh.vertices[i];
    ++corners[number[i]];
  }
  for (int i = 0; i < count; ++i) thin.vertices[i] /= corners[i];
  thin.triangles = keptTriangles(mesh, number);
  return thin;
}

double thinningCell(const std::vector<const TriangleMesh*>& meshes, size_t most) {
  size_t all = 0;
  double area = 0.0;
  for (const TriangleMesh* mesh : meshes) {
    all += mesh->triangles.size();
    area += areaOf(*mesh);
  }
  if (all <= most) return 0.0;
  // A surface has about two triangles a cell; half of that cell is a first guess from below.
  double cell = std::max(1e-4, 0.5 * std::sqrt(2.0 * area / static_cast<double>(most)));
  for (;; cell *= 1.5) {
    size_t left = 0;
    for (const TriangleMesh* mesh : meshes) {
      int count = 0;
      left += keptTriangles(*mesh, cellsOf(*mesh, cell, count)).size();
    }
    if (left <= most || cell > kCoarsest) return cell;
  }
}

}  // namespace amble

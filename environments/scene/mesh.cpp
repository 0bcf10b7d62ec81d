#include "environments/scene/mesh.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <tuple>

#include "base/rotation.h"
#include "base/union_find.h"

namespace amble {
namespace {

uint64_t hashOf(const Eigen::Vector3d& p) {
  uint64_t hash = 0;
  for (int k = 0; k < 3; ++k) {
    hash = (hash ^ std::bit_cast<uint64_t>(p[k] + 0.0)) * 0x9e3779b97f4a7c15;  // -0.0 is 0.0
    hash ^= hash >> 32;
  }
  return hash;
}

// For each vertex the first vertex of the same place.
std::vector<int> firstOfEqual(const std::vector<Eigen::Vector3d>& vertices) {
  // By hash, with a search to the next place that is free: half of them stay so.
  std::vector<int> table(std::bit_ceil(2 * vertices.size() + 1), -1);
  const size_t mask = table.size() - 1;
  std::vector<int> first(vertices.size());
  for (size_t i = 0; i < vertices.size(); ++i) {
    size_t slot = hashOf(vertices[i]) & mask;
    while (table[slot] >= 0 && vertices[table[slot]] != vertices[i]) slot = (slot + 1) & mask;
    if (table[slot] < 0) table[slot] = static_cast<int>(i);
    first[i] = table[slot];
  }
  return first;
}

// The triangles named by `chosen`, with the vertices that they use, in order of use.
TriangleMesh subMesh(const TriangleMesh& mesh, const std::vector<int>& chosen,
                     std::vector<int>& new_index) {
  TriangleMesh result;
  result.triangles.reserve(chosen.size());
  for (int t : chosen) {
    std::array<int, 3> triangle;
    for (int k = 0; k < 3; ++k) {
      int& index = new_index[mesh.triangles[t][k]];
      if (index < 0) {
        index = static_cast<int>(result.vertices.size());
        result.vertices.push_back(mesh.vertices[mesh.triangles[t][k]]);
      }
      triangle[k] = index;
    }
    result.triangles.push_back(triangle);
  }
  for (int t : chosen)
    for (int v : mesh.triangles[t]) new_index[v] = -1;
  return result;
}

struct EdgeUse {
  int low, high;  // vertices, low < high
  int triangle;
};

// By low, then high, then triangle: counted by low, and sorted among the few of one.
std::vector<EdgeUse> sortedEdges(const TriangleMesh& mesh) {
  std::vector<size_t> next(mesh.vertices.size() + 1, 0);
  const auto visitEdges = [&](const auto& visit) {
    for (size_t t = 0; t < mesh.triangles.size(); ++t) {
      for (int k = 0; k < 3; ++k) {
        const auto [low, high] = std::minmax(mesh.triangles[t][k], mesh.triangles[t][(k + 1) % 3]);
        visit(EdgeUse{low, high, static_cast<int>(t)});
      }
    }
  };
  visitEdges([&](const EdgeUse& edge) { ++next[edge.low + 1]; });
  std::partial_sum(next.begin(), next.end(), next.begin());
  std::vector<EdgeUse> edges(3 * mesh.triangles.size());
  visitEdges([&](const EdgeUse& edge) { edges[next[edge.low]++] = edge; });
  for (auto begin = edges.begin(); begin != edges.end();) {
    const auto end = edges.begin() + static_cast<ptrdiff_t>(next[begin->low]);
    std::sort(begin, end, [](const EdgeUse& a, const EdgeUse& b) {
      return std::tie(a.high, a.triangle) < std::tie(b.high, b.triangle);
    });
    begin = end;
  }
  return edges;
}

// Rings of a body of revolution about z: `profile` holds (radius, z) from the bottom to the top,
// the first and the last on the axis.
TriangleMesh revolve(const std::vector<Eigen::Vector2d>& profile, int segments) {
  assert(segments >= 8 && profile.size() >= 3);
  TriangleMesh mesh;
  const int rings = static_cast<int>(profile.size()) - 2;
  mesh.vertices.push_back({0.0, 0.0, profile.front().y()});
  for (int r = 1; r <= rings; ++r) {
    for (int s = 0; s < segments; ++s) {
      const double angle = 2.0 * kPi * s / segments;
      mesh.vertices.push_back(
          {profile[r].x() * std::cos(angle), profile[r].x() * std::sin(angle), profile[r].y()});
    }
  }
  const int top = static_cast<int>(mesh.vertices.size());
  mesh.vertices.push_back({0.0, 0.0, profile.back().y()});
  const auto at = [&](int ring, int s) { return 1 + ring * segments + s % segments; };
  for (int s = 0; s < segments; ++s) {
    mesh.triangles.push_back({0, at(0, s + 1), at(0, s)});
    for (int r = 0; r + 1 < rings; ++r) {
      mesh.triangles.push_back({at(r, s), at(r, s + 1), at(r + 1, s + 1)});
      mesh.triangles.push_back({at(r, s), at(r + 1, s + 1), at(r + 1, s)});
    }
    mesh.triangles.push_back({top, at(rings - 1, s), at(rings - 1, s + 1)});
  }
  return mesh;
}

// (radius, z) of a half circle from the pole at -90 degrees to the one at 90, the equator twice if
// its halves are apart.
std::vector<Eigen::Vector2d> capsuleProfile(double radius, double half_axis, int segments) {
  const int quarter = std::max(2, segments / 4);
  std::vector<Eigen::Vector2d> profile;
  for (int i = 0; i <= quarter; ++i) {
    const double angle = -0.5 * kPi + 0.5 * kPi * i / quarter;
    profile.push_back({radius * std::cos(angle), radius * std::sin(angle) - half_axis});
  }
  for (int i = half_axis > 0.0 ? 0 : 1; i <= quarter; ++i) {
    const double angle = 0.5 * kPi * i / quarter;
    profile.push_back({radius * std::cos(angle), radius * std::sin(angle) + half_axis});
  }
  return profile;
}

}  // namespace

TriangleMesh cleanMesh(const TriangleMesh& mesh) {
  const std::vector<int> first = firstOfEqual(mesh.vertices);
  TriangleMesh joined{mesh.vertices, {}};
  std::vector<int> kept;
  for (const std::array<int, 3>& t : mesh.triangles) {
    const std::array<int, 3> j = {first[t[0]], first[t[1]], first[t[2]]};
    if (j[0] == j[1] || j[1] == j[2] || j[2] == j[0]) continue;
    const Eigen::Vector3d u = mesh.vertices[j[1]] - mesh.vertices[j[0]];
    const Eigen::Vector3d v = mesh.vertices[j[2]] - mesh.vertices[j[0]];
    if (u.cross(v).squaredNorm() <= kZeroArea * u.squaredNorm() * v.squaredNorm()) continue;
    kept.push_back(static_cast<int>(joined.triangles.size()));
    joined.triangles.push_back(j);
  }
  std::vector<int> new_index(joined.vertices.size(), -1);
  return subMesh(joined, kept, new_index);
}

TriangleMesh makeBox(const Eigen::Vector3d& size) {
  TriangleMesh mesh;
  for (int i = 0; i < 8; ++i) {
    mesh.vertices.push_back(
        0.5 * size.cwiseProduct(Eigen::Vector3d(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1)));
  }
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

TriangleMesh makeCylinder(double radius, double height, int segments) {
  const double h = 0.5 * height;
  return revolve({{0.0, -h}, {radius, -h}, {radius, h}, {0.0, h}}, segments);
}

TriangleMesh makeSphere(double radius, int segments) {
  return revolve(capsuleProfile(radius, 0.0, segments), segments);
}

TriangleMesh makeCapsule(double radius, double height, int segments) {
  return revolve(capsuleProfile(radius, 0.5 * height - radius, segments), segments);
}

std::vector<MeshComponent> splitComponents(const TriangleMesh& mesh) {
  TriangleMesh joined = mesh;
  const std::vector<int> first = firstOfEqual(mesh.vertices);
  for (std::array<int, 3>& t : joined.triangles)
    for (int& v : t) v = first[v];

  const std::vector<EdgeUse> edges = sortedEdges(joined);
  UnionFind pieces(static_cast<int>(joined.triangles.size()));
  std::vector<bool> on_border(joined.triangles.size(), false);
  for (size_t begin = 0, end; begin < edges.size(); begin = end) {
    end = begin;
    while (end < edges.size() && edges[end].low == edges[begin].low &&
           edges[end].high == edges[begin].high) {
      pieces.join(edges[begin].triangle, edges[end].triangle);
      ++end;
    }
    if ((end - begin) % 2 != 0) on_border[edges[begin].triangle] = true;
  }

  std::vector<std::vector<int>> triangles_of(joined.triangles.size());
  std::vector<bool> open(joined.triangles.size(), false);
  for (size_t t = 0; t < joined.triangles.size(); ++t) {
    const int root = pieces.find(static_cast<int>(t));
    triangles_of[root].push_back(static_cast<int>(t));
    if (on_border[t]) open[root] = true;
  }
  std::vector<MeshComponent> components;
  std::vector<int> new_index(joined.vertices.size(), -1);
  for (size_t root = 0; root < triangles_of.size(); ++root) {
    if (triangles_of[root].empty()) continue;
    components.push_back({subMesh(joined, triangles_of[root], new_index), !open[root]});
  }
  return components;
}

}  // namespace amble

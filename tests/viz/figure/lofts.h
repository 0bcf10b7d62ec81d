/// Lofts at random, and what tests ask of surfaces made of them.
#pragma once

#include <map>
#include <set>
#include <utility>
#include <vector>

#include "environments/scene/mesh.h"
#include "tests/animation/random_clip.h"
#include "viz/figure/loft.h"

namespace amble {

inline Eigen::Vector3d directionIn(Generator& random) {
  return randomRotation(random) * Eigen::Vector3d::UnitX();
}

/// A bar of a few decimetres that gets no thinner than half as fast as it gets longer.
inline Loft loftIn(Generator& random) {
  Loft loft;
  loft.a = {randomVector(random, 0.3), uniform(random, 0.03, 0.08), uniform(random, 0.0, 0.05)};
  loft.b = {loft.a.at + uniform(random, 0.15, 0.3) * directionIn(random),
            uniform(random, 0.03, 0.08), uniform(random, 0.0, 0.05)};
  const Eigen::Vector3d axis = (loft.b.at - loft.a.at).normalized();
  loft.across = axis.cross(directionIn(random)).normalized();
  loft.blend = uniform(random, 0.01, 0.05);
  return loft;
}

/// How many triangles go along each edge in either direction.
inline std::map<std::pair<int, int>, int> edgesOf(const TriangleMesh& mesh) {
  std::map<std::pair<int, int>, int> edges;
  for (const auto& t : mesh.triangles)
    for (int i = 0; i < 3; ++i) ++edges[{t[i], t[(i + 1) % 3]}];
  return edges;
}

/// Whether every edge is there once in either direction.
inline bool isWatertight(const TriangleMesh& mesh) {
  const auto edges = edgesOf(mesh);
  for (const auto& [edge, times] : edges)
    if (times != 1 || !edges.contains({edge.second, edge.first})) return false;
  return !edges.empty();
}

/// Corners - edges + faces: 2 for each sphere, 0 for each torus.
inline int eulerNumber(const TriangleMesh& mesh) {
  std::set<int> used;
  for (const auto& t : mesh.triangles) used.insert(t.begin(), t.end());
  const auto edges = static_cast<int>(edgesOf(mesh).size()) / 2;
  return static_cast<int>(used.size()) - edges + static_cast<int>(mesh.triangles.size());
}

}  // namespace amble

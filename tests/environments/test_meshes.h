/// Meshes in tests: their bounds, their volume, turned, joined, moved.
#pragma once

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <utility>

#include "environments/scene/mesh.h"

namespace amble {

inline Eigen::AlignedBox3d boundsOf(const TriangleMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& v : mesh.vertices) box.extend(v);
  return box;
}

inline double volumeOf(const TriangleMesh& mesh) {
  double volume = 0.0;
  for (const auto& t : mesh.triangles)
    volume += mesh.vertices[t[0]].dot(mesh.vertices[t[1]].cross(mesh.vertices[t[2]])) / 6.0;
  return volume;
}

inline void expectBounds(const TriangleMesh& mesh, const Eigen::Vector3d& min,
                         const Eigen::Vector3d& max) {
  EXPECT_LT((boundsOf(mesh).min() - min).norm(), 1e-6) << boundsOf(mesh).min().transpose();
  EXPECT_LT((boundsOf(mesh).max() - max).norm(), 1e-6) << boundsOf(mesh).max().transpose();
}

inline TriangleMesh moved(TriangleMesh mesh, const Eigen::Vector3d& by) {
  for (Eigen::Vector3d& v : mesh.vertices) v += by;
  return mesh;
}

/// The mesh with every triangle wound the other way.
inline TriangleMesh turned(TriangleMesh mesh) {
  for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

inline TriangleMesh joined(TriangleMesh a, const TriangleMesh& b) {
  const int base = static_cast<int>(a.vertices.size());
  a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
  for (const auto& t : b.triangles) a.triangles.push_back({t[0] + base, t[1] + base, t[2] + base});
  return a;
}

}  // namespace amble

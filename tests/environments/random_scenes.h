/// Scenes drawn at random, and the same scene elsewhere: moved, turned, in a mirror, in another
/// order.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "base/rotation.h"
#include "base/sample_stream.h"
#include "tests/environments/test_scenes.h"

namespace amble {

inline Eigen::Vector3d drawnPoint(SampleStream& random, const Eigen::AlignedBox3d& box) {
  return {random.uniform(box.min().x(), box.max().x()),
          random.uniform(box.min().y(), box.max().y()),
          random.uniform(box.min().z(), box.max().z())};
}

/// Of any direction, no longer than `longest`.
inline Eigen::Vector3d drawnVector(SampleStream& random, double longest = 1.0) {
  const Eigen::Vector3d one = Eigen::Vector3d::Ones();
  Eigen::Vector3d v;
  do v = drawnPoint(random, {-one, one});
  while (v.norm() > 1.0);
  return longest * v;
}

/// A floor of 20 x 20 m and things of every shape that stand and hang about within 4 m of its
/// middle, turned any way.
inline std::vector<SceneObject> drawnThings(std::uint64_t seed, int count) {
  SampleStream random(seed, 0);
  std::vector<SceneObject> objects = {floorSlab()};
  const auto size = [&] { return random.uniform(0.1, 0.9); };
  for (int i = 0; i < count; ++i) {
    Shape shape = Box{{size(), size(), size()}};
    const int kind = i % 5;
    if (kind == 1) shape = Cylinder{0.5 * size(), size()};
    if (kind == 2) shape = Sphere{0.5 * size()};
    if (kind == 3) shape = makeBox({size(), size(), size()});
    if (kind == 4) shape = CapsuleShape{0.2 * size(), 0.4 + size()};
    const Eigen::Vector3d at =
        drawnPoint(random, {Eigen::Vector3d(-4, -4, 0.1), Eigen::Vector3d(4, 4, 2.0)});
    objects.push_back(makeObject("thing " + std::to_string(i), shape, at, Role::kObstacle));
    objects.back().X_WO.linear() = expRotation(drawnVector(random, 3.0)).toRotationMatrix();
  }
  return objects;
}

inline std::vector<SceneObject> movedObjects(std::vector<SceneObject> objects,
                                             const Eigen::Isometry3d& X) {
  for (SceneObject& object : objects) object.X_WO = X * object.X_WO;
  return objects;
}

/// Turned about World's z, then moved.
inline Eigen::Isometry3d turnedAndMoved(double angle, const Eigen::Vector3d& by) {
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  X.linear() = aboutZ(angle).toRotationMatrix();
  X.translation() = by;
  return X;
}

inline Eigen::Vector3d mirroredPoint(const Eigen::Vector3d& p) { return {p.x(), -p.y(), p.z()}; }

/// In a mirror that swaps left and right (y), as meshes.
inline std::vector<SceneObject> mirroredObjects(std::vector<SceneObject> objects) {
  for (SceneObject& object : objects) {
    TriangleMesh mesh = turned(worldMesh(object));
    for (Eigen::Vector3d& v : mesh.vertices) v = mirroredPoint(v);
    object.shape = mesh;
    object.X_WO.setIdentity();
  }
  return objects;
}

/// The mesh with its triangles, and the corners of each, in another order.
inline TriangleMesh shuffled(TriangleMesh mesh, SampleStream& random) {
  for (size_t i = mesh.triangles.size(); i > 1; --i)
    std::swap(mesh.triangles[i - 1], mesh.triangles[random.below(static_cast<int>(i))]);
  for (auto& t : mesh.triangles) std::rotate(t.begin(), t.begin() + random.below(3), t.end());
  return mesh;
}

/// The mesh with each triangle cut into three at a point within it: the same surface.
inline TriangleMesh subdivided(const TriangleMesh& mesh, SampleStream& random) {
  TriangleMesh fine;
  fine.vertices = mesh.vertices;
  for (const auto& [a, b, c] : mesh.triangles) {
    const double u = random.uniform(0.2, 0.4), v = random.uniform(0.2, 0.4);
    const int middle = static_cast<int>(fine.vertices.size());
    fine.vertices.push_back((1.0 - u - v) * mesh.vertices[a] + u * mesh.vertices[b] +
                            v * mesh.vertices[c]);
    fine.triangles.insert(fine.triangles.end(), {{a, b, middle}, {b, c, middle}, {c, a, middle}});
  }
  return fine;
}

}  // namespace amble

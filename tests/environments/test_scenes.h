/// Scenes made in memory, and random capsules in them.
#pragma once

#include <random>
#include <string>

#include "environments/body/capsule.h"
#include "environments/collision/obstacle_set.h"
#include "environments/scene/scene.h"
#include "environments/scene/scene_pieces.h"
#include "tests/environments/test_meshes.h"

namespace amble {

inline SceneObject makeObject(const std::string& name, Shape shape, const Eigen::Vector3d& at,
                              Role role = Role::kAuto) {
  SceneObject object;
  object.name = name;
  object.shape = std::move(shape);
  object.X_WO.translation() = at;
  object.role = role;
  return object;
}

/// A slab of 20 x 20 m whose top is z = 0.
inline SceneObject floorSlab() { return makeObject("floor", Box{{20, 20, 0.1}}, {0, 0, -0.05}); }

inline Scene sceneOf(std::vector<SceneObject> objects) {
  Scene scene;
  scene.objects = std::move(objects);
  return scene;
}

/// Steps of `rise` and `going` [m] that begin at x = 0 and go up along +x, each a box from the
/// floor up, 2 m wide about y = 0.
inline std::vector<SceneObject> stairs(int treads, double rise, double going) {
  std::vector<SceneObject> steps;
  for (int i = 0; i < treads; ++i) {
    const double top = (i + 1) * rise;
    steps.push_back(makeObject("tread", Box{{going, 2, top}}, {(i + 0.5) * going, 0, 0.5 * top}));
  }
  return steps;
}

/// What is solid of a mesh in World.
inline SolidMesh solidOf(const TriangleMesh& mesh) {
  return solidOf(0, splitScene(sceneOf({makeObject("it", mesh, {0, 0, 0})})));
}

inline Obstacle obstacleOf(const SceneObject& object, int index) {
  const bool is_mesh = std::holds_alternative<TriangleMesh>(object.shape);
  return {index, object.shape, object.X_WO, is_mesh ? solidOf(worldMesh(object)) : SolidMesh{}};
}

inline Capsule randomCapsule(std::mt19937_64& generator, const Eigen::AlignedBox3d& box,
                             double longest = 0.5) {
  const auto number = [&](double a, double b) {
    return std::uniform_real_distribution<double>(a, b)(generator);
  };
  const Eigen::Vector3d from(number(box.min().x(), box.max().x()),
                             number(box.min().y(), box.max().y()),
                             number(box.min().z(), box.max().z()));
  const Eigen::Vector3d way(number(-1, 1), number(-1, 1), number(-1, 1));
  return {from, from + number(0, longest) * way.normalized(), number(0.01, 0.15)};
}

}  // namespace amble

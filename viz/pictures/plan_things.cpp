#include "viz/pictures/plan_things.h"

#include <algorithm>

namespace amble {
namespace {

using Eigen::AlignedBox2d;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kLow = 0.05, kHigh = 1.80;        // what a body can touch, over the floor [m]
constexpr double kHipLow = 0.50, kHipHigh = 1.20;  // where hips and hands are [m]
constexpr double kCell = 0.008;                    // of the outlines of meshes [m]
constexpr double kOneThing = 5.0;  // what a file with parts spans at most to be one thing [m]

// Objects that are drawn as one thing.
struct ThingObjects {
  std::string name;
  std::vector<const SceneObject*> objects;
};

std::vector<ThingObjects> groupObjects(const Scene& scene) {
  std::vector<ThingObjects> groups;
  for (const SceneObject& object : scene.objects) {
    if (groups.empty() || groups.back().name != object.name) groups.push_back({object.name, {}});
    groups.back().objects.push_back(&object);
  }
  std::vector<ThingObjects> things;
  for (const ThingObjects& group : groups) {
    AlignedBox2d box;
    for (const SceneObject* object : group.objects)
      for (const Vector3d& p : worldMesh(*object).vertices) box.extend(p.head<2>());
    if (group.objects.size() == 1 || box.diagonal().norm() < kOneThing) {
      things.push_back(group);
    } else {
      for (const SceneObject* object : group.objects) things.push_back({object->part, {object}});
    }
  }
  return things;
}

TriangleMesh wholeMesh(const std::vector<const SceneObject*>& objects) {
  TriangleMesh whole;
  for (const SceneObject* object : objects) {
    const TriangleMesh part = worldMesh(*object);
    const int base = static_cast<int>(whole.vertices.size());
    whole.vertices.insert(whole.vertices.end(), part.vertices.begin(), part.vertices.end());
    for (const auto& t : part.triangles)
      whole.triangles.push_back({t[0] + base, t[1] + base, t[2] + base});
  }
  return whole;
}

}  // namespace

std::vector<PlanThing> cutScene(const Scene& scene, double floor) {
  std::vector<PlanThing> things;
  for (const ThingObjects& group : groupObjects(scene)) {
    PlanThing& thing = things.emplace_back();
    thing.name = group.name;
    const TriangleMesh mesh = wholeMesh(group.objects);
    const bool convex =
        group.objects.size() == 1 && !std::holds_alternative<TriangleMesh>(group.objects[0]->shape);
    const auto trace = convex ? traceConvexOutline : traceOutlines;
    for (const Vector3d& p : mesh.vertices) thing.top = std::max(thing.top, p.z() - floor);
    thing.floor = trace(mesh, {floor - kFloorDepth, floor + kFloorDepth, 0.02});
    thing.body = trace(mesh, {floor + kLow, floor + kHigh, kCell});
    thing.hips = trace(mesh, {floor + kHipLow, floor + kHipHigh, kCell});
    for (const Outline& outline : thing.body)
      for (const Vector2d& p : outline) thing.box.extend(p);
  }
  return things;
}

}  // namespace amble

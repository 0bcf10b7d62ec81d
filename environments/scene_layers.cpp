#include "environments/scene_layers.h"

#include <algorithm>
#include <utility>

namespace amble {
namespace {

// Obstacles higher than this over the floor are left to FCL: nobody is so tall [m].
constexpr double kFieldTop = 2.2;
constexpr double kFieldBottom = -0.3;  // soles and their depth need little [m]
constexpr double kFieldMargin = 0.7;   // beyond what can be walked on: an arm's reach [m]

// Where bodies can be: around the ground, not higher than they are; and no larger than what there
// is to touch.
Eigen::AlignedBox3d fieldRegion(const Eigen::AlignedBox3d& obstacles, const SceneGround& ground) {
  if (obstacles.isEmpty()) return {};
  const Eigen::Vector3d margin = Eigen::Vector3d::Constant(kFieldMargin);
  Eigen::AlignedBox3d region(obstacles.min() - margin, obstacles.max() + margin);
  const Eigen::AlignedBox2d extent = ground.extent();
  if (extent.isEmpty()) return region;
  const Eigen::Vector3d low(extent.min().x() - kFieldMargin, extent.min().y() - kFieldMargin,
                            ground.floor() + kFieldBottom);
  const Eigen::Vector3d high(extent.max().x() + kFieldMargin, extent.max().y() + kFieldMargin,
                             ground.floor() + kFieldTop);
  return region.intersection(Eigen::AlignedBox3d(low, high));
}

}  // namespace

struct SceneLayers::Split {
  std::vector<Obstacle> obstacles, ground;

  Split(const Scene& scene, const SceneGround& scene_ground) {
    const double top = scene_ground.floor() + SceneGround::kLevel;
    for (size_t i = 0; i < scene.objects.size(); ++i) {
      const SceneObject& object = scene.objects[i];
      const int index = static_cast<int>(i);
      if (object.role == Role::kIgnore) continue;
      if (scene_ground.isGround(index)) {
        splitGround(worldMesh(object), index, top);
        continue;
      }
      const bool is_mesh = std::holds_alternative<TriangleMesh>(object.shape);
      obstacles.push_back(
          {index, object.shape, object.X_WO, is_mesh ? worldMesh(object) : TriangleMesh{}});
    }
  }

  // Parts a ground object's surfaces into those on the floor's level or below, and the rest.
  void splitGround(const TriangleMesh& mesh, int index, double top) {
    TriangleMesh low{mesh.vertices, {}}, rest{mesh.vertices, {}};
    for (const std::array<int, 3>& t : mesh.triangles) {
      const double height =
          std::max({mesh.vertices[t[0]].z(), mesh.vertices[t[1]].z(), mesh.vertices[t[2]].z()});
      (height <= top ? low : rest).triangles.push_back(t);
    }
    ground.push_back({index, cleanMesh(low), Eigen::Isometry3d::Identity(), {}});
    if (!rest.triangles.empty())
      obstacles.push_back({index, cleanMesh(rest), Eigen::Isometry3d::Identity(), mesh, top});
  }
};

SceneLayers::SceneLayers(const Scene& scene, const SceneGround& ground)
    : SceneLayers(Split(scene, ground), ground) {}

SceneLayers::SceneLayers(Split split, const SceneGround& ground)
    : obstacles_(split.obstacles),
      ground_(std::move(split.ground), ground),
      field_(split.obstacles, fieldRegion(obstacles_.bounds(), ground)) {}

}  // namespace amble

#include "environments/collision/scene_layers.h"

#include <algorithm>
#include <utility>

#include "base/parallel.h"
#include "environments/scene/scene_pieces.h"

namespace amble {
namespace {

// Obstacles higher than this over the highest ground are left to the exact check: nobody is so tall
// [m].
constexpr double kFieldTop = 2.2;
constexpr double kFieldBottom = -0.3;  // soles and their depth need little [m]
constexpr double kFieldMargin = 0.7;   // beyond what can be walked on: an arm's reach [m]
// What ends on the ground and is no higher than this lies below the ground's surface with it:
// risers, edges of slabs, undersides. Higher than what is climbed in a step, lower than walls [m].
constexpr double kTallestRiser = 0.35;

Eigen::AlignedBox3d boundsOfAll(const std::vector<Obstacle>& obstacles) {
  Eigen::AlignedBox3d bounds;
  for (const Obstacle& obstacle : obstacles)
    bounds.extend(worldBounds(obstacle.shape, obstacle.X_WO));
  return bounds;
}

// Where bodies can be: around the ground, not higher than they are; and no larger than what there
// is to touch.
Eigen::AlignedBox3d fieldRegion(const Eigen::AlignedBox3d& obstacles, const SceneGround& ground) {
  if (obstacles.isEmpty()) return {};
  const Eigen::Vector3d margin = Eigen::Vector3d::Constant(kFieldMargin);
  Eigen::AlignedBox3d region(obstacles.min() - margin, obstacles.max() + margin);
  Eigen::AlignedBox3d surfaces;
  for (const Triangle3& t : ground.surfaces().triangles())
    for (const Eigen::Vector3d& corner : t) surfaces.extend(corner);
  if (surfaces.isEmpty()) return region;
  const Eigen::Vector3d low(kFieldMargin, kFieldMargin, -kFieldBottom),
      high(kFieldMargin, kFieldMargin, kFieldTop);
  return region.intersection(Eigen::AlignedBox3d(surfaces.min() - low, surfaces.max() + high));
}

// Whether a triangle of an object with ground lies below the surface of the ground, each corner no
// deeper than a riser is high.
bool isBelowGround(const Triangle3& t, const SceneGround& ground) {
  const auto [low, high] = std::minmax({t[0].z(), t[1].z(), t[2].z()});
  if (high - low > kTallestRiser) return false;
  return std::all_of(t.begin(), t.end(), [&](const Eigen::Vector3d& corner) {
    bool covered = false;
    ground.surfaces().visitAt(corner.x(), corner.y(), [&](int k) {
      if (covered) return;
      const auto z = heightOver(ground.surfaces().triangles()[k], corner.x(), corner.y());
      covered = z && *z >= corner.z() - kTouching && *z <= corner.z() + kTallestRiser;
    });
    return covered;
  });
}

}  // namespace

struct SceneLayers::Split {
  std::vector<Obstacle> obstacles, banks, ground;

  Split(const Scene& scene, const SceneGround& scene_ground, const StopRequest& stop) {
    const ScenePieces& pieces = scene_ground.pieces();
    for (size_t i = 0; i < scene.objects.size(); ++i) {
      stop.check();
      const SceneObject& object = scene.objects[i];
      const int index = static_cast<int>(i);
      if (object.role == Role::kIgnore) continue;
      if (scene_ground.isGround(index)) {
        splitGround(index, scene_ground);
        continue;
      }
      obstacles.push_back({index, object.shape, object.X_WO, {}});
    }
    // Both the field and the set of obstacles ask what is inside.
    parallelFor(static_cast<int>(obstacles.size()), usualThreads(), [&](int i, int) {
      stop.check();
      Obstacle& obstacle = obstacles[i];
      const bool is_mesh = std::holds_alternative<TriangleMesh>(obstacle.shape);
      if (is_mesh && !scene_ground.isGround(obstacle.object))
        obstacle.solid = solidOf(obstacle.object, pieces);
      obstacle.inside = std::make_shared<const Parity>(obstacle.solid);
    });
  }

  // Parts an object with ground: what is ground or lies below it; the rest of the pieces that this
  // is taken from; and pieces that have no ground. Inside is by parity over all of them: the ground
  // layer tells.
  void splitGround(int index, const SceneGround& ground_of) {
    TriangleMesh low, bank, rest;
    for (const ScenePiece& piece : ground_of.pieces().ofObject(index)) {
      std::vector<bool> is_low;
      bool has_ground = false;
      for (size_t t = 0; t < piece.mesh.triangles.size(); ++t) {
        const int number = piece.first + static_cast<int>(t);
        const bool is_ground = ground_of.isGroundTriangle(number);
        has_ground = has_ground || is_ground;
        is_low.push_back(is_ground ||
                         isBelowGround(ground_of.pieces().triangles()[number], ground_of));
      }
      if (!has_ground) {
        appendMesh(rest, piece.mesh);
        continue;
      }
      TriangleMesh below{piece.mesh.vertices, {}}, above{piece.mesh.vertices, {}};
      for (size_t t = 0; t < is_low.size(); ++t)
        (is_low[t] ? below : above).triangles.push_back(piece.mesh.triangles[t]);
      appendMesh(low, below);
      if (!above.triangles.empty()) appendMesh(bank, above);
    }
    const Eigen::Isometry3d here = Eigen::Isometry3d::Identity();
    this->ground.push_back({index, cleanMesh(low), here, solidOf(index, ground_of.pieces())});
    if (!bank.triangles.empty()) banks.push_back({index, cleanMesh(bank), here, {}});
    if (!rest.triangles.empty()) obstacles.push_back({index, cleanMesh(rest), here, {}});
  }

  // Obstacles and banks; `both` is where they are put together, if there are any banks.
  const std::vector<Obstacle>& standing(std::vector<Obstacle>& both) const {
    if (banks.empty()) return obstacles;
    both = obstacles;
    both.insert(both.end(), banks.begin(), banks.end());
    return both;
  }
};

SceneLayers::SceneLayers(const Scene& scene, const SceneGround& ground, const StopRequest& stop,
                         Checker checker) {
  Split split(scene, ground, stop);
  std::vector<Obstacle> both;
  const std::vector<Obstacle>& standing = split.standing(both);
  const Eigen::AlignedBox3d bounds = boundsOfAll(standing);
  empty_ = bounds.isEmpty();
  parallelFor(3, usualThreads(), [&](int part, int) {
    if (part == 0) {
      field_.emplace(standing, fieldRegion(bounds, ground), stop);
    } else if (part == 1) {
      obstacles_.emplace(split.obstacles, stop, checker);
      banks_.emplace(split.banks, stop, checker);
    } else {
      ground_.emplace(std::move(split.ground), stop, checker);
    }
  });
}

int SceneLayers::touchedObstacle(const Capsule& capsule, double depth,
                                 ObstacleSet::Scratch& scratch, int after) const {
  if (field_->isFree(capsule)) return -1;
  const int object = obstacles_->touched(capsule, scratch, after);
  if (banks_->bounds().isEmpty()) return object;
  Capsule lifted = capsule;
  lifted.from.z() += depth;
  lifted.to.z() += depth;
  const int bank = banks_->touched(lifted, scratch, after);
  return object < 0 || (bank >= 0 && bank < object) ? bank : object;
}

ObstacleSet::Nearest SceneLayers::nearestObstacle(const Capsule& capsule, double limit,
                                                  bool is_sole,
                                                  ObstacleSet::Scratch& scratch) const {
  if (field_->isFree(capsule.inflated(limit))) return {limit, -1};
  const ObstacleSet::Nearest nearest = obstacles_->nearest(capsule, limit, scratch);
  if (is_sole) return nearest;
  const ObstacleSet::Nearest bank = banks_->nearest(capsule, nearest.distance, scratch);
  return bank.object >= 0 ? bank : nearest;
}

}  // namespace amble

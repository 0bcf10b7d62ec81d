#include "environments/collision/obstacle_set.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/parallel.h"
#include "environments/collision/fcl_surface.h"
#include "environments/collision/segment_distance.h"
#include "environments/collision/triangle_tree.h"
#include "environments/scene/box_tree.h"

namespace amble {
namespace {

class TreeSurface : public Surface {
 public:
  explicit TreeSurface(const TriangleMesh& mesh) : tree_(mesh) {}
  bool touches(const Capsule& capsule) const override { return tree_.touches(capsule); }
  double distance(const Capsule& capsule, double limit) const override {
    return tree_.distance(capsule, limit);
  }

 private:
  TriangleTree tree_;
};

// A sphere or a capsule.
class RoundSurface : public Surface {
 public:
  explicit RoundSurface(const Capsule& round) : round_(round) {}
  bool touches(const Capsule& capsule) const override { return distance(capsule, 1.0) <= 0.0; }
  double distance(const Capsule& capsule, double limit) const override {
    const double axes =
        std::sqrt(squaredDistance({capsule.from, capsule.to}, Segment{round_.from, round_.to}));
    return std::clamp(axes - capsule.radius - round_.radius, 0.0, limit);
  }

 private:
  Capsule round_;
};

// All points no farther than `radius` from an axis along z, so long to both sides.
Capsule roundThing(const Eigen::Isometry3d& X_WO, double radius, double half) {
  const Eigen::Vector3d tip(0.0, 0.0, half);
  return {X_WO * Eigen::Vector3d(-tip), X_WO * tip, radius};
}

TriangleMesh placed(TriangleMesh mesh, const Eigen::Isometry3d& X) {
  for (Eigen::Vector3d& v : mesh.vertices) v = X * v;
  return mesh;
}

Eigen::AlignedBox3d boundsOf(const TriangleMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& v : mesh.vertices) box.extend(v);
  return box;
}

struct Piece {
  int object = -1;
  SurfacePtr surface;                   // none where there is no triangle
  std::shared_ptr<const Parity> solid;  // none where nothing is
  Eigen::AlignedBox3d bounds = {};      // World

  // For a capsule that touches no surface: it is inside as a whole or not at all.
  bool contains(const Capsule& capsule) const { return solid && solid->inside(capsule.from); }
  bool touches(const Capsule& capsule) const {
    return (surface && surface->touches(capsule)) || contains(capsule);
  }
};

// Meshes are placed here, once, instead of in every query.
Piece meshPiece(const Obstacle& obstacle, const TriangleMesh& mesh,
                std::shared_ptr<const Parity> solid, Checker checker) {
  const TriangleMesh here = placed(mesh, obstacle.X_WO);
  Piece piece{obstacle.object, nullptr, std::move(solid), boundsOf(here)};
  if (!piece.solid->empty()) piece.bounds.extend(piece.solid->bounds());
  if (here.triangles.empty()) return piece;
  piece.surface = checker == Checker::kFcl ? makeFclSurface(here, Eigen::Isometry3d::Identity())
                                           : std::make_unique<TreeSurface>(here);
  return piece;
}

Piece roundPiece(int object, const Capsule& round) {
  return {object, std::make_unique<RoundSurface>(round), {}, round.bounds()};
}

Piece fclPiece(const Obstacle& obstacle) {
  // FCL may find a contact from so far away [m].
  const Eigen::Vector3d tolerance = Eigen::Vector3d::Constant(1e-5);
  const Eigen::AlignedBox3d box = worldBounds(obstacle.shape, obstacle.X_WO);
  return {obstacle.object,
          makeFclSurface(obstacle.shape, obstacle.X_WO),
          {},
          {box.min() - tolerance, box.max() + tolerance}};
}

Piece makePiece(const Obstacle& obstacle, Checker checker) {
  const auto& [object, shape, X_WO, solid, inside] = obstacle;
  if (const auto* mesh = std::get_if<TriangleMesh>(&shape))
    return meshPiece(obstacle, *mesh, insideOf(obstacle), checker);
  if (checker == Checker::kFcl) return fclPiece(obstacle);
  if (const auto* box = std::get_if<Box>(&shape)) {
    const TriangleMesh mesh = makeBox(box->size);
    return meshPiece(obstacle, mesh, std::make_shared<const Parity>(SolidMesh(placed(mesh, X_WO))),
                     checker);
  }
  if (const auto* ball = std::get_if<Sphere>(&shape))
    return roundPiece(object, roundThing(X_WO, ball->radius, 0.0));
  if (const auto* post = std::get_if<CapsuleShape>(&shape))
    return roundPiece(object, roundThing(X_WO, post->radius, 0.5 * post->height - post->radius));
  return fclPiece(obstacle);
}

}  // namespace

std::shared_ptr<const Parity> insideOf(const Obstacle& obstacle) {
  return obstacle.inside ? obstacle.inside : std::make_shared<const Parity>(obstacle.solid);
}

class ObstacleSet::Scratch {
 public:
  std::vector<int> near;  // pieces that a query's box meets
};

struct ObstacleSet::Impl {
  std::vector<Piece> pieces;
  BoxTree tree;  // of the pieces
  Eigen::AlignedBox3d bounds;
};

void ObstacleSet::ScratchDeleter::operator()(Scratch* scratch) const { delete scratch; }
ObstacleSet::ScratchPtr ObstacleSet::makeScratch() { return ScratchPtr(new Scratch); }

ObstacleSet::ObstacleSet(const std::vector<Obstacle>& obstacles, const StopRequest& stop,
                         Checker checker)
    : impl_(std::make_unique<Impl>()) {
  const int count = static_cast<int>(obstacles.size());
  std::vector<Piece> pieces(obstacles.size());
  parallelFor(count, usualThreads(), [&](int i, int) {
    stop.check();
    pieces[i] = makePiece(obstacles[i], checker);
  });
  std::vector<Eigen::AlignedBox3d> boxes;
  for (Piece& piece : pieces) {
    if (piece.bounds.isEmpty()) continue;
    impl_->bounds.extend(piece.bounds);
    boxes.push_back(piece.bounds);
    impl_->pieces.push_back(std::move(piece));
  }
  impl_->tree = BoxTree(boxes);
}

ObstacleSet::~ObstacleSet() = default;
ObstacleSet::ObstacleSet(ObstacleSet&&) noexcept = default;

const Eigen::AlignedBox3d& ObstacleSet::bounds() const { return impl_->bounds; }

int ObstacleSet::touched(const Capsule& capsule, Scratch& scratch, int after) const {
  impl_->tree.find(capsule.bounds(), scratch.near);
  for (const int i : scratch.near) {
    const Piece& piece = impl_->pieces[i];
    if (piece.object > after && piece.touches(capsule)) return piece.object;
  }
  return -1;
}

ObstacleSet::Nearest ObstacleSet::nearest(const Capsule& capsule, double limit,
                                          Scratch& scratch) const {
  Nearest best{limit, -1};
  const Eigen::AlignedBox3d box = capsule.bounds();
  const Eigen::Vector3d reach = Eigen::Vector3d::Constant(limit);
  impl_->tree.find({box.min() - reach, box.max() + reach}, scratch.near);
  for (const int i : scratch.near) {
    const Piece& piece = impl_->pieces[i];
    if (std::sqrt(piece.bounds.squaredExteriorDistance(box)) >= best.distance) continue;
    if (piece.contains(capsule)) return {0.0, piece.object};
    if (!piece.surface) continue;
    const double distance = piece.surface->distance(capsule, best.distance);
    if (distance < best.distance) best = {distance, piece.object};
    if (distance <= 0.0) return best;
  }
  return best;
}

}  // namespace amble

#include "environments/collision/obstacle_set.h"

#include <fcl/fcl.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "environments/collision/box_tree.h"
#include "environments/scene/parity.h"

namespace amble {
namespace {

using Geometry = std::shared_ptr<fcl::CollisionGeometryd>;

template <typename Bv>
Geometry makeTree(const TriangleMesh& mesh) {
  auto model = std::make_shared<fcl::BVHModel<Bv>>();
  std::vector<fcl::Triangle> triangles;
  triangles.reserve(mesh.triangles.size());
  for (const std::array<int, 3>& t : mesh.triangles) triangles.emplace_back(t[0], t[1], t[2]);
  model->beginModel(static_cast<int>(triangles.size()), static_cast<int>(mesh.vertices.size()));
  model->addSubModel(mesh.vertices, triangles);
  model->endModel();
  model->computeLocalAABB();
  return model;
}

// What a shape is to FCL: for yes or no, and for distances.
struct Geometries {
  Geometry boolean, distance;
};

Geometries makeGeometries(const Shape& shape) {
  const auto both = [](Geometry g) {
    g->computeLocalAABB();
    return Geometries{g, g};
  };
  if (const auto* box = std::get_if<Box>(&shape))
    return both(std::make_shared<fcl::Boxd>(box->size));
  if (const auto* cylinder = std::get_if<Cylinder>(&shape))
    return both(std::make_shared<fcl::Cylinderd>(cylinder->radius, cylinder->height));
  if (const auto* sphere = std::get_if<Sphere>(&shape))
    return both(std::make_shared<fcl::Sphered>(sphere->radius));
  if (const auto* capsule = std::get_if<CapsuleShape>(&shape))
    return both(
        std::make_shared<fcl::Capsuled>(capsule->radius, capsule->height - 2.0 * capsule->radius));
  const auto& mesh = std::get<TriangleMesh>(shape);
  return {makeTree<fcl::OBBd>(mesh), makeTree<fcl::OBBRSSd>(mesh)};
}

// Takes FCL's capsule, along z about its middle, to ours.
fcl::Transform3d placing(const Capsule& capsule, double length) {
  fcl::Transform3d X = fcl::Transform3d::Identity();
  X.translation() = 0.5 * (capsule.from + capsule.to);
  if (length > 0.0) {
    const Eigen::Vector3d z = (capsule.to - capsule.from) / length;
    const Eigen::Vector3d x = z.unitOrthogonal();
    X.linear().col(0) = x;
    X.linear().col(1) = z.cross(x);
    X.linear().col(2) = z;
  }
  return X;
}

}  // namespace

class ObstacleSet::Scratch {
 public:
  void set(const Capsule& capsule) {
    const double length = (capsule.to - capsule.from).norm();
    shape.radius = capsule.radius;
    shape.lz = length;
    X = placing(capsule, length);
  }

  fcl::Capsuled shape{1.0, 1.0};
  fcl::Transform3d X;
  fcl::CollisionRequestd request;  // its defaults are ours: libccd, one contact, no details
  fcl::CollisionResultd result;
  std::vector<int> near;  // pieces that a query's box meets
};

struct ObstacleSet::Impl {
  struct Piece {
    int object;
    Eigen::AlignedBox3d bounds;  // World
    Geometries geometries;
    fcl::Transform3d X;
    Parity solid;

    // For a capsule that touches no surface: it is inside as a whole or not at all.
    bool contains(const Capsule& capsule) const { return solid.inside(capsule.from); }
  };

  // Meshes are placed here, once, instead of in every query.
  static Piece meshPiece(const Obstacle& obstacle) {
    Piece piece = emptyPiece(obstacle);
    TriangleMesh placed = std::get<TriangleMesh>(obstacle.shape);
    for (Eigen::Vector3d& v : placed.vertices) {
      v = obstacle.X_WO * v;
      piece.bounds.extend(v);
    }
    if (!placed.triangles.empty()) piece.geometries = makeGeometries(placed);
    if (!piece.solid.empty()) piece.bounds.extend(piece.solid.bounds());
    return piece;
  }

  static Piece primitivePiece(const Obstacle& obstacle) {
    Piece piece = emptyPiece(obstacle);
    piece.geometries = makeGeometries(obstacle.shape);
    piece.X.matrix() = obstacle.X_WO.matrix();
    const fcl::AABBd& local = piece.geometries.boolean->aabb_local;
    piece.bounds = Eigen::AlignedBox3d(local.min_, local.max_).transformed(piece.X);
    return piece;
  }

  static Piece emptyPiece(const Obstacle& obstacle) {
    return {obstacle.object, {}, {}, fcl::Transform3d::Identity(), Parity(obstacle.solid)};
  }

  bool touches(const Piece& piece, Scratch& scratch) const {
    scratch.result.clear();
    return fcl::collide(piece.geometries.boolean.get(), piece.X, &scratch.shape, scratch.X,
                        scratch.request, scratch.result) > 0;
  }

  double distance(const Piece& piece, const Scratch& scratch) const {
    fcl::DistanceRequestd request(false, false, 0.0, 0.0, 1e-7, fcl::GST_INDEP);
    fcl::DistanceResultd result;
    return fcl::distance(piece.geometries.distance.get(), piece.X, &scratch.shape, scratch.X,
                         request, result);
  }

  std::vector<Piece> pieces;
  BoxTree tree;  // of the pieces
  Eigen::AlignedBox3d bounds;
};

void ObstacleSet::ScratchDeleter::operator()(Scratch* scratch) const { delete scratch; }
ObstacleSet::ScratchPtr ObstacleSet::makeScratch() { return ScratchPtr(new Scratch); }

ObstacleSet::ObstacleSet(std::vector<Obstacle> obstacles, const StopRequest& stop)
    : impl_(std::make_unique<Impl>()) {
  std::vector<Eigen::AlignedBox3d> boxes;
  for (const Obstacle& obstacle : obstacles) {
    stop.check();
    Impl::Piece piece = std::holds_alternative<TriangleMesh>(obstacle.shape)
                            ? Impl::meshPiece(obstacle)
                            : Impl::primitivePiece(obstacle);
    if (piece.bounds.isEmpty()) continue;
    impl_->bounds.extend(piece.bounds);
    boxes.push_back(piece.bounds);
    impl_->pieces.push_back(std::move(piece));
  }
  impl_->tree = BoxTree(boxes);
  // FCL fills tables at the first query: do that before threads share us.
  const ScratchPtr scratch = makeScratch();
  if (!impl_->pieces.empty()) {
    const Eigen::Vector3d c = impl_->bounds.center();
    nearest({c, c + Eigen::Vector3d::UnitZ(), 0.1}, std::numeric_limits<double>::infinity(),
            *scratch);
  }
}

ObstacleSet::~ObstacleSet() = default;
ObstacleSet::ObstacleSet(ObstacleSet&&) noexcept = default;

const Eigen::AlignedBox3d& ObstacleSet::bounds() const { return impl_->bounds; }

int ObstacleSet::touched(const Capsule& capsule, Scratch& scratch) const {
  const Eigen::AlignedBox3d box = capsule.bounds();
  impl_->tree.find(box, scratch.near);
  if (scratch.near.empty()) return -1;
  scratch.set(capsule);
  for (const int i : scratch.near) {
    const Impl::Piece& piece = impl_->pieces[i];
    if (piece.geometries.boolean && impl_->touches(piece, scratch)) return piece.object;
    if (piece.contains(capsule)) return piece.object;
  }
  return -1;
}

ObstacleSet::Nearest ObstacleSet::nearest(const Capsule& capsule, double limit,
                                          Scratch& scratch) const {
  Nearest best{limit, -1};
  const Eigen::AlignedBox3d box = capsule.bounds();
  const Eigen::Vector3d reach = Eigen::Vector3d::Constant(limit);
  impl_->tree.find({box.min() - reach, box.max() + reach}, scratch.near);
  scratch.set(capsule);
  for (const int i : scratch.near) {
    const Impl::Piece& piece = impl_->pieces[i];
    if (std::sqrt(piece.bounds.squaredExteriorDistance(box)) >= best.distance) continue;
    const bool touches =
        (piece.geometries.boolean && impl_->touches(piece, scratch)) || piece.contains(capsule);
    if (touches) return {0.0, piece.object};
    if (!piece.geometries.distance) continue;
    const double distance = std::max(0.0, impl_->distance(piece, scratch));
    if (distance < best.distance) best = {distance, piece.object};
  }
  return best;
}

}  // namespace amble

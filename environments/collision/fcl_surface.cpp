#include "environments/collision/fcl_surface.h"

#include <fcl/fcl.h>

#include <algorithm>

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

// FCL's capsule, which lies along z about its middle, in the place of ours.
struct Placed {
  fcl::Capsuled shape;
  fcl::Transform3d X = fcl::Transform3d::Identity();

  explicit Placed(const Capsule& capsule)
      : shape(capsule.radius, (capsule.to - capsule.from).norm()) {
    X.translation() = 0.5 * (capsule.from + capsule.to);
    if (shape.lz <= 0.0) return;
    const Eigen::Vector3d z = (capsule.to - capsule.from) / shape.lz;
    const Eigen::Vector3d x = z.unitOrthogonal();
    X.linear().col(0) = x;
    X.linear().col(1) = z.cross(x);
    X.linear().col(2) = z;
  }
};

class FclSurface : public Surface {
 public:
  FclSurface(const Shape& shape, const Eigen::Isometry3d& X_WO)
      : geometries_(makeGeometries(shape)) {
    X_.matrix() = X_WO.matrix();
    // FCL fills tables at the first query: do that before threads share us.
    const Eigen::Vector3d c = X_WO.translation();
    FclSurface::touches({c, c + Eigen::Vector3d::UnitZ(), 0.1});
    FclSurface::distance({c, c + Eigen::Vector3d::UnitZ(), 0.1}, 1.0);
  }

  bool touches(const Capsule& capsule) const override {
    Placed placed(capsule);
    const fcl::CollisionRequestd request;  // its defaults are ours: libccd, one contact, no details
    fcl::CollisionResultd result;
    return fcl::collide(geometries_.boolean.get(), X_, &placed.shape, placed.X, request, result) >
           0;
  }

  double distance(const Capsule& capsule, double limit) const override {
    if (touches(capsule)) return 0.0;
    Placed placed(capsule);
    const fcl::DistanceRequestd request(false, false, 0.0, 0.0, 1e-7, fcl::GST_INDEP);
    fcl::DistanceResultd result;
    const double distance =
        fcl::distance(geometries_.distance.get(), X_, &placed.shape, placed.X, request, result);
    return std::clamp(distance, 0.0, limit);
  }

 private:
  Geometries geometries_;
  fcl::Transform3d X_;
};

}  // namespace

SurfacePtr makeFclSurface(const Shape& shape, const Eigen::Isometry3d& X_WO) {
  return std::make_unique<FclSurface>(shape, X_WO);
}

}  // namespace amble

#include "environments/ground_layer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace amble {
namespace {

constexpr double kNone = -std::numeric_limits<double>::infinity();

const TriangleMesh& meshOf(const Obstacle& surface) {
  return std::get<TriangleMesh>(surface.shape);
}

// Whether triangle and square are apart along `axis`, in the plane.
bool apartAlong(const Eigen::Vector2d& axis, const std::array<Eigen::Vector2d, 3>& t, double half) {
  const double a = axis.dot(t[0]), b = axis.dot(t[1]), c = axis.dot(t[2]);
  const double reach = half * axis.cwiseAbs().sum();
  return std::min({a, b, c}) > reach || std::max({a, b, c}) < -reach;
}

}  // namespace

GroundLayer::GroundLayer(std::vector<Obstacle> surfaces, const SceneGround& ground)
    : ground_(ground), surfaces_(surfaces), highest_(kNone) {
  for (const Obstacle& surface : surfaces) {
    Footprint footprint{surface.object, {}};
    for (const Eigen::Vector3d& v : meshOf(surface).vertices) {
      footprint.box.extend(Eigen::Vector2d(v.head<2>()));
      highest_ = std::max(highest_, v.z());
    }
    extent_.extend(footprint.box);
    footprints_.push_back(footprint);
  }
  if (extent_.isEmpty()) return;
  cell_ = std::max(kCell, extent_.sizes().maxCoeff() / kMostCells);
  for (int k = 0; k < 2; ++k) count_[k] = 1 + static_cast<int>(extent_.sizes()[k] / cell_);
  ceiling_.assign(static_cast<size_t>(count_.x()) * count_.y(), kNone);
  for (const Obstacle& surface : surfaces) raise(surface);
}

Eigen::Vector2i GroundLayer::cellOf(const Eigen::Vector2d& p) const {
  Eigen::Vector2i cell;
  for (int k = 0; k < 2; ++k) {
    const double steps = std::clamp((p[k] - extent_.min()[k]) / cell_, 0.0, count_[k] - 1.0);
    cell[k] = static_cast<int>(steps);
  }
  return cell;
}

// Every cell that a triangle overlaps becomes as high as its highest corner.
void GroundLayer::raise(const Obstacle& surface) {
  const TriangleMesh& mesh = meshOf(surface);
  const double half = 0.5 * cell_ * (1.0 + 1e-6);
  for (const std::array<int, 3>& t : mesh.triangles) {
    Eigen::AlignedBox2d box;
    double height = kNone;
    for (int v : t) {
      box.extend(Eigen::Vector2d(mesh.vertices[v].head<2>()));
      height = std::max(height, mesh.vertices[v].z());
    }
    const Eigen::Vector2i low = cellOf(box.min().array() - 1e-6),
                          high = cellOf(box.max().array() + 1e-6);
    for (int j = low.y(); j <= high.y(); ++j) {
      for (int i = low.x(); i <= high.x(); ++i) {
        const Eigen::Vector2d centre = extent_.min() + cell_ * Eigen::Vector2d(i + 0.5, j + 0.5);
        std::array<Eigen::Vector2d, 3> local;
        for (int k = 0; k < 3; ++k) local[k] = mesh.vertices[t[k]].head<2>() - centre;
        bool apart = false;
        for (int k = 0; k < 3 && !apart; ++k) {
          const Eigen::Vector2d edge = local[(k + 1) % 3] - local[k];
          apart = apartAlong({-edge.y(), edge.x()}, local, half);
        }
        double& cell = ceiling_[static_cast<size_t>(j) * count_.x() + i];
        if (!apart) cell = std::max(cell, height);
      }
    }
  }
}

double GroundLayer::ceiling(const Eigen::AlignedBox3d& box) const {
  const Eigen::AlignedBox2d flat(Eigen::Vector2d(box.min().head<2>()),
                                 Eigen::Vector2d(box.max().head<2>()));
  if (extent_.isEmpty() || !extent_.intersects(flat)) return kNone;
  const Eigen::Vector2i low = cellOf(flat.min()), high = cellOf(flat.max());
  double height = kNone;
  for (int j = low.y(); j <= high.y(); ++j)
    for (int i = low.x(); i <= high.x(); ++i)
      height = std::max(height, ceiling_[static_cast<size_t>(j) * count_.x() + i]);
  return height;
}

int GroundLayer::touched(const Capsule& capsule, double depth,
                         ObstacleSet::Scratch& scratch) const {
  if (capsule.lowest() + depth >= highest_) return -1;
  if (capsule.lowest() + depth >= ceiling(capsule.bounds())) return -1;
  Capsule lifted = capsule;
  lifted.from.z() += depth;
  lifted.to.z() += depth;
  const int object = surfaces_.touched(lifted, scratch);
  if (object >= 0) return object;
  // It touches nothing: it is under the ground as a whole or not at all.
  const Eigen::Vector3d& p = lifted.from;
  const auto height = ground_.height(p.x(), p.y(), ground_.floor(), SceneGround::kLevel);
  if (!height || p.z() >= *height) return -1;
  for (const Footprint& footprint : footprints_)
    if (footprint.box.contains(Eigen::Vector2d(p.head<2>()))) return footprint.object;
  return footprints_.front().object;
}

}  // namespace amble

/// Distances of bodies by brute force in doubles, apart from the code that is measured: of every
/// triangle whose box is near enough, the point of a capsule's axis that is nearest to it by golden
/// section, since its distance is convex; of boxes, cylinders, spheres and capsules their own
/// formulas.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "environments/body/capsule.h"
#include "environments/scene/scene.h"
#include "environments/scene/triangle_grid.h"

namespace amble {

class BruteForce {
 public:
  static constexpr double kFarthest = 1.0;  ///< larger distances are not told apart [m]

  void add(const SceneObject& object) {
    if (std::holds_alternative<TriangleMesh>(object.shape)) {
      const TriangleMesh mesh = worldMesh(object);
      for (const auto& t : mesh.triangles) {
        triangles_.push_back({mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]});
        Eigen::AlignedBox3d box;
        for (const Eigen::Vector3d& corner : triangles_.back()) box.extend(corner);
        boxes_.push_back(box);
      }
    } else {
      solids_.push_back(
          {object.shape, object.X_WO.inverse(), worldBounds(object.shape, object.X_WO)});
    }
  }

  /// From the capsule's side to the nearest thing, negative where they overlap; `least` if that is
  /// less [m].
  double distance(const Capsule& capsule, double least = kFarthest) const {
    Eigen::AlignedBox3d axis(capsule.from);
    axis.extend(capsule.to);
    const auto look = [&](const Eigen::AlignedBox3d& box, const auto& of_point) {
      const double reach = least + capsule.radius;
      if (reach <= 0.0 || box.squaredExteriorDistance(axis) >= reach * reach) return;
      least = std::min(least, ofAxis(capsule, of_point) - capsule.radius);
    };
    for (size_t i = 0; i < triangles_.size(); ++i)
      look(boxes_[i], [&](const Eigen::Vector3d& p) { return ofPoint(p, triangles_[i]); });
    for (const Solid& solid : solids_)
      look(solid.bounds, [&](const Eigen::Vector3d& p) { return ofPoint(p, solid); });
    return least;
  }

 private:
  struct Solid {
    Shape shape;
    Eigen::Isometry3d X_OW;
    Eigen::AlignedBox3d bounds;
  };

  // Of the axis: the least over its points.
  template <typename OfPoint>
  static double ofAxis(const Capsule& capsule, const OfPoint& of_point) {
    constexpr double kGolden = 0.6180339887498949;
    constexpr int kSteps = 75;  // to the last digit
    const auto at = [&](double s) {
      return of_point(Eigen::Vector3d(capsule.from + s * (capsule.to - capsule.from)));
    };
    double low = 0.0, high = 1.0, a = 1.0 - kGolden, b = kGolden, at_a = at(a), at_b = at(b);
    for (int i = 0; i < kSteps; ++i) {
      if (at_a < at_b) {
        high = b, b = a, at_b = at_a;
        at_a = at(a = high - kGolden * (high - low));
      } else {
        low = a, a = b, at_a = at_b;
        at_b = at(b = low + kGolden * (high - low));
      }
    }
    return std::min({at(0.0), at(1.0), at_a, at_b});
  }

  // To the plane where the point lies over the triangle, else to the nearest side.
  static double ofPoint(const Eigen::Vector3d& p, const Triangle3& t) {
    const Eigen::Vector3d normal = (t[1] - t[0]).cross(t[2] - t[0]).normalized();
    bool over = true;
    double least = HUGE_VAL;
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d side = t[(k + 1) % 3] - t[k], to = p - t[k];
      over = over && side.cross(to).dot(normal) >= 0.0;
      const double share = std::clamp(side.dot(to) / side.squaredNorm(), 0.0, 1.0);
      least = std::min(least, (to - share * side).norm());
    }
    return over ? std::abs(normal.dot(p - t[0])) : least;
  }

  // 0 inside.
  static double ofPoint(const Eigen::Vector3d& p_W, const Solid& solid) {
    const Eigen::Vector3d p = solid.X_OW * p_W;
    if (const auto* box = std::get_if<Box>(&solid.shape))
      return (p.cwiseAbs() - 0.5 * box->size).cwiseMax(0.0).norm();
    if (const auto* sphere = std::get_if<Sphere>(&solid.shape))
      return std::max(0.0, p.norm() - sphere->radius);
    if (const auto* round = std::get_if<Cylinder>(&solid.shape))
      return std::hypot(std::max(0.0, p.head<2>().norm() - round->radius),
                        std::max(0.0, std::abs(p.z()) - 0.5 * round->height));
    const auto& capsule = std::get<CapsuleShape>(solid.shape);
    const double half = 0.5 * capsule.height - capsule.radius;
    const Eigen::Vector3d on_axis(0.0, 0.0, std::clamp(p.z(), -half, half));
    return std::max(0.0, (p - on_axis).norm() - capsule.radius);
  }

  std::vector<Triangle3> triangles_;
  std::vector<Eigen::AlignedBox3d> boxes_;  // of the triangles
  std::vector<Solid> solids_;
};

}  // namespace amble

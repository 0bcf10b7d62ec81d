#include "viz/figure/loft.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace amble {

using Eigen::Vector3d;

LoftDistance distanceTo(const Loft& loft, const Vector3d& p) {
  const Vector3d axis = loft.b.at - loft.a.at;
  const double squared = axis.squaredNorm();
  const double along =
      squared > 0.0 ? std::clamp((p - loft.a.at).dot(axis) / squared, 0.0, 1.0) : 0.0;
  const Vector3d v = p - (loft.a.at + along * axis);
  const double half = loft.a.half + along * (loft.b.half - loft.a.half);
  const double aside = std::clamp(v.dot(loft.across), -half, half);
  const double radius = loft.a.radius + along * (loft.b.radius - loft.a.radius);
  return {(v - aside * loft.across).norm() - radius, along};
}

double smoothUnion(double a, double b, double blend) {
  const double near = std::max(blend - std::abs(a - b), 0.0) / blend;
  return std::min(a, b) - 0.25 * blend * near * near;
}

double distanceTo(const std::vector<LoftGroup>& groups, const Vector3d& p) {
  constexpr double kFar = 1e9;
  double all = kFar;
  for (const LoftGroup& group : groups) {
    double one = kFar;
    for (const Loft& loft : group.lofts)
      one = smoothUnion(one, distanceTo(loft, p).distance, loft.blend);
    if (group.floor) one = std::max(one, group.floor->offset - group.floor->normal.dot(p));
    all = smoothUnion(all, one, group.blend);
  }
  return all;
}

std::vector<LoftGroup> loftsNear(const std::vector<LoftGroup>& groups, const Vector3d& at,
                                 double radius, double nearest) {
  std::vector<LoftGroup> some;
  for (const LoftGroup& group : groups) {
    std::vector<Loft> lofts;
    for (const Loft& loft : group.lofts) {
      const double blend = std::max(loft.blend, group.blend);
      if (distanceTo(loft, at).distance < nearest + 4.0 * radius + 2.0 * blend)
        lofts.push_back(loft);
    }
    if (lofts.empty()) continue;
    LoftGroup& part = some.emplace_back();
    part.lofts = std::move(lofts);
    part.blend = group.blend;
    part.floor = group.floor;
  }
  return some;
}

Vector3d outwards(const std::vector<LoftGroup>& groups, const Vector3d& p) {
  constexpr double kStep = 1e-4;  // [m]
  Vector3d grows;
  for (int axis = 0; axis < 3; ++axis) {
    const Vector3d step = kStep * Vector3d::Unit(axis);
    grows[axis] = distanceTo(groups, p + step) - distanceTo(groups, p - step);
  }
  const double length = grows.norm();
  return length > 0.0 ? Vector3d(grows / length) : Vector3d::UnitZ();
}

}  // namespace amble

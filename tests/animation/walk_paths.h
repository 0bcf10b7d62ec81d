/// Root paths of known shape, and the stances at their ends.
#pragma once

#include <cmath>

#include "animation/steps/root_path.h"
#include "animation/steps/stance.h"
#include "base/rotation.h"

namespace amble {

inline RootPath straightPath(double length, double heading = 0.0,
                             const Eigen::Vector2d& from = Eigen::Vector2d::Zero()) {
  const Eigen::Vector2d way(std::cos(heading), std::sin(heading));
  return RootPath({makeBezier(from, heading, from + length * way, heading, 1.0 / 3.0)});
}

/// An arc of a circle, its centre on the left for a positive radius; `angle` has the sign of
/// `radius`. Short cubics: their curvature is 1/r to the fourth power of an arc's angle.
inline RootPath circlePath(double radius, double angle, double heading = 0.0) {
  constexpr int kCurves = 24;
  const double step = angle / kCurves, h = 4.0 / 3.0 * std::tan(step / 4.0) * radius;
  const auto at = [&](double a) {
    return Eigen::Vector2d(radius * (std::sin(heading + a) - std::sin(heading)),
                           radius * (std::cos(heading) - std::cos(heading + a)));
  };
  const auto along = [&](double a) {
    return Eigen::Vector2d(std::cos(heading + a), std::sin(heading + a));
  };
  std::vector<Bezier> curves(kCurves);
  for (int i = 0; i < kCurves; ++i) {
    const double a = i * step, b = a + step;
    curves[i] << at(a), at(a) + h * along(a), at(b) - h * along(b), at(b);
  }
  return RootPath(curves);
}

/// The stance at a path's begin or end.
inline Stance stanceAt(const RootPath& path, bool end, bool standing, Side leading = kLeft) {
  const RootPath::Sample at = path.at(end ? path.length() : 0.0);
  return {{at.position.x(), at.position.y(), 0.0}, at.heading, standing, leading};
}

}  // namespace amble

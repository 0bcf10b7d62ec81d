#include "environments/ground/plan_triangle.h"

#include <cmath>

namespace amble {
namespace {

double crossOf(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

}  // namespace

BoxCorners cornersOf(const Eigen::AlignedBox2d& box) {
  return {box.min(), Eigen::Vector2d(box.max().x(), box.min().y()), box.max(),
          Eigen::Vector2d(box.min().x(), box.max().y())};
}

PlanTriangle::PlanTriangle(const Triangle3& t)
    : corners_{t[0].head<2>(), t[1].head<2>(), t[2].head<2>()},
      twice_area_(crossOf(corners_[1] - corners_[0], corners_[2] - corners_[0])) {
  for (const Eigen::Vector2d& corner : corners_) box_.extend(corner);
}

// How far a point lies inside of edge k, times the edge's length.
double PlanTriangle::inside(int k, const Eigen::Vector2d& edge, const Eigen::Vector2d& p) const {
  return (twice_area_ < 0.0 ? -1.0 : 1.0) * crossOf(edge, p - corners_[k]);
}

bool PlanTriangle::holds(const Eigen::Vector2d& p) const {
  if (std::abs(twice_area_) < kThin || box_.squaredExteriorDistance(p) > kHeld * kHeld)
    return false;
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector2d edge = corner(k + 1) - corner(k);
    if (inside(k, edge, p) < -kHeld * edge.norm()) return false;
  }
  return true;
}

// Unless all of the box lies beyond one side.
bool PlanTriangle::mayMeet(const Eigen::AlignedBox2d& box) const {
  if ((box.min().array() > box_.max().array() + kSeen).any() ||
      (box.max().array() < box_.min().array() - kSeen).any())
    return false;
  if (std::abs(twice_area_) < kThin) return true;
  const Eigen::Vector2d centre = box.center(), half = 0.5 * box.sizes();
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector2d edge = corner(k + 1) - corner(k);
    const double reach = half.x() * std::abs(edge.y()) + half.y() * std::abs(edge.x());
    if (inside(k, edge, centre) + reach < -kSeen * edge.norm()) return false;
  }
  return true;
}

bool PlanTriangle::holdsWith(const PlanTriangle& other, const BoxCorners& box) const {
  for (int k = 0; k < 3; ++k) {
    for (int m = 0; m < 3; ++m)
      if (holdsAcross(k, other, m, box)) return true;
  }
  return false;
}

// The same across edge k, where that is the other's edge as well.
bool PlanTriangle::holdsAcross(int k, const PlanTriangle& other, int other_k,
                               const BoxCorners& box) const {
  const Eigen::Vector2d &p = corner(k), &q = corner(k + 1);
  const Eigen::Vector2d &r = other.corner(other_k), &s = other.corner(other_k + 1);
  if (!((p == r && q == s) || (p == s && q == r))) return false;
  const auto sideOf = [&](const Eigen::Vector2d& at) { return crossOf(q - p, at - p); };
  const double own_side = sideOf(corner(k + 2)), others = sideOf(other.corner(other_k + 2));
  if (!(own_side * others < 0.0)) return false;
  for (size_t i = 0; i < box.size(); ++i) {
    const Eigen::Vector2d &here = box[i], &next = box[(i + 1) % box.size()];
    const double at = sideOf(here), after = sideOf(next);
    if (at * own_side >= 0.0 && !holds(here)) return false;
    if (at * own_side <= 0.0 && !other.holds(here)) return false;
    if (at * after >= 0.0) continue;
    const Eigen::Vector2d crossed = here + at / (at - after) * (next - here);
    if (!holds(crossed) || !other.holds(crossed)) return false;
  }
  return true;
}

}  // namespace amble

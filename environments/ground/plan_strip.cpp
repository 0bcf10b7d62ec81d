#include "environments/ground/plan_strip.h"

#include <algorithm>
#include <array>

#include "environments/ground/plan_triangle.h"

namespace amble {

PlanStrip::PlanStrip(const PlanSegment& segment, double half_width) : origin(segment.from) {
  const Eigen::Vector2d way = segment.to - segment.from;
  const double length = way.norm();
  along = length > 0.0 ? Eigen::Vector2d(way / length) : Eigen::Vector2d(Eigen::Vector2d::UnitX());
  aside << -along.y(), along.x();
  box = {Eigen::Vector2d(0.0, -half_width), Eigen::Vector2d(length, half_width)};
}

Triangle3 PlanStrip::local(const Triangle3& t) const {
  Triangle3 own;
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector2d p = t[k].head<2>() - origin;
    own[k] << along.dot(p), aside.dot(p), t[k].z();
  }
  return own;
}

Eigen::AlignedBox2d PlanStrip::plan() const {
  Eigen::AlignedBox2d plan;
  for (const double s : {box.min().x(), box.max().x()})
    for (const double side : {box.min().y(), box.max().y()})
      plan.extend(origin + s * along + side * aside);
  return plan;
}

StripPlane::StripPlane(const Triangle3& own) {
  const Eigen::Vector3d b = own[1] - own[0], c = own[2] - own[0];
  const double area = b.x() * c.y() - b.y() * c.x();
  const Eigen::Vector2d slope((b.z() * c.y() - c.z() * b.y()) / area,
                              (c.z() * b.x() - b.z() * c.x()) / area);
  constexpr double kSteepest = 1000.0;
  if (!(slope.cwiseAbs().maxCoeff() < kSteepest)) return;
  height = own[0].z() - slope.dot(own[0].head<2>());
  along = slope.x(), aside = slope.y();
}

double StripPlane::highestOver(const Eigen::AlignedBox2d& box) const {
  constexpr double kRounding = 1e-6;  // of slopes up to 1,000 over some metres [m]
  const Eigen::Vector2d middle = 0.5 * (box.min() + box.max()), half = 0.5 * box.sizes();
  return height + middle.x() * along + middle.y() * aside + half.x() * std::abs(along) +
         half.y() * std::abs(aside) + kRounding;
}

std::pair<double, double> surelyMet(const Triangle3& own, double half_width) {
  constexpr double kSure = 1e-6;  // against rounding, of one frame against the other [m]
  constexpr std::pair<double, double> kNowhere = {HUGE_VAL, -HUGE_VAL};
  if (!isLevel(own)) return kNowhere;
  Eigen::AlignedBox2d band;
  for (const Eigen::Vector3d& corner : own) band.extend(Eigen::Vector2d(corner.head<2>()));
  band.min().y() = -half_width + kSure;
  band.max().y() = half_width - kSure;
  if (band.isEmpty()) return kNowhere;
  const auto met = boundsWithin(own, band);
  if (!met) return kNowhere;
  return {met->min().x() + kSure, met->max().x() - kSure};
}

std::optional<double> heightUpSlope(const Triangle3& own, const Eigen::AlignedBox2d& box) {
  const Eigen::Vector3d up = (own[1] - own[0]).cross(own[2] - own[0]);
  // A plane falls to where the normal that points up leans.
  const double x = up.x() * up.z() < 0.0 ? box.max().x() : box.min().x(),
               y = up.y() * up.z() < 0.0 ? box.max().y() : box.min().y();
  const auto sideOf = [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return (b.x() - a.x()) * (y - a.y()) - (b.y() - a.y()) * (x - a.x());
  };
  const double ab = sideOf(own[0], own[1]), bc = sideOf(own[1], own[2]),
               ca = sideOf(own[2], own[0]);
  constexpr double kUpright = 1e-12;  // of twice the area in plan: what is less is rounding [m^2]
  const bool held = (ab > 0.0 && bc > 0.0 && ca > 0.0) || (ab < 0.0 && bc < 0.0 && ca < 0.0);
  if (!held || std::abs(ab + bc + ca) < kUpright) return std::nullopt;
  // Each side weighs the corner opposite to it.
  const double z = (ab * own[2].z() + bc * own[0].z() + ca * own[1].z()) / (ab + bc + ca);
  const auto [low, high] = std::minmax({own[0].z(), own[1].z(), own[2].z()});
  return std::clamp(z, low, high);
}

double crestWithin(const Triangle3& own, const Eigen::AlignedBox2d& box, double low, double high) {
  double highest = -HUGE_VAL;
  if (const auto held = heightUpSlope(own, box)) {
    highest = *held;
  } else if (const auto heights = heightsWithin(own, box)) {
    highest = heights->high;
  }
  return highest >= low && highest <= high ? highest : -HUGE_VAL;
}

}  // namespace amble

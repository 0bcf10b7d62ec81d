#include "animation/ground/ground.h"

#include <algorithm>
#include <limits>

namespace amble {

double Ground::crest(const Eigen::Vector2d& a, const Eigen::Vector2d& b, double half_width,
                     double low, double high) const {
  constexpr double kSpacing = 0.02;  // narrower things are not seen [m]
  const Eigen::Vector2d along = b - a;
  const double length = along.norm();
  const Eigen::Vector2d unit =
      length > 0.0 ? Eigen::Vector2d(along / length) : Eigen::Vector2d(1, 0);
  const Eigen::Vector2d left(-unit.y(), unit.x());
  const int rows = std::max(1, static_cast<int>(std::ceil(length / kSpacing)));
  const int columns = std::max(1, static_cast<int>(std::ceil(half_width / kSpacing)));
  double highest = -std::numeric_limits<double>::infinity();
  for (int i = 0; i <= rows; ++i) {
    for (int j = -columns; j <= columns; ++j) {
      const Eigen::Vector2d p = a + along * i / rows + left * (half_width * j / columns);
      const auto z = height(p.x(), p.y(), 0.5 * (low + high), 0.5 * (high - low));
      if (z) highest = std::max(highest, *z);
    }
  }
  return highest;
}

std::vector<double> Ground::crests(std::span<const PlanSegment> pieces, double half_width,
                                   double low, double high) const {
  std::vector<double> all;
  for (const PlanSegment& piece : pieces)
    all.push_back(crest(piece.from, piece.to, half_width, low, high));
  return all;
}

void Ground::surfaces(std::span<const Eigen::Vector2d> points, double z, double reach,
                      std::span<std::optional<SurfacePoint>> out) const {
  for (size_t i = 0; i < points.size(); ++i)
    out[i] = surface(points[i].x(), points[i].y(), z, reach);
}

}  // namespace amble

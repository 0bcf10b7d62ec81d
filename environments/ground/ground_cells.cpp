#include "environments/ground/ground_cells.h"

#include <algorithm>
#include <cmath>

#include "environments/ground/ground_builder.h"
#include "environments/ground/plan_triangle.h"

namespace amble {
namespace {

bool hasGroundNear(std::span<const GroundCells::Span> spans, double height, double most) {
  bool found = false;
  eachNear(spans, height, most, [&](const GroundCells::Span& span) { found |= span.ground; });
  return found;
}

}  // namespace

GroundCells::GroundCells(const Scene& scene, const ScenePieces& pieces, const std::vector<bool>& up,
                         const GroundSettings& settings, const StopRequest& stop)
    : slope_(std::tan(settings.limits.max_slope)) {
  Eigen::AlignedBox2d extent;
  for (size_t t = 0; t < up.size(); ++t) {
    if (!up[t]) continue;
    for (const Eigen::Vector3d& corner : pieces.triangles()[t])
      extent.extend(Eigen::Vector2d(corner.head<2>()));
  }
  if (extent.isEmpty()) return;
  min_ = extent.min();
  Builder{scene, pieces, up, settings, *this, stop, extent.sizes()}.build();
}

std::span<const GroundCells::Span> GroundCells::spans(int column, int row) const {
  if (column < 0 || row < 0 || column >= count_.x() || row >= count_.y()) return {};
  const Tile& tile = tileAt(column, row);
  if (tile.plain >= 0) return {spans_.data() + tile.first, static_cast<size_t>(tile.plain)};
  const int cell = tile.first + row % kTile * kTile + column % kTile;
  return {spans_.data() + start_[cell], spans_.data() + start_[cell + 1]};
}

bool GroundCells::isPlainAround(int column, int row) const {
  const auto here = spans(column, row);
  const auto same = [](const Span& a, const Span& b) { return a.height == b.height; };
  for (int j = row - kTile; j <= row + kTile; j += kTile) {
    for (int i = column - kTile; i <= column + kTile; i += kTile) {
      if (i < 0 || j < 0 || i >= count_.x() || j >= count_.y() || tileAt(i, j).plain < 0)
        return false;
      const auto there = spans(i, j);
      if (!std::equal(here.begin(), here.end(), there.begin(), there.end(), same)) return false;
    }
  }
  return true;
}

Eigen::Vector2i GroundCells::squareAt(const Eigen::Vector2d& p) const {
  const Eigen::Array2d steps = ((p - min_) / cell_).array().floor();
  return steps.max(-1.0).min(count_.cast<double>().array()).cast<int>();
}

// Whether ground over one of the squares near p goes on as the plane through p does.
bool GroundCells::matches(const Eigen::Vector3d& p, const Eigen::Vector3d& normal) const {
  const Eigen::Vector2i at = squareAt(p.head<2>());
  for (int row = at.y() - 1; row <= at.y() + 1; ++row) {
    for (int column = at.x() - 1; column <= at.x() + 1; ++column) {
      const Eigen::Vector2d way = middle(column, row) - p.head<2>();
      const double z = p.z() - normal.head<2>().dot(way) / normal.z();
      if (hasGroundNear(spans(column, row), z, kLevel)) return true;
    }
  }
  return false;
}

// Whether the triangle is ground over one of these squares, which are of one tile.
bool GroundCells::isGroundWithin(const Triangle3& t, const Eigen::Vector2i& low,
                                 const Eigen::Vector2i& high) const {
  const auto [bottom, top] = std::minmax({t[0].z(), t[1].z(), t[2].z()});
  const bool plain = tileAt(low.x(), low.y()).plain >= 0;
  if (plain && !hasGroundNear(spans(low.x(), low.y()), 0.5 * (bottom + top),
                              0.5 * (top - bottom) + kTouching))
    return false;
  for (int row = low.y(); row <= high.y(); ++row) {
    for (int column = low.x(); column <= high.x(); ++column) {
      const Eigen::Vector2d p = middle(column, row);
      const auto z = heightOver(t, p.x(), p.y());
      if (z && hasGroundNear(spans(column, row), *z, kTouching)) return true;
    }
  }
  return false;
}

bool GroundCells::isGround(const Triangle3& t) const {
  Eigen::AlignedBox2d plan;
  for (const Eigen::Vector3d& corner : t) plan.extend(Eigen::Vector2d(corner.head<2>()));
  const Eigen::Vector2i low = squareAt(plan.min()).cwiseMax(0);
  const Eigen::Vector2i high = squareAt(plan.max()).cwiseMin(count_ - Eigen::Vector2i::Ones());
  if ((low.array() > high.array()).any()) return false;
  for (int j = low.y() / kTile; j <= high.y() / kTile; ++j) {
    for (int i = low.x() / kTile; i <= high.x() / kTile; ++i) {
      const Eigen::Vector2i first(i * kTile, j * kTile);
      const Eigen::Vector2i last = first.array() + (kTile - 1);
      if (isGroundWithin(t, low.cwiseMax(first), high.cwiseMin(last))) return true;
    }
  }
  // Small and narrow ones lie between the middles of squares.
  const Eigen::Vector3d centre = (t[0] + t[1] + t[2]) / 3.0;
  const Eigen::Vector3d normal = (t[1] - t[0]).cross(t[2] - t[0]).normalized();
  return matches(centre, normal) ||
         std::any_of(t.begin(), t.end(), [&](const Eigen::Vector3d& corner) {
           return matches(0.5 * (centre + corner), normal);
         });
}

}  // namespace amble

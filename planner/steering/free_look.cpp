#include "planner/steering/free_look.h"

#include <cmath>

#include "environments/ground/ground_cells.h"

namespace amble {
namespace {

constexpr double kSpacing = 0.1;  // of posts, and how far over the ground they begin [m]
constexpr double kSpare = 1.15;   // of their radius

}  // namespace

// With nothing to stand on over or under it.
bool FreeLook::isLevelAround(const Eigen::Vector3d& p) const {
  if (ground_.isLevel()) return true;
  const GroundCells& cells = ground_.cells();
  const Eigen::Vector2i at = cells.squareAt(p.head<2>());
  const int far = 1 + static_cast<int>(half_breadth_ / cells.cell());
  for (int row = at.y() - far; row <= at.y() + far; ++row) {
    for (int column = at.x() - far; column <= at.x() + far; ++column) {
      const auto spans = cells.spans(column, row);
      if (spans.size() != 1 || !spans.front().ground ||
          std::abs(spans.front().height - p.z()) > GroundCells::kLevel)
        return false;
    }
  }
  return true;
}

bool FreeLook::isFree(const WalkEdge& edge, CollisionScratch& scratch) const {
  const int count = static_cast<int>(edge.length / kSpacing) + 1;
  for (int i = 0; i <= count; ++i) {
    const RootPath::Sample at = edge.path.at(edge.length * i / count);
    if (std::abs(at.curvature) * synthesizer_.settings().speed > synthesizer_.maxTurnRate())
      return false;
    const Eigen::Vector3d under(at.position.x(), at.position.y(), edge.from.position.z());
    const Eigen::Vector3d foot = under + Eigen::Vector3d(0.0, 0.0, kSpacing);
    const Eigen::Vector3d head = foot + Eigen::Vector3d(0.0, 0.0, synthesizer_.stature());
    if (world_.touched(foot, head, kSpare * half_breadth_, scratch) >= 0) return false;
    if (!isLevelAround(under)) return false;
  }
  return true;
}

}  // namespace amble

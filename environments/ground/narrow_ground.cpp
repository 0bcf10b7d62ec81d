#include "environments/ground/narrow_ground.h"

#include "environments/scene/triangle_grid.h"

namespace amble {
namespace {

struct Squares {
  const Eigen::Vector2d& min;
  double cell;
  const Eigen::Vector2i& count;

  Eigen::Vector2i at(const Eigen::Vector2d& p) const {
    const Eigen::Array2d steps = ((p - min) / cell).array().floor();
    return steps.cast<int>().max(0).min(count.array() - 1);
  }
  Eigen::AlignedBox2d box(int column, int row) const {
    const Eigen::Vector2d low = min + cell * Eigen::Vector2d(column, row);
    return {low, low + Eigen::Vector2d::Constant(cell)};
  }
  bool isMiddleUnder(const Triangle3& t, int column, int row) const {
    const Eigen::Vector2d p = box(column, row).center();
    return heightOver(t, p.x(), p.y()).has_value();
  }
};

bool isUnderAny(const Triangle3& t, const Squares& squares, const Eigen::Vector2i& low,
                const Eigen::Vector2i& high) {
  for (int row = low.y(); row <= high.y(); ++row)
    for (int column = low.x(); column <= high.x(); ++column)
      if (squares.isMiddleUnder(t, column, row)) return true;
  return false;
}

}  // namespace

NarrowGround::NarrowGround(const Scene& scene, const ScenePieces& pieces,
                           const std::vector<bool>& up, const Eigen::Vector2d& min, double cell,
                           const Eigen::Vector2i& count) {
  const Squares squares{min, cell, count};
  for (size_t i = 0; i < up.size(); ++i) {
    const int object = pieces.pieceOf(static_cast<int>(i)).object;
    if (!up[i] || scene.objects[object].role != Role::kGround) continue;
    const Triangle3& t = pieces.triangles()[i];
    const Eigen::Vector3d centre = (t[0] + t[1] + t[2]) / 3.0;
    const Eigen::Vector2i there = squares.at(centre.head<2>());
    if (squares.isMiddleUnder(t, there.x(), there.y())) continue;  // as most are
    Eigen::AlignedBox2d plan;
    for (const Eigen::Vector3d& corner : t) plan.extend(Eigen::Vector2d(corner.head<2>()));
    const Eigen::Vector2i low = squares.at(plan.min()), high = squares.at(plan.max());
    if (isUnderAny(t, squares, low, high)) continue;
    for (int row = low.y(); row <= high.y(); ++row)
      for (int column = low.x(); column <= high.x(); ++column)
        if (const auto range = heightsWithin(t, squares.box(column, row)))
          heights_[{column, row}].push_back(0.5 * (range->low + range->high));
  }
}

std::span<const double> NarrowGround::over(int column, int row) const {
  const auto found = heights_.find({column, row});
  if (found == heights_.end()) return {};
  return found->second;
}

}  // namespace amble

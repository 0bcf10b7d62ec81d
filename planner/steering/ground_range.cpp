#include "planner/steering/ground_range.h"

#include <algorithm>
#include <cmath>

#include "environments/ground/ground_cells.h"

namespace amble {
namespace {

using Ranges = std::vector<Eigen::AlignedBox1d>;

// Of each so many before and after it, `stride` apart in a line of `count`.
void widen(Ranges& all, size_t first, size_t stride, int count, int far) {
  Ranges line(count);
  for (int i = 0; i < count; ++i) {
    for (int k = std::max(0, i - far); k <= std::min(count - 1, i + far); ++k)
      line[i].extend(all[first + k * stride]);
  }
  for (int i = 0; i < count; ++i) all[first + i * stride] = line[i];
}

}  // namespace

GroundRange::GroundRange(const SceneGround& ground, const ReachedGround& reached, double far)
    : cells_(ground.cells()), is_level_(ground.isLevel()), level_(ground.heights()) {
  if (is_level_ || cells_.layers() != 1) return;
  const int columns = cells_.columns(), rows = cells_.rows();
  ranges_ = reached.heights();
  const int squares = 1 + static_cast<int>(std::ceil(far / cells_.cell()));
  for (int row = 0; row < rows; ++row)
    widen(ranges_, static_cast<size_t>(row) * columns, 1, columns, squares);
  for (int column = 0; column < columns; ++column) widen(ranges_, column, columns, rows, squares);
}

Eigen::AlignedBox1d GroundRange::around(const Eigen::Vector2d& p) const {
  if (is_level_) return level_;
  const Eigen::Vector2i at = cells_.squareAt(p);
  if (ranges_.empty() || at.x() < 0 || at.y() < 0 || at.x() >= cells_.columns() ||
      at.y() >= cells_.rows())
    return {};
  return ranges_[static_cast<size_t>(at.y()) * cells_.columns() + at.x()];
}

}  // namespace amble

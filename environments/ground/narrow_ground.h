/// What is said to be ground and lies between the middles of the squares of GroundCells: planks and
/// beams that are narrower than a square.
#pragma once

#include <Eigen/Core>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "environments/scene/scene_pieces.h"

namespace amble {

class NarrowGround {
 public:
  /// @param up  as for GroundCells; @param min, cell, count  of the squares: where they begin [m],
  /// their side [m, > 0], and how many there are each way
  NarrowGround(const Scene& scene, const ScenePieces& pieces, const std::vector<bool>& up,
               const Eigen::Vector2d& min, double cell, const Eigen::Vector2i& count);

  /// Heights of it over a square, of each of its triangles there the middle one [m, World].
  std::span<const double> over(int column, int row) const;

 private:
  std::map<std::pair<int, int>, std::vector<double>> heights_;  // by column and row
};

}  // namespace amble

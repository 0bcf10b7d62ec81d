/// What lies over small squares of the plane, for feet: answers where all is level without a look
/// at triangles, and elsewhere which few of them to look at.
///
/// Over a patch whose ground is known for certain to be level surfaces alone, each over all of it,
/// the ground at any of its points is one of their heights: what SceneGround finds among the
/// triangles there, to the bit, since a level triangle's height over a point is its corners'. And
/// each patch knows what has its highest point over a part of it, and between which heights that
/// lies: all else is no crest there. Where a patch is not level, or not known yet, the answer is
/// "ask the triangles"; so all answers are those of the triangles, whether patches are there or
/// not.
///
/// "Over all of it" is certain where one level triangle holds the patch's four corners, or two that
/// share a side do and both hold the ends of what of that side is in the patch: what a triangle
/// holds is convex. "Alone" is certain where every other triangle that heightOver() may find over a
/// point of the patch lies level at one of those heights.
///
/// Patches are 5 cm, in tiles that are made when they have been asked for often enough to be worth
/// it: a long walk over a hall costs nothing here, a hundred trials on one stair little.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "environments/scene/triangle_grid.h"

namespace amble {

struct PlanStrip;  // plan_strip.h

/// Const: threads share it.
class GroundPatches {
 public:
  static constexpr double kPatch = 0.05;  ///< side of a patch; more in scenes of over 800 m [m]
  /// Of what stands upright, but for rounding, the normal rises by less [1].
  static constexpr double kUpright = 1e-6;
  /// So often a tile is asked for before it is made, which costs as much as so many points that are
  /// looked for among triangles.
  static constexpr int kAskedBefore = 128;

  /// @pre both outlive it, `ground` has triangles of `all` only
  GroundPatches(const TriangleGrid& ground, const TriangleGrid& all);
  ~GroundPatches();

  /// Heights of the ground, lowest first, at every point of the patch in which (x, y) lies; none
  /// where the triangles must be asked [m, World]. Empty: there is no ground.
  std::optional<std::span<const double>> levelsAt(double x, double y) const;
  /// Of levelsAt() the highest that is no farther than `reach` from z, where that is the same all
  /// over a box; none where it is not or must be asked of the triangles [m, World].
  std::optional<double> levelOver(const Eigen::AlignedBox2d& box, double z, double reach) const;
  /// The triangles that may have the highest point of what of them is over a part of this box of
  /// the plane between the two heights [m], each once; of what stands upright only what ends there
  /// as a whole. None where all triangles must be asked.
  std::optional<std::vector<int>> endingOver(const Eigen::AlignedBox2d& box, double low,
                                             double high) const;
  /// The same over a strip; fewer of those that are beside it.
  std::optional<std::vector<int>> endingOver(const PlanStrip& strip, double low, double high) const;
  /// Shows those triangles, some more than once, until one is the one that is looked for: whether
  /// one is. None where all triangles must be asked.
  std::optional<bool> anyEnding(const PlanStrip& strip, double low, double high,
                                const std::function<bool(int)>& is_it) const;

 private:
  static constexpr int kTile = 16;  // patches along a side of a tile
  // Of what ends farther above the highest ground of a tile, or below its lowest, tiles keep
  // nothing: feet do not go there [m].
  static constexpr double kKeptAbove = 0.8, kKeptBelow = 0.5;
  static constexpr double kMostTiles = 1000;  // along a side
  struct Tile;
  class Maker;
  struct Slot {
    std::atomic<int> asked{0};
    std::atomic<const Tile*> tile{nullptr};
  };

  const Tile* tileOf(int column, int row) const {
    const Slot& slot = slots_[static_cast<size_t>(row / kTile) * tiles_of_.x() + column / kTile];
    const Tile* made = slot.tile.load(std::memory_order_acquire);
    return made != nullptr ? made : makeTile(column / kTile, row / kTile);
  }
  const Tile* makeTile(int i, int j) const;
  static bool isLevelWithin(const Tile& tile, const Eigen::Vector2i& first,
                            const Eigen::Vector2i& last, double z, double reach,
                            std::optional<double>& level);
  template <typename Visit>
  bool visitPatches(const Eigen::AlignedBox2d& box, Visit visit_row) const;
  template <typename Visit>
  std::optional<bool> visitEnds(const Eigen::AlignedBox2d& box, const PlanStrip* strip, double low,
                                double high, Visit visit_one) const;
  // Perhaps outside, by one; what is no number is.
  int patchAt(double value, int axis) const {
    const double patches = (value - min_[axis]) * per_metre_;
    if (!(patches >= 0.0)) return -1;
    return static_cast<int>(std::min(patches, static_cast<double>(tiles_of_[axis] * kTile)));
  }
  Eigen::AlignedBox2d patchBox(int column, int row) const;

  const TriangleGrid* ground_;
  const TriangleGrid* all_;
  Eigen::Vector2d min_{0, 0};
  double patch_ = kPatch, per_metre_ = 1.0 / kPatch;
  Eigen::Vector2i tiles_of_{0, 0};  // along x and y
  std::unique_ptr<Slot[]> slots_;   // x fastest
};

}  // namespace amble

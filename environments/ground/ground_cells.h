/// Which surfaces of a scene are ground: no steeper than the character climbs, with room for a foot
/// and for who stands on it, and reached by steps no higher than it takes (DESIGN.md, section 5,
/// `auto`).
///
/// Asked at the middles of a grid of squares, layer by layer as a heightfield of spans (after
/// Haumont, Debunne and Sillion 2003 and Recast): at each height a surface that faces up, what is
/// free above it, and whether a foot has room there by some heading. Surfaces that have both are
/// joined where a step leads from one to the other. What hangs together is ground if it is large,
/// said to be, or, where there is no other, stood on by the problem; and so is all that goes on
/// level from it, below tables and in corners where nobody stands.
///
/// Squares are 0.1 m, whatever the size of the scene, and less for who is below 1.4 m tall: 1.3
/// breadths of a foot. What is narrower than a square may lie between their middles: then it is
/// ground where it is said to be, and none where that is to be found out. They lie in tiles of 16
/// by 16, and a tile over which there are level surfaces only, each over all of it and a foot's
/// length beyond, is kept as one square: what is found at one of its squares is found at all. So a
/// floor of 400 m costs what its edges do. Only where more than kMostSquares are left, or
/// kMostSurfaces over them (a hundred shells in one another), do they grow.
#pragma once

#include <span>
#include <vector>

#include "base/stop_request.h"
#include "environments/ground/ground_settings.h"
#include "environments/scene/scene_pieces.h"

namespace amble {

class GroundCells {
 public:
  static constexpr double kLevel = kOneLevel;
  /// What hangs together and is smaller is furniture: larger than tables and beds, smaller than
  /// rooms [m^2].
  static constexpr double kFloorArea = 4.0;

  /// A surface over the middle of a square.
  struct Span {
    double height = 0.0;     ///< [m, World]
    bool standable = false;  ///< room for a foot, and for who stands there
    bool ground = false;
    int part = -1;   ///< of what steps join; the first span of it. -1: not standable
    int floor = -1;  ///< of ground: its part, or that from which it goes on level; -1: none
    int both = -1;   ///< the same as floor, of what steps lead to and back from alone
  };

  /// @param up  of each triangle whether it faces up, is flat enough and of an `auto` or `ground`
  /// object
  GroundCells(const Scene& scene, const ScenePieces& pieces, const std::vector<bool>& up,
              const GroundSettings& settings, const StopRequest& stop = {});

  double cell() const { return cell_; }  ///< side of a square [m]
  int columns() const { return count_.x(); }
  int rows() const { return count_.y(); }
  Eigen::Vector2d middle(int column, int row) const {
    return min_ + cell_ * Eigen::Vector2d(column + 0.5, row + 0.5);
  }
  /// Lowest first; none outside.
  std::span<const Span> spans(int column, int row) const;
  /// Whether the squares around this one, for a tile's width at least, have its spans too.
  bool isPlainAround(int column, int row) const;
  /// The square that a point lies in, perhaps outside.
  Eigen::Vector2i squareAt(const Eigen::Vector2d& p) const;
  /// Most surfaces over one square that are ground and can be stood on.
  int layers() const { return layers_; }
  /// Ground that steps join to this part, seen from above: of floors over one another the lowest
  /// counts, so that a roof is less than the room below it [m^2].
  double area(int part) const { return part < 0 ? 0.0 : cell_ * cell_ * counts_[part]; }

  /// Whether the triangle is part of a surface that is ground.
  bool isGround(const Triangle3& t) const;

 private:
  struct Builder;
  static constexpr double kCell = 0.1;        // at most [m]
  static constexpr double kCellOfFoot = 1.3;  // and so many breadths of a foot
  static constexpr int kTile = 16;            // squares along a side of a tile
  // Beside plain tiles: 200 m of uneven ground; and what lies over them, of about 80 bytes each
  // while they are made.
  static constexpr long long kMostSquares = 4000000;
  static constexpr double kMostSurfaces = 8e6;

  // Its squares' spans: of a plain tile those from `first` on; else the squares' begins are in
  // start_, from `first` on, and the end.
  struct Tile {
    int first = 0;
    int plain = -1;  // spans of each square; -1: squares differ
  };

  const Tile& tileAt(int column, int row) const {
    return tiles_[static_cast<size_t>(row / kTile) * tile_count_.x() + column / kTile];
  }
  bool matches(const Eigen::Vector3d& p, const Eigen::Vector3d& normal) const;
  bool isGroundWithin(const Triangle3& t, const Eigen::Vector2i& low,
                      const Eigen::Vector2i& high) const;

  Eigen::Vector2d min_{0, 0};
  Eigen::Vector2i count_{0, 0}, tile_count_{0, 0};
  double cell_ = kCell, slope_ = 0.0;  // slope_: tangent of the steepest
  int layers_ = 0;
  std::vector<Tile> tiles_;  // x fastest
  std::vector<int> start_;
  std::vector<Span> spans_;
  std::vector<long long> counts_;  // of each span that is a part's first: squares of the part
};

}  // namespace amble

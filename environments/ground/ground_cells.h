/// Which surfaces of a scene are ground: no steeper than the character climbs, with room for a foot
/// and for who stands on it, and reached by steps no higher than it takes (DESIGN.md, section 5,
/// `auto`).
///
/// Asked at the middles of a grid of squares, layer by layer as a heightfield of spans (after
/// Haumont, Debunne and Sillion 2003 and Recast): at each height a surface that faces up, what is
/// free above it, and whether a foot has room there by some heading. Surfaces that have both are
/// joined where a step leads from one to the other. What hangs together is ground if it is large,
/// said to be, or stood on by the problem; and so is all that goes on level from it, below tables
/// and in corners where nobody stands. Squares are 0.1 m; in scenes of more than 100 m they grow,
/// and treads may slip through: say `role: ground` there.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "environments/scene/scene_pieces.h"

namespace amble {

/// What a character can stand on, and what of a scene is asked for.
struct GroundSettings {
  double max_slope = 0.3490658503988659;  ///< steepest ground: 20 degrees [rad, 0 to pi/4]
  double max_climb = 0.25;                ///< highest step up [m, 0 to 1]
  double max_drop = 0.25;                 ///< highest step down [m, 0 to 1]
  double headroom = 1.0;      ///< free height without which nobody walks, not even stooped [m, > 0]
  double foot_length = 0.25;  ///< [m, > 0]
  double foot_breadth = 0.09;  ///< [m, > 0]
  /// Ground is what is at this height, too, however small [m]...
  std::optional<double> level;
  /// ...and what is at these places, where nothing large is [m].
  std::vector<Eigen::Vector2d> places;
};

class GroundCells {
 public:
  /// How far two surfaces may be apart and still be one level: rugs and thresholds [m].
  static constexpr double kLevel = 0.03;
  /// What hangs together and is smaller is furniture: larger than tables and beds, smaller than
  /// rooms [m^2].
  static constexpr double kFloorArea = 4.0;

  /// A surface over the middle of a square.
  struct Span {
    double height = 0.0;     ///< [m, World]
    bool standable = false;  ///< room for a foot, and for who stands there
    bool ground = false;
    int part = -1;  ///< of what steps join; the lowest span of it. -1: not standable
  };

  /// @param up  of each triangle whether it faces up, is flat enough and of an `auto` or `ground`
  /// object
  GroundCells(const Scene& scene, const ScenePieces& pieces, const TriangleGrid& all,
              const std::vector<bool>& up, const GroundSettings& settings);

  double cell() const { return cell_; }  ///< side of a square [m]
  int columns() const { return count_.x(); }
  int rows() const { return count_.y(); }
  Eigen::Vector2d middle(int column, int row) const {
    return min_ + cell_ * Eigen::Vector2d(column + 0.5, row + 0.5);
  }
  /// Lowest first; none outside.
  std::span<const Span> spans(int column, int row) const;
  /// The square that a point lies in, perhaps outside.
  Eigen::Vector2i squareAt(const Eigen::Vector2d& p) const;
  /// Most surfaces that are ground over one square.
  int layers() const { return layers_; }

  /// Whether the triangle is part of a surface that is ground.
  bool isGround(const Triangle3& t) const;

 private:
  struct Builder;
  static constexpr double kCell = 0.1;          // [m]
  static constexpr double kMostCells = 1000.0;  // along a side

  bool matches(const Eigen::Vector3d& p, const Eigen::Vector3d& normal) const;

  Eigen::Vector2d min_{0, 0};
  Eigen::Vector2i count_{0, 0};
  double cell_ = kCell, slope_ = 0.0;  // slope_: tangent of the steepest
  int layers_ = 0;
  std::vector<int> start_;  // of each square in spans_, and the end; x fastest
  std::vector<Span> spans_;
};

}  // namespace amble

/// The ground as a thing to touch: a layer of its own, apart from the obstacles, since feet are
/// always near it.
///
/// A capsule is free of it if it neither touches its surfaces nor lies inside or under them. What
/// is allowed to sink in is lifted by that depth first. Most questions are answered by heights: in
/// each square of a grid the layer fills a few spans of height, and a box outside them is free.
/// Near the ground planes are looked for that part a capsule, or all that it sweeps between two
/// places, from each triangle near it; where none is found for one, the exact
/// check answers (ObstacleSet).
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "environments/body/capsule.h"
#include "environments/collision/obstacle_set.h"
#include "environments/scene/parity.h"
#include "environments/scene/triangle_grid.h"

namespace amble {

class GroundLayer {
 public:
  /// @param surfaces  of ground objects, with what lies below their ground: risers, edges,
  /// undersides; meshes in World, and their closed pieces as `solid`
  /// @throws Stopped if that is asked for.
  explicit GroundLayer(std::vector<Obstacle> surfaces, const StopRequest& stop = {},
                       Checker checker = Checker::kFast);

  /// The object that the capsule touches, or lies inside or under, when it is lifted by `depth` [m,
  /// >= 0]; -1 for none.
  int touched(const Capsule& capsule, double depth, ObstacleSet::Scratch& scratch) const;

  /// True only if the capsule, lifted by `depth` [m, >= 0], is higher than all ground near it;
  /// false says nothing.
  bool isAbove(const Capsule& capsule, double depth) const;

  /// The same, or that its bounds lie beside all heights that the layer fills in each square below
  /// or above them: nearer to uneven ground, at some times the cost.
  bool isFree(const Capsule& capsule, double depth) const;

  /// True only if nothing between the places a and b of a capsule touches the ground, lifted by
  /// `depth`, each point leaving its straight way by no more than `bend` [m, >= 0]; false says
  /// nothing.
  /// @pre it is not inside or under the ground at a.
  bool isClearBetween(const Capsule& a, const Capsule& b, double depth, double bend) const;

 private:
  // [m]; larger for scenes beyond kMostCells along a side, or kMostEntries surfaces over them: 24
  // bytes each while spans are made of them
  static constexpr double kCell = 0.1;
  static constexpr int kMostCells = 1000;
  static constexpr double kMostEntries = 4e6;
  static constexpr int kNearCells = 3;  // a thigh's half length in cells of the usual size
  struct Span {
    double low, high;
  };
  struct Solid {
    int object;
    Parity test;
  };
  struct Entry {
    int cell;
    int solid;  // in solids_
    Span span;
  };

  struct Face {
    Triangle3 corners;
    int solid;  // in solids_
  };
  // Cells of some rows: start of each one's spans, which are lowest first.
  struct Strip {
    std::vector<int> start;
    std::vector<Span> spans;
  };
  static constexpr int kStripRows = 16;

  // A triangle between planes across the axes and across its normal [m].
  struct Slab {
    Eigen::Vector3d min, max, normal;  // normal: unit
    double low, high;

    explicit Slab(const Triangle3& t);
  };
  struct Sweep;

  void fillSpans(const std::vector<Obstacle>& surfaces, const StopRequest& stop);
  std::vector<std::vector<Face>> facesByStrip(const std::vector<Obstacle>& surfaces,
                                              int strips) const;
  Strip fillStrip(const std::vector<Face>& faces, int first_row, int last_row) const;
  void collect(const Triangle3& t, int solid, int first_row, int last_row,
               std::vector<Entry>& entries) const;
  std::pair<int, int> columnsOf(const Triangle3& t, int row, int low, int high) const;
  void fillCell(std::span<const Entry> entries, std::vector<Span>& spans) const;
  void fillNearTops();
  Eigen::Vector2i cellOf(const Eigen::Vector2d& p) const;
  bool meetsSpan(const Eigen::AlignedBox3d& box) const;
  bool isAboveCell(const Eigen::Vector3d& p) const;
  int aboveOf(const Eigen::Vector3d& p) const;

  ObstacleSet surfaces_;
  TriangleGrid grid_;
  std::vector<Slab> slabs_;    // of the grid's triangles
  std::vector<int> objects_;   // of the grid's triangles
  std::vector<Solid> solids_;  // of each surface, empty where nothing of it is closed
  Eigen::AlignedBox2d extent_;
  double cell_ = kCell;
  Eigen::Vector2i count_{0, 0};
  std::vector<int> start_;   // of each cell in spans_, and the end; x fastest
  std::vector<Span> spans_;  // lowest first, without overlap
  // By cell: the top of all spans no more than kNearCells from it along either axis [m].
  std::vector<double> near_top_;
  double top_ = -HUGE_VAL;  // of all spans [m]
};

}  // namespace amble

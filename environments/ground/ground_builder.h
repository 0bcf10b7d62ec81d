/// How GroundCells are made: tiles, what lies over their squares, what of it steps join, and which
/// of that is ground.
///
/// On all threads where parts do not depend on one another: rows of tiles are filled, and what is
/// over them joined, each by itself; the steps between them follow. The cells are the same for any
/// number of threads.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "base/union_find.h"
#include "environments/ground/ground_cells.h"
#include "environments/ground/ground_column.h"
#include "environments/ground/narrow_ground.h"

namespace amble {

/// Calls visit_one(span) for those that are no farther up or down from a height than `most`.
template <typename Visit>
void eachNear(std::span<const GroundCells::Span> spans, double height, double most,
              Visit visit_one) {
  const double from = height - most - kTouching, to = height + most + kTouching;  // and rounding
  auto next = std::ranges::lower_bound(spans, from, {}, &GroundCells::Span::height);
  for (; next != spans.end() && next->height <= to; ++next)
    if (std::abs(next->height - height) <= most) visit_one(*next);
}

/// A struct whose functions are the stages, in build().
struct GroundCells::Builder {
  const Scene& scene;
  const ScenePieces& pieces;
  const std::vector<bool>& up;
  const GroundSettings& settings;
  GroundCells& cells;
  const StopRequest& stop;
  Eigen::Vector2d extent;  // of what could be ground [m]
  const TriangleGrid& all = pieces.grid;
  std::vector<bool> said = {};  // of each span: of an object that is said to be ground
  std::optional<NarrowGround> narrow = {};

  // What a row of tiles holds, by numbers within it.
  struct Filled {
    std::vector<Span> spans;
    std::vector<bool> said;
    std::vector<int> start;
  };

  using Open = std::vector<std::pair<int, Eigen::Vector2i>>;  // spans, squares

  void build();
  void makeTiles();
  bool isPlain(int i, int j) const;
  double surfacesOf(int i, int j) const;
  void fillTiles();
  void fillTile(int i, int j, GroundColumn& over, Filled& filled) const;
  void addSpans(int column, int row, GroundColumn& over, Filled& filled) const;
  static void addNarrow(double height, size_t first, Filled& filled);
  void append(const Filled& filled, int j);
  void joinSteps(double step, int Span::*part);
  double stepBothWays() const;
  bool isAsked(int column, int row) const;
  template <typename Visit>
  void eachSpan(Visit visit_one) const;
  template <typename Visit>
  void eachSpan(int begin, int end, Visit visit_one) const;
  void join(int span, const Eigen::Vector2i& other, double step, UnionFind& parts) const;
  template <typename Visit>
  void eachNeighbour(int span, const Eigen::Vector2i& other, double most, Visit visit_one) const;
  void choose();
  bool choosePlaces();
  bool hasGroundOfNoFloor() const;
  void goOn();
  void addOpen(int span, const Eigen::Vector2i& square, Open& open) const;
  template <typename Visit>
  void eachColumn(Visit visit_one) const;
  void measure();
};

}  // namespace amble

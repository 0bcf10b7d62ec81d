#include "environments/ground/ground_builder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>

#include "animation/steps/unevenness.h"
#include "base/parallel.h"
#include "environments/ground/plan_triangle.h"

namespace amble {
namespace {

// Steps bridge so many squares [cells]: gaps between treads, not strides.
constexpr int kStepReach = 3;

}  // namespace

void GroundCells::Builder::addSpans(int column, int row, GroundColumn& over, Filled& filled) const {
  const size_t first = filled.spans.size();
  for (const GroundColumn::Surface& surface : over.surfacesAt(cells.middle(column, row))) {
    filled.spans.push_back({surface.height, surface.standable});
    filled.said.push_back(surface.said);
  }
  for (const double height : narrow->over(column, row)) addNarrow(height, first, filled);
}

// To the spans from `first` on, unless one of them has that level.
void GroundCells::Builder::addNarrow(double height, size_t first, Filled& filled) {
  const auto begin = filled.spans.begin() + static_cast<std::ptrdiff_t>(first);
  const auto above = std::ranges::lower_bound(begin, filled.spans.end(), height, {}, &Span::height);
  if (above != filled.spans.end() && above->height - height <= kLevel) return;
  if (above != begin && height - std::prev(above)->height <= kLevel) return;
  filled.said.insert(filled.said.begin() + (above - filled.spans.begin()), true);
  filled.spans.insert(above, {height});
}

// Whether the square has neighbours that others of its tile do not stand for. In a plain tile those
// near a side have, where what lies there is no plain tile; else the middle of the side has them.
bool GroundCells::Builder::isAsked(int column, int row) const {
  if (cells.tileAt(column, row).plain < 0) return true;
  const Eigen::Vector2i square(column, row);
  for (int axis = 0; axis < 2; ++axis) {
    const int along = square[axis] % kTile, aside = square[1 - axis] % kTile;
    for (const int way : {-1, 1}) {
      const int off = way < 0 ? along : kTile - 1 - along;  // from that side of the tile
      if (off >= kStepReach) continue;
      Eigen::Vector2i other = square;
      other[axis] += way * kTile;
      const bool outside =
          (other.array() < 0).any() || (other.array() >= cells.count_.array()).any();
      if (outside || cells.tileAt(other.x(), other.y()).plain < 0 ||
          (off == 0 && aside == kTile / 2))
        return true;
    }
  }
  return false;
}

// Calls visit_one(span, square) for every span, of plain tiles at the squares that are asked only.
template <typename Visit>
void GroundCells::Builder::eachSpan(Visit visit_one) const {
  eachSpan(0, cells.count_.y(), visit_one);
}

// The same of the rows from `begin` to before `end`.
template <typename Visit>
void GroundCells::Builder::eachSpan(int begin, int end, Visit visit_one) const {
  for (int row = begin; row < end; ++row) {
    for (int column = 0; column < cells.count_.x(); ++column) {
      if (!isAsked(column, row)) continue;
      const auto here = cells.spans(column, row);
      const int first = static_cast<int>(here.data() - cells.spans_.data());
      for (int k = 0; k < static_cast<int>(here.size()); ++k)
        visit_one(first + k, Eigen::Vector2i(column, row));
    }
  }
}

// Calls visit_one(other) for the spans over another square that are no farther up or down than
// `most`.
template <typename Visit>
void GroundCells::Builder::eachNeighbour(int span, const Eigen::Vector2i& other, double most,
                                         Visit visit_one) const {
  eachNear(cells.spans(other.x(), other.y()), cells.spans_[span].height, most,
           [&](const Span& near) { visit_one(static_cast<int>(&near - cells.spans_.data())); });
}

// A span with those over another square to which a step no higher than that leads.
void GroundCells::Builder::join(int span, const Eigen::Vector2i& other, double step,
                                UnionFind& parts) const {
  eachNeighbour(span, other, step, [&](int near) {
    if (cells.spans_[near].standable) parts.join(span, near);
  });
}

// Rows of tiles have spans of their own: threads join those of some rows of them each, and then
// what is left are steps from the last squares of these to those beyond. The least span of a part
// does not depend on the order.
void GroundCells::Builder::joinSteps(double step, int Span::*part) {
  UnionFind parts(static_cast<int>(cells.spans_.size()));
  const int rows = cells.count_.y(), blocks = std::min(usualThreads(), cells.tile_count_.y());
  const auto rowOf = [&](int block) {
    return std::min(rows, kTile * static_cast<int>(static_cast<long long>(cells.tile_count_.y()) *
                                                   block / blocks));
  };
  parallelFor(blocks, blocks, [&](int block, int) {
    const int end = rowOf(block + 1);
    eachSpan(rowOf(block), end, [&](int span, const Eigen::Vector2i& square) {
      if (!cells.spans_[span].standable) return;
      for (int far = 1; far <= kStepReach; ++far) {
        join(span, square + Eigen::Vector2i(far, 0), step, parts);
        if (square.y() + far < end) join(span, square + Eigen::Vector2i(0, far), step, parts);
      }
    });
  });
  for (int block = 1; block < blocks; ++block) {
    const int end = rowOf(block);
    eachSpan(std::max(0, end - kStepReach), end, [&](int span, const Eigen::Vector2i& square) {
      if (!cells.spans_[span].standable) return;
      for (int far = end - square.y(); far <= kStepReach; ++far)
        join(span, square + Eigen::Vector2i(0, far), step, parts);
    });
  }
  for (int span = 0; span < parts.size(); ++span)
    if (cells.spans_[span].standable) cells.spans_[span].*part = parts.find(span);
}

// The highest step that is taken both up and down, or is there on a slope.
double GroundCells::Builder::stepBothWays() const {
  return std::max({std::min(settings.limits.max_climb, settings.limits.max_drop), kLevel,
                   Unevenness::kNatural, cells.slope_ * cells.cell_});
}

// Parts that are ground: large, or said to be.
void GroundCells::Builder::choose() {
  std::vector<long long> size(cells.spans_.size(), 0);
  eachColumn([&](int begin, int end, int squares) {
    for (int k = begin; k < end; ++k)
      if (cells.spans_[k].part >= 0) size[cells.spans_[k].part] += squares;
  });
  std::vector<bool> chosen(cells.spans_.size(), false);
  for (size_t i = 0; i < cells.spans_.size(); ++i) {
    Span& span = cells.spans_[i];
    const bool at_level = settings.level && std::abs(span.height - *settings.level) <= kLevel;
    const auto area = [&] {
      return static_cast<double>(size[span.part]) * cells.cell_ * cells.cell_;
    };
    if (span.part >= 0 && (area() >= kFloorArea || said[i] || at_level)) chosen[span.part] = true;
    span.ground = said[i] || at_level;
  }
  for (Span& span : cells.spans_)
    span.ground = span.ground || (span.part >= 0 && chosen[span.part]);
}

// What places name is ground, and where none is and none is named whatever can be stood on.
// @return whether there are such
bool GroundCells::Builder::choosePlaces() {
  std::vector<bool> chosen(cells.spans_.size(), false);
  bool any = false;
  for (const GroundPlace& place : settings.places) {
    const Eigen::Vector2i at = cells.squareAt(place.at);
    const auto here = cells.spans(at.x(), at.y());
    const auto off = [&](const Span& span) {
      return place.z ? std::abs(span.height - *place.z) : 0.0;
    };
    const auto is_ground = [&](const Span& span) {
      return span.ground && off(span) <= kFloorReach;
    };
    if (std::any_of(here.begin(), here.end(), is_ground)) continue;
    for (const Span& span : here)
      if (span.part >= 0 && off(span) <= kFloorReach) any = chosen[span.part] = true;
  }
  if (!any) return false;
  for (Span& span : cells.spans_)
    span.ground = span.ground || (span.part >= 0 && chosen[span.part]);
  return true;
}

bool GroundCells::Builder::hasGroundOfNoFloor() const {
  return std::ranges::any_of(cells.spans_,
                             [](const Span& span) { return span.ground && span.floor < 0; });
}

// Ground goes on level where nobody stands.
void GroundCells::Builder::goOn() {
  Open open;
  eachSpan([&](int i, const Eigen::Vector2i& square) {
    Span& span = cells.spans_[i];
    if (!span.ground) return;
    if (span.floor < 0) span.floor = span.part;
    open.emplace_back(i, square);
  });
  const double most = std::max(kLevel, cells.slope_ * cells.cell_);
  for (size_t next = 0; next < open.size(); ++next) {
    const auto [from, square] = open[next];
    for (const Eigen::Vector2i& way : {Eigen::Vector2i(1, 0), Eigen::Vector2i(-1, 0),
                                       Eigen::Vector2i(0, 1), Eigen::Vector2i(0, -1)}) {
      eachNeighbour(from, square + way, most, [&, here = square](int other) {
        Span& span = cells.spans_[other];
        if (span.floor < 0) span.floor = cells.spans_[from].floor;
        if (span.both < 0) span.both = cells.spans_[from].both;
        if (!std::exchange(span.ground, true)) addOpen(other, here + way, open);
      });
    }
  }
}

// Squares from which ground goes on: of a plain tile those of its border.
void GroundCells::Builder::addOpen(int span, const Eigen::Vector2i& square, Open& open) const {
  if (cells.tileAt(square.x(), square.y()).plain < 0) {
    open.emplace_back(span, square);
    return;
  }
  const Eigen::Vector2i corner = square / kTile * kTile;
  for (int k = 0; k < kTile; ++k) {
    for (const Eigen::Vector2i& at : {Eigen::Vector2i(k, 0), Eigen::Vector2i(k, kTile - 1),
                                      Eigen::Vector2i(0, k), Eigen::Vector2i(kTile - 1, k)})
      if (isAsked(corner.x() + at.x(), corner.y() + at.y())) open.emplace_back(span, corner + at);
  }
}

// Calls visit_one(spans, squares) for each square, a plain tile's all at once.
template <typename Visit>
void GroundCells::Builder::eachColumn(Visit visit_one) const {
  for (const Tile& tile : cells.tiles_) {
    if (tile.plain >= 0) {
      visit_one(tile.first, tile.first + tile.plain, kTile * kTile);
      continue;
    }
    for (int k = tile.first; k < tile.first + kTile * kTile; ++k)
      visit_one(cells.start_[k], cells.start_[k + 1], 1);
  }
}

void GroundCells::Builder::measure() {
  cells.counts_.assign(cells.spans_.size(), 0);
  eachColumn([&](int begin, int end, int squares) {
    int layers = 0;
    for (int k = begin; k < end; ++k) {
      const Span& span = cells.spans_[k];
      if (!span.ground || !span.standable) continue;
      if (layers++ == 0) cells.counts_[span.part] += squares;
    }
    cells.layers_ = std::max(cells.layers_, layers);
  });
}

// Whether over a tile, and a foot's length beyond, there are level surfaces only, each over all of
// it.
bool GroundCells::Builder::isPlain(int i, int j) const {
  const double side = kTile * cells.cell_;
  const Eigen::Vector2d low = cells.min_ + side * Eigen::Vector2d(i, j);
  const Eigen::Vector2d reach = Eigen::Vector2d::Constant(
      0.5 * std::max(settings.foot_length, settings.foot_breadth) + 2.0 * kSeam);
  const Eigen::AlignedBox2d box(low - reach, low + Eigen::Vector2d::Constant(side) + reach);
  std::vector<int> near;
  bool all_level = true;
  all.visitBox(box, [&](int t) {
    if (!all_level) return;
    const Triangle3& corners = all.triangles()[t];
    if (isLevel(corners))
      near.push_back(t);
    else if (heightsWithin(corners, box))
      all_level = false;
  });
  if (!all_level) return false;
  std::sort(near.begin(), near.end());
  near.erase(std::unique(near.begin(), near.end()), near.end());
  std::map<std::tuple<int, double, bool>, double> areas;  // of piece, height, facing [m^2]
  for (const int t : near) {
    const Triangle3& corners = all.triangles()[t];
    const double area = areaWithin(corners, box);
    if (area > 0.0) areas[{pieces.piece_of[t], corners[0].z(), upwardness(corners) > 0.0}] += area;
  }
  constexpr double kRounding = 1e-6;  // of the area
  return std::all_of(areas.begin(), areas.end(), [&](const auto& entry) {
    return std::abs(entry.second - box.volume()) <= kRounding * box.volume();
  });
}

// Surfaces over all squares of a tile, by four of them.
double GroundCells::Builder::surfacesOf(int i, int j) const {
  const Eigen::Vector2i first(i * kTile, j * kTile);
  const Eigen::Vector2i size = (cells.count_ - first).cwiseMin(kTile);
  const double share = 0.25 * size.x() * size.y();
  double surfaces = 0.0;
  for (const int x : {size.x() / 4, 3 * size.x() / 4}) {
    for (const int y : {size.y() / 4, 3 * size.y() / 4}) {
      const Eigen::Vector2d p = cells.middle(first.x() + x, first.y() + y);
      all.visitAt(p.x(), p.y(), [&](int t) {
        if (heightOver(all.triangles()[t], p.x(), p.y())) surfaces += share;
      });
    }
  }
  return surfaces;
}

void GroundCells::Builder::fillTile(int i, int j, GroundColumn& over, Filled& filled) const {
  Tile& tile = cells.tiles_[static_cast<size_t>(j) * cells.tile_count_.x() + i];
  if (tile.plain >= 0) {
    tile.first = static_cast<int>(filled.spans.size());
    addSpans(i * kTile, j * kTile, over, filled);
    tile.plain = static_cast<int>(filled.spans.size()) - tile.first;
    return;
  }
  tile.first = static_cast<int>(filled.start.size());
  for (int k = 0; k < kTile * kTile; ++k) {
    filled.start.push_back(static_cast<int>(filled.spans.size()));
    const int column = i * kTile + k % kTile, row = j * kTile + k / kTile;
    if (column < cells.count_.x() && row < cells.count_.y()) addSpans(column, row, over, filled);
  }
  filled.start.push_back(static_cast<int>(filled.spans.size()));
}

void GroundCells::Builder::append(const Filled& filled, int j) {
  const int spans = static_cast<int>(cells.spans_.size());
  const int starts = static_cast<int>(cells.start_.size());
  for (int i = 0; i < cells.tile_count_.x(); ++i) {
    Tile& tile = cells.tiles_[static_cast<size_t>(j) * cells.tile_count_.x() + i];
    tile.first += tile.plain >= 0 ? spans : starts;
  }
  cells.spans_.insert(cells.spans_.end(), filled.spans.begin(), filled.spans.end());
  said.insert(said.end(), filled.said.begin(), filled.said.end());
  for (const int start : filled.start) cells.start_.push_back(spans + start);
}

// Rows of tiles are filled apart from one another and put together in their order.
void GroundCells::Builder::fillTiles() {
  std::vector<Filled> rows(cells.tile_count_.y());
  std::vector<std::optional<GroundColumn>> over(usualThreads());  // one for each thread
  parallelFor(cells.tile_count_.y(), usualThreads(), [&](int j, int thread) {
    if (!over[thread]) over[thread].emplace(scene, pieces, up, settings);
    for (int i = 0; i < cells.tile_count_.x(); ++i) {
      stop.check();
      fillTile(i, j, *over[thread], rows[j]);
    }
  });
  for (int j = 0; j < cells.tile_count_.y(); ++j) {
    append(rows[j], j);
    rows[j] = {};
  }
}

// Finds the plain tiles, with squares that are larger where too many others are left.
void GroundCells::Builder::makeTiles() {
  for (cells.cell_ = std::min(kCell, kCellOfFoot * settings.foot_breadth);; cells.cell_ *= 2.0) {
    for (int k = 0; k < 2; ++k) {
      cells.count_[k] = 1 + static_cast<int>(extent[k] / cells.cell_);
      cells.tile_count_[k] = (cells.count_[k] + kTile - 1) / kTile;
    }
    cells.tiles_.assign(static_cast<size_t>(cells.tile_count_.x()) * cells.tile_count_.y(), {});
    long long squares = 0;
    double surfaces = 0.0;
    const auto fits = [&] { return squares <= kMostSquares && surfaces <= kMostSurfaces; };
    std::vector<double> found(cells.tile_count_.x());  // surfaces over each tile of a row
    for (int j = 0; j < cells.tile_count_.y() && fits(); ++j) {
      Tile* const row = &cells.tiles_[static_cast<size_t>(j) * cells.tile_count_.x()];
      parallelFor(cells.tile_count_.x(), usualThreads(), [&](int i, int) {
        stop.check();
        row[i].plain = isPlain(i, j) ? 0 : -1;
        found[i] = row[i].plain < 0 ? surfacesOf(i, j) : 0.0;
      });
      for (int i = 0; i < cells.tile_count_.x(); ++i) {
        if (row[i].plain < 0) squares += kTile * kTile;
        surfaces += found[i];
      }
    }
    if (fits() || cells.count_.maxCoeff() == 1) return;
  }
}

void GroundCells::Builder::build() {
  makeTiles();
  narrow.emplace(scene, pieces, up, cells.min_, cells.cell_, cells.count_);
  fillTiles();
  const double step = std::max(settings.limits.highestStep(), kLevel), both = stepBothWays();
  joinSteps(step, &Span::part);
  if (both < step) joinSteps(both, &Span::both);
  choose();
  goOn();
  // Where all has its floor and nothing is new, ground goes on no farther than it did.
  if (choosePlaces() || hasGroundOfNoFloor()) goOn();
  if (both >= step)
    for (Span& span : cells.spans_) span.both = span.floor;
  measure();
}

}  // namespace amble

#include "environments/ground/ground_cells.h"

#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include "base/parallel.h"
#include "base/union_find.h"
#include "environments/ground/ground_column.h"
#include "environments/ground/narrow_ground.h"
#include "environments/ground/plan_triangle.h"

namespace amble {
namespace {

// Steps bridge so many squares [cells]: gaps between treads, not strides.
constexpr int kStepReach = 3;

// Calls visit_one(span) for those that are no farther up or down from a height than `most`.
template <typename Visit>
void eachNear(std::span<const GroundCells::Span> spans, double height, double most,
              Visit visit_one) {
  const double from = height - most - kTouching, to = height + most + kTouching;  // and rounding
  auto next = std::ranges::lower_bound(spans, from, {}, &GroundCells::Span::height);
  for (; next != spans.end() && next->height <= to; ++next)
    if (std::abs(next->height - height) <= most) visit_one(*next);
}

bool hasGroundNear(std::span<const GroundCells::Span> spans, double height, double most) {
  bool found = false;
  eachNear(spans, height, most, [&](const GroundCells::Span& span) { found |= span.ground; });
  return found;
}

}  // namespace

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
  void joinSteps();
  bool isAsked(int column, int row) const;
  template <typename Visit>
  void eachSpan(Visit visit_one) const;
  template <typename Visit>
  void eachNeighbour(int span, const Eigen::Vector2i& other, double most, Visit visit_one) const;
  void choose();
  void choosePlaces();
  void goOn();
  void addOpen(int span, const Eigen::Vector2i& square, Open& open) const;
  template <typename Visit>
  void eachColumn(Visit visit_one) const;
  void measure();
};

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
  for (int row = 0; row < cells.count_.y(); ++row) {
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

void GroundCells::Builder::joinSteps() {
  UnionFind parts(static_cast<int>(cells.spans_.size()));
  const double step = std::max(settings.limits.highestStep(), kLevel);
  eachSpan([&](int span, const Eigen::Vector2i& square) {
    if (!cells.spans_[span].standable) return;
    for (int far = 1; far <= kStepReach; ++far) {
      for (const Eigen::Vector2i& way : {Eigen::Vector2i(far, 0), Eigen::Vector2i(0, far)}) {
        eachNeighbour(span, square + way, step, [&](int other) {
          if (cells.spans_[other].standable) parts.join(span, other);
        });
      }
    }
  });
  for (int span = 0; span < parts.size(); ++span)
    if (cells.spans_[span].standable) cells.spans_[span].part = parts.find(span);
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
void GroundCells::Builder::choosePlaces() {
  std::vector<bool> chosen(cells.spans_.size(), false);
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
      if (span.part >= 0 && off(span) <= kFloorReach) chosen[span.part] = true;
  }
  for (Span& span : cells.spans_)
    span.ground = span.ground || (span.part >= 0 && chosen[span.part]);
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
  joinSteps();
  choose();
  goOn();
  choosePlaces();
  goOn();
  measure();
}

GroundCells::GroundCells(const Scene& scene, const ScenePieces& pieces, const std::vector<bool>& up,
                         const GroundSettings& settings, const StopRequest& stop)
    : slope_(std::tan(settings.limits.max_slope)) {
  Eigen::AlignedBox2d extent;
  for (size_t t = 0; t < up.size(); ++t) {
    if (!up[t]) continue;
    for (const Eigen::Vector3d& corner : pieces.triangles()[t])
      extent.extend(Eigen::Vector2d(corner.head<2>()));
  }
  if (extent.isEmpty()) return;
  min_ = extent.min();
  Builder{scene, pieces, up, settings, *this, stop, extent.sizes()}.build();
}

std::span<const GroundCells::Span> GroundCells::spans(int column, int row) const {
  if (column < 0 || row < 0 || column >= count_.x() || row >= count_.y()) return {};
  const Tile& tile = tileAt(column, row);
  if (tile.plain >= 0) return {spans_.data() + tile.first, static_cast<size_t>(tile.plain)};
  const int cell = tile.first + row % kTile * kTile + column % kTile;
  return {spans_.data() + start_[cell], spans_.data() + start_[cell + 1]};
}

bool GroundCells::isPlainAround(int column, int row) const {
  const auto here = spans(column, row);
  const auto same = [](const Span& a, const Span& b) { return a.height == b.height; };
  for (int j = row - kTile; j <= row + kTile; j += kTile) {
    for (int i = column - kTile; i <= column + kTile; i += kTile) {
      if (i < 0 || j < 0 || i >= count_.x() || j >= count_.y() || tileAt(i, j).plain < 0)
        return false;
      const auto there = spans(i, j);
      if (!std::equal(here.begin(), here.end(), there.begin(), there.end(), same)) return false;
    }
  }
  return true;
}

Eigen::Vector2i GroundCells::squareAt(const Eigen::Vector2d& p) const {
  const Eigen::Array2d steps = ((p - min_) / cell_).array().floor();
  return steps.max(-1.0).min(count_.cast<double>().array()).cast<int>();
}

// Whether ground over one of the squares near p goes on as the plane through p does.
bool GroundCells::matches(const Eigen::Vector3d& p, const Eigen::Vector3d& normal) const {
  const Eigen::Vector2i at = squareAt(p.head<2>());
  for (int row = at.y() - 1; row <= at.y() + 1; ++row) {
    for (int column = at.x() - 1; column <= at.x() + 1; ++column) {
      const Eigen::Vector2d way = middle(column, row) - p.head<2>();
      const double z = p.z() - normal.head<2>().dot(way) / normal.z();
      if (hasGroundNear(spans(column, row), z, kLevel)) return true;
    }
  }
  return false;
}

// Whether the triangle is ground over one of these squares, which are of one tile.
bool GroundCells::isGroundWithin(const Triangle3& t, const Eigen::Vector2i& low,
                                 const Eigen::Vector2i& high) const {
  const auto [bottom, top] = std::minmax({t[0].z(), t[1].z(), t[2].z()});
  const bool plain = tileAt(low.x(), low.y()).plain >= 0;
  if (plain && !hasGroundNear(spans(low.x(), low.y()), 0.5 * (bottom + top),
                              0.5 * (top - bottom) + kTouching))
    return false;
  for (int row = low.y(); row <= high.y(); ++row) {
    for (int column = low.x(); column <= high.x(); ++column) {
      const Eigen::Vector2d p = middle(column, row);
      const auto z = heightOver(t, p.x(), p.y());
      if (z && hasGroundNear(spans(column, row), *z, kTouching)) return true;
    }
  }
  return false;
}

bool GroundCells::isGround(const Triangle3& t) const {
  Eigen::AlignedBox2d plan;
  for (const Eigen::Vector3d& corner : t) plan.extend(Eigen::Vector2d(corner.head<2>()));
  const Eigen::Vector2i low = squareAt(plan.min()).cwiseMax(0);
  const Eigen::Vector2i high = squareAt(plan.max()).cwiseMin(count_ - Eigen::Vector2i::Ones());
  if ((low.array() > high.array()).any()) return false;
  for (int j = low.y() / kTile; j <= high.y() / kTile; ++j) {
    for (int i = low.x() / kTile; i <= high.x() / kTile; ++i) {
      const Eigen::Vector2i first(i * kTile, j * kTile);
      const Eigen::Vector2i last = first.array() + (kTile - 1);
      if (isGroundWithin(t, low.cwiseMax(first), high.cwiseMin(last))) return true;
    }
  }
  // Small and narrow ones lie between the middles of squares.
  const Eigen::Vector3d centre = (t[0] + t[1] + t[2]) / 3.0;
  const Eigen::Vector3d normal = (t[1] - t[0]).cross(t[2] - t[0]).normalized();
  return matches(centre, normal) ||
         std::any_of(t.begin(), t.end(), [&](const Eigen::Vector3d& corner) {
           return matches(0.5 * (centre + corner), normal);
         });
}

}  // namespace amble

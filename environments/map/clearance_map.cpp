#include "environments/map/clearance_map.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "environments/ground/ground_cells.h"

namespace amble {
namespace {

constexpr int kNearCells = 6;       // to each side, where a place is looked for
constexpr double kSameFloor = 0.5;  // what is said and what is there differ by less [m]
// Cells begin beside round numbers: walls stand on these, and would be in two cells [m].
constexpr double kBesideRound = 1e-6;
constexpr double kLeastGain = 1e-4;  // smaller improvements of a distance are not passed on [m]
constexpr int kStopEvery = 1 << 12;  // triangles, rows or places between looks at the clock
// Cells around one without ground whose places see what is over it.
constexpr int kBesideGround = 3;

}  // namespace

ClearanceMap::ClearanceMap(const SceneGround& ground, const Eigen::AlignedBox2d& bounds,
                           const Breadth& body, const std::function<bool()>& stopped)
    : body_(body), step_(ground.settings().limits.highestStep()) {
  static_assert(kMostBands <= std::numeric_limits<decltype(Source::band)>::max());
  if (body.bands.size() > kMostBands) {
    throw std::invalid_argument("at most " + std::to_string(kMostBands) + " bands of a body");
  }
  bool made = layPlaces(ground, bounds, stopped);
  if (made) {
    source_.resize(size());
    done_.resize(static_cast<size_t>(count_.x()) * count_.y(), 0);
    for (const Place& place : places_) {
      lowest_ = std::min(lowest_, place.height);
      highest_ = std::max(highest_, place.height);
    }
    measureDistances();
    markEdges();
    made = markObstacles(ground, stopped) && spread(stopped);
  }
  source_ = {};
  done_ = {};
  queue_ = {};
  distance_ = {};
  if (!made) places_.clear();
}

bool ClearanceMap::layPlaces(const SceneGround& ground, const Eigen::AlignedBox2d& bounds,
                             const std::function<bool()>& stopped) {
  const GroundCells& squares = ground.cells();
  if (squares.columns() == 0 || bounds.isEmpty()) return true;
  const Eigen::Vector2d half = Eigen::Vector2d::Constant(0.5 * squares.cell());
  const Eigen::AlignedBox2d all(squares.middle(0, 0) - half,
                                squares.middle(squares.columns() - 1, squares.rows() - 1) + half);
  const Eigen::AlignedBox2d region = all.intersection(bounds);
  if (region.isEmpty()) return true;
  while (region.volume() / (cell_ * cell_) > kMostCells) cell_ *= 2.0;
  min_ = region.min().array() - kBesideRound - cell_;
  count_ = (region.sizes() / cell_).array().ceil().cast<int>().max(1) + 2;
  start_ = {0};
  for (int row = 0; row < count_.y(); ++row) {
    if (stopped()) return false;
    for (int column = 0; column < count_.x(); ++column) {
      const bool is_rim =
          row == 0 || column == 0 || row + 1 == count_.y() || column + 1 == count_.x();
      const Eigen::Vector2i square =
          squares.squareAt(min_ + cell_ * Eigen::Vector2d(column + 0.5, row + 0.5));
      for (const GroundCells::Span& span : squares.spans(square.x(), square.y())) {
        if (!span.ground || is_rim) continue;
        cell_of_.push_back(row * count_.x() + column);
        places_.push_back({static_cast<float>(span.height), static_cast<float>(kFarthest)});
      }
      start_.push_back(size());
    }
  }
  return true;
}

int ClearanceMap::placeAt(const Eigen::Vector3d& p) const {
  if (size() == 0) return -1;
  const Eigen::Vector2d middle = (p.head<2>() - min_) / cell_;
  int best = -1;
  double least = HUGE_VAL;
  for (int j = -kNearCells; j <= kNearCells; ++j) {
    for (int i = -kNearCells; i <= kNearCells; ++i) {
      const double x = std::floor(middle.x()) + i, y = std::floor(middle.y()) + j;
      if (!(x >= 0 && y >= 0 && x < count_.x() && y < count_.y())) continue;
      const int cell = static_cast<int>(y) * count_.x() + static_cast<int>(x);
      for (int place = start_[cell]; place < start_[cell + 1]; ++place) {
        const double off = std::abs(places_[place].height - p.z());
        const double distance = off + cell_ * std::hypot(i, j);
        if (off > kSameFloor || distance >= least) continue;
        least = distance;
        best = place;
      }
    }
  }
  return best;
}

// As far as anything is seen that takes room, and a cell on.
void ClearanceMap::measureDistances() {
  double breadth = body_.feet;
  for (const Band& band : body_.bands) breadth = std::max(breadth, band.half_breadth);
  far_ = static_cast<int>((kFarthest + breadth) / cell_) + 3;
  distance_.reserve(static_cast<size_t>(far_) * far_);
  for (int y = 0; y < far_; ++y) {
    for (int x = 0; x < far_; ++x) {
      const double dx = x, dy = y;
      distance_.push_back(std::max(0.0, cell_ * (std::sqrt(dx * dx + dy * dy) - 0.5)));
    }
  }
}

// More than kFarthest where the obstacle is too far away to matter.
double ClearanceMap::spareFrom(const Source& source) const {
  const int dx = std::abs(source.dx), dy = std::abs(source.dy);
  if (dx >= far_ || dy >= far_) return HUGE_VAL;
  return distance_[static_cast<size_t>(dy) * far_ + dx] -
         (source.band < 0 ? body_.feet : body_.bands[source.band].half_breadth);
}

bool ClearanceMap::isNews(int place, double spare) const {
  return spare <= places_[place].spare - kLeastGain;
}

// A place that waits in the queue already passes on what it has seen by then.
void ClearanceMap::see(int place, const Source& source) {
  const double spare = spareFrom(source);
  if (!isNews(place, spare)) return;
  const bool waits = source_[place].waits;
  places_[place].spare = static_cast<float>(spare);
  source_[place] = source;
  source_[place].waits = true;
  if (!waits) queue_.push_back(place);
}

// Places beside which no step leads on: feet must stay off.
void ClearanceMap::markEdges() {
  for (int place = 0; place < size(); ++place) {
    if (beside(place, 1, 0) < 0 || beside(place, -1, 0) < 0 || beside(place, 0, 1) < 0 ||
        beside(place, 0, -1) < 0)
      see(place, {});
  }
}

bool ClearanceMap::markObstacles(const SceneGround& ground, const std::function<bool()>& stopped) {
  if (size() == 0 || body_.bands.empty()) return true;
  const double low = ground.heights().min()[0] + body_.bands.front().low;
  const double high = ground.heights().max()[0] + body_.bands.back().high;
  const auto& triangles = ground.all().triangles();
  for (int i = 0; i < static_cast<int>(triangles.size()); ++i) {
    if (i % kStopEvery == 0 && stopped()) return false;
    const Triangle3& t = triangles[i];
    const auto [lowest, highest] = std::minmax({t[0].z(), t[1].z(), t[2].z()});
    if (!ground.isGroundTriangle(i) && lowest <= high && highest >= low) markTriangle(t);
  }
  return true;
}

ClearanceMap::Between ClearanceMap::between(double low, double high) const {
  Between heights{low, high};
  const int bands = static_cast<int>(body_.bands.size());
  heights.others = bands > kBandsDone;
  for (int i = 0; i < std::min(bands, kBandsDone); ++i) {
    const Band& band = body_.bands[i];
    if (low < highest_ + band.high && high > lowest_ + band.low) heights.at_some |= 1 << i;
    if (low < lowest_ + band.high && high > highest_ + band.low) heights.at_all |= 1 << i;
  }
  return heights;
}

// Whether something over a cell, between two heights, may be nearer to one of its places than what
// that has seen.
bool ClearanceMap::isNewsTo(const Eigen::Vector2i& cell, const Between& heights) {
  std::uint8_t& done = done_[static_cast<size_t>(cell.y()) * count_.x() + cell.x()];
  if (!heights.others && (heights.at_some & ~done) == 0) return false;
  const bool is_news =
      anyOver(cell, heights.low, heights.high,
              [&](int place, const Source& source) { return isNews(place, spareFrom(source)); });
  if (!is_news) done |= heights.at_all;
  return is_news;
}

// The same of cells that a small triangle lies over, or beside; of a large one it is not asked.
bool ClearanceMap::mayBeNews(const Triangle3& t, const Between& heights) {
  constexpr int kFewCells = 9;
  Eigen::AlignedBox2d around;
  for (const Eigen::Vector3d& corner : t) around.extend(corner.head<2>().eval());
  const Eigen::Vector2d max = min_ + cell_ * count_.cast<double>();
  if (!around.intersects({min_, max})) return true;
  const Eigen::Vector2i first = cellAt(around.min().array() - kBesideRound);
  const Eigen::Vector2i last = cellAt(around.max().array() + kBesideRound);
  if ((last - first + Eigen::Vector2i::Ones()).prod() > kFewCells) return true;
  for (int row = first.y(); row <= last.y(); ++row)
    for (int column = first.x(); column <= last.x(); ++column)
      if (isNewsTo({column, row}, heights)) return true;
  return false;
}

// That a point is over, or the nearest to it.
Eigen::Vector2i ClearanceMap::cellAt(const Eigen::Vector2d& p) const {
  const auto index = [&](int axis) {
    return static_cast<int>(std::clamp((p[axis] - min_[axis]) / cell_, 0.0, count_[axis] - 1.0));
  };
  return {index(0), index(1)};
}

// Row after row of cells, and in each only the columns that the triangle lies over; and of these
// only the cells to which it may be news: meshes have many triangles over one.
void ClearanceMap::markTriangle(const Triangle3& t) {
  const auto [lowest, highest] = std::minmax({t[0].z(), t[1].z(), t[2].z()});
  const Between all = between(lowest - kBesideRound, highest + kBesideRound);
  if (!mayBeNews(t, all)) return;
  const Eigen::Vector2d max = min_ + cell_ * count_.cast<double>();
  const auto inside = boundsWithin(t, {min_, max});
  if (!inside) return;
  const int last_row = cellAt(inside->max().head<2>()).y();
  for (int row = cellAt(inside->min().head<2>()).y(); row <= last_row; ++row) {
    const double y = min_.y() + cell_ * row;
    const auto strip =
        boundsWithin(t, {Eigen::Vector2d(min_.x(), y), Eigen::Vector2d(max.x(), y + cell_)});
    if (!strip) continue;
    const int last = cellAt(strip->max().head<2>()).x();
    for (int column = cellAt(strip->min().head<2>()).x(); column <= last; ++column) {
      if (!isNewsTo({column, row}, all)) continue;
      const Eigen::Vector2d corner(min_.x() + cell_ * column, y);
      const auto heights = heightsWithin(t, {corner, corner + Eigen::Vector2d::Constant(cell_)});
      if (heights) markColumn({column, row}, heights->low, heights->high);
    }
  }
}

// Shows what is over a cell between two heights to its places; where it has none, as under a wall
// that its floor ends at, to those around it: visit(place, source) until one says yes.
template <typename Visit>
bool ClearanceMap::anyOver(const Eigen::Vector2i& at, double low, double high, Visit visit) const {
  const int own = at.y() * count_.x() + at.x();
  const int far = start_[own] < start_[own + 1] ? 0 : kBesideGround;
  const int bands = static_cast<int>(body_.bands.size());
  for (int y = std::max(0, at.y() - far); y <= std::min(count_.y() - 1, at.y() + far); ++y) {
    for (int x = std::max(0, at.x() - far); x <= std::min(count_.x() - 1, at.x() + far); ++x) {
      const int cell = y * count_.x() + x;
      Source source{static_cast<std::int16_t>(x - at.x()), static_cast<std::int16_t>(y - at.y())};
      for (int place = start_[cell]; place < start_[cell + 1]; ++place) {
        const double height = places_[place].height;
        for (source.band = 0; source.band < bands; ++source.band) {
          const Band& band = body_.bands[source.band];
          if (low < height + band.high && high > height + band.low && visit(place, source))
            return true;
        }
      }
    }
  }
  return false;
}

void ClearanceMap::markColumn(const Eigen::Vector2i& at, double low, double high) {
  anyOver(at, low, high, [&](int place, const Source& source) {
    see(place, source);
    return false;
  });
}

// Waiting for memory is most of what a large map costs: the queue says what is needed next.
void ClearanceMap::fetchAhead(size_t next) const {
  constexpr size_t kFar = 24, kMiddle = 16, kNear = 8;  // places of the queue; by trial
  if (next + kFar >= queue_.size()) return;
  const int far = queue_[next + kFar];
  __builtin_prefetch(&cell_of_[far]);
  __builtin_prefetch(&places_[far]);
  __builtin_prefetch(&source_[far]);
  const int middle = cell_of_[queue_[next + kMiddle]], near = cell_of_[queue_[next + kNear]];
  for (const int row : {-count_.x(), 0, count_.x()}) {
    __builtin_prefetch(&start_[middle + row]);
    const int place = start_[near + row];  // or the end of all
    __builtin_prefetch(places_.data() + place);
    __builtin_prefetch(source_.data() + place);
  }
}

bool ClearanceMap::spread(const std::function<bool()>& stopped) {
  for (size_t next = 0; next < queue_.size(); ++next) {
    if (next % kStopEvery == 0 && stopped()) return false;
    fetchAhead(next);
    const int place = queue_[next];
    source_[place].waits = false;
    const Source source = source_[place];
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        if (dx == 0 && dy == 0) continue;
        const Source beyond{static_cast<std::int16_t>(source.dx + dx),
                            static_cast<std::int16_t>(source.dy + dy), source.band};
        if (spareFrom(beyond) > kFarthest) continue;
        const int other = beside(place, dx, dy);
        if (other >= 0) see(other, beyond);
      }
    }
  }
  return true;
}

}  // namespace amble

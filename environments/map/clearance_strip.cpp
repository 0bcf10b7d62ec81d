#include "environments/map/clearance_strip.h"

#include <algorithm>
#include <cmath>

namespace amble {
namespace {

// Things lie over cells so far beside them, and corners of cells on round numbers [m].
constexpr double kBesideCell = 1e-6;
constexpr int kStopEvery = 1 << 12;  // triangles or places between looks at the clock
// Cells around one without ground whose places see what is over it.
constexpr int kBesideGround = 3;

}  // namespace

// As far as anything is seen that takes room, and a cell on.
ClearanceReach::ClearanceReach(const ClearanceMap::Breadth& body, double cell) {
  std::vector<double> breadths = {body.feet};
  for (const ClearanceMap::Band& band : body.bands) breadths.push_back(band.half_breadth);
  const double most = *std::max_element(breadths.begin(), breadths.end());
  far_ = static_cast<int>((ClearanceMap::kFarthest + most) / cell) + 3;
  spare_.reserve(breadths.size() * far_ * far_);
  for (const double breadth : breadths) {
    for (int y = 0; y < far_; ++y) {
      for (int x = 0; x < far_; ++x) {
        const double dx = x, dy = y;
        spare_.push_back(std::max(0.0, cell * (std::sqrt(dx * dx + dy * dy) - 0.5)) - breadth);
      }
    }
  }
}

ClearanceStrip::ClearanceStrip(const ClearanceMap& map, const ClearanceReach& reach, int begin,
                               int end)
    : map_(map),
      reach_(reach),
      max_(map.min_ + map.cell_ * map.count_.cast<double>()),
      rows_begin_(std::max(0, begin - kBesideGround)),
      rows_end_(std::min(map.count_.y(), end + kBesideGround)),
      first_(map.firstOfRow(begin)),
      end_(map.firstOfRow(end)),
      seen_(static_cast<size_t>(end_ - first_)),
      done_(static_cast<size_t>(rows_end_ - rows_begin_) * map.count_.x(), 0) {
  for (int place = first_; place < end_; ++place) {
    lowest_ = std::min(lowest_, map.places_[place].height);
    highest_ = std::max(highest_, map.places_[place].height);
  }
}

bool ClearanceStrip::measure(const SceneGround& ground, const std::function<bool()>& stopped) {
  markEdges();
  return markObstacles(ground, stopped) && spread(stopped);
}

// A place that waits in the queue already passes on what it has seen by then.
void ClearanceStrip::see(int place, const Source& source, double spare) {
  if (!isNews(place, spare)) return;
  Seen& seen = seen_[place - first_];
  if (!seen.waits) queue_.push_back(place);
  seen = {static_cast<float>(spare), source, true};
}

// Places beside which no step leads on: feet must stay off.
void ClearanceStrip::markEdges() {
  const Source here;
  const double spare = reach_.spare(here.dx, here.dy, here.band);
  for (int place = first_; place < end_; ++place) {
    if (map_.beside(place, 1, 0) < 0 || map_.beside(place, -1, 0) < 0 ||
        map_.beside(place, 0, 1) < 0 || map_.beside(place, 0, -1) < 0)
      see(place, here, spare);
  }
}

bool ClearanceStrip::markObstacles(const SceneGround& ground,
                                   const std::function<bool()>& stopped) {
  const std::vector<ClearanceMap::Band>& bands = map_.body_.bands;
  if (first_ == end_ || bands.empty()) return true;
  const double low = ground.heights().min()[0] + bands.front().low;
  const double high = ground.heights().max()[0] + bands.back().high;
  // A cell beyond the rows, for what is on their rim.
  const double south = map_.middle(1, rows_begin_ - 1), north = map_.middle(1, rows_end_);
  const auto& triangles = ground.all().triangles();
  for (int i = 0; i < static_cast<int>(triangles.size()); ++i) {
    if (i % kStopEvery == 0 && stopped()) return false;
    const Triangle3& t = triangles[i];
    const auto [lowest, highest] = std::minmax({t[0].z(), t[1].z(), t[2].z()});
    if (ground.isGroundTriangle(i) || lowest > high || highest < low) continue;
    const auto [first, last] = std::minmax({t[0].y(), t[1].y(), t[2].y()});
    if (first <= north && last >= south) markTriangle(t);
  }
  return true;
}

ClearanceStrip::Between ClearanceStrip::between(double low, double high) const {
  Between heights{low, high};
  const int bands = static_cast<int>(map_.body_.bands.size());
  heights.others = bands > kBandsDone;
  for (int i = 0; i < std::min(bands, kBandsDone); ++i) {
    const ClearanceMap::Band& band = map_.body_.bands[i];
    if (low < highest_ + band.high && high > lowest_ + band.low) heights.at_some |= 1 << i;
    if (low < lowest_ + band.high && high > highest_ + band.low) heights.at_all |= 1 << i;
  }
  return heights;
}

// Whether something over a cell, between two heights, may be nearer to one of its places than what
// that has seen.
bool ClearanceStrip::isNewsTo(const Eigen::Vector2i& cell, const Between& heights) {
  std::uint8_t& done =
      done_[static_cast<size_t>(cell.y() - rows_begin_) * map_.count_.x() + cell.x()];
  if (!heights.others && (heights.at_some & ~done) == 0) return false;
  const bool is_news =
      anyOver(cell, heights.low, heights.high,
              [&](int place, const Source&, double spare) { return isNews(place, spare); });
  if (!is_news) done |= heights.at_all;
  return is_news;
}

// The same of cells that a small triangle lies over, or beside; of a large one it is not asked.
bool ClearanceStrip::mayBeNews(const Triangle3& t, const Between& heights) {
  constexpr int kFewCells = 9;
  Eigen::AlignedBox2d around;
  for (const Eigen::Vector3d& corner : t) around.extend(corner.head<2>().eval());
  if (!around.intersects({map_.min_, max_})) return true;
  const Eigen::Vector2i first = cellAt(around.min().array() - kBesideCell);
  const Eigen::Vector2i last = cellAt(around.max().array() + kBesideCell);
  if ((last - first + Eigen::Vector2i::Ones()).prod() > kFewCells) return true;
  const int end = std::min(last.y() + 1, rows_end_);
  for (int row = std::max(first.y(), rows_begin_); row < end; ++row)
    for (int column = first.x(); column <= last.x(); ++column)
      if (isNewsTo({column, row}, heights)) return true;
  return false;
}

// That a point is over, or the nearest to it.
Eigen::Vector2i ClearanceStrip::cellAt(const Eigen::Vector2d& p) const {
  const auto index = [&](int axis) {
    return static_cast<int>(
        std::clamp((p[axis] - map_.min_[axis]) / map_.cell_, 0.0, map_.count_[axis] - 1.0));
  };
  return {index(0), index(1)};
}

// Row after row of cells, and in each only the columns that the triangle lies over; and of these
// only the cells to which it may be news: meshes have many triangles over one.
void ClearanceStrip::markTriangle(const Triangle3& t) {
  const auto [lowest, highest] = std::minmax({t[0].z(), t[1].z(), t[2].z()});
  const Between all = between(lowest - kBesideCell, highest + kBesideCell);
  if (!mayBeNews(t, all)) return;
  const auto inside = boundsWithin(t, {map_.min_, max_});
  if (!inside) return;
  const int end = std::min(cellAt(inside->max().head<2>()).y() + 1, rows_end_);
  int row = std::max(cellAt(inside->min().head<2>()).y(), rows_begin_);
  for (; row < end; ++row) {
    const double y = map_.min_.y() + map_.cell_ * row;
    const auto strip = boundsWithin(
        t, {Eigen::Vector2d(map_.min_.x(), y), Eigen::Vector2d(max_.x(), y + map_.cell_)});
    if (!strip) continue;
    const int last = cellAt(strip->max().head<2>()).x();
    for (int column = cellAt(strip->min().head<2>()).x(); column <= last; ++column) {
      if (!isNewsTo({column, row}, all)) continue;
      const Eigen::Vector2d corner(map_.min_.x() + map_.cell_ * column, y);
      const auto heights =
          heightsWithin(t, {corner, corner + Eigen::Vector2d::Constant(map_.cell_)});
      if (heights) markColumn({column, row}, heights->low, heights->high);
    }
  }
}

// Shows what is over a cell between two heights to its places; where it has none, as under a wall
// that its floor ends at, to those around it: visit(place, source, spare) until one says yes.
template <typename Visit>
bool ClearanceStrip::anyOver(const Eigen::Vector2i& at, double low, double high,
                             Visit visit) const {
  const int own = at.y() * map_.count_.x() + at.x();
  const int far = map_.start_[own] < map_.start_[own + 1] ? 0 : kBesideGround;
  const int bands = static_cast<int>(map_.body_.bands.size());
  for (int y = std::max(0, at.y() - far); y <= std::min(map_.count_.y() - 1, at.y() + far); ++y) {
    for (int x = std::max(0, at.x() - far); x <= std::min(map_.count_.x() - 1, at.x() + far); ++x) {
      const int cell = y * map_.count_.x() + x;
      Source source{static_cast<std::int16_t>(x - at.x()), static_cast<std::int16_t>(y - at.y())};
      for (int place = map_.start_[cell]; place < map_.start_[cell + 1] && has(place); ++place) {
        const double height = map_.places_[place].height;
        for (source.band = 0; source.band < bands; ++source.band) {
          const ClearanceMap::Band& band = map_.body_.bands[source.band];
          if (low < height + band.high && high > height + band.low &&
              visit(place, source, reach_.spare(source.dx, source.dy, source.band)))
            return true;
        }
      }
    }
  }
  return false;
}

void ClearanceStrip::markColumn(const Eigen::Vector2i& at, double low, double high) {
  anyOver(at, low, high, [&](int place, const Source& source, double spare) {
    see(place, source, spare);
    return false;
  });
}

// Waiting for memory is most of what a large map costs: the queue says what is needed next.
void ClearanceStrip::fetchAhead(size_t next) const {
  constexpr size_t kFar = 24, kMiddle = 16, kNear = 8;  // places of the queue; by trial
  if (next + kFar >= queue_.size()) return;
  const int far = queue_[next + kFar];
  __builtin_prefetch(&map_.cell_of_[far]);
  __builtin_prefetch(&map_.places_[far]);
  __builtin_prefetch(&seen_[far - first_]);
  const int middle = map_.cell_of_[queue_[next + kMiddle]],
            near = map_.cell_of_[queue_[next + kNear]];
  for (const int row : {-map_.count_.x(), 0, map_.count_.x()}) {
    __builtin_prefetch(&map_.start_[middle + row]);
    const int place = map_.start_[near + row];  // or the end of all
    __builtin_prefetch(map_.places_.data() + place);
    if (has(place)) __builtin_prefetch(&seen_[place - first_]);
  }
}

// Round after round: those of a round that see something nearer are of the next.
bool ClearanceStrip::spread(const std::function<bool()>& stopped) {
  size_t end_of_round = 0;
  for (size_t next = 0; next < queue_.size(); ++next) {
    if (next % kStopEvery == 0 && stopped()) return false;
    if (next == end_of_round) {
      end_of_round = queue_.size();
      ++rounds_;
    }
    fetchAhead(next);
    const int place = queue_[next];
    seen_[place - first_].waits = false;
    const Source source = seen_[place - first_].source;
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        if (dx == 0 && dy == 0) continue;
        const Source beyond{static_cast<std::int16_t>(source.dx + dx),
                            static_cast<std::int16_t>(source.dy + dy), source.band};
        const double spare = reach_.spare(beyond.dx, beyond.dy, beyond.band);
        if (spare > ClearanceMap::kFarthest) continue;
        const int other = map_.beside(place, dx, dy);
        if (has(other)) see(other, beyond, spare);
      }
    }
  }
  return true;
}

}  // namespace amble

#include "environments/map/clearance_map.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "base/parallel.h"
#include "environments/ground/ground_cells.h"
#include "environments/map/clearance_strip.h"

namespace amble {
namespace {

constexpr int kNearCells = 6;       // to each side, where a place is looked for
constexpr double kSameFloor = 0.5;  // what is said and what is there differ by less [m]
// Cells begin beside round numbers: walls stand on these, and would be in two cells [m].
constexpr double kBesideRound = 1e-6;
constexpr int kRowsOfStrip = 40;  // at least, of one that a thread makes; by trial

}  // namespace

ClearanceMap::ClearanceMap(const SceneGround& ground, const Eigen::AlignedBox2d& bounds,
                           const Breadth& body, const std::function<bool()>& stopped, int threads)
    : body_(body), step_(ground.settings().limits.highestStep()) {
  if (body.bands.size() > kMostBands) {
    throw std::invalid_argument("at most " + std::to_string(kMostBands) + " bands of a body");
  }
  if (!layPlaces(ground, bounds, threads, stopped) || !measure(ground, threads, stopped))
    places_.clear();
}

bool ClearanceMap::layPlaces(const SceneGround& ground, const Eigen::AlignedBox2d& bounds,
                             int threads, const std::function<bool()>& stopped) {
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
  std::vector<Rows> blocks(std::min(threads, count_.y()));
  const int count = static_cast<int>(blocks.size());
  std::atomic<bool> ended{false};
  parallelFor(count, threads, [&](int i, int) {
    const int begin = rowsBefore(i, count), end = rowsBefore(i + 1, count);
    if (!layRows(squares, begin, end, stopped, blocks[i])) ended = true;
  });
  if (ended) return false;
  for (Rows& rows : blocks) append(std::move(rows));
  return true;
}

// The places of some rows of cells.
bool ClearanceMap::layRows(const GroundCells& squares, int begin, int end,
                           const std::function<bool()>& stopped, Rows& rows) const {
  std::vector<int> square_x(count_.x());
  for (int column = 0; column < count_.x(); ++column)
    square_x[column] = squares.squareAt({middle(0, column), middle(1, 0)}).x();
  rows.end.reserve(static_cast<size_t>(end - begin) * count_.x());
  for (int row = begin; row < end; ++row) {
    if (stopped()) return false;
    const int y = squares.squareAt({middle(0, 0), middle(1, row)}).y();
    for (int column = 0; column < count_.x(); ++column) {
      const bool is_rim =
          row == 0 || column == 0 || row + 1 == count_.y() || column + 1 == count_.x();
      for (const GroundCells::Span& span : squares.spans(square_x[column], y)) {
        if (!span.ground || is_rim) continue;
        rows.cell_of.push_back(row * count_.x() + column);
        rows.places.push_back({static_cast<float>(span.height), static_cast<float>(kFarthest)});
      }
      rows.end.push_back(static_cast<int>(rows.places.size()));
    }
  }
  return true;
}

void ClearanceMap::append(Rows rows) {
  const int first = size();
  start_.reserve(start_.size() + rows.end.size());
  for (const int end : rows.end) start_.push_back(first + end);
  if (first == 0) {
    cell_of_ = std::move(rows.cell_of);
    places_ = std::move(rows.places);
    return;
  }
  cell_of_.insert(cell_of_.end(), rows.cell_of.begin(), rows.cell_of.end());
  places_.insert(places_.end(), rows.places.begin(), rows.places.end());
}

// Strips of rows, one for each thread, each made with so much of what is beside it that its own
// places are as if all had been made at once (ClearanceStrip): as far as distances go straight on,
// and a bit. Where they went on more often than that all is made at once.
bool ClearanceMap::measure(const SceneGround& ground, int threads,
                           const std::function<bool()>& stopped) {
  const ClearanceReach reach(body_, cell_);
  const int beside = reach.farthest() + 2;  // rows
  const auto make = [&](int count) {
    std::atomic<bool> ended{false}, too_far{false};
    parallelFor(count, threads, [&](int i, int) {
      const int begin = rowsBefore(i, count), end = rowsBefore(i + 1, count);
      ClearanceStrip strip(*this, reach, std::max(0, begin - beside),
                           std::min(count_.y(), end + beside));
      if (!strip.measure(ground, stopped)) {
        ended = true;
      } else if (count > 1 && strip.rounds() > beside) {
        too_far = true;
      } else {
        for (int place = firstOfRow(begin); place < firstOfRow(end); ++place)
          places_[place].spare = strip.spare(place);
      }
    });
    return ended ? std::optional<bool>() : !too_far;
  };
  if (size() == 0) return true;
  auto made = make(std::clamp(count_.y() / kRowsOfStrip, 1, threads));
  if (made && !*made) made = make(1);
  return made.has_value();
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

}  // namespace amble

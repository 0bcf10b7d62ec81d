/// How much room the places of some rows of a ClearanceMap have: the distances that the map is made
/// of, spread over a part of it.
///
/// Obstacles are shown to the places over whose cells they are, one after another; what saw one
/// waits in a queue, and passes on to its neighbours what it sees itself. Where of two obstacles
/// as near the first one stays, all depends on this order, though by less than a cell. So that many
/// threads make what one makes, to the bit, each makes a strip of rows and some beside it, in the
/// same order, of which it leaves out what is elsewhere. What is missing beyond the strip's rim
/// then changes nothing farther in than the queue went round, by a cell a round: who is first in a
/// round, and what it passes on, depends on its neighbours in the round before. (The first round is
/// of the obstacles themselves, of which those beside the strip are shown as well.) So after
/// rounds() rounds all places that are as many rows from the rim are as they would be in the whole.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

#include "environments/ground/scene_ground.h"
#include "environments/map/clearance_map.h"
#include "environments/scene/triangle_grid.h"

namespace amble {

/// What room an obstacle leaves that is so many cells away, in a band of the body.
class ClearanceReach {
 public:
  /// @param cell  [m, > 0]
  ClearanceReach(const ClearanceMap::Breadth& body, double cell);

  int farthest() const { return far_ - 1; }  ///< that an obstacle may matter [cells]
  static constexpr int kFeet = -1;           ///< in place of a band
  /// More than kFarthest where the obstacle is too far away to matter [m].
  /// @param dx, dy  cells; @param band  of the body, or kFeet
  double spare(int dx, int dy, int band) const {
    dx = std::abs(dx), dy = std::abs(dy);
    if (dx >= far_ || dy >= far_) return HUGE_VAL;
    return spare_[(static_cast<size_t>(band + 1) * far_ + dy) * far_ + dx];
  }

 private:
  int far_;                    // cells along a side of the tables
  std::vector<double> spare_;  // of the feet and each band, by y and x [m]
};

class ClearanceStrip {
 public:
  /// Of a map whose places are laid: the rows from `begin` to before `end`.
  ClearanceStrip(const ClearanceMap& map, const ClearanceReach& reach, int begin, int end);

  /// False where it is stopped.
  bool measure(const SceneGround& ground, const std::function<bool()>& stopped);
  /// How often distances went on to the places beside those that had them.
  int rounds() const { return rounds_; }
  /// Of a place of these rows [m].
  float spare(int place) const { return seen_[place - first_].spare; }

 private:
  // What a place's spare room is measured to: so many cells away.
  struct Source {
    std::int16_t dx = 0, dy = 0;
    std::int8_t band = ClearanceReach::kFeet;
  };
  struct Seen {
    float spare = static_cast<float>(ClearanceMap::kFarthest);  // [m]
    Source source;
    bool waits = false;  // the place is in the queue
  };
  static_assert(ClearanceMap::kMostBands <= std::numeric_limits<decltype(Source::band)>::max());
  // Heights of something, and of the first bands those that it is in at some place of all, and at
  // every place.
  struct Between {
    double low, high;     // [m]
    bool others = false;  // whether there are more bands
    std::uint8_t at_some = 0, at_all = 0;
  };

  // Smaller improvements of a distance are not passed on [m].
  static constexpr double kLeastGain = 1e-4;

  bool has(int place) const { return place >= first_ && place < end_; }
  void markEdges();
  bool markObstacles(const SceneGround& ground, const std::function<bool()>& stopped);
  void markTriangle(const Triangle3& t);
  void markColumn(const Eigen::Vector2i& at, double low, double high);
  bool spread(const std::function<bool()>& stopped);
  void fetchAhead(size_t next) const;
  Between between(double low, double high) const;
  bool isNewsTo(const Eigen::Vector2i& cell, const Between& heights);
  bool mayBeNews(const Triangle3& t, const Between& heights);
  Eigen::Vector2i cellAt(const Eigen::Vector2d& p) const;
  template <typename Visit>
  bool anyOver(const Eigen::Vector2i& at, double low, double high, Visit visit) const;
  bool isNews(int place, double spare) const {
    return spare <= seen_[place - first_].spare - kLeastGain;
  }
  void see(int place, const Source& source, double spare);

  const ClearanceMap& map_;
  const ClearanceReach& reach_;
  const Eigen::Vector2d max_;  // of all cells [m, World]
  int rows_begin_, rows_end_;  // whose obstacles are seen from the strip's places
  int first_, end_;            // places
  float lowest_ = HUGE_VALF, highest_ = -HUGE_VALF;  // of these [m]
  std::vector<Seen> seen_;                           // by place
  // By cell: a bit for each of the first bands in which nothing over the cell is news to any place
  // any more.
  static constexpr int kBandsDone = 8;
  std::vector<std::uint8_t> done_;
  std::vector<int> queue_;  // places that saw something nearer
  int rounds_ = 0;
};

}  // namespace amble

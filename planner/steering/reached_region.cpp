#include "planner/steering/reached_region.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <queue>
#include <utility>
#include <vector>

namespace amble {
namespace {

constexpr double kHardlyRoom =
    0.04;                       // beside the body: walks through such a place are uncertain [m]
constexpr double kAtEnd = 0.5;  // so far around ends rooms are as those are [m]
// Around where a walk was stopped, until start and goal are parted [m].
constexpr std::array<double, 4> kCuts = {0.25, 0.5, 1.0, 2.0};
constexpr double kBelow = 2.5, kAbove = 0.5;  // ground that is cut, from there [m]
constexpr double kStraight = 0.01;            // of a strip's middle line, over the ground [m]

constexpr std::array<std::array<int, 2>, 8> kBeside = {
    {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {1, -1}, {-1, 1}, {-1, -1}}};

class Region {
 public:
  Region(const ClearanceMap& map, int from, int to) : map_(map), from_(from), to_(to) {}

  // Places with at least so much room that are joined to one.
  std::vector<bool> joinedTo(int place) const;
  // Room of the narrowest place of the widest way from end to end, these left out; the least there
  // is where there is no way [m].
  double widest() const;
  bool isParted() const { return to_ < 0 || !joinedTo(from_)[to_]; }

  void require(double room) { least_ = room; }
  void cut(const Eigen::Vector3d& at, double radius) {
    cut_at_ = at;
    cut_ = radius;
  }

 private:
  bool isNear(int place, int end) const {
    return end >= 0 && (map_.at(place) - map_.at(end)).head<2>().norm() < kAtEnd;
  }
  bool isIn(int place) const;

  const ClearanceMap& map_;
  int from_, to_;
  double least_ = 0.0;
  Eigen::Vector3d cut_at_ = Eigen::Vector3d::Zero();
  double cut_ = 0.0;
};

bool Region::isIn(int place) const {
  if (cut_ > 0.0) {
    const Eigen::Vector3d off = map_.at(place) - cut_at_;
    if (off.head<2>().norm() < cut_ && off.z() > -kBelow && off.z() < kAbove) return false;
  }
  if (map_.spare(place) >= least_) return true;
  const auto isAsRoomyAs = [&](int end) {
    return isNear(place, end) && map_.spare(place) >= map_.spare(end) - 0.5 * map_.cell();
  };
  return isAsRoomyAs(from_) || isAsRoomyAs(to_);
}

std::vector<bool> Region::joinedTo(int place) const {
  std::vector<bool> joined(map_.size(), false);
  std::vector<int> open = {place};
  joined[place] = true;
  while (!open.empty()) {
    const int here = open.back();
    open.pop_back();
    for (const auto& [dx, dy] : kBeside) {
      const int other = map_.beside(here, dx, dy);
      if (other < 0 || joined[other] || !isIn(other)) continue;
      joined[other] = true;
      open.push_back(other);
    }
  }
  return joined;
}

// Of all places that are reached the roomiest goes on first: the least room of those that have gone
// on is that of the widest way to the last of them.
double Region::widest() const {
  std::vector<bool> seen(map_.size(), false);
  std::priority_queue<std::pair<double, int>> open;
  const auto see = [&](int place) {
    if (place < 0 || seen[place]) return;
    seen[place] = true;
    const bool is_end = isNear(place, from_) || isNear(place, to_);
    open.emplace(is_end ? HUGE_VAL : map_.spare(place), place);
  };
  see(from_);
  double narrowest = HUGE_VAL;
  while (!open.empty()) {
    const auto [room, place] = open.top();
    open.pop();
    narrowest = std::min(narrowest, room);
    if (place == to_) return narrowest;
    for (const auto& [dx, dy] : kBeside) see(map_.beside(place, dx, dy));
  }
  return -HUGE_VAL;
}

// Runs of places along x, as long as their ground is straight.
std::vector<ReachedRegion::Strip> strips(const ClearanceMap& map, std::vector<bool> places) {
  std::vector<ReachedRegion::Strip> strips;
  for (int first = 0; first < map.size(); ++first) {
    if (!places[first]) continue;
    int last = first;
    const double height = map.at(first).z();
    double flattest = -HUGE_VAL, steepest = HUGE_VAL;  // rise of a cell that all so far allow [m]
    for (int count = 1;; ++count) {
      places[last] = false;
      const int next = map.beside(last, 1, 0);
      if (next < 0 || !places[next]) break;
      const double rise = map.at(next).z() - height;
      if (rise / count < flattest || rise / count > steepest) break;
      flattest = std::max(flattest, (rise - kStraight) / count);
      steepest = std::min(steepest, (rise + kStraight) / count);
      last = next;
    }
    strips.push_back({map.at(first), map.at(last)});
  }
  return strips;
}

// Where places come nearest, in plan, to others: rings of cells grow around them, each of which
// knows the place that it grew from.
class Nearest {
 public:
  Nearest(const ClearanceMap& map, const std::vector<bool>& places) : map_(map) {
    for (int place = 0; place < map.size(); ++place) box_.extend(map.at(place).head<2>().eval());
    count_ = (box_.sizes() / map.cell()).array().round().cast<int>() + 1;
    source_.assign(static_cast<size_t>(count_.x()) * count_.y(), -1);
    for (int place = 0; place < map.size(); ++place) {
      if (!places[place]) continue;
      const int cell = cellOf(map.at(place));
      if (source_[cell] < 0) ring_.push_back(cell);
      source_[cell] = place;
    }
  }

  // One of the places, and of the others the nearest to it; none where there are no others.
  std::optional<std::pair<int, int>> to(const std::vector<bool>& others) {
    std::vector<int> at(source_.size(), -1);
    for (int place = 0; place < map_.size(); ++place)
      if (others[place]) at[cellOf(map_.at(place))] = place;
    std::optional<std::pair<int, int>> nearest;
    double least = HUGE_VAL;
    for (int rings = 0; !ring_.empty() && rings * map_.cell() <= least; ++rings) {
      for (const int cell : ring_) {
        if (at[cell] < 0) continue;
        const double distance = (map_.at(source_[cell]) - map_.at(at[cell])).head<2>().norm();
        if (distance >= least) continue;
        least = distance;
        nearest = {source_[cell], at[cell]};
      }
      grow();
    }
    return nearest;
  }

 private:
  int cellOf(const Eigen::Vector3d& p) const {
    const Eigen::Vector2i cell =
        ((p.head<2>() - box_.min()) / map_.cell()).array().round().cast<int>();
    return cell.y() * count_.x() + cell.x();
  }
  void grow() {
    std::vector<int> next;
    for (const int cell : ring_) {
      const int x = cell % count_.x(), y = cell / count_.x();
      for (const auto& [dx, dy] : kBeside) {
        if (x + dx < 0 || y + dy < 0 || x + dx >= count_.x() || y + dy >= count_.y()) continue;
        const int other = cell + dy * count_.x() + dx;
        if (source_[other] >= 0) continue;
        source_[other] = source_[cell];
        next.push_back(other);
      }
    }
    ring_ = std::move(next);
  }

  const ClearanceMap& map_;
  Eigen::AlignedBox2d box_;
  Eigen::Vector2i count_{0, 0};
  std::vector<int> source_;  // by cell
  std::vector<int> ring_;
};

// Parts start and goal; whether that is done.
bool part(Region& region, const Eigen::Vector3d& stopped_at) {
  const double widest = region.widest();
  if (widest <= kHardlyRoom) region.require(std::max(0.0, std::nextafter(widest, HUGE_VAL)));
  if (region.isParted()) return true;
  for (const double radius : kCuts) {
    region.cut(stopped_at, radius);
    if (region.isParted()) return true;
  }
  return false;
}

}  // namespace

std::optional<ReachedRegion> reachedRegion(const ClearanceMap& map, const Eigen::Vector3d& from,
                                           const Eigen::Vector3d& to,
                                           const Eigen::Vector3d& stopped_at) {
  const int start = map.placeAt(from), goal = map.placeAt(to);
  if (start < 0) return std::nullopt;
  Region region(map, start, goal);
  if (!part(region, stopped_at)) return std::nullopt;
  const std::vector<bool> here = region.joinedTo(start);
  ReachedRegion reached;
  reached.breadth = map.cell();
  reached.strips = strips(map, here);
  reached.near = from;
  reached.far = to;
  std::vector<bool> there(map.size(), false);
  if (goal >= 0) there = region.joinedTo(goal);
  if (const auto nearest = Nearest(map, here).to(there)) {
    reached.near = map.at(nearest->first);
    reached.far = map.at(nearest->second);
  }
  return reached;
}

}  // namespace amble

#include "planner/steering/way_finder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <queue>
#include <tuple>
#include <utility>

#include "base/bucket_queue.h"

namespace amble {
namespace {

// Bodies sway, turn their shoulders, and walk narrower when they are slow: where the map says that
// so much is missing they may still pass [m].
constexpr double kTightest = -0.06;
// Room beside the body that a way is the longer for the less it has of it [m], and how much longer
// at most; and where there is none at all.
constexpr double kComfort = 0.25;
constexpr double kUnease = 1.0;
constexpr double kSqueeze = 4.0;
constexpr double kRefused = 4.0;       // the same near a place where steering refused...
constexpr double kRefusedNear = 0.4;   // ...within so much [m]
constexpr double kWayOfClimb = 2.0;    // metres of way that a metre up or down is worth
constexpr double kNearEnd = 0.5;       // so far around ends rooms are as those are [m]
constexpr double kFarthest = 10.0;     // from one corner to the next [m]
constexpr double kRoomSought = 0.8;    // how far back from the farthest place seen [m]
constexpr double kLevelNear = 0.3;     // somebody stands where it is level so far around [m]
constexpr double kSameHeight = 0.02;   // [m]
constexpr double kAcross = 0.3;        // to each side of a narrow place, for the way there [m]
constexpr int kPlacesEvery = 1 << 12;  // places between looks at the clock
constexpr double kStep = 0.05;         // higher from place to place is no slope [m]
constexpr double kRounding = 1e-5;     // of rooms [m]
constexpr double kSameRoom = 1e-3;     // [m]
constexpr float kBucket = 0.002f;      // of costs that are about as high [m]
constexpr double kRoomInSight = 0.04;  // beside a straight line, where there is as much [m]

constexpr std::array<std::array<int, 2>, 8> kAround = {
    {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {1, -1}, {-1, 1}, {-1, -1}}};

// Of the distance to a place along an axis, for each column (axis 0) or row of cells, its square
// [m^2].
std::vector<double> squaresTo(const ClearanceMap& map, int place, int axis) {
  std::vector<double> squares(map.cells()[axis]);
  const double there = map.middle(axis, map.cellOf(place)[axis]);
  for (size_t i = 0; i < squares.size(); ++i) {
    const double off = map.middle(axis, static_cast<int>(i)) - there;
    squares[i] = off * off;
  }
  return squares;
}

// Distances in plan from the cells of a map to one of its places, without a multiplication.
class DistanceTo {
 public:
  DistanceTo(const ClearanceMap& map, int place)
      : along_x_(squaresTo(map, place, 0)), along_y_(squaresTo(map, place, 1)) {}
  double from(int x, int y) const { return std::sqrt(along_x_[x] + along_y_[y]); }  // [m]

 private:
  std::vector<double> along_x_, along_y_;
};

}  // namespace

WayFinder::WayFinder(std::shared_ptr<const ClearanceMap> map, const Eigen::Vector3d& from,
                     const Eigen::Vector3d& to, double shortest, std::function<bool()> stopped)
    : map_(std::move(map)),
      from_(map_->placeAt(from)),
      to_(map_->placeAt(to)),
      shortest_(shortest),
      stopped_(std::move(stopped)),
      penalty_(map_->size(), 0.0f) {}

// How many times its length a way by this place counts.
double WayFinder::factor(int place) const {
  const double spare = map_->spare(place);
  if (spare >= kComfort) return 1.0 + penalty_[place];
  const double unease = kUnease * std::max(0.0, (kComfort - spare) / kComfort);
  const double squeeze = kSqueeze * std::max(0.0, spare / kTightest);
  return 1.0 + unease + squeeze + penalty_[place];
}

bool WayFinder::isNear(int place, int end) const {
  return (map_->at(place) - map_->at(end)).head<2>().norm() < kNearEnd;
}

// Least room that a way may have by a place. Who is asked to stand nearer to things than he walks
// comes from there, or goes there, by places as near to them.
double WayFinder::tightest(int place) const {
  double least = kTightest;
  for (const int end : {from_, to_})
    if (isNear(place, end)) least = std::min(least, map_->spare(end) - 0.5 * map_->cell());
  return least;
}

// Places from end to end; none where the map knows no way. A place goes on again only once it is
// known to be reached at less cost.
std::vector<int> WayFinder::cheapest() const {
  if (from_ < 0 || to_ < 0) return {};
  const double diagonal = map_->cell() * std::hypot(1, 1);
  const DistanceTo goal(*map_, to_);
  struct Reached {
    float cost = HUGE_VALF;
    int before = -1;
  };
  std::vector<Reached> reached(map_->size());
  std::vector<bool> went_on(map_->size(), false);
  BucketQueue open(kBucket);
  const auto reach = [&](int place, int x, int y, const Reached& by) {
    reached[place] = by;
    went_on[place] = false;
    open.push(by.cost + static_cast<float>(goal.from(x, y)), place);
  };
  const Eigen::Vector2i begin = map_->cellOf(from_);
  reach(from_, begin.x(), begin.y(), {0.0f, -1});
  for (long long i = 0; !open.empty(); ++i) {
    if (i % kPlacesEvery == 0 && stopped_()) return {};
    const int place = open.pop();
    if (place == to_) break;
    if (went_on[place]) continue;
    went_on[place] = true;
    // Waiting for memory is most of what it costs on a large map.
    if (const int soon = open.soon(); soon >= 0)
      for (const int row : map_->fetch(soon)) __builtin_prefetch(reached.data() + row);
    const float cost = reached[place].cost;
    const double height = map_->height(place);
    const Eigen::Vector2i cell = map_->cellOf(place);
    for (const auto& [dx, dy] : kAround) {
      const int other = map_->beside(place, dx, dy);
      if (other < 0) continue;
      double length = dx != 0 && dy != 0 ? diagonal : map_->cell();
      if (map_->height(other) != height)
        length += kWayOfClimb * std::abs(map_->height(other) - height);
      // No factor is less than 1: most places are known to be reached as well already.
      if (cost + static_cast<float>(length) >= reached[other].cost) continue;
      if (map_->spare(other) < kTightest && map_->spare(other) < tightest(other)) continue;
      const float total = cost + static_cast<float>(length * factor(other));
      if (total < reached[other].cost) reach(other, cell.x() + dx, cell.y() + dy, {total, place});
    }
  }
  std::vector<int> way;
  if (reached[to_].before < 0 && to_ != from_) return way;
  for (int place = to_; place >= 0; place = reached[place].before) way.push_back(place);
  std::reverse(way.begin(), way.end());
  return way;
}

// Whether a straight line from place to place has so much room beside it everywhere, and leads by
// no place of a higher penalty.
bool WayFinder::isClear(int from, int to, double least, float most) const {
  const Eigen::Vector2d a = map_->at(from).head<2>(), b = map_->at(to).head<2>();
  const double cell = map_->cell();
  const int count = static_cast<int>(std::ceil((b - a).norm() / cell));
  int place = from;
  for (int i = 1; i <= count; ++i) {
    const Eigen::Vector2d p = a + (b - a) * i / count, off = (p - map_->at(place).head<2>()) / cell;
    const int dx = static_cast<int>(std::lround(off.x())),
              dy = static_cast<int>(std::lround(off.y()));
    if (dx != 0 || dy != 0) place = map_->beside(place, dx, dy);
    if (place < 0 || map_->spare(place) < least || penalty_[place] > most) return false;
  }
  return place == to;
}

bool WayFinder::isLevel(int place) const {
  const double height = map_->at(place).z();
  const int far = static_cast<int>(kLevelNear / map_->cell());
  for (const auto& [dx, dy] : kAround) {
    int other = place;
    for (int i = 0; i < far && other >= 0; ++i) other = map_->beside(other, dx, dy);
    if (other >= 0 && std::abs(map_->at(other).z() - height) > kSameHeight) return false;
  }
  return true;
}

// Of a way the farthest place that is seen from one of its places: along a straight line that has
// as much room beside it as the way, and is no worse.
int WayFinder::farthestSeen(const std::vector<int>& way, int here) const {
  const int last = static_cast<int>(way.size()) - 1;
  const int farthest = static_cast<int>(kFarthest / map_->cell());
  double narrowest = kRoomInSight;
  float worst = penalty_[way[here]];
  int seen = here;
  for (int next = here + 1; next <= std::min(last, here + farthest); ++next) {
    narrowest = std::min(narrowest, map_->spare(way[next]));
    worst = std::max(worst, penalty_[way[next]]);
    if (isClear(way[here], way[next], narrowest - 0.5 * map_->cell(), worst)) seen = next;
  }
  return seen;
}

// Where one stands who goes from one place of a way as far as he sees: there, or a little before
// that where there is more room; over stairs on to where it is level again. -1: nowhere.
int WayFinder::standNear(const std::vector<int>& way, int here, int seen) const {
  const int last = static_cast<int>(way.size()) - 1;
  const int nearest = here + static_cast<int>(std::ceil(shortest_ / map_->cell()));
  const int back = static_cast<int>(kRoomSought / map_->cell());
  int best = -1;
  for (int i = std::max(nearest, seen - back); i <= std::max(nearest, seen) && i < last; ++i) {
    if (!isLevel(way[i])) continue;
    if (best < 0 || map_->spare(way[i]) > map_->spare(way[best])) best = i;
  }
  for (int i = seen + 1; best < 0 && i < last; ++i)
    if (isLevel(way[i])) best = i;
  return best;
}

// Of a way the places where one turns, its ends left out.
std::vector<int> WayFinder::corners(const std::vector<int>& way) const {
  std::vector<int> corners;
  for (int here = 0;;) {
    const int seen = farthestSeen(way, here);
    if (seen + 1 == static_cast<int>(way.size())) return corners;
    here = standNear(way, here, seen);
    if (here < 0) return corners;
    corners.push_back(way[here]);
  }
}

std::optional<std::vector<Stance>> WayFinder::next() {
  const std::vector<int> way = cheapest();
  if (way.size() < 2) return std::nullopt;
  std::vector<Stance> stances;
  Eigen::Vector3d before = map_->at(from_);
  for (const int place : corners(way)) {
    Stance stance;
    stance.position = map_->at(place);
    const Eigen::Vector3d along = stance.position - before;
    stance.heading = std::atan2(along.y(), along.x());
    before = stance.position;
    stances.push_back(stance);
  }
  return stances;
}

// From end to end by the widest way: of all places that are reached the roomiest goes on first, of
// those with the same room the nearest by the way. So what is in the way from side to side is
// crossed where one comes to it, and not beside a wall.
std::vector<int> WayFinder::widest() const {
  if (from_ < 0 || to_ < 0) return {};
  struct Open {
    long room;     // [kSameRoom]
    float length;  // from the begin [m]
    int place;
    bool operator<(const Open& other) const {  // whether the other goes on first
      return std::tie(room, other.length, place) < std::tie(other.room, length, other.place);
    }
  };
  std::vector<int> before(map_->size(), -1);
  std::priority_queue<Open> open;
  open.push({0, 0.0f, from_});
  before[from_] = from_;
  for (long long i = 0; !open.empty() && before[to_] < 0; ++i) {
    if (i % kPlacesEvery == 0 && stopped_()) return {};
    const Open here = open.top();
    open.pop();
    for (const auto& [dx, dy] : kAround) {
      const int other = map_->beside(here.place, dx, dy);
      if (other < 0 || before[other] >= 0) continue;
      before[other] = here.place;
      open.push({std::lround(map_->spare(other) / kSameRoom),
                 here.length + static_cast<float>(map_->cell() * std::hypot(dx, dy)), other});
    }
  }
  std::vector<int> way;
  if (before[to_] < 0) return way;
  for (int place = to_; place != from_; place = before[place]) way.push_back(place);
  way.push_back(from_);
  std::reverse(way.begin(), way.end());
  return way;
}

std::optional<WayGuide::Narrow> WayFinder::narrowest() const {
  const std::vector<int> way = widest();
  const auto isEnd = [&](int place) { return isNear(place, from_) || isNear(place, to_); };
  int narrow = -1;
  for (int i = 0; i < static_cast<int>(way.size()); ++i) {
    if (!isEnd(way[i]) && (narrow < 0 || map_->spare(way[i]) < map_->spare(way[narrow])))
      narrow = i;
  }
  if (narrow < 0 || map_->spare(way[narrow]) > kRoomInSight) return std::nullopt;
  const int far = static_cast<int>(kAcross / map_->cell());
  const int first = std::max(narrow - far, 0);
  const int last = std::min<int>(narrow + far, static_cast<int>(way.size()) - 1);
  const Eigen::Vector3d across = map_->at(way[last]) - map_->at(way[first]);
  bool on_steps = false;
  for (int i = first; i < last; ++i)
    on_steps |= std::abs(map_->height(way[i + 1]) - map_->height(way[i])) > kStep;
  const double room = map_->spare(way[narrow]);
  return Narrow{map_->at(way[narrow]), std::atan2(across.y(), across.x()), room >= kTightest,
                room <= kRounding - map_->leastBreadth(), on_steps};
}

void WayFinder::avoid(const Eigen::Vector3d& at) {
  for (int place = 0; place < map_->size(); ++place) {
    const double distance = (map_->at(place) - at).head<2>().norm();
    if (distance < kRefusedNear)
      penalty_[place] += static_cast<float>(kRefused * (1.0 - distance / kRefusedNear));
  }
}

}  // namespace amble

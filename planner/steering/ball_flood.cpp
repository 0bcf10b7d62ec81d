#include "planner/steering/ball_flood.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>
#include <utility>

namespace amble {
namespace {

constexpr double kMostSquares = 1e8;       // of a flood; larger ones are not begun
constexpr size_t kMostOfReport = 4000000;  // of a part that is flooded to be told of only
constexpr double kStackLevels = 0.01;      // between heights at which a stack is tried [m]
constexpr double kLevels = 0.03;           // between heights at which a ball is tried [m]
constexpr int kFinerLevels = 4;            // so many between two of them
constexpr double kOfEnds = 1e-6;           // rounding of where things end [m]
constexpr int kStopEvery = 1 << 10;        // squares between looks at the clock

}  // namespace

FloodGround::FloodGround(const SceneGround& ground, const ReachedGround& reached, double stature,
                         double longest_step, double high, double beyond)
    : range(ground, reached, BodyReach::kFeet * stature),
      chords(ground, reached, longest_step),
      near_body(ground, reached, longest_step, std::min(BodyReach::kBeyond, beyond)),
      near_legs(ground, reached, longest_step, std::min(BodyReach::kLegsBeyond, beyond)),
      near_post(ground, reached, longest_step, 0.0),
      edges(ground, near_body, range, stature, high) {}

BallFlood::BallFlood(const Ball& ball, double square, const Eigen::Vector3d& from,
                     const Eigen::Vector3d& to, const CollisionWorld& world,
                     const SceneGround& ground, const FloodGround& around, double beyond,
                     CollisionScratch& scratch)
    : ball_(ball),
      around_(around),
      ground_(ground),
      cells_(ground.cells()),
      square_(square),
      from_(from),
      to_(to),
      world_(world),
      scratch_(scratch) {
  beyond = std::min(beyond, ball.beyond);
  Eigen::AlignedBox2d region = ground.extent();
  region.extend(from.head<2>().eval()).extend(to.head<2>().eval());
  min_ = region.min().array() - beyond;
  const Eigen::Array2d squares = (region.sizes().array() + 2.0 * beyond) / square_ + 1.0;
  if (squares.prod() > kMostSquares) return;
  count_ = squares.cast<int>();
  reached_.assign(static_cast<size_t>(count_.x()) * count_.y(), kUnknown);
}

// What a ball touches there at every height between: all of one that is smaller by the distance of
// their middles is in it. One in the middle tells it of most places, few of most others, and many
// of those that are hardly touched.
int BallFlood::touchedAtAll(const Eigen::Vector2d& p, double low, double high,
                            double radius) const {
  const double middle = 0.5 * (low + high), half = 0.5 * (high - low);
  if (radius > half) {
    const int there = touched(p, middle, middle, radius - half);
    if (there >= 0) return there;
  }
  const int first = touched(p, middle, middle, radius);
  if (first < 0) return -1;
  const auto everywhere = [&](int count) {
    const double step = (high - low) / count;
    if (radius <= 0.5 * step) return false;
    for (int i = 0; i < count; ++i) {
      const double z = low + (i + 0.5) * step;
      if (touched(p, z, z, radius - 0.5 * step) < 0) return false;
    }
    return true;
  };
  const int few = 1 + static_cast<int>((high - low) / kLevels);
  return everywhere(few) || everywhere(kFinerLevels * few) ? first : -1;
}

// Between these heights over the ground the body is carried there.
Eigen::AlignedBox1d BallFlood::carried(const Eigen::Vector2d& p, const Eigen::AlignedBox1d& feet) {
  const Eigen::Vector2i at = cells_.squareAt(p);
  const auto [known, is_new] = chords_.try_emplace(std::pair(at.x(), at.y()));
  if (is_new) known->second = around_.chords.through(p);
  const Eigen::AlignedBox1d both = known->second.intersection(feet);
  return both.isEmpty() ? feet : both;
}

// Of what is carried over stairs and slopes. What is over an upright head goes on up to a height
// over the lower foot: where the head's upper end is anywhere below that, it is there.
int BallFlood::touchedOnUneven(const Eigen::Vector2d& p, const Eigen::AlignedBox1d& feet,
                               double radius) {
  const Eigen::AlignedBox1d body = carried(p, feet);
  const double low = body.min()[0] + ball_.carried.min()[0];
  const double high = body.max()[0] + ball_.carried.max()[0];
  const double upright = feet.min()[0] + ball_.upright;
  return upright > high ? touched(p, high, upright, radius)
                        : touchedAtAll(p, std::max(low, upright), high, radius);
}

// Whether swings by way of that square are refused for what ends over it: wherever in the square a
// sole's middle passes, they look at so much around it, and see of each triangle the highest that
// is in the strip they look at. So one that does not go on higher anywhere is seen.
bool BallFlood::isTooHigh(const Eigen::Vector2d& p, const Eigen::AlignedBox1d& feet) const {
  const double half = (ball_.looks - std::sqrt(0.5) * square_) / std::sqrt(2.0);
  if (half <= 0.0) return false;
  const double low = feet.max()[0] + feet.sizes()[0] + ball_.too_high.min()[0];
  const double high = feet.min()[0] + ball_.too_high.max()[0] - kOfEnds;
  const Eigen::AlignedBox2d box(p.array() - half, p.array() + half);
  bool found = false;
  ground_.all().visitBox(box, [&](int t) {
    const Triangle3& thing = ground_.all().triangles()[t];
    if (found || std::max({thing[0].z(), thing[1].z(), thing[2].z()}) > high) return;
    const auto within = heightsWithin(thing, box);
    found = within && within->high > low;
  });
  return found;
}

// A foot over things: what is solid up to where it may be, or up to what no swing goes over. Feet
// are lifted by as much more as one print is over the other.
int BallFlood::touchedByFoot(const Eigen::Vector2d& p, const Eigen::AlignedBox1d& feet,
                             double radius) const {
  const double low = feet.min()[0] + ball_.height;
  const double high = feet.max()[0] + ball_.highest + feet.sizes()[0];
  if (!ball_.too_high.isEmpty()) {
    const double up_to = feet.max()[0] + feet.sizes()[0] + ball_.too_high.min()[0];
    const int there = touchedAtAll(p, low, std::min(high, up_to), radius);
    if (there < 0 || isTooHigh(p, feet)) return there;
  }
  return touchedAtAll(p, low, high, radius);
}

// However high the hips are. What is between two heights that are tried is so near to one of them.
int BallFlood::touchedByStack(const Eigen::Vector2d& p, const Eigen::AlignedBox1d& feet) const {
  const std::vector<StackedBall>& stack = ball_.stack.balls;
  const double low = feet.min()[0] - ball_.stack.sway - BodyReach::kDip;
  const double high = feet.max()[0] + ball_.stack.sway + BodyReach::kRise;
  const int any = touched(p, low + stack.front().height, high + stack.back().height, ball_.radius);
  if (any < 0) return kNothing;
  const int count = 1 + static_cast<int>((high - low) / kStackLevels);
  const double step = (high - low) / count, less = 0.5 * step + std::sqrt(0.5) * square_;
  for (int i = 0; i < count; ++i) {
    const double z = low + (i + 0.5) * step;
    const bool is_touched = std::ranges::any_of(stack, [&](const StackedBall& own) {
      const double radius = own.radius - less;
      return radius > 0.0 && touched(p, z + own.height, z + own.height, radius) >= 0;
    });
    if (!is_touched) return kNothing;
  }
  return any;
}

// What the ball touches wherever in the square it is, kNothing: perhaps nothing; kNoGround where it
// would touch nothing, but none of the square is where somebody is who stands on ground.
int BallFlood::object(const Eigen::Vector2d& p) {
  const double far = std::sqrt(0.5) * square_;
  const NearGround& near = around_.near(ball_);
  const bool over = near.isOver(p);
  if (!over && !near.has(p, far)) return kNoGround;
  const int there = thing(p);
  return there != kNothing || over || around_.edges.has(p, far) ? there : kNoGround;
}

// The same wherever the square is, and whatever of the ground around the feet stand on.
int BallFlood::thing(const Eigen::Vector2d& p) {
  const Eigen::AlignedBox1d feet = around_.range.around(p);
  if (feet.isEmpty()) return kNothing;
  const double rise = feet.sizes()[0], radius = ball_.radius - std::sqrt(0.5) * square_;
  if (rise > ball_.most_rise) return kNothing;
  if (!ball_.stack.balls.empty()) return touchedByStack(p, feet);
  if (ball_.isFoot()) return touchedByFoot(p, feet, radius);
  const double low = feet.min()[0] + ball_.height;
  const double high = feet.max()[0] + ball_.highest;
  if (ball_.isTrunk() && rise <= SceneGround::kLevel) return touchedAtAll(p, low, high, radius);
  if (rise <= SceneGround::kLevel) return touched(p, high, feet.min()[0] + ball_.top, radius);
  return ball_.isLeg() ? touched(p, high, high, radius) : touchedOnUneven(p, feet, radius);
}

// What is known of a square, which is looked at the first time that it is asked about.
std::uint8_t BallFlood::look(int square, std::uint8_t if_open) {
  std::uint8_t& known = reached_[square];
  if (known != kUnknown) return known;
  const int there = object(middle(square));
  return known = there == kNothing ? if_open : there == kNoGround ? kFar : kShut;
}

// Whether visit(square) says yes of any, each of which is asked: of a square and those around it.
template <typename Visit>
bool BallFlood::anyAround(int square, Visit visit) const {
  const int x = square % count_.x(), y = square / count_.x();
  bool any = false;
  for (int j = std::max(0, y - 1); j <= std::min(count_.y() - 1, y + 1); ++j) {
    for (int i = std::max(0, x - 1); i <= std::min(count_.x() - 1, x + 1); ++i)
      any = visit(j * count_.x() + i) || any;
  }
  return any;
}

// The same of those that the ball may be at who stands at an end.
template <typename Visit>
bool BallFlood::anyBeside(const Eigen::Vector3d& end, Visit visit) const {
  const int far = static_cast<int>(std::ceil(ball_.aside / square_));
  const Eigen::Vector2i at = ((end.head<2>() - min_) / square_).cast<int>();
  bool any = false;
  for (int y = std::max(0, at.y() - far); y <= std::min(count_.y() - 1, at.y() + far); ++y) {
    for (int x = std::max(0, at.x() - far); x <= std::min(count_.x() - 1, at.x() + far); ++x)
      any = visit(y * count_.x() + x) || any;
  }
  return any;
}

// Whether a way leads from end to end, of both in turn what is nearest to the other first; none
// where it is stopped.
std::optional<bool> BallFlood::meets(const std::function<bool()>& stopped) {
  using Open = std::pair<double, int>;  // distance, square
  std::array<std::priority_queue<Open, std::vector<Open>, std::greater<>>, 2> open;
  const auto see = [&](int square, int side) {
    const auto mine = static_cast<std::uint8_t>(kSeen + side);
    const bool is_new = reached_[square] == kUnknown;
    const std::uint8_t known = look(square, mine);
    if (is_new && known == mine)
      open[side].emplace((middle(square) - (side == 0 ? to_ : from_).head<2>()).norm(), square);
    return known == kSeen + 1 - side;
  };
  if (anyBeside(from_, [&](int square) { return see(square, 0); }) ||
      anyBeside(to_, [&](int square) { return see(square, 1); }))
    return true;
  for (long long i = 0;; ++i) {
    if (i % kStopEvery == 0 && stopped()) return std::nullopt;
    for (const int side : {0, 1}) {
      if (open[side].empty()) return false;
      const int next = open[side].top().second;
      open[side].pop();
      if (anyAround(next, [&](int square) { return see(square, side); })) return true;
    }
  }
}

// @return whether the other side has been there
bool BallFlood::reach(int square, int side) {
  const auto mine = static_cast<std::uint8_t>(1 + side);
  const bool is_new = reached_[square] == kUnknown || reached_[square] >= kSeen;
  if (reached_[square] >= kSeen) reached_[square] = mine;
  const std::uint8_t known = look(square, mine);
  if (is_new && known == mine) squares_[side].push_back(square);
  return !is_new && known == 2 - side;
}

bool BallFlood::spread(int square, int side) {
  return anyAround(square, [&](int other) { return reach(other, side); });
}

bool BallFlood::isShut(const std::function<bool()>& stopped) {
  if (reached_.empty()) return false;
  const auto met = meets(stopped);
  if (!met || *met) return false;
  anyBeside(from_, [&](int square) { return reach(square, 0); });
  anyBeside(to_, [&](int square) { return reach(square, 1); });
  for (long long i = 0;; ++i) {
    if (i % kStopEvery == 0 && stopped()) return false;
    for (const int side : {0, 1}) {
      if (next_[side] >= squares_[side].size()) return true;
      spread(squares_[side][next_[side]++], side);
    }
  }
}

// Goes on from one end; whether all is reached that is, with so many squares at most.
bool BallFlood::flood(int side, size_t most) {
  while (next_[side] < squares_[side].size() && next_[side] < most)
    spread(squares_[side][next_[side]++], side);
  return next_[side] >= squares_[side].size();
}

// From the part that is flooded, the smaller, through shut squares, ring by ring, to the other; of
// squares that are reached in the same ring the one that is least out of the way. Past what has no
// ground only where there is no other way: nothing is named there. Of a part too large to be
// flooded for a report any square will do that is not shut.
BodyReach::Barrier BallFlood::barrier() {
  std::vector<int> way = wayOut(true);
  if (way.empty()) way = wayOut(false);
  return way.empty() ? Barrier{ball_.part, -1, to_, from_, to_} : between(std::move(way));
}

// From a square of the larger part back to one of the smaller; empty where none is found.
std::vector<int> BallFlood::wayOut(bool over_ground) {
  const int small = next_[0] >= squares_[0].size() ? 0 : 1, large = 1 - small;
  const bool is_known = flood(large, kMostOfReport);
  std::vector<int> before(reached_.size(), -1), ring = squares_[small];
  for (const int square : ring) before[square] = square;
  int best = -1;
  while (best < 0 && !ring.empty()) {
    std::vector<int> next;
    for (const int square : ring) {
      const int x = square % count_.x(), y = square / count_.x();
      for (const auto& [dx, dy] : {std::pair(1, 0), {-1, 0}, {0, 1}, {0, -1}}) {
        if (x + dx < 0 || y + dy < 0 || x + dx >= count_.x() || y + dy >= count_.y()) continue;
        const int other = square + dy * count_.x() + dx;
        if (before[other] >= 0) continue;
        if (over_ground && !around_.near(ball_).has(middle(other))) continue;
        before[other] = square;
        next.push_back(other);
        if (!is_known) reach(other, large);
        if (reached_[other] == 1 + large && (best < 0 || detour(other) < detour(best)))
          best = other;
      }
    }
    ring = std::move(next);
  }
  if (best < 0) return {};
  std::vector<int> way = {best};
  while (before[way.back()] != way.back()) way.push_back(before[way.back()]);
  return way;
}

// Of the way back from a square of the other part the middle, where something is in the way. Where
// it comes out before, between two things that shut off one after another, of the way to there.
BodyReach::Barrier BallFlood::between(std::vector<int> way) {
  const auto out = std::find_if(way.rbegin() + 1, way.rend() - 1,
                                [&](int square) { return object(middle(square)) == kNothing; });
  way.erase(way.begin(), out.base() - 1);
  const Eigen::Vector2d far = middle(way.front()), near = middle(way.back());
  Barrier barrier{ball_.part, -1, from_, from_, from_};
  const Eigen::Vector2d at = middle(way[way.size() / 2]);
  const Eigen::AlignedBox1d ground = around_.range.around(at);
  const double z = ground.isEmpty() ? from_.z() : ground.min()[0];
  barrier.far << far, z;
  barrier.near << near, z;
  barrier.object = std::max(-1, object(at));
  barrier.at << at, z + ball_.height;
  return barrier;
}

}  // namespace amble

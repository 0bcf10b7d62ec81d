#include "planner/steering/body_reach.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <utility>

#include "animation/steps/swing_path.h"
#include "base/ease.h"
#include "base/parallel.h"
#include "environments/ground/ground_cells.h"
#include "planner/steering/edge_reach.h"
#include "planner/steering/ground_chords.h"
#include "planner/steering/ground_range.h"
#include "planner/steering/near_ground.h"
#include "planner/steering/open_way.h"

namespace amble {
namespace {

constexpr double kMostSquares = 1e8;       // of a flood; larger ones are not begun
constexpr double kMostFinest = 2e6;        // the same of the second one
constexpr size_t kMostOfReport = 4000000;  // of a part that is flooded to be told of only
// Of a ball's radius, half a square's diagonal.
constexpr double kOfRadius = 0.4;
// Of a leg from the path, at any height [m].
constexpr double kOfLegs = 0.5;
constexpr double kLowestHips = 0.4;  // of stature
// The feet of who has a ball at a place are no farther from there, of stature.
constexpr double kFeet = 0.5;
constexpr double kLevels = 0.03;     // between heights at which a ball is tried [m]
constexpr int kFinerLevels = 4;      // so many between two of them
constexpr int kStopEvery = 1 << 10;  // squares between looks at the clock
// Of the floods over what all balls pass, and what one passes that is asked about finely [m].
constexpr double kOpenSquare = 0.2, kFinerOpenSquare = 0.04;

// Share of a foot's extra lift that it may have that far through its swing (SwingShape).
double mostOfLift(double tau) {
  const double ramp = *std::ranges::min_element(SwingSearch::kRamps);
  return tau <= 0.0 ? 0.0 : minimumJerk(tau / ramp) * minimumJerk((1.0 - tau) / ramp);
}

}  // namespace

BodyReach::BodyReach(const StraightWalk& walk, const Skeleton& skeleton, const JointRoles& roles,
                     const Body& body, double stature, double highest_step, double longest_step,
                     double highest_lift)
    : stature_(stature), longest_step_(longest_step) {
  if (walk.buffer.size() == 0) return;
  const std::vector<PartWay> ways = waysOfParts(walk, skeleton, body);
  for (int part = 0; part < static_cast<int>(body.parts.size()); ++part) {
    const BodyPart& own = body.parts[part];
    const PartWay& way = ways[part];
    Ball ball;
    ball.part = part;
    ball.radius = own.radius;
    ball.aside = way.aside + kDip;
    ball.height = way.middle.min()[0] - kDip;
    ball.highest = ball.top = way.middle.max()[0] + kRise;
    ball.carried = {way.middle.min()[0] - kUnevenDip, way.middle.max()[0] + kUnevenRise};
    if (part == body.head) {
      // A head that may stoop is anywhere between, as pelvis and chest are.
      if (body.upright > 0.0) {
        ball.height = ball.highest;
        ball.upright = body.upright - own.radius;
        ball.top = std::max(ball.highest, ball.upright);
      }
      ball.carried = {way.upper.min()[0] - kUnevenDip, way.upper.max()[0] + kUnevenRise};
    } else if (own.joint == roles.legs[kLeft].leg || own.joint == roles.legs[kRight].leg) {
      // The leg, from the hip to the ankle, crosses this height once, with the thigh or the shank.
      ball.height = ball.highest = ball.top =
          std::max(highest_step, highest_lift) + kAnkle * stature;
      ball.most_rise = kLowestHips * stature - ball.height;
      ball.aside = kOfLegs;
      ball.beyond = kLegsBeyond;
      ball.carried = {};
      if (ball.most_rise <= 0.0) continue;
    } else if (own.joint != roles.hips && own.name != "chest") {
      continue;
    }
    balls_.push_back(ball);
  }
  std::stable_sort(balls_.begin(), balls_.end(), [](const Ball& a, const Ball& b) {
    if (a.isTrunk() != b.isTrunk()) return b.isTrunk();
    return a.radius > b.radius;
  });
  addFeet(walk, skeleton, roles, body, highest_lift);
  addPost(roles, body);
}

void BodyReach::addPost(const JointRoles& roles, const Body& body) {
  const auto hips = std::ranges::find(body.parts, roles.hips, &BodyPart::joint);
  if (hips == body.parts.end()) return;
  Ball post;
  post.part = static_cast<int>(hips - body.parts.begin());
  post.radius = kPostRadius * stature_;
  post.height = kPostLow * stature_;
  post.highest = post.top = kPostHigh * stature_;
  post.most_rise = SceneGround::kLevel;
  post.aside = kOfLegs;
  post.beyond = 0.0;
  post.post = true;
  balls_.push_back(post);
}

// Of each foot the front end of one of its soles, which swings lower than the heel.
void BodyReach::addFeet(const StraightWalk& walk, const Skeleton& skeleton, const JointRoles& roles,
                        const Body& body, double highest_lift) {
  std::vector<JointFrame> joints(skeleton.size());
  for (const Side side : {kLeft, kRight}) {
    const auto part = std::find_if(body.parts.begin(), body.parts.end(), [&](const BodyPart& own) {
      return own.sole == side && own.joint == roles.legs[side].foot;
    });
    if (part == body.parts.end()) continue;
    Eigen::AlignedBox1d heights;
    for (int frame = 0; frame < walk.buffer.size(); ++frame) {
      const FrameState& state = walk.buffer.states[frame];
      forwardKinematics(skeleton, walk.buffer.poses[frame], joints);
      const double z = (joints[part->joint] * part->to).z() - state.position.z();
      const double most = highest_lift * mostOfLift(state.feet[side].at - 1.0);
      heights.extend(Eigen::AlignedBox1d(z, z + most));
    }
    Ball ball;
    ball.part = static_cast<int>(part - body.parts.begin());
    ball.radius = part->radius;
    ball.height = heights.min()[0] - kRise;
    ball.highest = ball.top = heights.max()[0] + kRise;
    ball.most_rise = SceneGround::kLevel;
    ball.aside = kOfLegs;
    ball.beyond = kLegsBeyond;
    balls_.push_back(ball);
  }
}

// What holds balls, all of them, wherever they are carried.
UprightPost BodyReach::postAround(std::span<const Ball> balls) const {
  UprightPost post{HUGE_VAL, 0.0, kFeet * stature_, 0.0, HUGE_VAL};
  for (const Ball& ball : balls) {
    post.low = std::min(post.low, ball.height);
    post.high = std::max({post.high, ball.highest, ball.top});
    post.radius = std::max(post.radius, ball.radius);
    post.aside = std::min(post.aside, ball.aside);
  }
  return post;
}

// What the floods ask of the ground.
struct BodyReach::Around {
  Around(const SceneGround& ground, const ReachedGround& reached, double stature,
         double longest_step, double high, double beyond)
      : range(ground, reached, kFeet * stature),
        chords(ground, reached, longest_step),
        near_body(ground, reached, longest_step, std::min(kBeyond, beyond)),
        near_legs(ground, reached, longest_step, std::min(kLegsBeyond, beyond)),
        near_post(ground, reached, longest_step, 0.0),
        edges(ground, near_body, range, stature, high) {}
  const NearGround& near(const Ball& ball) const {
    return ball.post ? near_post : ball.isLeg() ? near_legs : near_body;
  }

  GroundRange range;
  GroundChords chords;
  NearGround near_body, near_legs, near_post;
  EdgeReach edges;
};

// Of one ball, from both ends in turn.
class BodyReach::Flood {
 public:
  Flood(const Ball& ball, double square, const Eigen::Vector3d& from, const Eigen::Vector3d& to,
        const CollisionWorld& world, const SceneGround& ground, const Around& around, double beyond,
        CollisionScratch& scratch)
      : ball_(ball),
        around_(around),
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

  // Whether start and goal are in different parts; no where it is stopped.
  bool isShut(const std::function<bool()>& stopped);
  Barrier barrier();  // @pre isShut

 private:
  static constexpr std::uint8_t kUnknown = 0, kShut = 3, kFar = 4;  // reached from: 1, 2
  static constexpr int kNothing = -1, kNoGround = -2;               // in place of objects

  Eigen::Vector2d middle(int square) const {
    return min_ + square_ * Eigen::Vector2d(square % count_.x() + 0.5, square / count_.x() + 0.5);
  }
  double detour(int square) const {
    const Eigen::Vector2d p = middle(square);
    return (p - from_.head<2>()).norm() + (p - to_.head<2>()).norm();
  }
  int touched(const Eigen::Vector2d& p, double low, double high, double radius) const {
    return world_.touched({p.x(), p.y(), low}, {p.x(), p.y(), high}, radius, scratch_);
  }
  int touchedAtAll(const Eigen::Vector2d& p, double low, double high, double radius) const;
  Eigen::AlignedBox1d carried(const Eigen::Vector2d& p, const Eigen::AlignedBox1d& feet);
  int touchedOnUneven(const Eigen::Vector2d& p, const Eigen::AlignedBox1d& feet, double radius);
  int object(const Eigen::Vector2d& p);
  int thing(const Eigen::Vector2d& p);
  std::vector<int> wayOut(bool over_ground);
  Barrier between(std::vector<int> way);
  bool begin(const Eigen::Vector3d& end, int side);
  bool reach(int square, int side);
  bool spread(int square, int side);
  bool flood(int side, size_t most);

  const Ball& ball_;
  const Around& around_;
  const GroundCells& cells_;
  const double square_;  // side [m]
  const Eigen::Vector3d from_, to_;
  const CollisionWorld& world_;
  CollisionScratch& scratch_;
  Eigen::Vector2d min_{0, 0};
  Eigen::Vector2i count_{0, 0};
  std::vector<std::uint8_t> reached_;        // by square
  std::array<std::vector<int>, 2> squares_;  // reached from each end, in order
  std::array<size_t, 2> next_ = {0, 0};      // of them whose neighbours are to be looked at
  std::map<std::pair<int, int>, Eigen::AlignedBox1d> chords_;  // by square of the cells
};

// What a ball touches there at every height between: all of one that is smaller by the distance of
// their middles is in it. One in the middle tells it of most places, few of most others, and many
// of those that are hardly touched.
int BodyReach::Flood::touchedAtAll(const Eigen::Vector2d& p, double low, double high,
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
Eigen::AlignedBox1d BodyReach::Flood::carried(const Eigen::Vector2d& p,
                                              const Eigen::AlignedBox1d& feet) {
  const Eigen::Vector2i at = cells_.squareAt(p);
  const auto [known, is_new] = chords_.try_emplace(std::pair(at.x(), at.y()));
  if (is_new) known->second = around_.chords.through(p);
  const Eigen::AlignedBox1d both = known->second.intersection(feet);
  return both.isEmpty() ? feet : both;
}

// Of what is carried over stairs and slopes. What is over an upright head goes on up to a height
// over the lower foot: where the head's upper end is anywhere below that, it is there.
int BodyReach::Flood::touchedOnUneven(const Eigen::Vector2d& p, const Eigen::AlignedBox1d& feet,
                                      double radius) {
  const Eigen::AlignedBox1d body = carried(p, feet);
  const double low = body.min()[0] + ball_.carried.min()[0];
  const double high = body.max()[0] + ball_.carried.max()[0];
  const double upright = feet.min()[0] + ball_.upright;
  return upright > high ? touched(p, high, upright, radius)
                        : touchedAtAll(p, std::max(low, upright), high, radius);
}

// What the ball touches wherever in the square it is, kNothing: perhaps nothing; kNoGround where it
// would touch nothing, but none of the square is where somebody is who stands on ground.
int BodyReach::Flood::object(const Eigen::Vector2d& p) {
  const double far = std::sqrt(0.5) * square_;
  const NearGround& near = around_.near(ball_);
  const bool over = near.isOver(p);
  if (!over && !near.has(p, far)) return kNoGround;
  const int there = thing(p);
  return there != kNothing || over || around_.edges.has(p, far) ? there : kNoGround;
}

// The same wherever the square is, and whatever of the ground around the feet stand on.
int BodyReach::Flood::thing(const Eigen::Vector2d& p) {
  const Eigen::AlignedBox1d feet = around_.range.around(p);
  if (feet.isEmpty()) return kNothing;
  const double rise = feet.sizes()[0], radius = ball_.radius - std::sqrt(0.5) * square_;
  if (rise > ball_.most_rise) return kNothing;
  const double low = feet.min()[0] + ball_.height;
  // Feet are lifted by as much more as one print is over the other.
  const double high = feet.max()[0] + ball_.highest + (ball_.isFoot() ? rise : 0.0);
  if (ball_.isTrunk() && rise <= SceneGround::kLevel) return touchedAtAll(p, low, high, radius);
  if (rise <= SceneGround::kLevel) return touched(p, high, feet.min()[0] + ball_.top, radius);
  return ball_.isLeg() ? touched(p, high, high, radius) : touchedOnUneven(p, feet, radius);
}

// @return whether the other side has been there
bool BodyReach::Flood::reach(int square, int side) {
  std::uint8_t& known = reached_[square];
  if (known == kUnknown) {
    const int there = object(middle(square));
    if (there == kNothing) squares_[side].push_back(square);
    known = there == kNothing    ? static_cast<std::uint8_t>(1 + side)
            : there == kNoGround ? kFar
                                 : kShut;
    return false;
  }
  return known == 2 - side;
}

bool BodyReach::Flood::begin(const Eigen::Vector3d& end, int side) {
  const int far = static_cast<int>(std::ceil(ball_.aside / square_));
  const Eigen::Vector2i at = ((end.head<2>() - min_) / square_).cast<int>();
  bool met = false;
  for (int y = std::max(0, at.y() - far); y <= std::min(count_.y() - 1, at.y() + far); ++y) {
    for (int x = std::max(0, at.x() - far); x <= std::min(count_.x() - 1, at.x() + far); ++x)
      met = reach(y * count_.x() + x, side) || met;
  }
  return met;
}

bool BodyReach::Flood::spread(int square, int side) {
  const int x = square % count_.x(), y = square / count_.x();
  bool met = false;
  for (int j = std::max(0, y - 1); j <= std::min(count_.y() - 1, y + 1); ++j) {
    for (int i = std::max(0, x - 1); i <= std::min(count_.x() - 1, x + 1); ++i)
      met = reach(j * count_.x() + i, side) || met;
  }
  return met;
}

bool BodyReach::Flood::isShut(const std::function<bool()>& stopped) {
  if (reached_.empty() || begin(from_, 0) || begin(to_, 1)) return false;
  for (long long i = 0;; ++i) {
    if (i % kStopEvery == 0 && stopped()) return false;
    for (const int side : {0, 1}) {
      if (next_[side] >= squares_[side].size()) return true;
      if (spread(squares_[side][next_[side]++], side)) return false;
    }
  }
}

// Goes on from one end; whether all is reached that is, with so many squares at most.
bool BodyReach::Flood::flood(int side, size_t most) {
  while (next_[side] < squares_[side].size() && next_[side] < most)
    spread(squares_[side][next_[side]++], side);
  return next_[side] >= squares_[side].size();
}

// From the part that is flooded, the smaller, through shut squares, ring by ring, to the other; of
// squares that are reached in the same ring the one that is least out of the way. Past what has no
// ground only where there is no other way: nothing is named there. Of a part too large to be
// flooded for a report any square will do that is not shut.
BodyReach::Barrier BodyReach::Flood::barrier() {
  std::vector<int> way = wayOut(true);
  if (way.empty()) way = wayOut(false);
  return way.empty() ? Barrier{ball_.part, -1, to_, from_, to_} : between(std::move(way));
}

// From a square of the larger part back to one of the smaller; empty where none is found.
std::vector<int> BodyReach::Flood::wayOut(bool over_ground) {
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
BodyReach::Barrier BodyReach::Flood::between(std::vector<int> way) {
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

// The first of the balls that is shut off; floods of those after it end when that is known. One
// that is like an earlier one is shut off only if that is, too.
std::optional<BodyReach::Barrier> BodyReach::barrier(
    const Eigen::Vector3d& from, const Eigen::Vector3d& to, const CollisionWorld& world,
    const SceneGround& ground, const std::vector<CollisionScratch*>& scratches,
    const std::function<bool()>& stopped, double beyond) const {
  const ReachedGround reached(ground, from, longest_step_);
  double high = 0.0;
  for (const Ball& ball : balls_) {
    high = std::max(high, ball.highest);
    if (!ball.carried.isEmpty()) high = std::max(high, ball.carried.max()[0]);
  }
  const Around around(ground, reached, stature_, longest_step_, high, beyond);
  const auto is_open = [&](std::span<const Ball> balls, double square) {
    return isOpenWay(from, to, postAround(balls), square, world, ground, reached, around.near_legs,
                     *scratches.front(), stopped);
  };
  const auto is_foot = [](const Ball& ball) { return ball.isFoot(); };
  const std::span<const Ball> but_feet(balls_.begin(), std::ranges::find_if(balls_, is_foot));
  if (balls_.empty() || !around.range.isKnown() || is_open(but_feet, kOpenSquare))
    return std::nullopt;
  using Asked = std::pair<const Ball*, double>;  // by squares of that side
  const auto first_shut = [&](const std::vector<Asked>& asked) -> std::optional<Barrier> {
    const int count = static_cast<int>(asked.size());
    std::vector<std::unique_ptr<Flood>> floods(asked.size());
    std::atomic<int> shut{count};  // one that is known to be
    const int first = firstOf(count, static_cast<int>(scratches.size()), [&](int i, int thread) {
      auto flood = std::make_unique<Flood>(*asked[i].first, asked[i].second, from, to, world,
                                           ground, around, beyond, *scratches[thread]);
      if (!flood->isShut([&] { return shut < i || stopped(); })) return false;
      for (int known = shut; i < known && !shut.compare_exchange_weak(known, i);) continue;
      floods[i] = std::move(flood);
      return true;
    });
    if (first == count) return std::nullopt;
    return floods[first]->barrier();
  };
  const auto squareOf = [](const Ball& ball) { return kOfRadius * std::sqrt(2.0) * ball.radius; };
  std::vector<Asked> coarse, fine;
  for (size_t i = 0; i < but_feet.size(); ++i) {
    const Ball& ball = but_feet[i];
    if (i > 0 && ball.isAsWide(balls_[i - 1])) continue;  // the other leg
    coarse.emplace_back(&ball, std::min(kLargest, squareOf(ball)));
  }
  if (ground.isLevel() && !balls_.empty() && balls_.back().post)
    coarse.emplace_back(&balls_.back(), std::min(kLargest, squareOf(balls_.back())));
  if (auto found = first_shut(coarse)) return found;
  if (ground.extent().sizes().prod() > kMostFinest * kFinest * kFinest) return std::nullopt;
  for (const Ball& ball : balls_) {
    // From a step beside it feet come higher over a thing.
    const bool is_asked = ball.isFoot() ? ground.isLevel() : !ball.isLeg();  // the post has been
    if (is_asked && !is_open({&ball, 1}, kFinerOpenSquare))
      fine.emplace_back(&ball, std::min(kFinest, squareOf(ball)));
  }
  return first_shut(fine);
}

}  // namespace amble

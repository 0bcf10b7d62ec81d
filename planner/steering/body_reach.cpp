#include "planner/steering/body_reach.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <functional>
#include <memory>
#include <utility>

#include "animation/steps/swing_path.h"
#include "base/ease.h"
#include "base/parallel.h"
#include "planner/steering/ball_flood.h"
#include "planner/steering/open_way.h"

namespace amble {
namespace {

constexpr double kSureWaist = 0.9;     // of what thigh and pelvis hold together
constexpr double kStackMargin = 0.01;  // of poses that are not those of a straight walk [m]
constexpr double kMostFinest = 2e6;    // squares of the second flood; larger ones are not begun
// Of a ball's radius, half a square's diagonal.
constexpr double kOfRadius = 0.4;
// Of a leg from the path, at any height [m].
constexpr double kOfLegs = 0.5;
constexpr double kLowestHips = 0.4;  // of stature
// Of the floods over what all balls pass, and what one passes that is asked about finely [m].
constexpr double kOpenSquare = 0.2, kFinerOpenSquare = 0.04;

// Share of a foot's extra lift that it may have that far through its swing (SwingShape).
double mostOfLift(double tau) {
  const double ramp = *std::ranges::min_element(SwingSearch::kRamps);
  return tau <= 0.0 ? 0.0 : minimumJerk(tau / ramp) * minimumJerk((1.0 - tau) / ramp);
}

// Of two balls, their middles so far apart: the circle in which they meet, than which nothing of
// what bounds the two together is nearer to any point of the line between the middles.
double waistOf(double a, double b, double apart) {
  if (apart >= a + b) return 0.0;
  const double x = (apart * apart + a * a - b * b) / (2.0 * apart);
  if (!(x > 0.0) || x >= apart) return std::min(a, b);  // that circle is not between them
  return std::sqrt(std::max(0.0, a * a - x * x));
}

}  // namespace

BodyReach::BodyReach(const StraightWalk& walk, const Skeleton& skeleton, const JointRoles& roles,
                     const Body& body, double stature, const Feet& feet)
    : stature_(stature), feet_(feet) {
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
          std::max(feet.highest_step, feet.highest_lift) + kAnkle * stature;
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
  addCrossings(walk, skeleton, roles, body);
  if (body.upright > 0.0) {  // who may stoop bends his trunk otherwise in another walk
    for (TrunkStack& stack : trunkStacks(walk, skeleton, roles, body, kStackMargin))
      addStack(std::move(stack));
  }
  addFeet(walk, skeleton, roles, body);
  addPost(roles, body);
}

// Legs cross any height between an ankle and the middle of the pelvis once: from the height of the
// ball that there is to where that middle is at least, evenly.
void BodyReach::addCrossings(const StraightWalk& walk, const Skeleton& skeleton,
                             const JointRoles& roles, const Body& body) {
  const auto leg = std::ranges::find_if(balls_, &Ball::isLeg);
  const auto hips = std::ranges::find(body.parts, roles.hips, &BodyPart::joint);
  if (leg == balls_.end() || hips == body.parts.end()) return;
  const auto pelvis = std::ranges::find(balls_, hips - body.parts.begin(), &Ball::part);
  Ball ball = *leg;
  ball.most_rise = SceneGround::kLevel;
  ball.aside = kOfLegs;
  ball.beyond = kBeyond;
  std::vector<JointFrame> joints(skeleton.size());
  std::vector<Eigen::Vector3d> from(body.parts.size()), to(body.parts.size());
  for (int frame = 0; frame < walk.buffer.size(); ++frame) {
    forwardKinematics(skeleton, walk.buffer.poses[frame], joints);
    placeBody(body, joints, from, to);
    const size_t of_hips = hips - body.parts.begin();
    const Eigen::Vector3d middle = 0.5 * (from[of_hips] + to[of_hips]);
    for (size_t i = 0; i < body.parts.size(); ++i) {
      const BodyPart& thigh = body.parts[i];
      if (thigh.joint != roles.legs[kLeft].up_leg && thigh.joint != roles.legs[kRight].up_leg)
        continue;
      const double waist = waistOf(thigh.radius, hips->radius, (from[i] - middle).norm());
      ball.radius = std::min({ball.radius, thigh.radius, kSureWaist * waist});
    }
  }
  if (ball.radius <= 0.0) return;
  const double lowest = leg->height, way = pelvis->height - lowest;
  const int count =
      static_cast<int>(std::ceil(way / (kThinnest + 2.0 * (1.0 - kOfRadius) * ball.radius)));
  for (int i = 1; i <= count; ++i) {
    ball.height = ball.highest = ball.top = lowest + way * i / count;
    balls_.push_back(ball);
  }
}

void BodyReach::addStack(TrunkStack stack) {
  Ball ball;
  for (const StackedBall& own : stack.balls) ball.radius = std::max(ball.radius, own.radius);
  ball.part = stack.balls.back().part;
  ball.height = stack.balls.front().height - stack.sway - kDip;
  ball.highest = ball.top = stack.balls.back().height + stack.sway + kRise;
  ball.most_rise = SceneGround::kLevel;
  ball.aside = kOfLegs;
  ball.stack = std::move(stack);
  balls_.push_back(std::move(ball));
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

// At the front end of a part of a foot, between the heights at which that swings.
BodyReach::Ball BodyReach::footBall(const StraightWalk& walk, const Skeleton& skeleton, Side side,
                                    const BodyPart& own, int part) const {
  std::vector<JointFrame> joints(skeleton.size());
  Eigen::AlignedBox1d heights;
  for (int frame = 0; frame < walk.buffer.size(); ++frame) {
    const FrameState& state = walk.buffer.states[frame];
    forwardKinematics(skeleton, walk.buffer.poses[frame], joints);
    const double z = (joints[own.joint] * own.to).z() - state.position.z();
    const double most = feet_.highest_lift * mostOfLift(state.feet[side].at - 1.0);
    heights.extend(Eigen::AlignedBox1d(z, z + most));
  }
  Ball ball;
  ball.part = part;
  ball.radius = own.radius;
  ball.height = heights.min()[0] - kRise;
  ball.highest = ball.top = heights.max()[0] + kRise;
  ball.most_rise = SceneGround::kLevel;
  ball.aside = kOfLegs;
  ball.beyond = kLegsBeyond;
  return ball;
}

// Of each foot the front end of one of its soles, which swings lower than the heel; and that of its
// instep, which is over the middle of the sole while the foot is flat.
void BodyReach::addFeet(const StraightWalk& walk, const Skeleton& skeleton, const JointRoles& roles,
                        const Body& body) {
  for (const Side side : {kLeft, kRight}) {
    std::vector<int> parts;
    for (int part = 0; part < static_cast<int>(body.parts.size()); ++part) {
      if (body.parts[part].sole == side && body.parts[part].joint == roles.legs[side].foot)
        parts.push_back(part);
    }
    if (parts.empty()) continue;
    balls_.push_back(footBall(walk, skeleton, side, body.parts[parts.front()], parts.front()));
    if (feet_.too_high.isEmpty()) continue;
    const BodyPart& instep = body.parts[parts.back()];
    Ball ball = footBall(walk, skeleton, side, instep, parts.back());
    std::vector<JointFrame> joints(skeleton.size());
    forwardKinematics(skeleton, walk.buffer.poses[0], joints);
    const FootPlace& print = walk.buffer.states.front().feet[side].from;
    ball.radius -= (joints[instep.joint] * instep.to - print.position).head<2>().norm();
    ball.too_high = feet_.too_high;
    ball.looks = feet_.half_width;
    if (ball.radius > 0.0) balls_.push_back(ball);
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

// The first of the balls that is shut off; floods of those after it end when that is known. One
// that is like an earlier one is shut off only if that is, too.
std::optional<BodyReach::Barrier> BodyReach::barrier(
    const Eigen::Vector3d& from, const Eigen::Vector3d& to, const CollisionWorld& world,
    const SceneGround& ground, const std::vector<CollisionScratch*>& scratches,
    const std::function<bool()>& stopped, double beyond) const {
  const ReachedGround reached(ground, from, feet_.longest_step);
  double high = 0.0;
  for (const Ball& ball : balls_) {
    high = std::max(high, ball.highest);
    if (!ball.carried.isEmpty()) high = std::max(high, ball.carried.max()[0]);
  }
  const FloodGround around(ground, reached, stature_, feet_.longest_step, high, beyond);
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
    std::vector<std::unique_ptr<BallFlood>> floods(asked.size());
    std::atomic<int> shut{count};  // one that is known to be
    const int first = firstOf(count, static_cast<int>(scratches.size()), [&](int i, int thread) {
      auto flood = std::make_unique<BallFlood>(*asked[i].first, asked[i].second, from, to, world,
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
    if (!ball.stack.balls.empty() || (ball.isOverLevelOnly() && !ground.isLevel())) continue;
    coarse.emplace_back(&ball, std::min(kLargest, squareOf(ball)));
  }
  if (ground.isLevel() && !balls_.empty() && balls_.back().post)
    coarse.emplace_back(&balls_.back(), std::min(kLargest, squareOf(balls_.back())));
  if (auto found = first_shut(coarse)) return found;
  if (ground.extent().sizes().prod() > kMostFinest * kFinest * kFinest) return std::nullopt;
  for (const Ball& ball : balls_) {
    // From a step beside it feet come higher over a thing. Legs and the post have been.
    const bool is_asked = ball.isFoot() || !ball.stack.balls.empty()
                              ? ground.isLevel() && (ball.too_high.isEmpty() || ground.isAllLevel())
                              : !ball.isLeg();
    if (is_asked && !is_open({&ball, 1}, kFinerOpenSquare))
      fine.emplace_back(&ball, std::min(kFinest, squareOf(ball)));
  }
  return first_shut(fine);
}

}  // namespace amble

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

constexpr double kMostFinest = 2e6;  // squares of the second flood; larger ones are not begun
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
  const FloodGround around(ground, reached, stature_, longest_step_, high, beyond);
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

#include "animation/steps/footsteps.h"

#include <algorithm>
#include <cmath>

#include "animation/steps/start_and_stop.h"
#include "base/ease.h"

namespace amble {
namespace {

GroundPoint ahead(const Stance& stance, double forward) {
  return {stance.position +
              forward * Eigen::Vector3d(std::cos(stance.heading), std::sin(stance.heading), 0.0),
          stance.heading};
}

double staggerOf(const FootPlacement& p, Side side) {
  return side == kLeft ? p.stagger : -p.stagger;
}

FootPlace stancePlace(const FootPlacement& p, const Stance& stance, Side side) {
  if (stance.standing) {
    return footBeside(ahead(stance, p.forward), side, p.stand_width, p.stand_toe_out);
  }
  const double step = side == stance.leading ? 0.5 * p.step_length : -0.5 * p.step_length;
  return footBeside(ahead(stance, p.forward + step + staggerOf(p, side)), side, p.walk_width,
                    p.walk_toe_out);
}

}  // namespace

GroundPoint pathPoint(const RootPath& path, double arc, double z) {
  const RootPath::Sample at = path.at(arc);
  const double beyond = arc < 0.0 ? arc : std::max(0.0, arc - path.length());
  return {{at.position.x() + beyond * std::cos(at.heading),
           at.position.y() + beyond * std::sin(at.heading), z},
          at.heading};
}

FootPlace footBeside(const GroundPoint& point, Side side, double width, double toe_out) {
  const double sign = side == kLeft ? 1.0 : -1.0;
  const Eigen::Vector3d left(-std::sin(point.heading), std::cos(point.heading), 0.0);
  return {point.position + 0.5 * sign * width * left, point.heading + sign * toe_out};
}

Footsteps::Footsteps(const FootPlacement& placement, const Stance& from, const Stance& to,
                     int steps, Side first)
    : placement_(placement), from_(from), to_(to), steps_(steps), first_(first) {
  places_.resize(steps + 2);
  landings_.resize(steps + 2);
  half_supports_.assign(steps + 1, placement.half_support);
  places_[0] = stancePlace(placement, from, first);
  places_[1] = stancePlace(placement, from, other(first));
  places_[steps] = stancePlace(placement, to, side(steps - 1));
  places_[steps + 1] = stancePlace(placement, to, side(steps));
}

Side Footsteps::side(int placing) const { return placing % 2 != 0 ? first_ : other(first_); }

void Footsteps::place(const std::function<GroundPoint(int)>& path_at) {
  for (int i = 1; i + 1 < steps_; ++i) {
    GroundPoint point = path_at(i);
    point.position += staggerOf(placement_, side(i)) *
                      Eigen::Vector3d(std::cos(point.heading), std::sin(point.heading), 0.0);
    places_[i + 1] = footBeside(point, side(i), placement_.walk_width, placement_.walk_toe_out);
  }
}

void Footsteps::setStances(const std::array<FootPlace, 2>& from,
                           const std::array<FootPlace, 2>& to) {
  places_[0] = from[first_];
  places_[1] = from[other(first_)];
  places_[steps_] = to[side(steps_ - 1)];
  places_[steps_ + 1] = to[side(steps_)];
}

void Footsteps::setSupports(std::vector<double> half_supports) {
  half_supports_ = std::move(half_supports);
}

double Footsteps::halfSupport(int node) const {
  return half_supports_[std::clamp(node, 0, steps_)];
}

double Footsteps::strike(int placing) const {
  if (placing == steps_ && to_.standing) return steps_ - StartAndStop::kLastStrike;
  return placing - halfSupport(placing);
}

double Footsteps::liftOff(int placing) const {
  if (placing == -1 && from_.standing) return StartAndStop::kFirstLift;
  return placing + 1 + halfSupport(placing + 1);
}

// State of the foot whose last placing is `placing`.
FootState Footsteps::stateOf(int placing, double progress) const {
  FootState foot;
  foot.from = place(placing);
  foot.to = foot.from;
  const double begin = strike(placing), end = liftOff(placing);
  const auto strike_roll = [&](int i) {
    return to_.standing && i == steps_ ? 0.0 : landings_[i + 1].strike_roll;
  };
  foot.strike_roll = placing <= 0 && from_.standing ? 0.0 : strike_roll(placing);
  foot.lift_roll = to_.standing && placing >= steps_ - 1 ? 0.0 : 1.0;
  const bool first = from_.standing && placing == -1;
  if (first) foot.lift_roll = StartAndStop::kFirstRoll * smoothstep(progress / end);
  if (progress <= end || placing + 2 > steps_) {
    foot.at = std::min(1.0, (progress - begin) / (end - begin));
    return foot;
  }
  foot.to = place(placing + 2);
  foot.strike_roll = strike_roll(placing + 2);
  foot.swing = landings_[placing + 3].swing;
  double tau = (progress - end) / (strike(placing + 2) - end);
  if (first) tau = std::pow(std::max(tau, 0.0), StartAndStop::kFirstDelay);
  foot.at = 1.0 + std::clamp(tau, 1e-12, 1.0);
  return foot;
}

std::array<FootState, 2> Footsteps::at(double progress) const {
  if (progress <= 0.0) return atStance(placement_, from_);
  if (progress >= steps_) return atStance(placement_, to_);
  std::array<FootState, 2> feet;
  for (const int parity : {0, 1}) {
    // 0 or -1, then every other; it has landed, since that is before its node.
    const int landed = static_cast<int>(progress);
    int placing = landed - (landed + parity) % 2;
    while (placing + 2 <= steps_ && strike(placing + 2) <= progress) placing += 2;
    feet[side(placing)] = stateOf(placing, progress);
  }
  return feet;
}

std::array<FootState, 2> Footsteps::atStance(const FootPlacement& placement, const Stance& stance) {
  std::array<FootState, 2> feet;
  for (const Side side : {kLeft, kRight}) {
    FootState& foot = feet[side];
    foot.from = foot.to = stancePlace(placement, stance, side);
    if (stance.standing) {
      foot.at = 0.5;
      foot.strike_roll = foot.lift_roll = 0.0;
    } else {
      const double since = placement.half_support + (side == stance.leading ? 0.0 : 1.0);
      foot.at = since / (1.0 + 2.0 * placement.half_support);
    }
  }
  return feet;
}

}  // namespace amble

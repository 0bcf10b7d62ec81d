#include "animation/steps/footsteps.h"

#include <algorithm>
#include <cmath>

#include "animation/library/foot_cycle.h"
#include "base/ease.h"

namespace amble {
namespace {

GroundPoint ahead(const Stance& stance, double forward) {
  return {stance.position +
              forward * Eigen::Vector3d(std::cos(stance.heading), std::sin(stance.heading), 0.0),
          stance.heading};
}

FootPlace stancePlace(const FootPlacement& p, const Stance& stance, Side side) {
  const double sign = side == kLeft ? 1.0 : -1.0;
  if (stance.standing) {
    return footBeside(ahead(stance, p.forward),
                      {0.0, 0.5 * sign * p.stand_width, sign * p.stand_toe_out});
  }
  const double step = side == stance.leading ? 0.5 * p.step_length : -0.5 * p.step_length;
  return footBeside(ahead(stance, p.forward + step), p.print(side));
}

}  // namespace

GroundPoint pathPoint(const RootPath& path, double arc, double z) {
  const RootPath::Sample at = path.at(arc);
  const double beyond = arc < 0.0 ? arc : std::max(0.0, arc - path.length());
  return {{at.position.x() + beyond * std::cos(at.heading),
           at.position.y() + beyond * std::sin(at.heading), z},
          at.heading};
}

FootPlace footBeside(const GroundPoint& point, const PrintPlace& print) {
  const Eigen::Vector3d ahead(std::cos(point.heading), std::sin(point.heading), 0.0);
  const Eigen::Vector3d left(-ahead.y(), ahead.x(), 0.0);
  return {point.position + print.forward * ahead + print.left * left,
          point.heading + print.toe_out};
}

Footsteps::Footsteps(const FootPlacement& placement, const Stance& from, const Stance& to,
                     int steps, Side first)
    : placement_(placement), from_(from), to_(to), steps_(steps), first_(first) {
  places_.resize(steps + 2);
  landings_.resize(steps + 2);
  for (int node = 0; node <= steps; ++node)
    supports_.push_back(nodeSupport(placement.supports, side(node)));
  places_[0] = stancePlace(placement, from, first);
  places_[1] = stancePlace(placement, from, other(first));
  places_[steps] = stancePlace(placement, to, side(steps - 1));
  places_[steps + 1] = stancePlace(placement, to, side(steps));
  setTimes();
}

Side Footsteps::side(int placing) const { return placing % 2 != 0 ? first_ : other(first_); }

void Footsteps::place(const std::function<FootPlace(int)>& print_at) {
  for (int i = 1; i + 1 < steps_; ++i) places_[i + 1] = print_at(i);
}

void Footsteps::setStances(const std::array<FootPlace, 2>& from,
                           const std::array<FootPlace, 2>& to) {
  places_[0] = from[first_];
  places_[1] = from[other(first_)];
  places_[steps_] = to[side(steps_ - 1)];
  places_[steps_ + 1] = to[side(steps_)];
}

void Footsteps::setSupports(std::vector<NodeSupport> supports) {
  supports_ = std::move(supports);
  setTimes();
}

void Footsteps::setTimes() {
  strikes_.clear();
  lift_offs_.clear();
  for (int placing = -1; placing <= steps_; ++placing) {
    strikes_.push_back(strikeOf(placing));
    lift_offs_.push_back(liftOffOf(placing));
  }
}

// Beyond an end that of the same foot within it.
const Footsteps::NodeSupport& Footsteps::support(int node) const {
  const int within = std::abs(node);
  return supports_[within <= steps_ ? within : 2 * steps_ - within];
}

double Footsteps::strikeOf(int placing) const {
  if (placing == steps_ && to_.standing) {
    const EndSwing& last = lastSwing();
    return steps_ - (last.captured ? last.strike : StartAndStop::kLastStrike);
  }
  if (placing == 1 && from_.standing && firstSwing().captured) return firstSwing().strike;
  return placing - support(placing)[0];
}

double Footsteps::liftOffOf(int placing) const {
  if (placing == -1 && from_.standing)
    return firstSwing().captured ? firstSwing().lift_off : StartAndStop::kFirstLift;
  if (placing == steps_ - 2 && to_.standing && lastSwing().captured)
    return steps_ - lastSwing().lift_off;
  return placing + 1 + support(placing + 1)[1];
}

// Which captured swing the foot of a placing follows, where it is.
void Footsteps::follow(int placing, FootState& foot) const {
  foot.kind = placement_.swings;
  const bool first = from_.standing && firstSwing().captured;
  const bool last = to_.standing && lastSwing().captured;
  // A stance is of the swing before until the foot is flat, and of the swing after from then on.
  const int swings_to = foot.at < FootCycle::kFlat ? placing : placing + 2;
  if (first && swings_to == 1) foot.kind = SwingKind::kFirst;
  if (last && swings_to == steps_) foot.kind = SwingKind::kLast;
  if (swings_to <= steps_) foot.turn_rate = landings_[swings_to + 1].turn_rate;
  foot.slower = landings_[std::min(swings_to, steps_) + 1].slower;
}

// State of the foot whose last placing is `placing`, from a new one.
void Footsteps::setState(int placing, double progress, FootState& foot) const {
  foot.from = place(placing);
  foot.to = foot.from;
  const bool first = from_.standing && placing == -1;
  const bool captured_first = first && firstSwing().captured;
  const bool captured_last = to_.standing && lastSwing().captured;
  const double end = liftOff(placing);
  const double begin = captured_first ? -end : strike(placing);  // standing is half of its stance
  const auto strike_roll = [&](int i) {
    // A captured last swing ends flat by itself.
    if (to_.standing && i == steps_) return captured_last ? 1.0 : 0.0;
    return landings_[i + 1].strike_roll;
  };
  foot.strike_roll = placing <= 0 && from_.standing ? 0.0 : strike_roll(placing);
  foot.lift_roll = to_.standing && placing >= steps_ - 1 ? 0.0 : 1.0;
  if (first) {
    const double whole = captured_first ? 1.0 : StartAndStop::kFirstRoll;
    foot.lift_roll = whole * smoothstep(progress / end);
  }
  if (progress <= end || placing + 2 > steps_) {
    foot.at = std::min(1.0, (progress - begin) / (end - begin));
    if (captured_last && placing == steps_)
      foot.at = FootCycle::kFlat * (progress - begin) / (steps_ - begin);
    follow(placing, foot);
    return;
  }
  foot.to = place(placing + 2);
  foot.strike_roll = strike_roll(placing + 2);
  foot.swing = landings_[placing + 3].swing;
  double tau = (progress - end) / (strike(placing + 2) - end);
  if (first && !captured_first) tau = std::pow(std::max(tau, 0.0), StartAndStop::kFirstDelay);
  foot.at = 1.0 + std::clamp(tau, 1e-12, 1.0);
  follow(placing, foot);
}

std::array<FootState, 2> Footsteps::at(double progress) const {
  std::array<FootState, 2> feet;
  if (progress <= 0.0 || progress >= steps_) {  // weight may be shifted there, on the ground
    const bool begin = progress <= 0.0;
    feet = atStance(placement_, begin ? from_ : to_);
    for (const int placing : {begin ? -1 : steps_ - 1, begin ? 0 : steps_})
      feet[side(placing)].from = feet[side(placing)].to = place(placing);
    return feet;
  }
  for (const int parity : {0, 1}) {
    // 0 or -1, then every other; it has landed, since that is before its node.
    const int landed = static_cast<int>(progress);
    int placing = landed - (landed + parity) % 2;
    while (placing + 2 <= steps_ && strike(placing + 2) <= progress) placing += 2;
    setState(placing, progress, feet[side(placing)]);
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
      const double before = placement.supports(side, 0), after = placement.supports(other(side), 1);
      foot.at = (before + (side == stance.leading ? 0.0 : 1.0)) / (before + 1.0 + after);
      foot.slower = placement.slower;
    }
  }
  return feet;
}

}  // namespace amble

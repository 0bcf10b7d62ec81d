#include "animation/steps/stance_feet.h"

#include <cmath>

#include "animation/steps/slope_gait.h"

namespace amble {

WalkRule ruleOf(Foothold::Refusal refusal) {
  switch (refusal) {
    case Foothold::Refusal::kNone:
      return WalkRule::kNone;
    case Foothold::Refusal::kNoGround:
      return WalkRule::kNoGround;
    case Foothold::Refusal::kSlope:
      return WalkRule::kSlope;
    case Foothold::Refusal::kEdge:
      return WalkRule::kFoothold;
  }
  return WalkRule::kFoothold;
}

bool onLevel(const FootPlace& place, double height) {
  return place.normal.z() == 1.0 && std::abs(place.position.z() - height) <= Unevenness::kLevel;
}

double slopeUnder(const StepSettings& settings, const FootholdFinder& holds, const Stance& stance) {
  const double half = 0.5 * settings.placement.step_length, reach = settings.reach();
  const Eigen::Vector3d ahead(half * std::cos(stance.heading), half * std::sin(stance.heading), 0);
  const auto front = holds.heightNear(stance.position + ahead, reach);
  const auto rear = holds.heightNear(stance.position - ahead, reach);
  return front && rear ? (*front - *rear) / (2.0 * half) : 0.0;
}

namespace {

// Steps of a walking stance are those of its own and its slope's speed.
FootPlacement placementAt(const StepSettings& settings, const FootholdFinder& holds,
                          const SwingCycles& cycles, const Stance& stance) {
  FootPlacement placement = settings.placement;
  if (stance.standing) return placement;
  const double pace = stance.pace * slopePace(slopeUnder(settings, holds, stance));
  if (pace < 1.0) {
    const double speed = settings.limits.speed * pace;
    placement.step_length = settings.limits.law.stepLength(speed);
    placement.supports = settings.limits.law.supports(speed, 0.0);
    placement.slower = cycles.departures.slowerBy(speed);
    const auto print = [&](Side side) {
      return cycles.print(side, placement.print(side), placement.slower, 0.0);
    };
    const PrintPlace left = print(kLeft);
    placement.walk_width = 2.0 * left.left;
    placement.stagger = left.forward;
    placement.walk_toe_out = {left.toe_out, print(kRight).toe_out};
  }
  return placement;
}

}  // namespace

StanceFeet findStanceFeet(const StepSettings& settings, const FootholdFinder& holds,
                          const SwingCycles& cycles, const Stance& stance) {
  StanceFeet result;
  result.placement = placementAt(settings, holds, cycles, stance);
  const auto places = Footsteps::atStance(result.placement, stance);
  result.height = stance.position.z();
  for (const Side side : {kLeft, kRight}) {
    const Foothold hold = holds.at(places[side].from, side, settings.reach());
    result.feet[side] = hold.place;
    if (result.refused == WalkRule::kNone) result.refused = ruleOf(hold.refusal);
    if (result.refused == WalkRule::kNone && hold.supported < 1.0)
      result.refused = WalkRule::kFoothold;
    result.level = result.level && onLevel(hold.place, stance.position.z());
  }
  const FootPlace& front = result.feet[stance.leading];
  const FootPlace& rear = result.feet[other(stance.leading)];
  if (result.refused == WalkRule::kNone && std::abs(stepHeight(rear, front)) > Unevenness::kStance)
    result.refused = WalkRule::kFoothold;
  if (result.level) return result;
  result.height = 0.5 * (front.position.z() + rear.position.z());
  if (!stance.standing) result.rise = front.position.z() - rear.position.z();
  return result;
}

}  // namespace amble

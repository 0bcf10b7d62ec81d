#include "animation/steps/step_placer.h"

#include <algorithm>
#include <cmath>

#include "animation/steps/foot_target.h"
#include "base/ease.h"
#include "base/rotation.h"

namespace amble {
namespace {

constexpr double kHighestLift = 0.25;  // over what lies between prints, of a captured subject [m]
// Prints within so much of the stance's height are level with it: rugs and thresholds [m].
constexpr double kLevel = 0.03;
// Feet of a stance stand no higher one over the other than this, beside what the slope gives [m].
constexpr double kStanceStep = 0.05;
// A higher step than this is looked for, not just taken [m].
constexpr double kNaturalStep = 0.06;
constexpr double kPaceSpacing = 0.25;  // of the points at which slopes are looked at [m]
// A landing this much above or below the other foot is flat, or on the ball [m].
constexpr double kFlatLanding = 0.15;
// Of a step that rises or falls by kStairRise: Riener, Rabuffetti & Frigo (2002), cycles of 1.41 s
// up and 1.19 s down stairs of 0.17 m by 0.29 m, against steps of 0.53 s on the level.
constexpr double kStairRise = 0.17;  // [m]
constexpr double kSlowerUp = 0.33, kSlowerDown = 0.13;

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

// Which foot steps first: from standing the one on the inside of the first turn, unless parity and
// the last foot say otherwise.
Side firstFoot(const Stance& from, const Stance& to, const RootPath& path, int steps,
               bool any_leading) {
  if (!from.standing) return other(from.leading);
  if (!to.standing && !any_leading) return steps % 2 == 1 ? to.leading : other(to.leading);
  return path.at(0.5 * path.length()).curvature > 1e-6 ? kLeft : kRight;
}

double reachOf(const FootholdLimits& limits) {
  return std::max(limits.max_climb, limits.max_drop) + kLevel;
}

bool onLevel(const FootPlace& place, double height) {
  return place.normal.z() == 1.0 && std::abs(place.position.z() - height) <= kLevel;
}

}  // namespace

double slopePace(double slope) {
  constexpr double kSlowing = 3.5, kFastest = 0.05;
  return std::min(1.0, std::exp(-0.5 * kSlowing * (std::abs(slope + kFastest) - kFastest)));
}

double slopeLean(double slope) {
  constexpr double kUp = 0.35, kDown = 0.15;  // of the slope's angle
  return (slope > 0.0 ? kUp : kDown) * std::atan(slope);
}

double WalkSteps::heightAt(const SpeedProfile::Sample& at, double length) const {
  if (!level) return height.at(at.steps);
  return from.position.z() + smoothstep(at.arc / length) * (end.position.z() - from.position.z());
}

StepPlacer::StepPlacer(const Ground& ground, const std::array<FootShape, 2>& shapes,
                       const StrideLaw& law, const std::array<FootCycle, 2>& cycles,
                       const Settings& settings)
    : ground_(ground),
      shapes_(shapes),
      law_(law),
      cycles_(cycles),
      s_(settings),
      holds_(ground, shapes, settings.footholds),
      clearance_(ground, shapes, kHighestLift * settings.scale) {}

// Rise per metre of the ground between the places where a walking stance's feet would be.
double StepPlacer::slopeUnder(const Stance& stance) const {
  const double half = 0.5 * s_.placement.step_length, reach = reachOf(s_.footholds);
  const Eigen::Vector3d ahead(half * std::cos(stance.heading), half * std::sin(stance.heading), 0);
  const auto front = holds_.heightNear(stance.position + ahead, reach);
  const auto rear = holds_.heightNear(stance.position - ahead, reach);
  return front && rear ? (*front - *rear) / (2.0 * half) : 0.0;
}

StanceFeet StepPlacer::stanceFeet(const Stance& stance) const {
  StanceFeet result;
  result.placement = s_.placement;
  if (!stance.standing) {
    const double pace = slopePace(slopeUnder(stance));
    if (pace < 1.0) {
      const double speed = s_.limits.speed * pace;
      result.placement.step_length = law_.stepLength(speed);
      result.placement.half_support = 0.5 * doubleSupport(speed, s_.leg_length);
    }
  }
  const auto places = Footsteps::atStance(result.placement, stance);
  result.height = stance.position.z();
  for (const Side side : {kLeft, kRight}) {
    const Foothold hold = holds_.at(places[side].from, side, reachOf(s_.footholds));
    result.feet[side] = hold.place;
    if (result.refused == WalkRule::kNone) result.refused = ruleOf(hold.refusal);
    if (result.refused == WalkRule::kNone && hold.supported < 1.0)
      result.refused = WalkRule::kFoothold;
    result.level = result.level && onLevel(hold.place, stance.position.z());
  }
  const FootPlace& front = result.feet[stance.leading];
  const FootPlace& rear = result.feet[other(stance.leading)];
  if (result.refused == WalkRule::kNone && std::abs(stepHeight(rear, front)) > kStanceStep)
    result.refused = WalkRule::kFoothold;
  if (result.level) return result;
  result.height = 0.5 * (front.position.z() + rear.position.z());
  if (!stance.standing) result.rise = front.position.z() - rear.position.z();
  return result;
}

double StepPlacer::slopeAlong(const RootPath& path, double arc, double z) const {
  const GroundPoint point = pathPoint(path, arc, z);
  return slopeUnder({point.position, point.heading, true, kLeft});
}

// The pace at every arc, linear between points; none where the ground is level all along.
std::function<double(double)> StepPlacer::paceAlong(const RootPath& path, const Stance& from,
                                                    const Stance& to) const {
  const int count = std::max(1, static_cast<int>(std::ceil(path.length() / kPaceSpacing)));
  const double spacing = path.length() / count, reach = reachOf(s_.footholds);
  std::vector<double> paces(count + 1, 1.0);
  double z = from.position.z();
  bool level = true;
  for (int i = 0; i <= count; ++i) {
    const GroundPoint point = pathPoint(path, i * spacing, z);
    const auto surface = ground_.surface(point.position.x(), point.position.y(), z, reach);
    if (surface) z = surface->height;
    // On treads the slope under a step is no slope that soles stand on.
    if (!surface || surface->normal.z() > 1.0 - 1e-9) continue;
    level = false;
    paces[i] = slopePace(slopeAlong(path, i * spacing, z));
  }
  if (level) return nullptr;
  if (!from.standing) paces.front() = slopePace(slopeUnder(from));
  if (!to.standing) paces.back() = slopePace(slopeUnder(to));
  return [paces = std::move(paces), spacing](double arc) {
    const double at = std::clamp(arc / spacing, 0.0, static_cast<double>(paces.size() - 1));
    const size_t i = std::min(static_cast<size_t>(at), paces.size() - 2);
    return paces[i] + (at - static_cast<double>(i)) * (paces[i + 1] - paces[i]);
  };
}

WalkSteps StepPlacer::plan(const Stance& from, const Stance& to, const RootPath& path,
                           bool any_leading, const GaitWishes& wishes) const {
  WalkSteps walk;
  walk.from = from;
  walk.end = to;
  walk.from_feet = stanceFeet(from);
  walk.end_feet = stanceFeet(to);
  walk.refused = walk.from_feet.refused;
  if (walk.refused == WalkRule::kNone) walk.refused = walk.end_feet.refused;
  if (walk.refused != WalkRule::kNone) return walk;

  SpeedLimits limits = s_.limits;
  limits.pace = paceAlong(path, from, to);
  limits.stride = wishes.stride;
  SpeedProfileEnds ends{from.standing, to.standing, std::nullopt};
  if (!from.standing && !to.standing && !any_leading)
    ends.parity = from.leading == to.leading ? 0 : 1;
  walk.profile.emplace(path, limits, ends);
  if (walk.profile->refusal() == SpeedProfile::Refusal::kTurnRate) {
    walk.refused = WalkRule::kTurnRate;
    return walk;
  }
  const bool whole = walk.profile->refusal() == SpeedProfile::Refusal::kNone;
  if (!whole) walk.refused = WalkRule::kStepLength;
  if (!whole || !natural(walk, path, any_leading, wishes)) {
    // Where there is no whole number of steps on the level, there is none.
    if (!whole && walk.from_feet.level && walk.end_feet.level &&
        walk.from_feet.height == walk.end_feet.height) {
      return walk;
    }
    adapted(walk, path, any_leading, wishes, limits);
  }
  if (walk.refused != WalkRule::kNone) return walk;
  if (limits.pace || limits.stride || walk.timing) support(walk);
  finish(walk);
  return walk;
}

// Steps as they follow from the speed, each on the ground where it falls. False where one does not
// stand whole there or is high: then `refused` says which rule.
bool StepPlacer::natural(WalkSteps& walk, const RootPath& path, bool any_leading,
                         const GaitWishes& wishes) const {
  const SpeedProfile& profile = *walk.profile;
  walk.steps = profile.steps();
  walk.first = firstFoot(walk.from, walk.end, path, walk.steps, any_leading);
  const Side leading = walk.steps % 2 == 1 ? walk.first : other(walk.first);
  if (leading != walk.end.leading) {
    walk.end.leading = leading;
    walk.end_feet = stanceFeet(walk.end);
    walk.refused = walk.end_feet.refused;
    if (walk.refused != WalkRule::kNone) return false;
  }
  walk.feet.emplace(s_.placement, walk.from, walk.end, walk.steps, walk.first);
  walk.feet->place([&](int i) {
    const double s = 0.5 * (profile.arcAtStep(i) + profile.arcAtStep(i + 1)) + s_.placement.forward;
    return pathPoint(path, s, walk.from.position.z());
  });
  walk.feet->setStances(walk.from_feet.feet, walk.end_feet.feet);
  walk.refused = standOnGround(*walk.feet);
  if (walk.refused == WalkRule::kNone) shapeSwings(walk, path, wishes);
  return walk.refused == WalkRule::kNone;
}

WalkRule StepPlacer::standOnGround(Footsteps& steps) const {
  std::vector<FootPlace>& places = steps.places();
  for (int i = 1; i + 1 < steps.steps(); ++i) {
    FootPlace& place = places[i + 1];
    place.position.z() = places[i].position.z();
    const Foothold hold = holds_.at(place, steps.side(i), reachOf(s_.footholds));
    if (hold.refusal != Foothold::Refusal::kNone) return ruleOf(hold.refusal);
    if (hold.supported < 1.0) return WalkRule::kFoothold;
    place = hold.place;
  }
  for (size_t i = 0; i + 1 < places.size(); ++i) {
    if (std::abs(stepHeight(places[i], places[i + 1])) > kNaturalStep) return WalkRule::kFoothold;
  }
  return WalkRule::kNone;
}

// Steps that are chosen for the ground.
void StepPlacer::adapted(WalkSteps& walk, const RootPath& path, bool any_leading,
                         const GaitWishes& wishes, const SpeedLimits& limits) const {
  const WalkRule natural_rule = walk.refused;
  Stance other_end = walk.end;
  other_end.leading = other(walk.end.leading);
  const StanceFeet other_feet = stanceFeet(other_end);
  const double first_step = law_.stepLength(std::min(limits.speed, law_.onset().first_speed));
  const auto wanted = [&](double arc) {
    if (wishes.stride) return wishes.stride(arc);
    const double pace = limits.pace ? limits.pace(arc) : 1.0;
    const double step = law_.stepLength(limits.speed * pace);
    const bool starts = walk.from.standing && arc < step;
    const bool stops = walk.end.standing && arc > path.length() - step;
    return starts || stops ? std::min(step, first_step) : step;
  };
  const FootstepRequest request{
      .path = path,
      .placement = s_.placement,
      .from = walk.from,
      .to = walk.end,
      .from_feet = walk.from_feet.feet,
      .to_feet = walk.end_feet.feet,
      .to_other_feet = other_feet.feet,
      .any_leading = any_leading && other_feet.refused == WalkRule::kNone,
      .preferred = firstFoot(walk.from, walk.end, path, 0, true),
      .wanted = wanted,
      .shortest = StrideLaw::kShortestStep * law_.capturedStep(),
      .longest = StrideLaw::kLongestStep * law_.capturedStep(),
  };
  const FootstepPlan plan = planFootsteps(request, holds_);
  walk.refused = plan.refused;
  if (plan.refused != WalkRule::kNone) {
    if (natural_rule == WalkRule::kSlope) walk.refused = natural_rule;
    return;
  }
  walk.steps = plan.steps;
  walk.first = plan.first;
  const Side leading = walk.steps % 2 == 1 ? walk.first : other(walk.first);
  if (leading != walk.end.leading) walk.end = other_end, walk.end_feet = other_feet;
  walk.feet.emplace(s_.placement, walk.from, walk.end, walk.steps, walk.first);
  walk.feet->setStances(walk.from_feet.feet, walk.end_feet.feet);
  for (int i = 1; i + 1 < walk.steps; ++i) walk.feet->places()[i + 1] = plan.places[i + 1];
  time(walk, plan, path, limits);
  shapeSwings(walk, path, wishes);
}

// Nodes are midway between prints; steps up and down take longer than those on the level.
void StepPlacer::time(WalkSteps& walk, const FootstepPlan& plan, const RootPath& path,
                      const SpeedLimits& limits) const {
  const std::vector<FootPlace>& places = walk.feet->places();
  const auto paceAt = [&](double arc) { return limits.pace ? limits.pace(arc) : 1.0; };
  TimedSteps timed;
  timed.frame_time = limits.frame_time;
  timed.first_speed = walk.from.standing ? 0.0 : limits.speed * paceAt(0.0);
  timed.last_speed = walk.end.standing ? 0.0 : limits.speed * paceAt(path.length());
  for (int i = 0; i <= walk.steps; ++i) {
    timed.arcs.push_back(0.5 * (plan.arcs[i] + plan.arcs[i + 1]) - s_.placement.forward);
    timed.lengths.push_back(plan.arcs[i + 1] - plan.arcs[i]);
  }
  timed.arcs.front() = 0.0;
  timed.arcs.back() = path.length();
  timed.lengths.front() =
      walk.from.standing ? timed.lengths[1] : walk.from_feet.placement.step_length;
  timed.lengths.back() =
      walk.end.standing ? timed.lengths[walk.steps - 1] : walk.end_feet.placement.step_length;
  for (int i = 1; i <= walk.steps; ++i) {
    const double middle = 0.5 * (timed.arcs[i - 1] + timed.arcs[i]);
    double speed = limits.speed * paceAt(middle);
    if ((i == 1 && walk.from.standing) || (i == walk.steps && walk.end.standing))
      speed = std::min(speed, law_.onset().first_speed);
    double duration = law_.stepLength(speed) / speed;
    const double height = stepHeight(places[i], places[i + 1]) / (kStairRise * s_.scale);
    duration *= 1.0 + std::abs(height) * (height > 0.0 ? kSlowerUp : kSlowerDown);
    const double turning = std::abs(path.at(middle).curvature) / limits.max_turn_rate;
    duration = std::max(duration, (timed.arcs[i] - timed.arcs[i - 1]) * turning);
    timed.durations.push_back(duration);
  }
  walk.timing.emplace(timed);
}

// What is asked of one foot. Captured feet swing a little differently: near the captured lift they
// go on doing so, and the captured lift gives the captured walk back.
double StepPlacer::askedLift(double lift, Side side) const {
  constexpr double kNear = 0.1;  // of the captured lift
  const double captured = 0.5 * (s_.captured_lift[kLeft] + s_.captured_lift[kRight]);
  const double own = s_.captured_lift[side] / captured;
  const double keep = std::max(0.0, 1.0 - std::abs(lift / captured - 1.0) / kNear);
  return lift * std::pow(own, keep);
}

// Lifts as asked and as high as what lies between prints needs; landings by what they land on.
void StepPlacer::shapeSwings(WalkSteps& walk, const RootPath& path,
                             const GaitWishes& wishes) const {
  Footsteps& feet = *walk.feet;
  const std::vector<FootPlace>& places = feet.places();
  walk.gait.clear();
  for (int i = 0; i < 2; ++i) feet.landings()[i].strike_roll = slopeStrike(places[i]);
  for (int i = 1; i <= walk.steps; ++i) {
    const FootCycle& cycle = cycles_[feet.side(i)];
    const FootShape& foot = shapes_[feet.side(i)];
    Footsteps::Landing& landing = feet.landings()[i + 1];
    const double height = stepHeight(places[i], places[i + 1]);
    landing.strike_roll = slopeStrike(places[i + 1]);
    // The last foot of a walking stance lands as every walk's.
    if (walk.end.standing || i < walk.steps) {
      const double flat = smoothstep(std::abs(height) / (kFlatLanding * s_.scale));
      landing.strike_roll *= 1.0 - flat;
      if (height < 0.0) landing.strike_roll -= flat;
    }
    const auto swinging = [&] { return feet.at(i - 0.5)[feet.side(i)]; };
    if (wishes.lift) {
      const double arc = path.length() * (i - 0.5) / walk.steps;
      landing.swing.lift =
          liftFactor(askedLift(wishes.lift(arc), feet.side(i)), swinging(), cycle, foot);
    }
    if (!clearance_.clear(places[i - 1], places[i + 1], feet.side(i), cycle, landing.swing)) {
      walk.refused = WalkRule::kStepHeight;
      return;
    }
    const Eigen::Vector3d step = places[i + 1].position - places[i].position;
    // Left and right feet's toeing out cancel.
    const double heading =
        places[i].heading + 0.5 * wrapAngle(places[i + 1].heading - places[i].heading);
    walk.gait.push_back({step.x() * std::cos(heading) + step.y() * std::sin(heading),
                         swingLift(swinging(), cycle, foot), step.z()});
  }
}

// Double supports by the speed at each node. Short steps up and down are as quick as the long ones
// of a walk on the level, and their double support is that walk's.
void StepPlacer::support(WalkSteps& walk) const {
  const std::vector<FootPlace>& places = walk.feet->places();
  std::vector<double> halves(walk.steps + 1, s_.placement.half_support);
  for (int k = 1, node = 1; k < walk.frames() && node < walk.steps; ++k) {
    const SpeedProfile::Sample at = walk.at(k), before = walk.at(k - 1);
    if (at.steps < node) continue;
    const double cadence = (at.steps - before.steps) / s_.limits.frame_time;
    const bool climbs = std::abs(stepHeight(places[node], places[node + 1])) > kNaturalStep;
    const double speed = climbs ? std::max(at.speed, cadence * s_.placement.step_length) : at.speed;
    halves[node++] = 0.5 * doubleSupport(speed, s_.leg_length);
  }
  if (!walk.from.standing) halves[0] = halves[1] = walk.from_feet.placement.half_support;
  if (!walk.end.standing) {
    halves[walk.steps] = halves[walk.steps - 1] = walk.end_feet.placement.half_support;
  }
  walk.feet->setSupports(std::move(halves));
}

void StepPlacer::finish(WalkSteps& walk) const {
  const std::vector<FootPlace>& places = walk.feet->places();
  const double level = walk.from.position.z();
  walk.level = walk.from_feet.level && walk.end_feet.level;
  for (const FootPlace& place : places) walk.level = walk.level && onLevel(place, level);
  if (walk.level) return;
  std::vector<double> nodes, heights;
  for (int i = 0; i <= walk.steps; ++i) {
    nodes.push_back(i);
    heights.push_back(0.5 * (places[i].position.z() + places[i + 1].position.z()));
  }
  heights.front() = walk.from_feet.height;
  heights.back() = walk.end_feet.height;
  walk.height =
      CubicSpline(std::move(nodes), std::move(heights), walk.from_feet.rise, walk.end_feet.rise);
}

}  // namespace amble

#include "animation/steps/step_placer.h"

#include <algorithm>
#include <cmath>

#include "animation/steps/path_pace.h"
#include "animation/steps/slope_gait.h"
#include "animation/steps/wanted_walk.h"
#include "base/ease.h"
#include "base/rotation.h"

namespace amble {
namespace {

// Which foot steps first: from standing the one on the inside of the first turn, unless parity and
// the last foot say otherwise.
Side firstFoot(const WalkRequest& request, int steps, bool any_leading) {
  constexpr double kStraight = 1e-6;  // [1/m]
  const auto& [from, to, path, any, wishes, is_wanted, outlook] = request;
  if (!from.standing) return other(from.leading);
  if (!to.standing && !any_leading) return steps % 2 == 1 ? to.leading : other(to.leading);
  return path.at(0.5 * path.length()).curvature > kStraight ? kLeft : kRight;
}

// The foot in front after all steps.
Side lastFoot(const WalkSteps& walk) {
  return walk.steps % 2 == 1 ? walk.first : other(walk.first);
}

double paceOf(const SpeedLimits& limits, double arc) {
  return limits.pace ? limits.pace(arc) : 1.0;
}

// Of step i, that turns within the library's rate and is slower up and down.
double wantedDuration(const WalkSteps& walk, const RootPath& path, const SpeedLimits& limits,
                      const WantedWalk& wanted, double scale, int i, const TimedSteps& timed) {
  const std::vector<FootPlace>& places = walk.feet->places();
  const double middle = 0.5 * (timed.arcs[i - 1] + timed.arcs[i]);
  double where = middle;  // steps beside standing are slow however long they are
  if (i == 1 && walk.from.standing) where = 0.0;
  if (i == walk.steps && walk.end.standing) where = path.length();
  double duration = wanted.step(where) / wanted.speed(where);
  duration *= climbTime(stepHeight(places[i], places[i + 1]), scale);
  const double turning = std::abs(path.at(middle).curvature) / limits.max_turn_rate;
  return std::max(duration, (timed.arcs[i] - timed.arcs[i - 1]) * turning);
}

// Nodes are midway between prints; steps up and down take longer than those on the level.
TimedSteps timeSteps(const WalkSteps& walk, const FootstepPlan& plan, const RootPath& path,
                     const SpeedLimits& limits, const WantedWalk& wanted, double forward,
                     double scale) {
  TimedSteps timed;
  timed.frame_time = limits.frame_time;
  if (walk.from.standing) timed.start_sway = limits.law.onset().start_sway;
  if (walk.end.standing) timed.stop_sway = limits.law.onset().stop_sway;
  timed.first_speed = walk.from.standing ? 0.0 : limits.speed * paceOf(limits, 0.0);
  timed.last_speed = walk.end.standing ? 0.0 : limits.speed * paceOf(limits, path.length());
  for (int i = 0; i <= walk.steps; ++i) {
    timed.arcs.push_back(0.5 * (plan.arcs[i] + plan.arcs[i + 1]) - forward);
    timed.lengths.push_back(plan.arcs[i + 1] - plan.arcs[i]);
  }
  timed.arcs.front() = 0.0;
  timed.arcs.back() = path.length();
  timed.lengths.front() =
      walk.from.standing ? timed.lengths[1] : walk.from_feet.placement.step_length;
  timed.lengths.back() =
      walk.end.standing ? timed.lengths[walk.steps - 1] : walk.end_feet.placement.step_length;
  for (int i = 1; i <= walk.steps; ++i) {
    timed.durations.push_back(wantedDuration(walk, path, limits, wanted, scale, i, timed));
  }
  return timed;
}

// Double supports by the speed at each node and how fast the step to it turns. Short steps up and
// down are as quick as the long ones of a walk on the level, and their double support is that
// walk's.
std::vector<Footsteps::NodeSupport> nodeSupports(const WalkSteps& walk,
                                                 const StepSettings& settings) {
  const std::vector<FootPlace>& places = walk.feet->places();
  std::vector<Footsteps::NodeSupport> supports;
  const auto ofStance = [&](const StanceFeet& stance, int node) {
    return nodeSupport(stance.placement.supports, walk.feet->side(node));
  };
  const auto at = [&](double speed, int node) {
    const double rate = walk.feet->landings()[node + 1].turn_rate;
    return nodeSupport(settings.limits.law.supports(speed, rate), walk.feet->side(node));
  };
  for (int node = 0; node <= walk.steps; ++node) {
    supports.push_back(walk.timing
                           ? nodeSupport(settings.placement.supports, walk.feet->side(node))
                           : at(walk.profile->speedAt(walk.profile->arcAtStep(node)), node));
  }
  for (int k = 1, node = 1; walk.timing && k < walk.frames() && node < walk.steps; ++k) {
    const SpeedProfile::Sample now = walk.at(k), before = walk.at(k - 1);
    if (now.steps < node) continue;
    const double cadence = (now.steps - before.steps) / settings.limits.frame_time;
    const bool climbs = std::abs(stepHeight(places[node], places[node + 1])) > Unevenness::kNatural;
    supports[node] = at(
        climbs ? std::max(now.speed, cadence * settings.placement.step_length) : now.speed, node);
    ++node;
  }
  for (const int node : {0, 1}) {
    const int last = walk.steps - node;
    if (!walk.from.standing) supports[node] = ofStance(walk.from_feet, node);
    if (!walk.end.standing) supports[last] = ofStance(walk.end_feet, last);
  }
  return supports;
}

// Mean speed of the i-th step [m/s].
double speedOf(const SpeedProfile& profile, int step) {
  return profile.speedAt(0.5 * (profile.arcAtStep(step - 1) + profile.arcAtStep(step)));
}

// How much slower than the plan's walk each step is; at stances these say. Steps that are asked for
// are edited ones of the plan's walk, however short.
void slowSteps(const WalkDepartures& departures, const GaitWishes& wishes, WalkSteps& walk) {
  std::vector<Footsteps::Landing>& landings = walk.feet->landings();
  for (int i = 1; i <= walk.steps && !wishes.stride; ++i) {
    const double speed = walk.timing ? walk.timing->stepSpeed(i) : speedOf(*walk.profile, i);
    landings[i + 1].slower = departures.slowerBy(speed);
  }
  if (!walk.end.standing)
    for (const int i : {walk.steps, walk.steps + 1})
      landings[i].slower = walk.end_feet.placement.slower;
  // After the end's: of two steps the first is the begin's, whose rear heel is up already.
  if (!walk.from.standing)
    for (const int i : {0, 1, 2}) landings[i].slower = walk.from_feet.placement.slower;
}

// How fast each step turns that is level; a stance is that of a straight walk.
// @param arcs  of the nodes [m]
void turnSteps(const RootPath& path, const std::vector<double>& arcs, WalkSteps& walk) {
  const std::vector<FootPlace>& places = walk.feet->places();
  for (int i = 2; i + 1 < walk.steps; ++i) {
    const double highest = std::max(std::abs(stepHeight(places[i - 1], places[i + 1])),
                                    std::abs(stepHeight(places[i], places[i + 1])));
    if (highest > Unevenness::kNatural) continue;
    const double turn = wrapAngle(path.at(arcs[i]).heading - path.at(arcs[i - 1]).heading);
    walk.feet->landings()[i + 1].turn_rate =
        turn / (arcs[i] - arcs[i - 1]) * walk.timing->stepSpeed(i);
  }
}

// The root path's height over progress: at each node midway between the two feet.
CubicSpline rootHeight(const WalkSteps& walk) {
  const std::vector<FootPlace>& places = walk.feet->places();
  std::vector<double> nodes, heights;
  for (int i = 0; i <= walk.steps; ++i) {
    nodes.push_back(i);
    heights.push_back(0.5 * (places[i].position.z() + places[i + 1].position.z()));
  }
  heights.front() = walk.from_feet.height;
  heights.back() = walk.end_feet.height;
  return {std::move(nodes), std::move(heights), walk.from_feet.rise, walk.end_feet.rise};
}

// Where the walk puts down placing i, along a path so long: midway between its two nodes. Beside
// captured standing steps are short: there the first and the last node is midway between the prints
// around it, as captured.
double printArc(const WalkSteps& walk, const FootPlacement& placement, double length, int i) {
  const SpeedProfile& profile = *walk.profile;
  const bool first = i == 1 && walk.from.standing && placement.first[walk.first].captured;
  const bool last =
      i == walk.steps - 2 && walk.end.standing && placement.last[lastFoot(walk)].captured;
  if (first && !last) return 2.0 * profile.arcAtStep(1);
  if (last && !first) return 2.0 * profile.arcAtStep(walk.steps - 1) - length;
  return 0.5 * (profile.arcAtStep(i) + profile.arcAtStep(i + 1));
}

// Mean turn rate of the i-th step of a path [rad/s].
double turnRateOf(const SpeedProfile& profile, const RootPath& path, int step) {
  const double from = profile.arcAtStep(step - 1), to = profile.arcAtStep(step);
  const double turn = wrapAngle(path.at(to).heading - path.at(from).heading);
  return turn / (to - from) * profile.speedAt(0.5 * (from + to));
}

bool isLevel(const WalkSteps& walk) {
  if (!walk.from_feet.level || !walk.end_feet.level) return false;
  const std::vector<FootPlace>& places = walk.feet->places();
  return std::all_of(places.begin(), places.end(), [&](const FootPlace& place) {
    return onLevel(place, walk.from.position.z());
  });
}

}  // namespace

double WalkSteps::heightAt(const SpeedProfile::Sample& at, double length) const {
  if (!level) return height.at(at.steps);
  return from.position.z() + smoothstep(at.arc / length) * (end.position.z() - from.position.z());
}

StepPlacer::StepPlacer(const Ground& ground, const std::array<FootShape, 2>& shapes,
                       const SwingCycles& cycles, const StepSettings& settings)
    : s_(settings),
      holds_(ground, shapes, settings.footholds),
      swings_{shapes, cycles, settings.captured_lift, settings.scale},
      clearance_(ground, shapes, kHighestLift * settings.scale) {}

WalkSteps StepPlacer::plan(const WalkRequest& request) const {
  const auto& [from, to, path, any_leading, wishes, is_wanted, outlook] = request;
  WalkSteps walk;
  walk.from = from;
  walk.end = to;
  walk.from_feet = stanceFeet(from);
  walk.end_feet = stanceFeet(to);
  walk.refused = walk.from_feet.refused;
  if (walk.refused == WalkRule::kNone) walk.refused = walk.end_feet.refused;
  if (walk.refused != WalkRule::kNone) return walk;

  SpeedLimits limits = s_.limits;
  limits.pace = paceAlong(s_, holds_, path, from, to);
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
  if (!whole || !natural(walk, request)) {
    // Where there is no whole number of steps on the level, there is none.
    if (!whole && walk.from_feet.level && walk.end_feet.level &&
        walk.from_feet.height == walk.end_feet.height) {
      return walk;
    }
    if (outlook) {
      walk.refused = WalkRule::kNone;
    } else if (mayBeWanted(request)) {
      adapted(walk, request, limits);
    } else {
      walk.refused = WalkRule::kNone;
      walk.unwanted = true;
    }
  }
  if (walk.refused != WalkRule::kNone || walk.unwanted || outlook) return walk;
  walk.feet->setSupports(nodeSupports(walk, s_));
  walk.level = isLevel(walk);
  if (!walk.level) walk.height = rootHeight(walk);
  return walk;
}

// Whether a walk whose steps are chosen for the ground might be, of all that it could come out as
// the shortest: on a straight line, at the highest speed.
bool StepPlacer::mayBeWanted(const WalkRequest& request) const {
  if (request.is_wanted == nullptr) return true;
  const double straight = (request.to.position - request.from.position).head<2>().norm();
  const double time = straight / (kFastest * s_.limits.speed);
  const int least = static_cast<int>(time / s_.limits.frame_time);
  const Side leading = request.to.leading;
  return (*request.is_wanted)(least, leading, {}) ||
         (request.any_leading && !request.to.standing &&
          (*request.is_wanted)(least, other(leading), {}));
}

// Steps as they follow from the speed, each on the ground where it falls. False where one does not
// stand whole there or is high: then `refused` says which rule.
bool StepPlacer::natural(WalkSteps& walk, const WalkRequest& request) const {
  const SpeedProfile& profile = *walk.profile;
  walk.steps = profile.steps();
  walk.first = firstFoot(request, walk.steps, request.any_leading);
  if (lastFoot(walk) != walk.end.leading) {
    Stance end = walk.end;
    end.leading = lastFoot(walk);
    const StanceFeet feet = stanceFeet(end);
    walk.refused = feet.refused;
    if (walk.refused != WalkRule::kNone) return false;  // and it ends as asked, if at all
    walk.end = end;
    walk.end_feet = feet;
  }
  walk.feet.emplace(s_.placement, walk.from, walk.end, walk.steps, walk.first);
  const double length = request.path.length();
  std::vector<double> rates(walk.steps + 1, 0.0);
  for (int i = 1; i <= walk.steps; ++i) rates[i] = turnRateOf(profile, request.path, i);
  slowSteps(swings_.cycles.departures, request.wishes, walk);
  const std::vector<Footsteps::Landing>& landings = walk.feet->landings();
  walk.feet->place([&](int i) {
    const double s = printArc(walk, s_.placement, length, i) + s_.placement.forward;
    const Side side = walk.feet->side(i);
    return footBeside(
        pathPoint(request.path, s, walk.from.position.z()),
        swings_.cycles.print(side, s_.placement.print(side), landings[i + 2].slower, rates[i + 1]));
  });
  for (int i = 2; i + 1 < walk.steps; ++i) walk.feet->landings()[i + 1].turn_rate = rates[i];
  walk.feet->setStances(walk.from_feet.feet, walk.end_feet.feet);
  walk.refused = standOnGround(*walk.feet);
  if (walk.refused == WalkRule::kNone) swing(walk, request);
  return walk.refused == WalkRule::kNone;
}

Eigen::AlignedBox1d StepPlacer::tooHighToSwingOver() const {
  const double highest = swings_.cycles.most(
      [this](const FootCycle& cycle) { return clearance_.highestCleared(cycle); });
  return {highest, clearance_.highestSeen()};
}

// Unless that is not wanted.
void StepPlacer::swing(WalkSteps& walk, const WalkRequest& request) const {
  if (request.is_wanted != nullptr) {
    const std::vector<FootPlace>& places = walk.feet->places();
    walk.gait.clear();
    for (int i = 1; i <= walk.steps; ++i)
      walk.gait.push_back(gaitOf(places[i], places[i + 1], 0.0));
    walk.unwanted = !(*request.is_wanted)(walk.frames(), walk.end.leading, walk.gait);
    if (walk.unwanted) return;
  }
  if (request.outlook) return;
  if (!shapeSwings(swings_, clearance_, request.wishes, request.path.length(), walk.end.standing,
                   *walk.feet, walk.gait)) {
    walk.refused = WalkRule::kStepHeight;
  }
}

WalkRule StepPlacer::standOnGround(Footsteps& steps) const {
  std::vector<FootPlace>& places = steps.places();
  for (int i = 1; i + 1 < steps.steps(); ++i) {
    FootPlace& place = places[i + 1];
    place.position.z() = places[i].position.z();
    const Foothold hold = holds_.at(place, steps.side(i), s_.reach());
    if (hold.refusal != Foothold::Refusal::kNone) return ruleOf(hold.refusal);
    if (hold.supported < 1.0) return WalkRule::kFoothold;
    place = hold.place;
  }
  for (size_t i = 0; i + 1 < places.size(); ++i) {
    if (std::abs(stepHeight(places[i], places[i + 1])) > Unevenness::kNatural)
      return WalkRule::kFoothold;
  }
  return WalkRule::kNone;
}

// Steps that are chosen for the ground.
void StepPlacer::adapted(WalkSteps& walk, const WalkRequest& request,
                         const SpeedLimits& limits) const {
  const WalkRule natural_rule = walk.refused;
  Stance other_end = walk.end;
  other_end.leading = other(walk.end.leading);
  const StanceFeet other_feet = stanceFeet(other_end);
  const double forward = s_.placement.forward;
  const WantedWalk usual(request.path, walk.from, walk.end, limits, s_.placement.step_length);
  const PrintAlong print = [&](Side side, double arc) {
    const WalkDepartures& departures = swings_.cycles.departures;
    const double slower =
        request.wishes.stride ? 0.0 : departures.slowerBy(usual.speed(arc - forward));
    return swings_.cycles.print(side, s_.placement.print(side), slower,
                                usual.turnRate(arc - forward));
  };
  const FootstepRequest wanted{
      .path = request.path,
      .placement = s_.placement,
      .from = walk.from,
      .to = walk.end,
      .from_feet = walk.from_feet.feet,
      .to_feet = walk.end_feet.feet,
      .to_other_feet = other_feet.feet,
      .any_leading = request.any_leading && other_feet.refused == WalkRule::kNone,
      .preferred = firstFoot(request, 0, true),
      .print = print,
      .wanted =
          [&](double arc) {
            return request.wishes.stride ? request.wishes.stride(arc) : usual.step(arc);
          },
      .shortest = StrideLaw::kShortestStep * limits.law.capturedStep(),
      .longest = StrideLaw::kLongestStep * limits.law.capturedStep(),
  };
  const FootstepPlan plan = planFootsteps(wanted, holds_);
  walk.refused = plan.refused;
  if (plan.refused != WalkRule::kNone) {
    if (natural_rule == WalkRule::kSlope) walk.refused = natural_rule;
    return;
  }
  walk.steps = plan.steps;
  walk.first = plan.first;
  if (lastFoot(walk) != walk.end.leading) walk.end = other_end, walk.end_feet = other_feet;
  walk.feet.emplace(s_.placement, walk.from, walk.end, walk.steps, walk.first);
  walk.feet->setStances(walk.from_feet.feet, walk.end_feet.feet);
  for (int i = 1; i + 1 < walk.steps; ++i) walk.feet->places()[i + 1] = plan.places[i + 1];
  const TimedSteps timed =
      timeSteps(walk, plan, request.path, limits, usual, s_.placement.forward, s_.scale);
  walk.timing.emplace(timed);
  slowSteps(swings_.cycles.departures, request.wishes, walk);
  turnSteps(request.path, timed.arcs, walk);
  swing(walk, request);
}

}  // namespace amble

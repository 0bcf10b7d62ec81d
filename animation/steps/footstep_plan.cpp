#include "animation/steps/footstep_plan.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "animation/steps/footstep_trials.h"
#include "animation/steps/slope_gait.h"
#include "animation/steps/unevenness.h"

namespace amble {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

// The cheapest way to a place.
struct Way {
  double cost = kNever;
  int before = -1;  // index along the other foot's line; -1: the begin
};
using Ways = std::array<std::vector<Way>, 2>;  // by Side, as the trials

// In plan, from rear to front, if the front foot were not staggered against the other.
double stanceStep(const FootstepRequest& r, const std::array<FootPlace, 2>& feet, Side front) {
  const Eigen::Vector2d d = (feet[kLeft].position - feet[kRight].position).head<2>();
  const double heading = 0.5 * (feet[kLeft].heading + feet[kRight].heading);
  const double stagger = r.placement.print(front).forward - r.placement.print(other(front)).forward;
  return std::abs(d.dot(Eigen::Vector2d(std::cos(heading), std::sin(heading)))) - stagger;
}

TrialRequest trialsOf(const FootstepRequest& r) {
  const double forward = r.placement.forward;
  return {r.path, r.print,
          forward + (r.from.standing ? 0.0 : 0.5 * stanceStep(r, r.from_feet, r.from.leading)),
          r.path.length() + forward -
              (r.to.standing ? 0.0 : 0.5 * stanceStep(r, r.to_feet, r.to.leading)),
          r.from.position.z()};
}

// The feet of the end, where `side` is the last but one to be put down.
const std::array<FootPlace, 2>& endFeet(const FootstepRequest& r, Side side) {
  return r.to.standing || side != r.to.leading ? r.to_feet : r.to_other_feet;
}

// Whether a foot could stand between the two, on something that is neither's surface nor on the
// slope between them.
bool passesTread(const FootTrials& trials, const FootPlace& a, double arc_a, const FootPlace& b,
                 double arc_b) {
  constexpr double kLeast = Unevenness::kLeastStep, kSpacing = TrialGrid::kSpacing;
  const double rise = b.position.z() - a.position.z();
  if (std::abs(rise) < 2.0 * kLeast) return false;
  const double slope = rise / (arc_b - arc_a);
  const int first = static_cast<int>(std::ceil((arc_a - trials.begin) / kSpacing)) - 1;
  const int last = static_cast<int>(std::floor((arc_b - trials.begin) / kSpacing)) - 1;
  for (int k = std::max(first, 0); k <= std::min(last, trials.count() - 1); ++k) {
    for (const Side side : {kLeft, kRight}) {
      const FootTrial& trial = trials.lines[side][k];
      if (!trial.stands()) continue;
      const FootPlace& place = trial.hold.place;
      const double up = place.position.z() - a.position.z();
      const bool between = up * rise > 0.0 && std::abs(up) > kLeast &&
                           std::abs(rise - up) > kLeast && std::abs(up) < std::abs(rise);
      if (between && std::abs(trial.tilt - slope) > FootstepCosts::kTreadTilt) return true;
    }
  }
  return false;
}

double shortened(double level, double height) {
  return std::abs(height) < Unevenness::kLeastStep ? level : climbStep(level, height);
}

// Of a way of the cost `so_far` and a step in plan along the path; kNever where that may not be or
// is no less than `least`. Steps that are too high are counted.
double stepCost(const FootstepRequest& r, const GroundLimits& limits, const FootTrials& trials,
                const FootPlace& a, double arc_a, const FootPlace& b, double arc_b, double so_far,
                double least, int& too_high) {
  const double step = arc_b - arc_a;
  if (step < r.shortest || step > r.longest) return kNever;
  const double height = stepHeight(a, b);
  if (height > limits.max_climb || -height > limits.max_drop) {
    ++too_high;
    return kNever;
  }
  if (so_far >= least) return kNever;
  const double level = r.wanted(0.5 * (arc_a + arc_b));
  const double off = (step - shortened(level, height)) / level;
  if (so_far + off * off >= least) return kNever;
  const double cost =
      so_far + (off * off + (passesTread(trials, a, arc_a, b, arc_b) ? FootstepCosts::kSkip : 0.0));
  return cost < least ? cost : kNever;
}

// The cheapest way to a trial of `side`, from the other foot's places or, where there is one, from
// the begin.
Way cheapestWay(const FootstepRequest& r, const GroundLimits& limits, const FootTrials& trials,
                const Ways& ways, const FootTrial& trial, Side side, const FootPlace* begin,
                int& too_high) {
  const double own = FootstepCosts::kOverhang * (1.0 - trial.hold.supported) +
                     FootstepCosts::kAside * trial.aside / TrialGrid::kAside.back();
  const FootPlace& place = trial.hold.place;
  Way way;
  if (begin != nullptr) {
    const double cost =
        stepCost(r, limits, trials, *begin, trials.begin, place, trial.arc, own, kNever, too_high);
    if (cost < way.cost) way = {cost, -1};
  }
  const auto& from = trials.lines[other(side)];
  const double into = trial.arc - trials.begin;
  const int nearest = static_cast<int>((into - r.shortest) / TrialGrid::kSpacing);
  const int farthest = static_cast<int>((into - r.longest) / TrialGrid::kSpacing) - 1;
  for (int k = std::max(farthest, 0); k <= std::min(nearest, trials.count() - 1); ++k) {
    const double so_far = ways[other(side)][k].cost;
    if (so_far >= way.cost) continue;
    const double cost = stepCost(r, limits, trials, from[k].hold.place, from[k].arc, place,
                                 trial.arc, so_far + own, way.cost, too_high);
    if (cost < way.cost) way = {cost, k};
  }
  return way;
}

// How much farther than it need a foot stands before what the next steps up to.
double kneeRoom(double height) {
  return FootstepCosts::kKneeRoom * std::max(0.0, height - FootstepCosts::kKneeClears);
}

Side sideOf(const FootstepPlan& plan, int i) { return i % 2 == 0 ? plan.first : other(plan.first); }

// Puts each place between its neighbours as their wanted steps have it, on the surface that it
// stands on; narrow surfaces draw it to their middle.
void evenOut(const FootstepRequest& r, const TrialRequest& along, const FootholdFinder& holds,
             const FootTrials& trials, const std::vector<int>& chain, FootstepPlan& plan) {
  constexpr double kNarrow = TrialGrid::kNarrow, kNarrowest = FootstepCosts::kNarrowest;
  const int n = static_cast<int>(chain.size());
  std::vector<std::pair<double, double>> free(n);
  for (int i = 0; i < n; ++i) {
    free[i] = surfaceAround(along, holds, trials, sideOf(plan, i), chain[i]);
    const double room = kneeRoom(stepHeight(plan.places[i + 2], plan.places[i + 3]));
    free[i].second = std::max(free[i].first, free[i].second - room);
  }
  std::vector<double> wanted(n + 1);
  for (int i = 0; i <= n; ++i) {
    const double level = r.wanted(0.5 * (plan.arcs[i + 1] + plan.arcs[i + 2]));
    wanted[i] = shortened(level, stepHeight(plan.places[i + 1], plan.places[i + 2]));
  }
  for (int sweep = 0; sweep < FootstepCosts::kSweeps; ++sweep) {
    for (int i = 0; i < n; ++i) {
      const double before = plan.arcs[i + 1], after = plan.arcs[i + 3];
      const double even = before + (after - before) * wanted[i] / (wanted[i] + wanted[i + 1]);
      const auto [low, high] = free[i];
      const double pull = std::clamp((kNarrow - (high - low)) / (kNarrow - kNarrowest), 0.0, 1.0);
      const double at = std::clamp(even + pull * (0.5 * (low + high) - even), low, high);
      // No step becomes longer or shorter for it than steps may be.
      const double here = plan.arcs[i + 2];
      const double least = std::max(before + r.shortest, after - r.longest);
      const double most = std::min(before + r.longest, after - r.shortest);
      plan.arcs[i + 2] = std::clamp(at, std::min(least, here), std::max(most, here));
    }
  }
  for (int i = 0; i < n; ++i) {  // the exact place; the one that was tried where that fails
    const FootTrial& trial = trials.lines[sideOf(plan, i)][chain[i]];
    const Foothold hold = holdAt(along, holds, sideOf(plan, i), trial, plan.arcs[i + 2]);
    const bool stands = standsLike(trial.hold, hold);
    plan.places[i + 2] = stands ? hold.place : trial.hold.place;
    if (!stands) plan.arcs[i + 2] = trial.arc;
  }
}

// The sequence that a way to the last placing but one, of `side`, came by.
FootstepPlan traced(const FootstepRequest& r, const TrialRequest& along, const FootTrials& trials,
                    const Ways& ways, const Way& last, Side side, Side first,
                    std::vector<int>& chain) {
  chain.clear();
  Side at = other(side);
  for (int k = last.before; k >= 0; at = other(at)) {
    chain.push_back(k);
    k = ways[at][k].before;
  }
  std::reverse(chain.begin(), chain.end());
  FootstepPlan plan;
  plan.first = first;
  plan.steps = static_cast<int>(chain.size()) + 2;
  const auto add = [&](double arc, const FootPlace& place) {
    plan.arcs.push_back(arc);
    plan.places.push_back(place);
  };
  add(along.begin - (r.from.standing ? 0.0 : stanceStep(r, r.from_feet, r.from.leading)),
      r.from_feet[first]);
  add(along.begin, r.from_feet[other(first)]);
  for (size_t i = 0; i < chain.size(); ++i) {
    const FootTrial& trial = trials.lines[sideOf(plan, static_cast<int>(i))][chain[i]];
    add(trial.arc, trial.hold.place);
  }
  const auto& feet = endFeet(r, side);
  add(along.end, feet[side]);
  add(r.to.standing ? along.end : along.end + stanceStep(r, feet, other(side)), feet[other(side)]);
  return plan;
}

WalkRule ruleOf(const FootTrials& trials, int too_high) {
  const int edge = trials.refused(Foothold::Refusal::kEdge);
  const int slope = trials.refused(Foothold::Refusal::kSlope);
  const int none = trials.refused(Foothold::Refusal::kNoGround);
  if (slope > std::max(edge, none)) return WalkRule::kSlope;
  if (none > edge && trials.out_of_step == 0) return WalkRule::kNoGround;
  return too_high + trials.out_of_step > 0 ? WalkRule::kStepHeight : WalkRule::kFoothold;
}

FootstepPlan planFrom(const FootstepRequest& r, const FootholdFinder& holds,
                      const TrialRequest& along, const FootTrials& trials, Side first,
                      int& too_high) {
  const GroundLimits& limits = holds.limits();
  Ways ways;
  for (auto& line : ways) line.resize(trials.count());
  const auto wayTo = [&](const FootTrial& trial, Side side) {
    const FootPlace* begin = side == first ? &r.from_feet[other(first)] : nullptr;
    return cheapestWay(r, limits, trials, ways, trial, side, begin, too_high);
  };
  for (int k = 0; k < trials.count(); ++k) {
    for (const Side side : {kLeft, kRight}) {
      const FootTrial& trial = trials.lines[side][k];
      if (trial.stands()) ways[side][k] = wayTo(trial, side);
    }
  }
  // The end: the last but one placing stands where the stance has it.
  FootstepPlan best;
  best.refused = ruleOf(trials, too_high);
  double least = kNever;
  for (const Side side : {kLeft, kRight}) {
    if (!r.to.standing && !r.any_leading && side == r.to.leading) continue;
    FootTrial last;
    last.arc = along.end;
    last.hold.place = endFeet(r, side)[side];
    const Way way = wayTo(last, side);
    if (way.cost >= least) continue;
    least = way.cost;
    std::vector<int> chain;
    best = traced(r, along, trials, ways, way, side, first, chain);
    evenOut(r, along, holds, trials, chain, best);
  }
  return best;
}

}  // namespace

FootstepPlan planFootsteps(const FootstepRequest& request, const FootholdFinder& holds) {
  const TrialRequest along = trialsOf(request);
  const FootTrials trials = tryPlaces(along, holds);
  int too_high = 0;
  if (!request.from.standing)
    return planFrom(request, holds, along, trials, other(request.from.leading), too_high);
  const FootstepPlan plan = planFrom(request, holds, along, trials, request.preferred, too_high);
  if (plan.refused == WalkRule::kNone) return plan;
  return planFrom(request, holds, along, trials, other(request.preferred), too_high);
}

}  // namespace amble

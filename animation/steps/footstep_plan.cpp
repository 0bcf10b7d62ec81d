#include "animation/steps/footstep_plan.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace amble {
namespace {

constexpr double kFar = 1.5;       // up to which ground that is out of a step's reach is seen [m]
constexpr double kSpacing = 0.02;  // of the places that are tried [m]
// Steps up and down are shorter: by half at this height; by trial [m].
constexpr double kHalvingHeight = 0.25;
constexpr double kLeastStep = 0.04;  // a lower one is unevenness [m]
// Costs, against that of a step twice as long as wanted, which is 1; by trial.
constexpr double kOverhangCost = 2.0;  // of a sole that overhangs by all of its length
constexpr double kSkipCost = 0.5;      // of passing over a tread
constexpr double kAsideCost = 0.1;     // of a foot put down beside its line
// A tread between two prints: its tilt differs from the line's by more [1].
constexpr double kTreadTilt = 0.08;
constexpr std::array<double, 3> kAside = {0.0, 0.04, 0.08};  // outwards of its line [m]
// Surfaces shorter than this draw a foot towards their middle [m].
constexpr double kNarrow = 0.3, kNarrowest = 0.15;
constexpr double kFinest = 0.001;  // to which their ends are found [m]
constexpr int kSweeps = 40;        // of evening out
constexpr double kNever = std::numeric_limits<double>::infinity();

// Rise per metre of the plane that a foot stands in, along a direction in plan.
double tiltAlong(const FootPlace& place, const Eigen::Vector2d& direction) {
  return -place.normal.head<2>().dot(direction) / place.normal.z();
}

}  // namespace

GroundPoint pathPoint(const RootPath& path, double arc, double z) {
  const RootPath::Sample at = path.at(arc);
  const double beyond = arc < 0.0 ? arc : std::max(0.0, arc - path.length());
  return {{at.position.x() + beyond * std::cos(at.heading),
           at.position.y() + beyond * std::sin(at.heading), z},
          at.heading};
}

double stepHeight(const FootPlace& a, const FootPlace& b) {
  const Eigen::Vector2d line = (b.position - a.position).head<2>();
  const double slope = 0.5 * (tiltAlong(a, line) + tiltAlong(b, line));
  return b.position.z() - a.position.z() - slope;
}

namespace {

// A place that is tried, and the cheapest way to it.
struct Trial {
  double arc = 0.0;
  Foothold hold;
  double aside = 0.0;  // cost
  double cost = kNever;
  int before = -1;  // index along the other foot's line; -1: the begin
};

class Planner {
 public:
  Planner(const FootstepRequest& request, const FootholdFinder& holds)
      : r_(request), holds_(holds), length_(request.path.length()) {
    begin_arc_ = r_.placement.forward + (r_.from.standing ? 0.0 : 0.5 * stanceStep(r_.from_feet));
    end_arc_ =
        length_ + r_.placement.forward - (r_.to.standing ? 0.0 : 0.5 * stanceStep(r_.to_feet));
    tryPlaces();
  }

  FootstepPlan plan() {
    if (!r_.from.standing) return planFrom(other(r_.from.leading));
    FootstepPlan plan = planFrom(r_.preferred);
    return plan.refused == WalkRule::kNone ? plan : planFrom(other(r_.preferred));
  }

 private:
  // In plan, from rear to front.
  static double stanceStep(const std::array<FootPlace, 2>& feet) {
    const Eigen::Vector2d d = (feet[kLeft].position - feet[kRight].position).head<2>();
    const double heading = 0.5 * (feet[kLeft].heading + feet[kRight].heading);
    return std::abs(d.dot(Eigen::Vector2d(std::cos(heading), std::sin(heading))));
  }

  void tryPlaces() {
    const FootholdLimits& limits = holds_.limits();
    const double reach = std::max(limits.max_climb, limits.max_drop) + kLeastStep;
    const int count = std::max(0, static_cast<int>((end_arc_ - begin_arc_) / kSpacing));
    double z = r_.from.position.z();
    for (int k = 1; k < count; ++k) {
      const double arc = begin_arc_ + k * kSpacing;
      const GroundPoint point = pathPoint(r_.path, arc, z);
      const auto near = holds_.heightNear(point.position, reach);
      if (!near && holds_.heightNear(point.position, kFar)) ++out_of_step_;
      z = near.value_or(z);
      for (const Side side : {kLeft, kRight}) {
        Trial trial;
        trial.arc = arc;
        for (const double aside : kAside) {
          FootPlace place = footBeside(point, side, r_.placement.walk_width + 2.0 * aside,
                                       r_.placement.walk_toe_out);
          place.position.z() = z;
          trial.hold = holds_.at(place, side, reach);
          trial.aside = aside > 0.0 ? kAsideCost * aside / kAside.back() : 0.0;
          if (trial.hold.refusal == Foothold::Refusal::kNone) break;
        }
        if (trial.hold.refusal != Foothold::Refusal::kNone)
          ++refusals_[static_cast<int>(trial.hold.refusal)];
        lines_[side].push_back(trial);
      }
    }
  }

  // Of a step in plan along the path; kNever where it may not be.
  double stepCost(const FootPlace& a, double arc_a, const FootPlace& b, double arc_b) {
    const double step = arc_b - arc_a;
    if (step < r_.shortest || step > r_.longest) return kNever;
    const double height = stepHeight(a, b);
    if (height > holds_.limits().max_climb || -height > holds_.limits().max_drop) {
      ++too_high_;
      return kNever;
    }
    const double level = r_.wanted(0.5 * (arc_a + arc_b));
    const double off = (step - shortened(level, height)) / level;
    return off * off + (passesTread(a, arc_a, b, arc_b) ? kSkipCost : 0.0);
  }

  static double shortened(double level, double height) {
    if (std::abs(height) < kLeastStep) return level;
    return level / (1.0 + height * height / (kHalvingHeight * kHalvingHeight));
  }

  // Whether a foot could stand between the two, on something that is neither's surface nor on the
  // slope between them.
  bool passesTread(const FootPlace& a, double arc_a, const FootPlace& b, double arc_b) const {
    const double rise = b.position.z() - a.position.z();
    if (std::abs(rise) < 2.0 * kLeastStep) return false;
    const double slope = rise / (arc_b - arc_a);
    const auto& line = lines_[kLeft];
    const int first = static_cast<int>(std::ceil((arc_a - begin_arc_) / kSpacing)) - 1;
    const int last = static_cast<int>(std::floor((arc_b - begin_arc_) / kSpacing)) - 1;
    for (int k = std::max(first, 0); k <= std::min(last, static_cast<int>(line.size()) - 1); ++k) {
      for (const Side side : {kLeft, kRight}) {
        const Foothold& hold = lines_[side][k].hold;
        if (hold.refusal != Foothold::Refusal::kNone) continue;
        const double up = hold.place.position.z() - a.position.z();
        const bool between = up * rise > 0.0 && std::abs(up) > kLeastStep &&
                             std::abs(rise - up) > kLeastStep && std::abs(up) < std::abs(rise);
        const Eigen::Vector2d ahead(std::cos(hold.place.heading), std::sin(hold.place.heading));
        if (between && std::abs(tiltAlong(hold.place, ahead) - slope) > kTreadTilt) return true;
      }
    }
    return false;
  }

  FootstepPlan planFrom(Side first) {
    const FootPlace& begin = r_.from_feet[other(first)];
    const int count = static_cast<int>(lines_[kLeft].size());
    for (auto& line : lines_) {
      for (Trial& trial : line) trial.cost = kNever, trial.before = -1;
    }
    for (int k = 0; k < count; ++k) {
      for (const Side side : {kLeft, kRight}) {
        Trial& trial = lines_[side][k];
        if (trial.hold.refusal != Foothold::Refusal::kNone) continue;
        reach(trial, side == first ? &begin : nullptr, side);
      }
    }
    // The end: the last but one placing stands where the stance has it.
    FootstepPlan best;
    best.refused = rule();
    double least = kNever;
    for (const Side side : {kLeft, kRight}) {
      if (!r_.to.standing && !r_.any_leading && side == r_.to.leading) continue;
      Trial last;
      last.arc = end_arc_;
      last.hold.place = endFeet(side)[side];
      reach(last, side == first ? &begin : nullptr, side);
      if (last.cost >= least) continue;
      least = last.cost;
      best = traced(last, side, first);
    }
    return best;
  }

  // The feet of the end, where `side` is the last but one to be put down.
  const std::array<FootPlace, 2>& endFeet(Side side) const {
    return r_.to.standing || side != r_.to.leading ? r_.to_feet : r_.to_other_feet;
  }

  // Finds the cheapest way to a trial, from the other foot's places or from the begin.
  void reach(Trial& trial, const FootPlace* begin, Side side) {
    const double own = kOverhangCost * (1.0 - trial.hold.supported) + trial.aside;
    if (begin != nullptr) {
      const double cost = stepCost(*begin, begin_arc_, trial.hold.place, trial.arc);
      if (cost + own < trial.cost) trial.cost = cost + own, trial.before = -1;
    }
    const auto& from = lines_[other(side)];
    const int nearest = static_cast<int>((trial.arc - r_.shortest - begin_arc_) / kSpacing);
    const int farthest = static_cast<int>((trial.arc - r_.longest - begin_arc_) / kSpacing) - 1;
    for (int k = std::max(farthest, 0); k <= std::min(nearest, static_cast<int>(from.size()) - 1);
         ++k) {
      if (from[k].cost >= trial.cost) continue;
      const double cost = from[k].cost + own +
                          stepCost(from[k].hold.place, from[k].arc, trial.hold.place, trial.arc);
      if (cost < trial.cost) trial.cost = cost, trial.before = k;
    }
  }

  FootstepPlan traced(const Trial& last, Side side, Side first) {
    std::vector<int> chain;  // of indices, last first
    Side at = other(side);
    for (int k = last.before; k >= 0; at = other(at)) {
      chain.push_back(k);
      k = lines_[at][k].before;
    }
    std::reverse(chain.begin(), chain.end());
    FootstepPlan plan;
    plan.first = first;
    plan.steps = static_cast<int>(chain.size()) + 2;
    const auto add = [&](double arc, const FootPlace& place) {
      plan.arcs.push_back(arc);
      plan.places.push_back(place);
    };
    const double begin_step = r_.from.standing ? 0.0 : stanceStep(r_.from_feet);
    add(begin_arc_ - begin_step, r_.from_feet[first]);
    add(begin_arc_, r_.from_feet[other(first)]);
    Side stands = first;
    for (const int k : chain) {
      add(lines_[stands][k].arc, lines_[stands][k].hold.place);
      stands = other(stands);
    }
    const auto& feet = endFeet(side);
    add(end_arc_, feet[side]);
    add(r_.to.standing ? end_arc_ : end_arc_ + stanceStep(feet), feet[other(side)]);
    evenOut(plan, chain);
    return plan;
  }

  // Arcs around place k on which a foot stands as well, on the same surface.
  std::pair<double, double> surfaceAround(Side side, int k) const {
    const auto& line = lines_[side];
    const auto same = [&](int i, int j) {
      const Foothold &a = line[i].hold, &b = line[j].hold;
      return b.refusal == Foothold::Refusal::kNone && line[j].aside == line[k].aside &&
             b.supported >= line[k].hold.supported - 1e-9 &&
             std::abs(stepHeight(a.place, b.place)) < 0.5 * kLeastStep;
    };
    int low = k, high = k;
    while (low > 0 && same(low, low - 1)) --low;
    while (high + 1 < static_cast<int>(line.size()) && same(high, high + 1)) ++high;
    std::pair<double, double> arcs = {line[low].arc, line[high].arc};
    if (arcs.second - arcs.first >= kNarrow) return arcs;
    // Its ends, finer than the places that were tried.
    for (double step = 0.5 * kSpacing; step > kFinest; step *= 0.5) {
      if (standsLike(side, line[k], arcs.first - step)) arcs.first -= step;
      if (standsLike(side, line[k], arcs.second + step)) arcs.second += step;
    }
    return arcs;
  }

  Foothold holdAt(Side side, const Trial& trial, double arc) const {
    const GroundPoint point = pathPoint(r_.path, arc, trial.hold.place.position.z());
    const double aside = trial.aside * kAside.back() / kAsideCost;
    const FootPlace place =
        footBeside(point, side, r_.placement.walk_width + 2.0 * aside, r_.placement.walk_toe_out);
    return holds_.at(place, side, std::max(holds_.limits().max_climb, holds_.limits().max_drop));
  }

  // Whether a foot stands at an arc as well as in a trial, on the same surface.
  bool standsLike(Side side, const Trial& trial, double arc) const {
    const Foothold hold = holdAt(side, trial, arc);
    return hold.refusal == Foothold::Refusal::kNone &&
           hold.supported >= trial.hold.supported - 1e-9 &&
           std::abs(stepHeight(trial.hold.place, hold.place)) < 0.5 * kLeastStep;
  }

  void evenOut(FootstepPlan& plan, const std::vector<int>& chain) {
    const int n = static_cast<int>(chain.size());
    std::vector<std::pair<double, double>> free(n);
    for (int i = 0; i < n; ++i) free[i] = surfaceAround(sideOf(plan, i), chain[i]);
    std::vector<double> wanted(n + 1);
    for (int i = 0; i <= n; ++i) {
      const double level = r_.wanted(0.5 * (plan.arcs[i + 1] + plan.arcs[i + 2]));
      wanted[i] = shortened(level, stepHeight(plan.places[i + 1], plan.places[i + 2]));
    }
    for (int sweep = 0; sweep < kSweeps; ++sweep) {
      for (int i = 0; i < n; ++i) {
        const double before = plan.arcs[i + 1], after = plan.arcs[i + 3];
        const double even = before + (after - before) * wanted[i] / (wanted[i] + wanted[i + 1]);
        const auto [low, high] = free[i];
        const double pull = std::clamp((kNarrow - (high - low)) / (kNarrow - kNarrowest), 0.0, 1.0);
        plan.arcs[i + 2] = std::clamp(even + pull * (0.5 * (low + high) - even), low, high);
      }
    }
    for (int i = 0; i < n; ++i) standAgain(plan, i, chain[i]);
  }

  static Side sideOf(const FootstepPlan& plan, int i) {
    return i % 2 == 0 ? plan.first : other(plan.first);
  }

  // The exact place after evening out; the one that was tried where that does not stand.
  void standAgain(FootstepPlan& plan, int i, int k) {
    const Side side = sideOf(plan, i);
    const Trial& trial = lines_[side][k];
    const Foothold hold = holdAt(side, trial, plan.arcs[i + 2]);
    const bool stands =
        hold.refusal == Foothold::Refusal::kNone && hold.supported >= trial.hold.supported - 1e-9;
    plan.places[i + 2] = stands ? hold.place : trial.hold.place;
    if (!stands) plan.arcs[i + 2] = trial.arc;
  }

  WalkRule rule() const {
    const auto count = [&](Foothold::Refusal refusal) {
      return refusals_[static_cast<int>(refusal)];
    };
    const int edge = count(Foothold::Refusal::kEdge), slope = count(Foothold::Refusal::kSlope);
    const int none = count(Foothold::Refusal::kNoGround);
    if (slope > std::max(edge, none)) return WalkRule::kSlope;
    if (none > edge && out_of_step_ == 0) return WalkRule::kNoGround;
    return too_high_ + out_of_step_ > 0 ? WalkRule::kStepHeight : WalkRule::kFoothold;
  }

  const FootstepRequest& r_;
  const FootholdFinder& holds_;
  double length_, begin_arc_ = 0.0, end_arc_ = 0.0;
  std::array<std::vector<Trial>, 2> lines_;  // by Side, every kSpacing from begin_arc_ on
  std::array<int, 4> refusals_ = {0, 0, 0, 0};
  int too_high_ = 0;
  int out_of_step_ = 0;  // places whose ground lies higher or lower than a step
};

}  // namespace

FootstepPlan planFootsteps(const FootstepRequest& request, const FootholdFinder& holds) {
  return Planner(request, holds).plan();
}

}  // namespace amble

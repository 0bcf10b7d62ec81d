#include "animation/steps/footstep_trials.h"

#include <algorithm>
#include <cmath>

#include "animation/steps/unevenness.h"

namespace amble {
namespace {

// Where a foot is tried, so far outwards of its line.
FootPlace placeBeside(const GroundPoint& point, PrintPlace print, Side side, double aside) {
  print.left += side == kLeft ? aside : -aside;
  return footBeside(point, print);
}

// The nearest to its line on which a foot stands; where none does, the farthest that was tried.
// @param point  of the path, at the arc and at the ground's height
FootTrial tryPlace(const TrialRequest& request, const FootholdFinder& holds, Side side, double arc,
                   const GroundPoint& point, double reach) {
  FootTrial trial;
  trial.arc = arc;
  const PrintPlace print = request.print(side, arc);
  for (const double aside : TrialGrid::kAside) {
    FootPlace place = placeBeside(point, print, side, aside);
    place.position.z() = point.position.z();
    trial.hold = holds.at(place, side, reach);
    trial.aside = aside;
    if (trial.stands()) break;
  }
  const FootPlace& stood = trial.hold.place;
  trial.tilt = tiltAlong(stood, {std::cos(stood.heading), std::sin(stood.heading)});
  return trial;
}

bool sameSurface(const Foothold& a, const Foothold& b) {
  return std::abs(stepHeight(a.place, b.place)) < 0.5 * Unevenness::kLeastStep;
}

}  // namespace

FootTrials tryPlaces(const TrialRequest& request, const FootholdFinder& holds) {
  const GroundLimits& limits = holds.limits();
  const double reach = limits.highestStep() + Unevenness::kLeastStep;
  FootTrials trials;
  trials.begin = request.begin;
  const int count =
      std::max(0, static_cast<int>((request.end - request.begin) / TrialGrid::kSpacing));
  double z = request.from_height;
  for (int k = 1; k < count; ++k) {
    const double arc = request.begin + k * TrialGrid::kSpacing;
    GroundPoint point = pathPoint(request.path, arc, z);
    const auto near = holds.heightNear(point.position, reach);
    if (!near && holds.heightNear(point.position, TrialGrid::kFar)) ++trials.out_of_step;
    point.position.z() = z = near.value_or(z);
    for (const Side side : {kLeft, kRight}) {
      const FootTrial trial = tryPlace(request, holds, side, arc, point, reach);
      if (!trial.stands()) ++trials.refusals[static_cast<int>(trial.hold.refusal)];
      trials.lines[side].push_back(trial);
    }
  }
  return trials;
}

bool standsLike(const Foothold& hold, const Foothold& found) {
  return found.refusal == Foothold::Refusal::kNone && found.supported >= hold.supported - 1e-9;
}

Foothold holdAt(const TrialRequest& request, const FootholdFinder& holds, Side side,
                const FootTrial& trial, double arc) {
  const GroundPoint point = pathPoint(request.path, arc, trial.hold.place.position.z());
  return holds.at(placeBeside(point, request.print(side, arc), side, trial.aside), side,
                  holds.limits().highestStep());
}

std::pair<double, double> surfaceAround(const TrialRequest& request, const FootholdFinder& holds,
                                        const FootTrials& trials, Side side, int k) {
  const auto& line = trials.lines[side];
  const FootTrial& own = line[k];
  const auto goesOn = [&](int i, int j) {
    return line[j].aside == own.aside && standsLike(own.hold, line[j].hold) &&
           sameSurface(line[i].hold, line[j].hold);
  };
  int low = k, high = k;
  while (low > 0 && goesOn(low, low - 1)) --low;
  while (high + 1 < trials.count() && goesOn(high, high + 1)) ++high;
  std::pair<double, double> arcs = {line[low].arc, line[high].arc};
  if (arcs.second - arcs.first >= TrialGrid::kNarrow) return arcs;
  const auto stands = [&](double arc) {
    const Foothold hold = holdAt(request, holds, side, own, arc);
    return standsLike(own.hold, hold) && sameSurface(own.hold, hold);
  };
  for (double step = 0.5 * TrialGrid::kSpacing; step > TrialGrid::kFinest; step *= 0.5) {
    if (stands(arcs.first - step)) arcs.first -= step;
    if (stands(arcs.second + step)) arcs.second += step;
  }
  return arcs;
}

}  // namespace amble

#include "animation/analysis/foot_plants.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "animation/analysis/plant_signals.h"
#include "animation/clips/floor_fit.h"

namespace amble {
namespace {

// A foot whose ankle comes in (whose toe goes off) faster than this share of its swing is in the
// air, whatever its vertical velocity says: drawn motion often lands and leaves softer than people
// do. People strike at 0.2 and lift off at 0.3 of it.
constexpr double kLandingShare = 0.35;
constexpr double kLeavingShare = 0.5;

// A foot of which neither ankle nor toe is so low is in the air for certain: toes that stand
// upright on their tips have their joint by PlantOptions::height higher than flat ones [of that].
constexpr double kUp = 1.5;

/// The frames of a foot, told apart by how low and slow its ankle and toe are.
struct FootStates {
  std::vector<bool> planted;  // stage 1: one of them is low and slow
  std::vector<bool> still;    // one of them is low and stands as good as still: certainly planted
  Eigen::VectorXd over;       // how far the one that is lower is over kUp; not below: in the air
};

/// Stage 1: ankle or toe low and slow.
FootStates lowAndSlow(const PlantSignals& signals, const PlantOptions& options) {
  const Eigen::Index frames = signals.frames();
  const PlantLimits limits = plantLimits(signals, options);
  const std::vector<bool> none(frames, false);
  FootStates states{none, none, Eigen::VectorXd::Constant(frames, HUGE_VAL)};
  for (int j = 0; j < 2; ++j) {
    for (Eigen::Index i = 0; i < frames; ++i) {
      const double over = signals.height(i, j) - limits.height[j];
      states.over[i] = std::min(states.over[i], over - (kUp - 1.0) * options.height);
      if (over >= 0.0) continue;
      if (signals.speed(i, j) < limits.speed[j]) states.planted[i] = true;
      if (signals.speed(i, j) < limits.still) states.still[i] = true;
    }
  }
  return states;
}

/// Runs of `value` shorter than `shortest` frames are turned over; at the clip's ends they stay,
/// being cut off there.
void dropShortRuns(std::vector<bool>& flags, bool value, double shortest) {
  for (size_t begin = 0; begin < flags.size();) {
    size_t end = begin;
    while (end < flags.size() && flags[end] == flags[begin]) ++end;
    const bool inside = begin > 0 && end < flags.size();
    if (inside && flags[begin] == value && static_cast<double>(end - begin) < shortest) {
      std::fill(flags.begin() + static_cast<std::ptrdiff_t>(begin),
                flags.begin() + static_cast<std::ptrdiff_t>(end), !value);
    }
    begin = end;
  }
}

/// The highest point of `sign` * `values` that is reached uphill from `start` within `reach` frames
/// and while `speed` is below `limit`, between frames by a parabola; `crossing` where that is no
/// clear peak.
struct Climb {
  int start, reach;
  double sign;
  double limit;  // of speed
  double clear;  // least height of a peak
  double crossing;
};

double climb(const Eigen::VectorXd& values, const Eigen::Ref<const Eigen::VectorXd>& speed,
             const Climb& how) {
  const auto at = [&](int i) { return how.sign * values[i]; };
  const int last = static_cast<int>(values.size()) - 1;
  const int step = how.start > 0 && at(how.start - 1) > at(how.start) ? -1 : 1;
  int top = how.start;
  for (int moved = 0; moved < how.reach; ++moved) {
    const int next = top + step;
    if (next < 0 || next > last || at(next) <= at(top)) break;
    if (speed[next] > how.limit)
      return top;  // the foot swings: it has left the ground here at the latest
    top = next;
  }
  if (at(top) < how.clear || top == 0 || top == last) return how.crossing;
  const double before = at(top - 1), after = at(top + 1);
  const double bend = before - 2.0 * at(top) + after;
  if (!(bend < 0.0) || before > at(top) || after > at(top)) return how.crossing;
  return top + 0.5 * (before - after) / bend;
}

/// Where on from a frame in which the foot is down it comes up, between frames; half a frame beyond
/// the clip where it does not. @param step  -1: back
double downUntil(const Eigen::VectorXd& over, int frame, int step) {
  const int last = static_cast<int>(over.size()) - 1;
  int next = frame + step;
  while (next >= 0 && next <= last && over[next] < 0.0) next += step;
  if (next < 0 || next > last) return next - 0.5 * step;
  const double down = over[next - step], up = over[next];
  return next - step * up / (up - down);
}

/// The ends of a run of frames moved to strike and lift-off, while the foot is down: who runs draws
/// a foot up behind him that is slow for its swing, and rises fastest when it is a hand's breadth
/// over the ground.
FootPlant refined(const FootPlant& run, const PlantSignals& signals, const FootStates& states,
                  const PlantOptions& options, double rate) {
  const int reach = static_cast<int>(std::lround(options.reach * rate));
  const int frames = static_cast<int>(signals.frames());
  int first_still = run.first, last_still = run.last;
  while (first_still < run.last && !states.still[first_still]) ++first_still;
  while (last_still > run.first && !states.still[last_still]) --last_still;
  const double down_from = downUntil(states.over, run.first, -1);
  const double down_until = downUntil(states.over, run.last, 1);
  FootPlant plant = run;
  if (run.first > 0) {
    const double trough = climb(signals.rise, signals.speed.col(0),
                                {run.first, reach, -1.0, kLandingShare * signals.swing[0],
                                 options.clear_velocity, run.strike});
    plant.strike = std::min(std::max(trough, down_from), static_cast<double>(first_still));
    const double planted_from = plant.strike - options.strike_lead * rate;
    plant.first =
        std::clamp(static_cast<int>(std::ceil(std::max(planted_from, down_from))), 0, run.last);
  }
  if (run.last < frames - 1) {
    const double peak = climb(signals.rise, signals.speed.col(1),
                              {run.last, reach, 1.0, kLeavingShare * signals.swing[1],
                               options.clear_velocity, run.lift_off});
    plant.lift_off =
        std::max(std::min(peak - options.lift_off_lead * rate, down_until), last_still + 0.5);
    const double planted_until = plant.lift_off - options.lift_off_contact * rate;
    plant.last =
        std::clamp(static_cast<int>(std::ceil(planted_until)) - 1, plant.first, frames - 1);
  }
  return plant;
}

// Two plants that were moved over one another become one.
void mergeTouching(std::vector<FootPlant>& plants) {
  std::vector<FootPlant> merged;
  for (const FootPlant& plant : plants) {
    if (!merged.empty() && plant.first <= merged.back().last + 1) {
      merged.back().last = std::max(merged.back().last, plant.last);
      merged.back().lift_off = std::max(merged.back().lift_off, plant.lift_off);
    } else {
      merged.push_back(plant);
    }
  }
  plants = std::move(merged);
}

/// Plants of `fine`, which has `factor` times the frames, on the frames that are there.
FootPlants coarser(const FootPlants& fine, int factor, int frames) {
  FootPlants result;
  result.frames = frames;
  for (const Side side : {kLeft, kRight}) {
    for (const FootPlant& from : fine.plants[side]) {
      FootPlant plant;
      plant.first = from.first == 0 ? 0 : (from.first + factor - 1) / factor;
      plant.last = from.last == fine.frames - 1 ? frames - 1 : from.last / factor;
      if (plant.first > plant.last) continue;
      plant.strike = from.first == 0 ? -0.5 : from.strike / factor;
      plant.lift_off = from.last == fine.frames - 1 ? frames - 0.5 : from.lift_off / factor;
      result.plants[side].push_back(plant);
    }
  }
  return result;
}

}  // namespace

bool FootPlants::planted(Side side, int frame) const {
  return std::any_of(plants[side].begin(), plants[side].end(), [&](const FootPlant& plant) {
    return plant.first <= frame && frame <= plant.last;
  });
}

std::vector<bool> FootPlants::planted(Side side) const {
  std::vector<bool> flags(frames, false);
  for (const FootPlant& plant : plants[side]) {
    for (int i = plant.first; i <= plant.last; ++i) flags[i] = true;
  }
  return flags;
}

FootPlants plantsOf(const std::array<std::vector<bool>, 2>& planted) {
  FootPlants result;
  result.frames = static_cast<int>(planted[kLeft].size());
  for (const Side side : {kLeft, kRight}) {
    for (int i = 0; i < result.frames; ++i) {
      if (!planted[side][i]) continue;
      if (i == 0 || !planted[side][i - 1]) result.plants[side].push_back({i, i, i - 0.5, i + 0.5});
      result.plants[side].back().last = i;
      result.plants[side].back().lift_off = i + 0.5;
    }
  }
  return result;
}

FootPlants detectPlants(const Clip& clip, const JointRoles& roles, const PlantOptions& options) {
  return detectPlants(footPaths(clip, roles), legLengths(clip, roles), clip.frame_time, options);
}

FootPlants detectPlants(const FootPaths& paths, const std::array<double, 2>& legs,
                        double frame_time, const PlantOptions& options) {
  FootPlants result;
  result.frames = static_cast<int>(paths[kLeft].rows());
  if (result.frames == 0) return result;
  const double rate = 1.0 / frame_time;
  if (const int factor = plantFactor(frame_time, result.frames); factor > 1) {
    const FootPaths fine = {finerRows(paths[kLeft], factor), finerRows(paths[kRight], factor)};
    return coarser(detectPlants(fine, legs, frame_time / factor, options), factor, result.frames);
  }
  const FloorFit floor = fitFloor(paths, legs, frame_time);
  std::array<PlantSignals, 2> signals;
  std::array<FootStates, 2> states;
  std::array<std::vector<bool>, 2> planted;
  for (const Side side : {kLeft, kRight}) {
    signals[side] = plantSignals(paths[side], floor, legs[side], rate, options.cutoff);
    states[side] = lowAndSlow(signals[side], options);
    planted[side] = states[side].planted;
    dropShortRuns(planted[side], false, options.shortest_gap * rate);
    dropShortRuns(planted[side], true, options.shortest_plant * rate);
  }
  result.plants = plantsOf(planted).plants;
  for (const Side side : {kLeft, kRight}) {
    for (FootPlant& plant : result.plants[side])
      plant = refined(plant, signals[side], states[side], options, rate);
    mergeTouching(result.plants[side]);
  }
  return result;
}

}  // namespace amble

#include "animation/analysis/gait_measures.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <optional>

#include "animation/body/pelvis.h"
#include "base/statistics.h"

namespace amble {
namespace {

constexpr double kTrim = 0.15;      // of a plant, at both ends (QUALITY.md)
constexpr double kFlatUntil = 0.5;  // of a plant: from then on the heel may have risen
constexpr double kSpeedWindow =
    0.5;  // smoothing of the pelvis for speed, as MANIFEST's of the captures [s]
// Of a swing: in between the toe passes the standing foot; before and after it is on its way up and
// down.
constexpr double kClearFrom = 0.3, kClearTo = 0.7;
constexpr double kGroundReach = 1.0;  // how far the ground may lie from a sole point [m]

/// Standard deviation over mean.
double variation(const std::vector<double>& values) {
  const double middle = mean(values);
  double squares = 0.0;
  for (const double value : values) squares += (value - middle) * (value - middle);
  return middle > 0.0 ? std::sqrt(squares / static_cast<double>(values.size())) / middle : 0.0;
}

double asymmetry(const std::array<std::vector<double>, 2>& values) {
  if (values[kLeft].empty() || values[kRight].empty()) return 0.0;
  const double left = mean(values[kLeft]), right = mean(values[kRight]);
  return std::abs(left - right) / std::max(1e-9, 0.5 * (left + right));
}

/// Ankle and toe of a foot, and their heights over the ground below them.
struct FootTrack {
  std::vector<Eigen::Vector3d> ankle, toe;
  std::vector<double> ankle_height, toe_height;
};

double groundHeight(const Ground* ground, const Eigen::Vector3d& p) {
  if (ground == nullptr) return 0.0;
  return ground->height(p.x(), p.y(), p.z(), kGroundReach).value_or(0.0);
}

std::array<FootTrack, 2> footTracks(const Clip& clip, const JointRoles& roles,
                                    const Ground* ground) {
  const std::array<Eigen::MatrixXd, 2> paths = footPaths(clip, roles);
  std::array<FootTrack, 2> tracks;
  for (const Side side : {kLeft, kRight}) {
    FootTrack& track = tracks[side];
    for (int i = 0; i < clip.frames(); ++i) {
      track.ankle.emplace_back(paths[side].block<1, 3>(i, 0).transpose());
      track.toe.emplace_back(paths[side].block<1, 3>(i, 3).transpose());
      track.ankle_height.push_back(track.ankle.back().z() -
                                   groundHeight(ground, track.ankle.back()));
      track.toe_height.push_back(track.toe.back().z() - groundHeight(ground, track.toe.back()));
    }
  }
  return tracks;
}

std::vector<double> slice(const std::vector<double>& values, int first, int last) {
  return {values.begin() + first, values.begin() + last + 1};
}

Eigen::Vector2d medianPlace(const std::vector<Eigen::Vector3d>& points, int first, int last) {
  std::vector<double> x, y;
  for (int i = first; i <= last; ++i) {
    x.push_back(points[i].x());
    y.push_back(points[i].y());
  }
  return {median(x), median(y)};
}

PlantMeasures measurePlant(Side side, const FootPlant& plant, const FootTrack& track,
                           double frame_time) {
  PlantMeasures result;
  result.side = side;
  result.plant = plant;
  const double length = plant.last - plant.first;
  const int first = static_cast<int>(std::ceil(plant.first + kTrim * length));
  const int last = std::max(first, static_cast<int>(std::floor(plant.last - kTrim * length)));
  const int flat = std::max(first, static_cast<int>(std::floor(plant.first + kFlatUntil * length)));
  const Eigen::Vector2d toe = medianPlace(track.toe, first, last);
  for (int i = first; i <= last; ++i) {
    result.drift = std::max(result.drift, (track.toe[i].head<2>() - toe).norm());
    if (i > first) result.travel += (track.toe[i] - track.toe[i - 1]).head<2>().norm();
  }
  result.time = (last - first) * frame_time;
  result.toe_height = median(slice(track.toe_height, first, last));
  result.ankle_height = median(slice(track.ankle_height, first, flat));
  const Eigen::Vector2d middle = 0.5 * (toe + medianPlace(track.ankle, first, flat));
  const int at = (first + last) / 2;
  result.at << middle, track.toe[at].z() - track.toe_height[at];
  return result;
}

void measureFeet(const std::array<FootTrack, 2>& tracks, const FootPlants& plants,
                 double frame_time, GaitMeasures& result) {
  double travel = 0.0, time = 0.0;
  std::vector<double> drifts;
  for (const Side side : {kLeft, kRight}) {
    std::vector<double> toe_heights, ankle_heights;
    for (const FootPlant& plant : plants.plants[side]) {
      const PlantMeasures measures = measurePlant(side, plant, tracks[side], frame_time);
      travel += measures.travel;
      time += measures.time;
      drifts.push_back(measures.drift);
      toe_heights.push_back(measures.toe_height);
      ankle_heights.push_back(measures.ankle_height);
      result.plants.push_back(measures);
    }
    result.toe_height[side] = median(toe_heights);
    result.ankle_height[side] = median(ankle_heights);
    for (size_t i = 0; !toe_heights.empty() && i < tracks[side].toe.size(); ++i) {
      const double toe = result.toe_height[side] - tracks[side].toe_height[i];
      const double ankle = result.ankle_height[side] - tracks[side].ankle_height[i];
      result.penetration = std::max({result.penetration, toe, ankle});
    }
  }
  std::stable_sort(result.plants.begin(), result.plants.end(),
                   [](const PlantMeasures& a, const PlantMeasures& b) {
                     return a.plant.strike < b.plant.strike;
                   });
  result.toe_skate = time > 0.0 ? travel / time : 0.0;
  result.drift = median(drifts);
  result.largest_drift = drifts.empty() ? 0.0 : *std::max_element(drifts.begin(), drifts.end());
}

/// The same foot's plant before plants[landing]; none where it is not seen.
const PlantMeasures* standBefore(const GaitMeasures& measures, size_t landing) {
  for (size_t i = landing; i-- > 0;) {
    if (measures.plants[i].side == measures.plants[landing].side) return &measures.plants[i];
  }
  return nullptr;
}

/// What the foot that lands does since it stood `before`: how high its ankle goes over where it
/// stood, how near to the ground its toe stays.
void measureSwing(const PlantMeasures& before, const PlantMeasures& landing, const FootTrack& track,
                  StepMeasures& step) {
  double highest = 0.0;
  for (int k = before.plant.last; k <= landing.plant.first; ++k) {
    highest = std::max(highest, track.ankle_height[k]);
  }
  step.lift = std::max(0.0, highest - before.ankle_height);
  const double swing = landing.plant.strike - before.plant.lift_off;
  const int first = static_cast<int>(std::ceil(before.plant.lift_off + kClearFrom * swing));
  const int last = static_cast<int>(std::floor(before.plant.lift_off + kClearTo * swing));
  double lowest = std::numeric_limits<double>::infinity();
  for (int k = first; k <= last; ++k) lowest = std::min(lowest, track.toe_height[k]);
  if (first <= last) step.toe_clearance = std::max(0.0, lowest - before.toe_height);
  step.stride = (landing.at - before.at).head<2>().norm();
}

StepMeasures measureStep(const GaitMeasures& measures, size_t landing,
                         const std::vector<Eigen::Vector3d>& pelvis,
                         const std::array<FootTrack, 2>& tracks, double frame_time) {
  const PlantMeasures& from = measures.plants[landing - 1];
  const PlantMeasures& to = measures.plants[landing];
  StepMeasures step;
  step.side = to.side;
  step.begin = from.plant.strike;
  step.end = to.plant.strike;
  step.duration = (step.end - step.begin) * frame_time;
  const Eigen::Vector2d along =
      (pelvis[to.plant.first] - pelvis[from.plant.first]).head<2>().normalized();
  const Eigen::Vector3d way = to.at - from.at;
  step.length = way.head<2>().dot(along);
  step.width = (along.x() * way.y() - along.y() * way.x()) * (to.side == kLeft ? 1.0 : -1.0);
  if (const PlantMeasures* before = standBefore(measures, landing)) {
    measureSwing(*before, to, tracks[to.side], step);
  }
  step.rise = way.z();
  return step;
}

// A plant whose strike is in the clip.
bool struck(const PlantMeasures& plant) { return plant.plant.first > 0; }

void measureSteps(const std::vector<Eigen::Vector3d>& pelvis,
                  const std::array<FootTrack, 2>& tracks, double frame_time, GaitMeasures& result) {
  std::array<std::vector<double>, 2> lengths, times;
  std::vector<double> all_lengths, all_times, widths, lifts, strides, clearances;
  for (size_t i = 1; i < result.plants.size(); ++i) {
    if (result.plants[i].side == result.plants[i - 1].side || !struck(result.plants[i - 1]))
      continue;
    const StepMeasures step = measureStep(result, i, pelvis, tracks, frame_time);
    lengths[step.side].push_back(step.length);
    times[step.side].push_back(step.duration);
    all_lengths.push_back(step.length);
    all_times.push_back(step.duration);
    widths.push_back(step.width);
    if (step.lift > 0.0) lifts.push_back(step.lift);
    if (step.stride > 0.0) strides.push_back(step.stride);
    if (step.stride > 0.0) clearances.push_back(step.toe_clearance);
    result.steps.push_back(step);
  }
  result.step_length = mean(all_lengths);
  result.step_time = mean(all_times);
  result.step_time_variation = variation(all_times);
  result.step_width = mean(widths);
  result.lift = mean(lifts);
  result.stride_length = mean(strides);
  result.toe_clearance = mean(clearances);
  result.length_asymmetry = asymmetry(lengths);
  result.time_asymmetry = asymmetry(times);
}

/// Whole strides of the foot that has the longer span of them.
void findSpan(int frames, GaitMeasures& result) {
  std::array<std::vector<double>, 2> strikes;
  std::vector<double> all;
  for (const PlantMeasures& plant : result.plants) {
    if (!struck(plant)) continue;
    strikes[plant.side].push_back(plant.plant.strike);
    all.push_back(plant.plant.strike);
  }
  result.begin = 0.0;
  result.end = std::max(0, frames - 1);
  if (all.size() >= 2) {
    result.begin = all.front();
    result.end = all.back();
  }
  double longest = 0.0;
  for (const std::vector<double>& side : strikes) {
    if (side.size() < 2 || side.back() - side.front() <= longest) continue;
    longest = side.back() - side.front();
    result.begin = side.front();
    result.end = side.back();
  }
}

/// Frames within [begin, end] in which each foot stands, and both do.
struct SupportTime {
  std::array<double, 2> single = {0.0, 0.0};
  double both = 0.0;
};

SupportTime supportTime(const FootPlants& plants, double begin, double end) {
  // Between frames, from strikes and lift-offs; a plant cut off by the clip's end lasts to it.
  SupportTime time;
  const auto overlap = [&](const FootPlant& a, double from, double to) {
    const double first = a.first == 0 ? -1.0 : a.strike;
    const double last = a.last == plants.frames - 1 ? plants.frames : a.lift_off;
    return std::pair(std::max(first, from), std::min(last, to));
  };
  for (const Side side : {kLeft, kRight}) {
    for (const FootPlant& plant : plants.plants[side]) {
      const auto [from, to] = overlap(plant, begin, end);
      if (to <= from) continue;
      time.single[side] += to - from;
      if (side == kRight) continue;
      for (const FootPlant& other : plants.plants[kRight]) {
        const auto [both_from, both_to] = overlap(other, from, to);
        time.both += std::max(0.0, both_to - both_from);
      }
    }
  }
  return time;
}

void measureSupport(const FootPlants& plants, GaitMeasures& result) {
  for (StepMeasures& step : result.steps) {
    const double span = step.end - step.begin;
    if (span > 0.0) {
      step.double_support = supportTime(plants, step.begin, step.end).both / span;
    }
  }
  const double span = result.end - result.begin;
  if (!(span > 0.0)) return;
  const SupportTime time = supportTime(plants, result.begin, result.end);
  result.double_support = time.both / span;
  result.flight =
      std::max(0.0, 1.0 - (time.single[kLeft] + time.single[kRight] - time.both) / span);
}

// Value of a sequence between frames.
template <typename T>
T between(const std::vector<T>& values, double frame) {
  const int last = static_cast<int>(values.size()) - 1;
  const int i = std::clamp(static_cast<int>(frame), 0, std::max(0, last - 1));
  const double t = std::clamp(frame - i, 0.0, 1.0);
  return T((1.0 - t) * values[i] + t * values[std::min(i + 1, last)]);
}

/// Mean speed and turn rate over a stretch.
struct Travel {
  double speed = 0.0, turn_rate = 0.0;
};

Travel travelOver(const std::vector<Eigen::Vector3d>& path, const std::vector<double>& headings,
                  double begin, double end, double frame_time) {
  const double time = (end - begin) * frame_time;
  if (!(time > 0.0)) return {};
  double way = 0.0;
  Eigen::Vector3d at = between(path, begin);
  for (int i = static_cast<int>(std::floor(begin)) + 1; i < end; ++i) {
    way += (path[i] - at).head<2>().norm();
    at = path[i];
  }
  way += (between(path, end) - at).head<2>().norm();
  return {way / time, (between(headings, end) - between(headings, begin)) / time};
}

void measureTravel(const Clip& clip, const JointRoles& roles,
                   const std::vector<Eigen::Vector3d>& pelvis, GaitMeasures& result) {
  const std::vector<double> headings = pelvisHeadings(clip, roles);
  const std::vector<Eigen::Vector3d> path = smoothed(pelvis, clip.frame_time, kSpeedWindow);
  const int window = std::max(1, static_cast<int>(std::lround(kSpeedWindow / clip.frame_time)));
  for (int i = 0; i + window < clip.frames(); ++i) {
    const double rate = std::abs(headings[i + window] - headings[i]) / (window * clip.frame_time);
    result.peak_turn_rate = std::max(result.peak_turn_rate, rate);
  }
  const double time = (result.end - result.begin) * clip.frame_time;
  if (!(time > 0.0)) return;
  const Travel whole = travelOver(path, headings, result.begin, result.end, clip.frame_time);
  result.speed = whole.speed;
  result.turn_rate = whole.turn_rate;
  int steps = 0;
  for (StepMeasures& step : result.steps) {
    const Travel travel = travelOver(path, headings, step.begin, step.end, clip.frame_time);
    step.speed = travel.speed;
    step.turn_rate = travel.turn_rate;
    if (step.begin >= result.begin - 1e-9 && step.end <= result.end + 1e-9) ++steps;
  }
  result.cadence = 60.0 * steps / time;
  result.cycle_frequency = 0.5 * steps / time;
  result.leg_length =
      0.5 * (roles.legLength(clip.skeleton, kLeft) + roles.legLength(clip.skeleton, kRight));
  result.normalised_speed = result.speed / result.leg_length;
}

}  // namespace

GaitMeasures measureGait(const Clip& clip, const JointRoles& roles, const FootPlants& plants,
                         const Ground* ground) {
  assert(plants.frames == clip.frames());
  GaitMeasures result;
  if (clip.frames() == 0) return result;
  const std::array<FootTrack, 2> tracks = footTracks(clip, roles, ground);
  const std::vector<Eigen::Vector3d> pelvis = pelvisPath(clip, roles);
  measureFeet(tracks, plants, clip.frame_time, result);
  measureSteps(pelvis, tracks, clip.frame_time, result);
  findSpan(clip.frames(), result);
  measureSupport(plants, result);
  measureTravel(clip, roles, pelvis, result);
  result.root_acceleration = rootAcceleration(clip);
  result.joint_jerk = jointJerk(clip);
  result.pops = pops(clip);
  result.knee_backwards = kneeBackwardsShare(clip, roles);
  result.bone_length_change = boneLengthChange(clip);
  return result;
}

}  // namespace amble

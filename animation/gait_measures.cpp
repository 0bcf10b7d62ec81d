#include "animation/gait_measures.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>

namespace amble {
namespace {

constexpr double kTrim = 0.15;      // of a plant, at both ends (QUALITY.md)
constexpr double kFlatUntil = 0.5;  // of a plant: from then on the heel may have risen
constexpr double kSpeedWindow =
    0.5;  // smoothing of the pelvis for speed, as MANIFEST's of the captures [s]
constexpr double kGroundReach = 1.0;  // how far the ground may lie from a sole point [m]

double median(std::vector<double> values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1) return *middle;
  return 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

double mean(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return values.empty() ? 0.0 : sum / static_cast<double>(values.size());
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

/// Highest the ankle goes between the foot's plant before `landing` and `landing`, over where it
/// stood.
double swingLift(const GaitMeasures& measures, size_t landing, const FootTrack& track) {
  for (size_t i = landing; i-- > 0;) {
    const PlantMeasures& before = measures.plants[i];
    if (before.side != measures.plants[landing].side) continue;
    double highest = 0.0;
    for (int k = before.plant.last; k <= measures.plants[landing].plant.first; ++k) {
      highest = std::max(highest, track.ankle_height[k]);
    }
    return std::max(0.0, highest - before.ankle_height);
  }
  return 0.0;
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
  step.lift = swingLift(measures, landing, tracks[to.side]);
  step.rise = way.z();
  return step;
}

// A plant whose strike is in the clip.
bool struck(const PlantMeasures& plant) { return plant.plant.first > 0; }

void measureSteps(const std::vector<Eigen::Vector3d>& pelvis,
                  const std::array<FootTrack, 2>& tracks, double frame_time, GaitMeasures& result) {
  std::array<std::vector<double>, 2> lengths, times;
  std::vector<double> all_lengths, all_times, widths, lifts;
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
    result.steps.push_back(step);
  }
  result.step_length = mean(all_lengths);
  result.step_time = mean(all_times);
  result.step_width = mean(widths);
  result.lift = mean(lifts);
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

/// Time within [begin, end] in which the foot is planted, as a sum of pieces, for two feet at once.
void measureSupport(const FootPlants& plants, GaitMeasures& result) {
  const double span = result.end - result.begin;
  if (!(span > 0.0)) return;
  // Between frames, from strikes and lift-offs; a plant cut off by the clip's end lasts to it.
  double single[2] = {0.0, 0.0}, both = 0.0;
  const auto overlap = [&](const FootPlant& a, double begin, double end) {
    const double first = a.first == 0 ? -1.0 : a.strike;
    const double last = a.last == plants.frames - 1 ? plants.frames : a.lift_off;
    return std::pair(std::max(first, begin), std::min(last, end));
  };
  for (const Side side : {kLeft, kRight}) {
    for (const FootPlant& plant : plants.plants[side]) {
      const auto [begin, end] = overlap(plant, result.begin, result.end);
      if (end <= begin) continue;
      single[side] += end - begin;
      if (side == kRight) continue;
      for (const FootPlant& other : plants.plants[kRight]) {
        const auto [from, to] = overlap(other, begin, end);
        both += std::max(0.0, to - from);
      }
    }
  }
  result.double_support = both / span;
  result.flight = std::max(0.0, 1.0 - (single[kLeft] + single[kRight] - both) / span);
}

// Value of a sequence between frames.
template <typename T>
T between(const std::vector<T>& values, double frame) {
  const int last = static_cast<int>(values.size()) - 1;
  const int i = std::clamp(static_cast<int>(frame), 0, std::max(0, last - 1));
  const double t = std::clamp(frame - i, 0.0, 1.0);
  return T((1.0 - t) * values[i] + t * values[std::min(i + 1, last)]);
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
  double way = 0.0;
  Eigen::Vector3d at = between(path, result.begin);
  for (int i = static_cast<int>(std::floor(result.begin)) + 1; i < result.end; ++i) {
    way += (path[i] - at).head<2>().norm();
    at = path[i];
  }
  way += (between(path, result.end) - at).head<2>().norm();
  result.speed = way / time;
  result.turn_rate = (between(headings, result.end) - between(headings, result.begin)) / time;
  int steps = 0;
  for (const StepMeasures& step : result.steps) {
    if (step.begin >= result.begin - 1e-9 && step.end <= result.end + 1e-9) ++steps;
  }
  result.cadence = 60.0 * steps / time;
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

#include "animation/analysis/gait_measures.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <optional>
#include <span>

#include "animation/analysis/motion_measures.h"
#include "animation/body/pelvis.h"
#include "animation/body/step_prints.h"
#include "base/statistics.h"

namespace amble {
namespace {

constexpr double kTrim = 0.15;      // of a plant, at both ends (QUALITY.md)
constexpr double kFlatUntil = 0.5;  // of a plant: from then on the heel may have risen
// Smoothing of the pelvis for speed, as MANIFEST's of the captures [s]
constexpr double kSpeedWindow = 0.5;
// Of a swing: in between the toe passes the standing foot; before and after it is on its way up and
// down.
constexpr double kClearFrom = 0.3, kClearTo = 0.7;
constexpr double kGroundReach = 1.0;  // how far the ground may lie from a sole point [m]
// Ground that is so much lower below ankle or toe than below the other is another tread, over which
// the foot hangs: on a slope of 20 degrees it is less [m].
constexpr double kOtherTread = 0.05;
// Steps whose mean is less are on the spot or backwards as often as ahead: what left and right
// differ by is no share of it.
constexpr double kShortestStep = 0.05;  // [m]
constexpr double kShortestTime = 0.01;  // [s]

/// Standard deviation over mean.
double variation(const std::vector<double>& values) {
  const double middle = mean(values);
  double squares = 0.0;
  for (const double value : values) squares += (value - middle) * (value - middle);
  return middle > 0.0 ? std::sqrt(squares / static_cast<double>(values.size())) / middle : 0.0;
}

std::optional<double> asymmetry(const std::array<std::vector<double>, 2>& values, double least) {
  if (values[kLeft].empty() || values[kRight].empty()) return std::nullopt;
  const double left = mean(values[kLeft]), right = mean(values[kRight]);
  const double middle = 0.5 * (left + right);
  if (middle < least) return std::nullopt;
  return std::abs(left - right) / middle;
}

/// Ankle and toe of a foot, and their heights over the ground below them.
struct FootTrack {
  std::vector<Eigen::Vector3d> ankle, toe;
  std::vector<double> ankle_height, toe_height;
  // The same over what a foot that stands there is on.
  std::vector<double> ankle_stands, toe_stands;
  double heel = 0.0;  // the heel's point of the sole is so far below the ankle of a flat foot [m]
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
    track.heel = kAnkleHeightOfLeg * roles.legLength(clip.skeleton, side);
    for (int i = 0; i < clip.frames(); ++i) {
      track.ankle.emplace_back(paths[side].block<1, 3>(i, 0).transpose());
      track.toe.emplace_back(paths[side].block<1, 3>(i, 3).transpose());
      const double below_ankle = groundHeight(ground, track.ankle.back());
      const double below_toe = groundHeight(ground, track.toe.back());
      const bool hangs_over = std::abs(below_toe - below_ankle) > kOtherTread;
      const double tread = std::max(below_ankle, below_toe);
      track.ankle_height.push_back(track.ankle.back().z() - below_ankle);
      track.toe_height.push_back(track.toe.back().z() - below_toe);
      track.ankle_stands.push_back(track.ankle.back().z() - (hangs_over ? tread : below_ankle));
      track.toe_stands.push_back(track.toe.back().z() - (hangs_over ? tread : below_toe));
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

/// Frames of a plant without those in which the foot comes down and leaves.
struct Trimmed {
  int first, last;  // last < first: none is left
};

/// Of a plant that the clip cuts only a part is seen: at its other end as much is left out as of a
/// whole one, of `usual` frames. So a foot is judged in each frame as if the clip went on.
Trimmed trimmed(const FootPlant& plant, double usual, int frames) {
  const double length = plant.last - plant.first;
  const bool begins = plant.first > 0, ends = plant.last < frames - 1;
  const double whole = begins && ends ? length : std::max(length, usual);
  return {static_cast<int>(std::ceil(plant.first + kTrim * (begins ? whole : length))),
          static_cast<int>(std::floor(plant.last - kTrim * (ends ? whole : length)))};
}

/// Length of the plants that are seen whole, a median [frames]; 0 where there is none.
double usualLength(const FootPlants& plants) {
  std::vector<double> lengths;
  for (const std::vector<FootPlant>& of_foot : plants.plants) {
    for (const FootPlant& plant : of_foot) {
      if (plant.first > 0 && plant.last < plants.frames - 1)
        lengths.push_back(plant.last - plant.first);
    }
  }
  return median(lengths);
}

void measureSlide(const Trimmed& over, const FootTrack& track, double frame_time,
                  PlantMeasures& result) {
  if (over.last < over.first) return;
  const Eigen::Vector2d toe = medianPlace(track.toe, over.first, over.last);
  for (int i = over.first; i <= over.last; ++i) {
    result.drift = std::max(result.drift, (track.toe[i].head<2>() - toe).norm());
    if (i > over.first) result.travel += (track.toe[i] - track.toe[i - 1]).head<2>().norm();
  }
  result.time = (over.last - over.first) * frame_time;
}

PlantMeasures measurePlant(Side side, const FootPlant& plant, const FootTrack& track) {
  PlantMeasures result;
  result.side = side;
  result.plant = plant;
  const double length = plant.last - plant.first;
  const int first = static_cast<int>(std::ceil(plant.first + kTrim * length));
  const int last = std::max(first, static_cast<int>(std::floor(plant.last - kTrim * length)));
  const int flat = std::max(first, static_cast<int>(std::floor(plant.first + kFlatUntil * length)));
  const Eigen::Vector2d toe = medianPlace(track.toe, first, last);
  result.toe_height = median(slice(track.toe_stands, first, last));
  result.ankle_height = median(slice(track.ankle_stands, first, flat));
  const Eigen::Vector2d middle = 0.5 * (toe + medianPlace(track.ankle, first, flat));
  const int at = (first + last) / 2;
  const double ground = track.toe[at].z() - track.toe_stands[at];
  result.at << middle, ground;
  const Eigen::Vector2d ankle = medianPlace(track.ankle, first, flat);
  const double drop = result.ankle_height - result.toe_height;
  result.flat_pitch = std::atan2(drop, (toe - ankle).norm());
  result.ends.ball << toe, ground + result.toe_height;
  result.ends.heel << ankle, ground + result.ankle_height - track.heel;
  return result;
}

void measureFeet(const std::array<FootTrack, 2>& tracks, const FootPlants& plants,
                 double frame_time, GaitMeasures& result) {
  double travel = 0.0, time = 0.0;
  std::vector<double> drifts;
  const double usual = usualLength(plants);
  for (const Side side : {kLeft, kRight}) {
    std::vector<double> toe_heights, ankle_heights;
    for (const FootPlant& plant : plants.plants[side]) {
      PlantMeasures measures = measurePlant(side, plant, tracks[side]);
      const Trimmed stands = trimmed(plant, usual, plants.frames);
      measureSlide(stands, tracks[side], frame_time, measures);
      travel += measures.travel;
      time += measures.time;
      if (stands.first <= stands.last) drifts.push_back(measures.drift);
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

/// Least rise of the toe over where it stood, in the middle of its swing.
double toeClearance(const PlantMeasures& before, const PlantMeasures& landing,
                    const FootTrack& track) {
  const double swing = landing.plant.strike - before.plant.lift_off;
  const int first = static_cast<int>(std::ceil(before.plant.lift_off + kClearFrom * swing));
  const int last = static_cast<int>(std::floor(before.plant.lift_off + kClearTo * swing));
  if (first > last) return 0.0;
  double lowest = std::numeric_limits<double>::infinity();
  for (int k = first; k <= last; ++k) lowest = std::min(lowest, track.toe_height[k]);
  return std::max(0.0, lowest - before.toe_height);
}

StepMeasure stepTo(const GaitMeasures& measures, size_t landing,
                   const std::vector<Eigen::Vector3d>& pelvis,
                   const std::array<FootTrack, 2>& tracks, double frame_time) {
  const PlantMeasures& other = measures.plants[landing - 1];
  const PlantMeasures& to = measures.plants[landing];
  const Eigen::Vector3d way = pelvis[to.plant.first] - pelvis[other.plant.first];
  StepPrints prints{to.side, {}, {to.at, to.ends}, {other.at, other.ends}, 0.0, {}};
  prints.along = std::atan2(way.y(), way.x());
  const PlantMeasures* before = standBefore(measures, landing);
  if (before != nullptr) {
    const FootTrack& track = tracks[to.side];
    prints.from = {before->at, before->ends};
    for (int k = before->plant.last; k <= to.plant.first; ++k) {
      prints.swing.push_back(
          capturedSole(track.ankle[k], track.toe[k], track.heel, before->flat_pitch));
    }
  }
  StepMeasure step = measureStep(prints);
  step.strike = to.plant.strike * frame_time;
  step.lift_off = to.plant.lift_off * frame_time;
  step.duration = (to.plant.strike - other.plant.strike) * frame_time;
  step.slide = to.drift;
  if (before != nullptr) step.toe_clearance = toeClearance(*before, to, tracks[to.side]);
  return step;
}

// A plant whose strike is in the clip.
bool struck(const PlantMeasures& plant) { return plant.plant.first > 0; }

// Whether with the last step the foot was only put beside the other one, and both stand there to
// the end.
bool endsClosed(const GaitMeasures& measures, int frames) {
  constexpr double kBeside = 0.5;  // of the others' mean length
  if (measures.steps.size() < 2) return false;
  for (size_t i = measures.plants.size() - 2; i < measures.plants.size(); ++i) {
    if (measures.plants[i].plant.last < frames - 1) return false;
  }
  double others = 0.0;
  for (const StepMeasure& step : measures.steps) others += step.stride;
  const double last = measures.steps.back().stride;
  others = (others - last) / static_cast<double>(measures.steps.size() - 1);
  return last < kBeside * others;
}

// Means of all steps but one that closes the walk: it has no length.
void averageSteps(int frames, GaitMeasures& result) {
  std::array<std::vector<double>, 2> lengths, times;
  std::vector<double> all_lengths, all_times, widths, lifts, strides, clearances;
  const std::span<const StepMeasure> steps(result.steps);
  for (const StepMeasure& step : steps.first(steps.size() - endsClosed(result, frames))) {
    lengths[step.side].push_back(step.stride);
    times[step.side].push_back(step.duration);
    all_lengths.push_back(step.stride);
    all_times.push_back(step.duration);
    widths.push_back(step.width);
    if (step.lift > 0.0) lifts.push_back(step.lift);
    if (step.two_steps > 0.0) strides.push_back(step.two_steps);
    if (step.two_steps > 0.0) clearances.push_back(step.toe_clearance);
  }
  result.step_length = mean(all_lengths);
  result.step_time = mean(all_times);
  result.step_time_variation = variation(all_times);
  result.step_width = mean(widths);
  result.lift = mean(lifts);
  result.stride_length = mean(strides);
  result.toe_clearance = mean(clearances);
  result.length_asymmetry = asymmetry(lengths, kShortestStep);
  result.time_asymmetry = asymmetry(times, kShortestTime);
}

void measureSteps(const std::vector<Eigen::Vector3d>& pelvis,
                  const std::array<FootTrack, 2>& tracks, double frame_time, GaitMeasures& result) {
  for (size_t i = 1; i < result.plants.size(); ++i) {
    if (result.plants[i].side == result.plants[i - 1].side || !struck(result.plants[i - 1]))
      continue;
    result.steps.push_back(stepTo(result, i, pelvis, tracks, frame_time));
  }
  averageSteps(static_cast<int>(pelvis.size()), result);
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

/// From strike to strike [frames].
struct StepSpan {
  double begin, end;
};

StepSpan spanOf(const StepMeasure& step, double frame_time) {
  return {(step.strike - step.duration) / frame_time, step.strike / frame_time};
}

void measureSupport(const FootPlants& plants, double frame_time, GaitMeasures& result) {
  for (StepMeasure& step : result.steps) {
    const auto [begin, end] = spanOf(step, frame_time);
    if (end > begin) step.double_support = supportTime(plants, begin, end).both / (end - begin);
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
  for (StepMeasure& step : result.steps) {
    const auto [begin, end] = spanOf(step, clip.frame_time);
    const Travel travel = travelOver(path, headings, begin, end, clip.frame_time);
    step.speed = travel.speed;
    step.turn_rate = travel.turn_rate;
    if (begin >= result.begin - 1e-9 && end <= result.end + 1e-9) ++steps;
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
  measureSupport(plants, clip.frame_time, result);
  measureTravel(clip, roles, pelvis, result);
  result.root_acceleration = rootAcceleration(clip);
  result.joint_jerk = jointJerk(clip);
  result.pops = pops(clip);
  result.knee_backwards = kneeBackwardsShare(clip, roles);
  result.bone_length_change = boneLengthChange(clip);
  return result;
}

double smoothedSpeed(const std::vector<Eigen::Vector3d>& way, double frame_time, double begin,
                     double end) {
  const std::vector<double> ahead(way.size(), 0.0);
  return travelOver(smoothed(way, frame_time, kSpeedWindow), ahead, begin, end, frame_time).speed;
}

SoleEnds capturedSole(const Eigen::Vector3d& ankle, const Eigen::Vector3d& toe, double heel,
                      double flat_pitch) {
  const Eigen::Vector2d ahead = (toe - ankle).head<2>();
  const double run = ahead.norm();
  const double pitch = std::atan2(ankle.z() - toe.z(), run) - flat_pitch;
  SoleEnds ends{ankle - Eigen::Vector3d(0, 0, heel * std::cos(pitch)), toe};
  if (run > 0.0) ends.heel.head<2>() -= heel * std::sin(pitch) / run * ahead;
  return ends;
}

double fastestFootTurn(const Clip& clip, const JointRoles& roles) {
  const std::vector<int> feet =
      chainOf(clip.skeleton, std::array{roles.legs[kLeft].foot, roles.legs[kRight].foot});
  std::vector<JointFrame> before(clip.skeleton.size()), now(clip.skeleton.size());
  double most = 0.0;
  for (int i = 0; i < clip.frames(); ++i) {
    forwardKinematics(clip.skeleton, clip.poses[i], feet, now);
    for (const LegJoints& leg : roles.legs) {
      if (i > 0) most = std::max(most, now[leg.foot].q_WJ.angularDistance(before[leg.foot].q_WJ));
    }
    std::swap(before, now);
  }
  return most / clip.frame_time;
}

}  // namespace amble

#include "animation/preparation/walk_cycle_fit.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <utility>

#include "animation/analysis/gait_measures.h"
#include "animation/body/rotation_mean.h"
#include "animation/preparation/cycle_finder.h"
#include "animation/preparation/cycle_path.h"
#include "animation/preparation/foot_cycle_fit.h"
#include "animation/preparation/gait_track.h"
#include "animation/preparation/heel_rise_fit.h"
#include "base/error.h"
#include "base/rotation.h"

namespace amble {
namespace {

constexpr int kSamples = 64;  // of a cycle, to fit the series to; even
constexpr int kFewestHarmonics = 4;
constexpr int kMostHarmonics = 6;  // eight carry the shaking of captures
constexpr double kSmallResidual = 0.5 * kDegree;

// Root mean square of what the series leaves out of the joints' channels.
double residualOf(const FourierSeries& series, const Eigen::MatrixXd& samples,
                  const std::vector<double>& phases) {
  double squares = 0.0;
  for (Eigen::Index i = 0; i < samples.cols(); ++i) {
    const Eigen::VectorXd value = fourierAt(series, phases[i]);
    squares += (samples.col(i) - value).tail(series.channels() - 3).squaredNorm();
  }
  return std::sqrt(squares / static_cast<double>(samples.cols() * (series.channels() - 3)));
}

// The stretches' samples: column i is phase i / kSamples, whichever foot led.
std::vector<Eigen::MatrixXd> cycleSamples(const GaitTrack& track,
                                          const std::vector<Stretch>& stretches,
                                          const std::vector<FittedPath>& paths,
                                          const std::vector<Eigen::Quaterniond>& reference) {
  std::vector<Eigen::MatrixXd> all;
  for (size_t k = 0; k < stretches.size(); ++k) {
    const Eigen::MatrixXd one = closedSamples(track, stretches[k], paths[k], reference, kSamples);
    Eigen::MatrixXd& samples = all.emplace_back(one.rows(), one.cols());
    const int late = stretches[k].leading == kLeft ? 0 : kSamples / 2;
    for (int i = 0; i < kSamples; ++i) samples.col((i + late) % kSamples) = one.col(i);
  }
  return all;
}

Eigen::MatrixXd meanOf(const std::vector<Eigen::MatrixXd>& all) {
  Eigen::MatrixXd mean = all.front();
  for (size_t k = 1; k < all.size(); ++k) mean += all[k];
  return mean / static_cast<double>(all.size());
}

std::vector<double> evenPhases() {
  std::vector<double> phases;
  for (int i = 0; i < kSamples; ++i) phases.push_back(static_cast<double>(i) / kSamples);
  return phases;
}

// With as many harmonics as asked, or as few as leave out little enough.
void fitSeries(const Eigen::MatrixXd& samples, int harmonics, WalkCycle& cycle) {
  const std::vector<double> phases = evenPhases();
  const int first = harmonics > 0 ? harmonics : kFewestHarmonics;
  const int last = harmonics > 0 ? harmonics : kMostHarmonics;
  for (int h = first; h <= last; ++h) {
    cycle.series = fitFourier(samples, phases, h);
    cycle.residual = residualOf(cycle.series, samples, phases);
    if (cycle.residual <= kSmallResidual) return;
  }
}

// Feet of the stretches, averaged; phases as if the left foot had led.
void fitFeet(const GaitTrack& track, const std::vector<Stretch>& stretches,
             const std::array<FootShape, 2>& shapes, const std::string& clip, WalkCycle& cycle) {
  for (const Side side : {kLeft, kRight}) {
    std::vector<FootCycle> feet;
    for (const Stretch& s : stretches)
      feet.push_back(fitFootCycle(track, side, shapes[side], s, clip));
    cycle.feet[side] = meanFoot(feet);
  }
}

// @return the middle of the footprints, to the left of the path and over the floor [m]
Eigen::Vector2d fitPlacing(const GaitTrack& track, const std::vector<Stretch>& stretches,
                           const std::vector<FittedPath>& paths, WalkCycle& cycle) {
  const double share = 1.0 / static_cast<double>(stretches.size());
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  for (size_t k = 0; k < stretches.size(); ++k) {
    const Stretch& s = stretches[k];
    const FootPlacing placing = measurePlacing(track, s.begin, paths[k], s.leading);
    cycle.step_width += share * placing.width;
    middle += share * Eigen::Vector2d(placing.left, placing.height);
    for (const Side side : {kLeft, kRight}) {
      cycle.foot_forward[side] += share * placing.forward[side];
      cycle.toe_out[side] += share * placing.toe_out[side];
    }
    cycle.slide = std::max(cycle.slide, placing.slide);
  }
  // Halfway to where the captured feet are as they land: neither then nor later do legs have to be
  // much longer than captured.
  for (const Side side : {kLeft, kRight}) cycle.foot_forward[side] -= 0.5 * cycle.feet[side].slip;
  return middle;
}

}  // namespace

CaptureQuality measureCapture(const Clip& level, const JointRoles& roles) {
  const GaitMeasures gait = measureGait(level, roles, detectPlants(level, roles));
  return {gait.toe_skate, gait.root_acceleration, gait.joint_jerk, gait.pops};
}

WalkCycle prepareWalkCycle(const Clip& level, const JointRoles& roles,
                           const std::array<FootShape, 2>& feet,
                           const std::vector<Eigen::Quaterniond>& reference,
                           const CycleOptions& options, std::pair<int, int>* used_frames,
                           std::vector<FourierSeries>* captured) {
  const GaitTrack track(level, roles, feet, options.plants);
  const std::vector<Stretch> stretches = findStretches(track, options);
  std::vector<FittedPath> paths;
  WalkCycle cycle;
  cycle.cycles = static_cast<int>(stretches.size());
  double first = level.frames(), last = 0.0, length = 0.0, turn = 0.0;
  for (const Stretch& s : stretches) {
    paths.push_back(fitPath(track, s, options.turning, kSamples));
    cycle.period += (s.end - s.begin) * level.frame_time / cycle.cycles;
    length += paths.back().length / cycle.cycles;
    turn += paths.back().turn / cycle.cycles;
    cycle.closure = std::max(cycle.closure, s.closure);
    first = std::min(first, s.begin);
    last = std::max(last, s.end);
  }
  cycle.speed = length / cycle.period;
  cycle.turn_rate = turn / cycle.period;
  const std::vector<Eigen::MatrixXd> samples = cycleSamples(track, stretches, paths, reference);
  fitSeries(meanOf(samples), options.harmonics, cycle);
  fitFeet(track, stretches, feet, options.clip, cycle);
  // Heights are over the soles' ground, which a levelled floor is within some millimetres of; a
  // straight walk's path is midway between its footprints, whichever foot the walker leans over.
  Eigen::Vector2d middle = fitPlacing(track, stretches, paths, cycle);
  if (options.turning) cycle.prints_left = std::exchange(middle[0], 0.0);
  cycle.series.alpha.col(0).segment<2>(1) -= middle;
  fitHeelRise(level.skeleton, roles, feet, reference, cycle);
  for (size_t k = 0; captured != nullptr && k < samples.size(); ++k) {
    captured->push_back(fitFourier(samples[k], evenPhases(), kAllHarmonics));
    captured->back().alpha.col(0).segment<2>(1) -= middle;
  }
  cycle.capture = measureCapture(level, roles);
  if (used_frames != nullptr) {
    *used_frames = {static_cast<int>(std::lround(first)), static_cast<int>(std::lround(last))};
  }
  return cycle;
}

bool hasCycle(const Clip& level, const JointRoles& roles, const std::array<FootShape, 2>& feet,
              const CycleOptions& options) {
  return !wholeCycles(GaitTrack(level, roles, feet, options.plants), options).empty();
}

Posture preparePosture(const Clip& level, const JointRoles& roles,
                       const std::array<FootShape, 2>& feet, int first, int last) {
  const GaitTrack track(level, roles, feet);
  const int joints = level.skeleton.size();
  Posture posture;
  posture.rotations.assign(joints, Eigen::Quaterniond::Identity());
  const int count = last - first + 1;
  std::vector<RotationMean> mean(joints);
  for (int i = first; i <= last; ++i) {
    const double heading = track.headingAt(i);
    Pose pose;
    pose.rotations.resize(joints);
    track.poseAt(i, pose);
    pose.rotations[0] = aboutZ(-heading) * pose.rotations[0];
    for (int j = 0; j < joints; ++j) mean[j].add(pose.rotations[j]);
    Eigen::Vector3d middle = Eigen::Vector3d::Zero(), across = Eigen::Vector3d::Zero();
    for (const Side side : {kLeft, kRight}) {
      const Plant here{static_cast<double>(i), static_cast<double>(i)};
      const GaitTrack::FlatFoot flat = track.flatFoot(side, here);
      middle += 0.5 * flat.print;
      across += side == kLeft ? flat.print : Eigen::Vector3d(-flat.print);
      posture.toe_out[side] += wrapAngle(flat.heading - heading) / count;
    }
    posture.root_height += (pose.p_WR.z() - middle.z()) / count;
    const Eigen::Vector3d back = aboutZ(-heading) * (pose.p_WR - middle);
    posture.root_forward += back.x() / count;
    posture.step_width += (aboutZ(-heading) * across).y() / count;
  }
  for (int j = 0; j < joints; ++j) posture.rotations[j] = mean[j].mean();
  return posture;
}

}  // namespace amble

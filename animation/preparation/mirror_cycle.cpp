#include "animation/preparation/mirror_cycle.h"

#include <cmath>
#include <utility>

#include "animation/clips/mirror_clip.h"
#include "base/rotation.h"

namespace amble {
namespace {

constexpr int kPhases = 64;  // of the cycle; even, more than twice the harmonics of any series

// One cycle along +x.
Clip straightened(const WalkCycle& cycle, const Skeleton& skeleton,
                  const std::vector<Eigen::Quaterniond>& reference) {
  Clip clip{"cycle", skeleton, cycle.period / kPhases, PoseArray(skeleton.size()), {}};
  Pose pose;
  pose.rotations.resize(reference.size());
  for (int i = 0; i < kPhases; ++i) {
    const double phase = static_cast<double>(i) / kPhases;
    const Eigen::VectorXd c = fourierAt(cycle.series, phase);
    pose.p_WR = c.head<3>();
    pose.p_WR.x() += cycle.speed * cycle.period * phase;
    for (size_t j = 0; j < reference.size(); ++j) {
      pose.rotations[j] =
          reference[j] * expRotation(c.segment<3>(3 + 3 * static_cast<Eigen::Index>(j)));
    }
    clip.poses.append(pose);
  }
  return clip;
}

// Channels of the mirrored poses: column i is their phase, half a period after the cycle's.
Eigen::MatrixXd channelsOf(const Clip& mirrored, const WalkCycle& cycle,
                           const std::vector<Eigen::Quaterniond>& reference) {
  Eigen::MatrixXd channels(cycle.series.channels(), kPhases);
  for (int i = 0; i < kPhases; ++i) {
    auto column = channels.col((i + kPhases / 2) % kPhases);
    column.head<3>() = mirrored.poses.p_WR(i);
    column[0] -= cycle.speed * cycle.period * i / kPhases;
    for (size_t j = 0; j < reference.size(); ++j) {
      column.segment<3>(3 + 3 * static_cast<Eigen::Index>(j)) =
          logRotation(reference[j].conjugate() * mirrored.poses.rotations(i)[j]);
    }
  }
  return channels;
}

FootCycle mirrored(FootCycle foot) {
  foot.strike = std::fmod(foot.strike + 0.5, 1.0);
  foot.lift_off = std::fmod(foot.lift_off + 0.5, 1.0);
  for (auto* strays : {&foot.sideways, &foot.roll, &foot.yaw}) {
    for (double& coefficient : *strays) coefficient = -coefficient;
  }
  return foot;
}

}  // namespace

WalkCycle mirrorCycle(const WalkCycle& cycle, const Skeleton& skeleton, const JointRoles& roles,
                      const std::vector<Eigen::Quaterniond>& reference) {
  WalkCycle other = cycle;
  other.turn_rate = 0.0 - cycle.turn_rate;  // no -0
  other.feet = {mirrored(cycle.feet[kRight]), mirrored(cycle.feet[kLeft])};
  other.prints_left = 0.0 - cycle.prints_left;
  other.foot_forward = {cycle.foot_forward[kRight], cycle.foot_forward[kLeft]};
  other.toe_out = {-cycle.toe_out[kRight], -cycle.toe_out[kLeft]};
  if (other.foot_drops) std::swap((*other.foot_drops)[kLeft], (*other.foot_drops)[kRight]);
  std::vector<double> phases;
  for (int i = 0; i < kPhases; ++i) phases.push_back(static_cast<double>(i) / kPhases);
  const Clip clip = mirrorClip(straightened(cycle, skeleton, reference), roles);
  other.series = fitFourier(channelsOf(clip, cycle, reference), phases, cycle.series.harmonics());
  return other;
}

}  // namespace amble

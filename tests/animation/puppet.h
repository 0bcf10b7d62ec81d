/// A walker drawn from formulas: its pelvis goes along a line or circle, its feet stand and swing
/// as told to the digit. Joints are moved by their positions (Clip::joint_positions), so that no
/// kinematics stands between a formula and a foot.
#pragma once

#include <cmath>
#include <functional>

#include "animation/analysis/foot_plants.h"
#include "animation/body/clip.h"
#include "animation/body/joint_roles.h"
#include "base/ease.h"
#include "base/rotation.h"

namespace amble {

struct Puppet {
  double speed = 1.2;        ///< [m/s]
  double turn_rate = 0.0;    ///< [rad/s], left positive
  double period = 1.1;       ///< of two steps [s]
  double stance = 0.62;      ///< share of the period on the ground
  double right_phase = 0.5;  ///< of the right foot's strike after the left's [cycles]
  double width = 0.1;        ///< between the lines of the feet [m]
  double lift = 0.12;        ///< of the ankle in its swing [m]
  double slide = 0.0;        ///< of a planted foot, forwards at this speed [m/s]
  double sink = 0.0;      ///< of a foot in the middle of its swing: its lift is this much less [m]
  double rate = 100.0;    ///< [Hz]
  double duration = 6.0;  ///< [s]
  /// Of a foot at FootState::at [rad], by rigs that have feet; null: it stays flat.
  double (*pitch)(double at) = nullptr;

  static constexpr double kThigh = 0.42, kShank = 0.41, kHip = 0.86;  // [m]
  static constexpr double kAnkle = 0.08, kToe = 0.03,
                          kFoot = 0.14;  // heights, and ankle to toe [m]

  double heading(double t) const { return turn_rate * t; }
  Eigen::Vector3d pelvis(double t) const {
    if (turn_rate == 0.0) return {speed * t, 0.0, kHip};
    const double radius = speed / turn_rate;
    return {radius * std::sin(turn_rate * t), radius * (1.0 - std::cos(turn_rate * t)), kHip};
  }

  double strike(Side side, int cycle) const {
    return (cycle + (side == kRight ? right_phase : 0.0)) * period;
  }
  double liftOff(Side side, int cycle) const { return strike(side, cycle) + stance * period; }

  Eigen::Vector3d footprint(Side side, int cycle) const {
    const double middle = 0.5 * (strike(side, cycle) + liftOff(side, cycle));
    const double left = side == kLeft ? 0.5 * width : -0.5 * width;
    Eigen::Vector3d p = pelvis(middle) + aboutZ(heading(middle)) * Eigen::Vector3d(0, left, 0);
    p.z() = 0.0;
    return p;
  }

  /// FootState::at of a foot at a time.
  double at(Side side, double t) const {
    const int cycle = static_cast<int>(std::floor((t - strike(side, 0)) / period));
    const double into = t - strike(side, cycle), standing = stance * period;
    return into <= standing ? into / standing : 1.0 + (into - standing) / (period - standing);
  }

  /// The ankle of a foot that is flat at a time, and the heading of the foot.
  std::pair<Eigen::Vector3d, double> ankle(Side side, double t) const {
    const int cycle = static_cast<int>(std::floor((t - strike(side, 0)) / period));
    const double into = t - strike(side, cycle), standing = stance * period;
    const double from = heading(strike(side, cycle) + 0.5 * standing),
                 to = from + turn_rate * period;
    if (into <= standing) {
      const Eigen::Vector3d way(slide * (into - 0.5 * standing), 0, kAnkle);
      return {footprint(side, cycle) + aboutZ(from) * way, from};
    }
    const double u = (into - standing) / (period - standing);
    const double progress = smoothstep(u);
    Eigen::Vector3d p =
        (1.0 - progress) * footprint(side, cycle) + progress * footprint(side, cycle + 1);
    p.z() = kAnkle + (lift - sink) * std::sin(kPi * u);
    return {p, (1.0 - progress) * from + progress * to};
  }

  Clip clip() const;
  static JointRoles roles();
  /// What detectPlants should find, at every frame.
  FootPlants plants() const;
};

inline JointRoles Puppet::roles() {
  JointRoles roles;
  for (const int side : {kLeft, kRight}) {
    roles.legs[side] = {1 + 4 * side, 2 + 4 * side, 3 + 4 * side, 4 + 4 * side};
  }
  return roles;
}

inline Clip Puppet::clip() const {
  std::vector<Joint> joints(9);
  for (int side : {0, 1}) {
    for (int i = 0; i < 4; ++i) {
      Joint& joint = joints[1 + 4 * side + i];
      joint.parent = i == 0 ? 0 : 4 * side + i;
      if (i == 1) joint.offset = {0, 0, -kThigh};
      if (i == 2) joint.offset = {0, 0, -kShank};
      if (i == 3) joint.offset = {kFoot, 0, kToe - kAnkle};
    }
  }
  Clip clip;
  clip.name = "puppet";
  clip.skeleton = Skeleton(joints);
  clip.frame_time = 1.0 / rate;
  clip.poses = PoseArray(9);
  const int frames = static_cast<int>(std::lround(duration * rate)) + 1;
  clip.poses.resize(frames);
  for (int i = 0; i < frames; ++i) {
    const double t = i * clip.frame_time;
    const Eigen::Quaterniond q_WR = aboutZ(heading(t));
    clip.poses.p_WR(i) = pelvis(t);
    clip.poses.rotations(i)[0] = q_WR;
    clip.joint_positions.emplace_back(0, 0, 0);
    for (const Side side : {kLeft, kRight}) {
      const auto [p_ankle, foot_heading] = ankle(side, t);
      const Eigen::Vector3d hip(0, side == kLeft ? 0.09 : -0.09, 0), knee(0.02, 0, -kThigh);
      const Eigen::Vector3d toe = aboutZ(foot_heading) * Eigen::Vector3d(kFoot, 0, kToe - kAnkle);
      clip.joint_positions.push_back(hip);
      clip.joint_positions.push_back(knee);
      clip.joint_positions.push_back(q_WR.conjugate() * (p_ankle - pelvis(t)) - hip - knee);
      clip.joint_positions.push_back(q_WR.conjugate() * toe);
    }
  }
  return clip;
}

inline FootPlants Puppet::plants() const {
  std::array<std::vector<bool>, 2> planted;
  for (const Side side : {kLeft, kRight}) {
    for (int i = 0; i <= std::lround(duration * rate); ++i) {
      const double since = i / rate - strike(side, 0);
      planted[side].push_back(since - std::floor(since / period) * period <=
                              stance * period + 1e-9);
    }
  }
  return plantsOf(planted);
}

inline Puppet onACircle() {
  Puppet puppet;
  puppet.speed = 1.0;
  puppet.turn_rate = 0.6;
  puppet.duration = 10.0;
  return puppet;
}

}  // namespace amble

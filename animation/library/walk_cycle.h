/// A walk cycle as Fourier series (Pettré §4.1): what a capture of a walk becomes before it is
/// warped and blended.
///
/// Phase is in cycles; phase 0 is the middle of the double support with the left foot in front, 0.5
/// the same with the right.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "animation/body/clip.h"
#include "animation/body/joint_roles.h"
#include "animation/library/foot_cycle.h"
#include "animation/library/fourier.h"

namespace amble {

/// Slower than this is straight, faster is a turn: walkers sway by as much [rad/s].
inline constexpr double kStraightTurnRate = 0.15;

/// QUALITY.md's measures of the clip that a cycle was cut from: its anchors.
struct CaptureQuality {
  double toe_skate = 0.0;          ///< [m/s, >= 0]
  double root_acceleration = 0.0;  ///< [m/s^2, >= 0]
  double joint_jerk = 0.0;         ///< [m/s^3, >= 0]
  double pops = 0.0;               ///< [1, >= 0]
};

struct WalkCycle {
  double speed = 0.0;      ///< along the fitted line or circle [m/s, > 0]
  double turn_rate = 0.0;  ///< [rad/s], left positive
  double period = 0.0;     ///< of a cycle, two steps [s, > 0]
  int cycles = 0;          ///< of the capture that were averaged [>= 1]
  /// Measured error of the cycle, the largest of those averaged: rms distance of joints between its
  /// ends [m, >= 0].
  double closure = 0.0;
  double residual = 0.0;  ///< rms of what the low-pass leaves out, over joints' angles [rad, >= 0]
  double slide = 0.0;     ///< largest way of a standing ankle in the capture [m, >= 0]
  CaptureQuality capture;
  /// Rows are channels: errors of the root around the fitted line or circle, captured minus fitted
  /// (forward, left, height over the ground [m]) - the paper's eps is the negative of it - then the
  /// rotation vector [rad] of the root against the heading and of each further joint, each against
  /// the library's reference rotation: q = q_reference * exp(v).
  FourierSeries series;
  std::array<FootCycle, 2> feet;  ///< by Side
  double step_width = 0.0;        ///< between the lines of left and right footprints [m]
  /// Of a turn's path, where the middle between those lines is: people lean into a turn. 0 of a
  /// straight walk [m].
  double prints_left = 0.0;
  /// Of the footprints of phase 0 before the path's points half of a step before and behind,
  /// by Side: different where steps of left and right are [m].
  std::array<double, 2> foot_forward = {0, 0};
  /// Heading of the footprint against the path beside it, left positive, by Side [rad].
  std::array<double, 2> toe_out = {0, 0};
  /// Of a walk of the library's own rig: how far its captured feet drop where they stand
  /// (footDrops), by Side, from which the library has its soles (library_soles.h) [rad].
  std::optional<std::array<double, 2>> foot_drops = std::nullopt;

  /// Of the capture (the papers' "stride") [m, > 0].
  double stepLength() const { return 0.5 * speed * period; }
  /// When feet strike and leave beside phases 0 and 0.5 [steps], as StrideLaw has it: rows: Side of
  /// the foot in front; columns: since it has come down, until the other one leaves.
  Eigen::Array22d doubleSupports() const {
    Eigen::Array22d steps;
    for (const Side front : {kLeft, kRight}) {
      const double node = front == kLeft ? 0.0 : 0.5;
      steps(front, 0) = 2.0 * std::remainder(node - feet[front].strike, 1.0);
      steps(front, 1) = 2.0 * std::remainder(feet[other(front)].lift_off - node, 1.0);
    }
    return steps;
  }
  /// Share of the cycle in which both feet are planted [0, 1].
  double doubleSupport() const { return 0.5 * doubleSupports().sum(); }
};

/// A pose to hold.
struct Posture {
  double root_height = 0.0;   ///< over the ground [m, > 0]
  double root_forward = 0.0;  ///< of the root before the middle of the footprints [m]
  /// Of the root against the heading, then of each joint in its parent.
  std::vector<Eigen::Quaterniond> rotations;
  double step_width = 0.0;                 ///< between the footprints [m]
  std::array<double, 2> toe_out = {0, 0};  ///< [rad], left positive, by Side
};

}  // namespace amble

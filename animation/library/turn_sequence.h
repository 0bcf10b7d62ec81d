/// A turn on the spot (Pettré §4.3): what a body does, as captured, while it turns where it stands.
///
/// Its clock is the share of its time, from 0 to 1; at both ends the body stands at rest.
#pragma once

#include <Eigen/Core>
#include <span>

#include "animation/body/joint_roles.h"
#include "base/cubic_spline.h"
#include "base/rotation.h"

namespace amble {

struct TurnSequence {
  /// Coefficients at either end that are the posture `stand`, and the turn not begun or over: so it
  /// begins and ends at rest.
  static constexpr int kStanding = 3;
  static constexpr double kKnot = 0.1;  ///< of a piece of the splines, nearly [s]

  static constexpr double kLeastAngle = 10.0 * kDegree, kMostAngle = 720.0 * kDegree;
  static constexpr double kShortest = 0.2, kLongest = 20.0;  ///< [s]
  static constexpr int kMostSteps = 100;

  double angle = 0.0;     ///< that the pelvis is turned by [rad, left positive, |.| >= kLeastAngle]
  double duration = 0.0;  ///< [s, 0.2 to 20]
  Side first = kLeft;     ///< the foot that steps first
  int steps = 0;          ///< of both feet [1 to 100]
  /// Largest yaw of a standing foot against the pelvis: people pivot on it [rad, 0 to pi].
  double twist = 0.0;
  /// Rows: channels as WalkCycle::series has them, against the heading of the pelvis; forward and
  /// left, and the legs', are those of `stand`, for both are the steps'. Columns: coefficients of a
  /// uniform cubic B-spline over the clock.
  Eigen::MatrixXd spline;
  /// Share of the angle that is done, as such a spline of one row: 0 at first, 1 at last.
  Eigen::MatrixXd turned;

  bool empty() const { return spline.size() == 0; }
  int pieces() const { return static_cast<int>(spline.cols()) - 3; }
};

/// The channels at a moment of the clock, held at its ends. @param channels  as many as rows
void turnChannels(const TurnSequence& sequence, double clock, std::span<double> channels);

/// The share of the angle over the clock.
CubicSpline shareTurned(const TurnSequence& sequence);

}  // namespace amble

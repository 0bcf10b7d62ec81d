/// A start or a stop (Pettré §4.3): how standing becomes walking, and walking standing.
///
/// A transition has a clock that counts steps from standing, forwards in a start and backwards in a
/// stop. From 0 to 1 one foot steps, which a start begins with and a stop ends with; 1 is the
/// middle of the double support that joins it to the walk. Below 0, as far as -sway, both feet
/// stand and weight is shifted.
#pragma once

#include <Eigen/Core>
#include <span>

#include "animation/body/joint_roles.h"
#include "animation/library/foot_cycle.h"

namespace amble {

/// What a body does from standing to the walk, or back, as captured.
struct TransitionSequence {
  static constexpr double kEnd = 2.0;   ///< last moment of the clock [steps]
  static constexpr double kKnot = 0.2;  ///< of the clock a piece of the spline, nearly [steps]
  /// Coefficients at the begin that are the posture `stand`, which it leaves at rest.
  static constexpr int kStanding = 3;

  Side side = kLeft;       ///< the foot that steps between 0 and 1
  double sway = 0.0;       ///< [steps, 0 to 5]
  double step_time = 0.0;  ///< of a step at clock 1 [s, 0.2 to 2]
  double advance = 0.0;    ///< of the path's point between 0 and 1 [m, 0.05 to 1]
  /// How it swings there; its lift-off and its strike are on the clock.
  FootCycle swing;
  /// Rows: channels as WalkCycle::series has them, on the way of the path's point
  /// (transitionAdvance); columns: coefficients of a uniform cubic B-spline over the clock from
  /// -sway to kEnd.
  Eigen::MatrixXd spline;

  bool empty() const { return spline.size() == 0; }
  int pieces() const { return static_cast<int>(spline.cols()) - 3; }
};

/// How walking begins or ends, measured along the root's way.
struct Transition {
  double speed = 0.0;           ///< of the walk that it leads to or comes from [m/s, > 0]
  double first_speed = 0.0;     ///< at the first strike, or the last lift-off [m/s, > 0]
  double acceleration = 0.0;    ///< mean between 10 % and 90 % of the speed [m/s^2, > 0]
  TransitionSequence sequence;  ///< empty in libraries that only have these numbers
};

/// Four columns of a uniform cubic B-spline of so many pieces, and their weights, at x [0 to 1] of
/// its whole length.
struct SplineWeights {
  int first;
  double weight[4];
};
SplineWeights splineWeights(int pieces, double x);

/// Such a spline at x. Rows: channels; columns: coefficients. @param channels  as many as rows
void splineAt(const Eigen::MatrixXd& spline, double x, std::span<double> channels);

/// The channels at a moment of the clock, held at its ends. @param channels  as many as rows
void transitionAt(const TransitionSequence& sequence, double clock, std::span<double> channels);

/// Share of the way between 0 and 1 that the path's point has gone at a moment of the clock, where
/// its speed grows from 0 to that of the walk: tau^3 - tau^4 / 2 of twice the way, a smoothstep of
/// speed. @param clock  held in [0, 1]
inline double transitionAdvance(double clock) {
  const double tau = clock < 0.0 ? 0.0 : clock > 1.0 ? 1.0 : clock;
  return tau * tau * tau * (2.0 - tau);
}

}  // namespace amble

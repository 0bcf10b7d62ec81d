/// A walk cycle as Fourier series (Pettré §4.1): what a capture of a walk becomes before it is warped and blended.
///
/// Channels, in this order: errors of the root around the fitted line or circle (forward, left, up [m]; rotation vector [rad] of
/// the root against the path's frame), then the rotation vector [rad] of each further joint against the library's reference
/// rotation. Phase is in cycles; phase 0 is the middle of the double support with the left foot in front (DESIGN.md, 2).
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <optional>
#include <vector>

#include "animation/clip.h"
#include "animation/joint_roles.h"

namespace amble {

/// p(phase) = alpha_0 + sum_k alpha_k cos(2 pi k phase) + beta_k sin(2 pi k phase)   (Pettré eq. 2), for many channels.
struct FourierSeries {
  Eigen::MatrixXd alpha;  ///< rows: channels; columns: k = 0..harmonics
  Eigen::MatrixXd beta;   ///< rows: channels; columns: k = 0..harmonics; column 0 is 0

  int channels() const { return static_cast<int>(alpha.rows()); }
  int harmonics() const { return static_cast<int>(alpha.cols()) - 1; }
  /// All channels at `phase` [cycles]; alpha_k and beta_k, k >= 1, times `amplitude`. alpha_0, the mean posture, is not
  /// scaled: that would change how the walker stands (the paper does not say).
  void evaluate(double phase, double amplitude, Eigen::VectorXd& values) const;
};

/// Least squares over one period: samples (rows: channels, columns: times at phases[i]). @pre more samples than coefficients.
FourierSeries fitFourier(const Eigen::MatrixXd& samples, const std::vector<double>& phases, int harmonics);

/// How one foot moves over a cycle, relative to its own footprints. Side-specific; angles of the sole against the ground.
struct FootCycle {
  double strike = 0.0;    ///< phase at which the heel lands [cycles]
  double lift_off = 0.0;  ///< phase at which the toe leaves [cycles]
  /// Swing, sampled evenly from lift-off to strike (both included): how far the foot has gone from one footprint to the next
  /// [0 to 1], height of the ball over the straight line between them [m], how far it strays to the left of that line [m], and the sole's rotation
  /// vector against the heading (x roll, y pitch, toe down positive, z yaw) [rad].
  std::vector<double> progress, height, sideways;
  std::vector<Eigen::Vector3d> swing_rotation;
  /// Pitch of the sole during stance, sampled evenly from strike to lift-off: negative while only the heel touches, 0 while
  /// flat, positive when the heel has risen [rad].
  std::vector<double> stance_pitch;
};

struct WalkCycle {
  double speed = 0.0;       ///< along the fitted line or circle [m/s]
  double turn_rate = 0.0;   ///< [rad/s], left positive
  double period = 0.0;      ///< of a cycle, two steps [s]
  double closure = 0.0;     ///< measured error of the cycle: rms joint distance between its ends [m]
  double residual = 0.0;    ///< rms of what the low-pass leaves out, over joints [rad]
  FourierSeries series;
  std::array<FootCycle, 2> feet;      ///< by Side
  double step_width = 0.0;            ///< between the feet's lines [m]
  double foot_forward = 0.0;          ///< mean of front and rear foot against the root at phase 0 [m]
  std::array<double, 2> toe_out = {0, 0};  ///< heading of the planted foot against the path, left positive [rad]
};

/// A pose to hold, relative to a path's frame on the ground below the root.
struct Posture {
  double root_height = 0.0;              ///< over the ground [m]
  std::vector<Eigen::Quaterniond> rotations;  ///< of the root against the heading, then of each joint in its parent
  double step_width = 0.0;               ///< between the feet [m]
  double foot_forward = 0.0;             ///< mean of the feet against the root [m]
  std::array<double, 2> toe_out = {0, 0};  ///< [rad], left positive
};

}  // namespace amble

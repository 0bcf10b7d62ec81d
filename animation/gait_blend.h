/// Walk cycles blended to a turn rate and warped to a step length (Pettré §4.2, eq. 3).
///
/// Straight walks, left turns and right turns of the library are each averaged into one cycle;
/// which is which is told by each cycle's own measured turn rate. (The paper has left turns
/// negative; ours are positive.) Weights grow with the turn rate up to that of the captured turns
/// and are held there: nothing is extrapolated, the speed drops instead.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "animation/motion_library.h"
#include "animation/stride_law.h"

namespace amble {

class GaitBlend {
 public:
  /// For a character `scale` times the captured subject: lengths grow with scale, speeds and turn
  /// rates by Froude's law with its root and the inverse of it. @throws std::invalid_argument
  /// without a straight walk.
  GaitBlend(const MotionLibrary& library, double scale);

  const StrideLaw& law() const { return law_; }
  /// Fastest turn of the library's walks; what there is without turns in the library is `kNoTurns`
  /// [rad/s].
  double maxTurnRate() const { return max_turn_rate_; }
  static constexpr double kNoTurns = 0.5;
  double stepWidth() const { return step_width_; }      ///< of the straight walk [m]
  double footForward() const { return foot_forward_; }  ///< [m]
  double toeOut() const { return toe_out_; }            ///< of the left foot, left positive [rad]
  const FootCycle& foot(Side side) const { return feet_[side]; }

  /// Channels of WalkCycle::series at a phase [cycles], blended for a turn rate [rad/s] and warped
  /// to a step length [m]. Amplitudes are proportional to step length, that of the root's height to
  /// its square as an inverted pendulum's; means stay.
  void evaluate(double phase, double turn_rate, double step_length,
                Eigen::VectorXd& channels) const;

 private:
  struct Mean {
    Eigen::MatrixXd
        coefficients;  // rows: channels; columns: alpha_0, beta_0 = 0, alpha_1, beta_1, ...
    double turn_rate = 0.0;
    int count = 0;
  };
  void add(Mean& mean, const WalkCycle& cycle, int harmonics, double scale);
  void averageFeet(const std::vector<const WalkCycle*>& straight, double scale);

  StrideLaw law_;
  Mean straight_, left_, right_;
  double max_turn_rate_ = 0.0, step_width_ = 0.0, foot_forward_ = 0.0, toe_out_ = 0.0;
  std::array<FootCycle, 2> feet_;
};

}  // namespace amble

/// The space of one gait from its cycles (Glardon 2004, §3 and §4): principal components, lines
/// over speed, the person's own frequency law.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "animation/library/speed_engine.h"

namespace amble {

/// A cycle on the engine's skeleton.
struct EngineCycle {
  int clip = 0;         ///< index of the capture that it is from [>= 0]
  double speed = 0.0;   ///< [m/s, > 0]
  double period = 0.0;  ///< [s, > 0]
  /// Rows: channels of WalkCycle::series, rotations against the mean posture; columns: phases.
  Eigen::MatrixXd channels;
  std::array<double, 2> support = {0, 0};
  double step_width = 0.0;                      ///< as WalkCycle has these [m]
  std::array<double, 2> foot_forward = {0, 0};  ///< [m]
  std::array<double, 2> toe_out = {0, 0};       ///< [rad]
};

/// The space of these cycles (all but GaitSpace::clips), of a person whose legs are so long [m].
/// @pre one cycle or more
GaitSpace fitGaitSpace(const std::vector<EngineCycle>& cycles, double leg, double variance);

/// The motion vector of a space at a speed (eq. 1 and 2), beyond its captures as well. Rows:
/// rotation channels; columns: phases.
Eigen::MatrixXd motionVectorAt(const GaitSpace& space, double speed);

}  // namespace amble

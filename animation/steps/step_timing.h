/// When a walk of given footsteps is where on its root path: what SpeedProfile is for walks whose
/// steps it chooses itself.
#pragma once

#include <vector>

#include "animation/steps/speed_profile.h"
#include "base/cubic_spline.h"

namespace amble {

/// A walk of n steps whose node i (middle of the double support after step i) lies at arcs[i].
struct TimedSteps {
  std::vector<double> arcs;       ///< n + 1, from 0 to the path's length [m]
  std::vector<double> lengths;    ///< of the step at each node, to warp the cycles to: n + 1 [m]
  std::vector<double> durations;  ///< wanted, of each step: n [s]
  double first_speed = 0.0;       ///< at the ends: 0 where the walk stands [m/s]
  double last_speed = 0.0;
  /// How long weight is shifted before the first and after the last step, both feet standing, in
  /// durations of that step [1, >= 0].
  double start_sway = 0.0, stop_sway = 0.0;
  double frame_time = 1.0 / 60.0;  ///< [s]
};

/// Arc and progress are splines over time through the nodes, with continuous accelerations; the
/// durations give way so that the whole takes a whole number of frames.
class StepTiming {
 public:
  /// @pre steps.durations.size() >= 2, arcs increasing
  explicit StepTiming(const TimedSteps& steps);

  int frames() const { return frames_; }  ///< intervals; there is one frame more
  SpeedProfile::Sample at(int frame) const;
  /// Mean over the i-th step [m/s]. @param step  [1 to the number of steps]
  double stepSpeed(int step) const { return speeds_[step - 1]; }

 private:
  CubicSpline arc_, progress_;
  std::vector<double> lengths_;
  std::vector<double> speeds_;  // by step [m/s]
  double frame_time_ = 0.0;
  double first_ = 0.0, last_ = 0.0;  // wanted steps' times beside standing, as they came out [s]
  double start_sway_ = 0.0, stop_sway_ = 0.0;
  int frames_ = 0;
};

}  // namespace amble

/// How a walk would go along a path if its steps could be as they please: what steps that are
/// chosen for the ground are measured by.
#pragma once

#include <vector>

#include "animation/steps/speed_profile.h"
#include "animation/steps/stance.h"

namespace amble {

/// On the level. Slower where the ground is steep (SpeedLimits::pace), in turns that would be
/// faster than the limits' rate, and in first and last steps from and to standing; steps are those
/// of the speed, in turns those of captured turns.
class WantedWalk {
 public:
  static constexpr double kSpacing = 0.05;  ///< of the points; linear between them [m]

  /// @pre the path is longer than 0
  /// @param step  of the plan's straight walk, over which turns are looked at [m, > 0]
  WantedWalk(const RootPath& path, const Stance& from, const Stance& to, const SpeedLimits& limits,
             double step);

  /// At an arc, held within the path [m]: speed [m/s], turn rate [rad/s, left positive], step [m].
  double speed(double arc) const { return at(arc, &Point::speed); }
  double turnRate(double arc) const { return at(arc, &Point::turn_rate); }
  double step(double arc) const { return at(arc, &Point::step); }

 private:
  struct Point {
    double speed, turn_rate, step;
  };
  double at(double arc, double Point::*value) const;

  double spacing_ = 0.0;
  std::vector<Point> points_;
};

}  // namespace amble

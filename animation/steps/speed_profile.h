/// The speed profile: when a walk is where on its root path, and in which step.
///
/// It starts from standing, slows where the path turns faster than the library's walks, stops
/// standing; it is a whole number of steps and of frames (DESIGN.md, section 3). Progress is
/// counted in steps: at progress i the walker is in the middle of a double support, and the i-th
/// step of the walk has just landed.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <vector>

#include "animation/steps/root_path.h"
#include "animation/steps/stride_law.h"

namespace amble {

struct SpeedLimits {
  StrideLaw law;
  double speed = 1.2;              ///< on the straight, and at walking stances [m/s, > 0]
  double max_turn_rate = 1.0;      ///< [rad/s, > 0]
  double frame_time = 1.0 / 60.0;  ///< [s, > 0]
  /// Share of the speed that the ground allows at an arc [0 to 1]; none: all of it, everywhere.
  std::function<double(double)> pace = {};
  /// Step length that is asked for at an arc [m], at the plan's cadence; none: the law's.
  std::function<double(double)> stride = {};
};

/// How fast a walk may be beside ends that stand: its first and its last step are slower than
/// others.
class BesideStanding {
 public:
  BesideStanding(const StrideLaw& law, bool from_stands, bool to_stands);

  /// Within half of such a step of that end; elsewhere infinite [m/s].
  /// @param from, to  how far it is to the path's ends [m, >= 0]
  double fastest(double from, double to) const {
    return std::min(from < first_.within ? first_.speed : HUGE_VAL,
                    to < last_.within ? last_.speed : HUGE_VAL);
  }

 private:
  struct Step {
    double speed, within;  // [m/s], [m]
  };
  Step first_, last_;
};

/// How whole steps are fitted to a path.
struct StepFit {
  /// Steps are made no shorter and no longer than these shares of the wanted ones; by trial: a
  /// narrower range refuses short walks, a wider one minces and leaps [1].
  static constexpr double kLeastStretch = 0.35, kMostStretch = 1.2;
  static constexpr double kSpacing = 0.02;       ///< of knots: a step has thirty [m]
  static constexpr double kShortestPath = 0.05;  ///< shorter is no walk: turn on the spot [m]
  /// Over this many straight steps a stretched stride fades to the plan's at a walking stance;
  /// sooner, and the step before it jumps [steps].
  static constexpr double kFadeSteps = 1.2;
  /// Log of the stretch at which speed begins to follow; by trial. A walk whose steps give way by a
  /// few percent keeps its speed and changes its cadence [1].
  static constexpr double kSteady = 0.12;
  static constexpr double kRounding = 1e-6;  ///< a step as long as the longest is walked [1]
};

struct SpeedProfileEnds {
  bool from_standing = true;
  bool to_standing = true;
  std::optional<int> parity;  ///< 0 or 1: the number of steps must be even or odd
};

class SpeedProfile {
 public:
  enum class Refusal { kNone, kTurnRate, kStepLength };

  /// Plans the whole profile. Where it is refused, nothing else may be asked.
  SpeedProfile(const RootPath& path, const SpeedLimits& limits, const SpeedProfileEnds& ends);

  Refusal refusal() const { return refusal_; }
  int steps() const { return steps_; }    ///< >= 2
  int frames() const { return frames_; }  ///< intervals; there is one frame more

  struct Sample {
    double arc;          ///< [m]
    double speed;        ///< [m/s]
    double steps;        ///< progress [0, steps()]
    double step_length;  ///< [m]
    /// Before the first step negative, after the last positive, while weight is shifted there and
    /// both feet stand [steps beside standing].
    double sway = 0.0;
  };
  Sample at(int frame) const;
  double arcAtStep(int step) const;  ///< [m]
  /// Walked at an arc, were there no start and stop [m/s].
  double speedAt(double arc) const { return 1.0 / valueAt(arc, &Knot::slowness); }

 private:
  class PathKnots;
  bool turnsTooFastBeside(bool at_end, int count, PathKnots& path) const;
  void limitSpeed(const RootPath& path);
  void turnSteps(const std::vector<double>& headings);
  double allowedSpeed(double arc) const;
  void chooseSteps();
  void stretch(double delta);
  double countSteps() const;
  void time();

  struct Knot {
    double arc;          // [m]
    double window;       // how far its step may be stretched: 0 at a walking stance [0, 1]
    double wanted;       // step length [m]
    double speed;        // wanted [m/s]
    double step;         // step length [m]
    double per_metre;    // steps, 1 / step [1/m]
    double slowness;     // [s/m]
    double steps, time;  // integrals from the path's begin, of per_metre and of slowness
  };
  // Where an arc lies between two knots.
  struct Place {
    int knot;       // the first of them
    double beyond;  // it [m]
  };
  Place placeAt(double arc) const;
  double valueAt(const Place& at, double Knot::*value) const;
  double valueAt(double arc, double Knot::*value) const { return valueAt(placeAt(arc), value); }
  double integralAt(const Place& at, double Knot::*value, double Knot::*rate) const;
  double integralAt(double arc, double Knot::*value, double Knot::*rate) const {
    return integralAt(placeAt(arc), value, rate);
  }
  double arcWhere(double value, double Knot::*integral, double Knot::*rate) const;

  SpeedLimits limits_;
  SpeedProfileEnds ends_;
  Refusal refusal_ = Refusal::kNone;
  std::vector<Knot> knots_;  // even in arc
  double length_ = 0.0;
  // Arc of the first and of the last node that is walked through [m].
  double start_arc_ = 0.0, stop_arc_ = 0.0;
  double start_time_ = 0.0, stop_time_ = 0.0;      // how long starting and stopping take [s]
  double start_sway_ = 0.0, stop_sway_ = 0.0;      // before and after that weight is shifted [s]
  double usual_step_ = 0.0;                        // at the plan's speed [m]
  double steps_before_ = 0.0, time_before_ = 0.0;  // of the integrals, at start_arc_
  int steps_ = 0, frames_ = 0;
};

}  // namespace amble

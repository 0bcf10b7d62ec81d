/// What is found of a walk that is validated: what it touches, what its feet do.
#pragma once

#include <string>

namespace amble {

/// A stretch of time in which one body part touches one object.
struct ContactSpan {
  double start = 0.0, end = 0.0;  ///< [s]
  std::string part, object;
};

/// A planted sole that is higher over its ground is seen to hang in the air [m].
inline constexpr double kHoverLimit = 0.015;

/// A sole that slides farther within one plant is seen to slide [m]: found by trial, of 69 captured
/// clips two drift so far, at most 44 mm.
inline constexpr double kSlideLimit = 0.04;
/// A walk with more pops (pops in motion_measures.h) has a joint that jumps or flips over: found by
/// trial, of 69 captured clips five have more, and all flip.
inline constexpr double kPopsLimit = 10.0;

struct StandingFeet {
  int plants = 0;
  double skate_mean = 0.0, skate_max = 0.0;  ///< of the plants' slides [m]
  /// Highest that a sole hangs over its ground in a plant: the median of its lowest point's height,
  /// since a step in place that is taken for one plant is none; at most kMostHover [m, >= 0].
  double hover_max = 0.0;
  /// Of the planted time, that of plants that hang over kHoverLimit [0 to 1].
  double hover_share = 0.0;
};

/// The highest steps from one plant to the next, of whichever foot, as footsteps are judged
/// (stepHeight): a slope is no step [m, >= 0].
struct StepHeights {
  double up = 0.0, down = 0.0;
};
/// Steps may be so much higher than a limit: soles may sink in as deep [m].
inline constexpr double kStepSlack = 0.005;

}  // namespace amble

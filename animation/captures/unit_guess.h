/// The unit of a capture, weighed by how long its legs come out, by how its cadence goes with such
/// legs, and by which units are usual.
#pragma once

#include "animation/captures/reading.h"
#include "animation/captures/step_rhythm.h"

namespace amble {

inline constexpr double kCmuFrameTime = 1.0 / 120.0;  ///< [s]

/// The likeliest of metre, centimetre, inch, millimetre, CMU's 0.056444 m, decimetre and foot;
/// unsure where another is not far less likely, which the text then names, and where nobody has
/// such legs [m].
/// @param leg  thigh and shank [file units, >= 0]
/// @param frame_time  of the file: CMU's unit goes with CMU's rate [s, > 0]
Reading<double> guessUnit(double leg, const StepRhythm& rhythm, double frame_time = kCmuFrameTime);

/// A unit that a file says; unsure where nobody has such legs: the text then says which unit would
/// make a person of it. @param leg  thigh and shank, by that unit [m, >= 0]
Reading<double> checkSaidUnit(double metres_per_unit, double leg);

}  // namespace amble

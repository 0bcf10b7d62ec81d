/// What a step costs the walker, for those who choose between ways.
#pragma once

#include "animation/gait_parameters.h"

namespace amble {

/// Metabolic energy of a step over that of standing, by body mass [J/kg, >= 0]: level walking costs
/// 2.5 J/kg/m (Minetti et al. 2002, at slope 0), climbing its work at an efficiency of 0.25 and
/// going down at -1.2 (Margaria 1968), lifting a foot higher than the captured walk does the work
/// on a leg, 0.161 of the body (Winter), at the first of these. @param captured_lift  [m, >= 0]
double effortOf(const GaitParameters& step, double captured_lift);

}  // namespace amble

/// How hips give way where legs are too short: the one place that decides it.
#pragma once

#include <vector>

#include "animation/steps/leg_reach.h"

namespace amble {

/// By how much hips give way where so much is missing: all of it, and more (HipDip::kMore) [m].
double givenWay(double missing);

/// How far the root is lowered at each frame [m, >= 0], by how much is missing there: at the first
/// and last frame, which are stances, exactly that, so that a stance is the same in every walk; in
/// between the least smooth curve over givenWay() that the stances leave time for (HipDip).
/// @param missing  [m, >= 0] @param frame_time  [s, > 0]
std::vector<double> hipDip(const std::vector<double>& missing, double frame_time);

}  // namespace amble

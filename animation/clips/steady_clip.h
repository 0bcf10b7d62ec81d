/// Noisy captures made steady enough to be measured.
#pragma once

#include "animation/body/clip.h"

namespace amble {

/// The clip with each joint's turns smoothed by a Gaussian of `width` as its deviation; places
/// stay. A swing at 1 Hz keeps 95 % of its size at 0.05 s. The weights of a window that goes beyond
/// an end of the clip are those of what is there. @param width  [s, > 0]
Clip steadied(const Clip& clip, double width = 0.05);

}  // namespace amble

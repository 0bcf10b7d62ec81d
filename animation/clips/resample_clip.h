/// Clips at another frame rate.
#pragma once

#include "animation/body/clip.h"

namespace amble {

/// The clip at another frame time [s, > 0], as a player shows it in between: places linearly, turns
/// by slerp. The first frame stays; what is left of a last frame time is cut off, less than a
/// hundredth of one is rounding. The same frame time gives the same clip.
Clip resampleClip(const Clip& clip, double frame_time);

}  // namespace amble

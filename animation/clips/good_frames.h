/// Which frames of a capture are motion: clips begin with a reference pose, with frozen frames or
/// with a slide out of such a pose (QUALITY.md, "Clips start badly").
#pragma once

#include "animation/body/clip.h"

namespace amble {

/// First and last frame of the clip that are motion; all of it where nothing is wrong. What comes
/// before a leap within the first moments is left out, and the frozen or sliding frames after it;
/// where the root jumps (capture_checks.h) the longest stretch without a jump is kept.
/// @pre the clip has a frame and is in metres
struct GoodFrames {
  int first = 0;
  int last = 0;
};
GoodFrames goodFrames(const Clip& clip);

/// Frames [first, last] of a clip. @pre 0 <= first <= last < frames
Clip trimmed(const Clip& clip, int first, int last);

}  // namespace amble

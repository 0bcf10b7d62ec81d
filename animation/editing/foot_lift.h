/// How high the feet swing (Shanbhag's thesis, §6.2.3, eq. 6.5 and 6.7).
///
/// The thesis scales the height of the foot joint over the ground at each frame, with it that of a
/// foot that stands. Here the whole foot is raised over what its sole is clear of the line between
/// its prints, so that feet which stand, and how they roll, stay.
#pragma once

#include <functional>

#include "animation/editing/captured_walk.h"
#include "animation/editing/walk_tracks.h"

namespace amble {

/// Each swing's lift, as StepMeasure has it, becomes what it was times `factor` in the middle of
/// the swing [> 0]; 1 changes nothing. Where it is less, heel and ball stay over the line between
/// the prints where they were; toes whose tips hang turn up as far as it takes for these to stay,
/// too.
void scaleLift(const CapturedWalk& walk, const std::function<double(int frame)>& factor,
               WalkTracks& tracks);

}  // namespace amble

/// Which captured motions a walk is made of, at each of its moments.
#pragma once

#include <vector>

#include "animation/library/motion_library.h"
#include "animation/synthesis/walk_synthesizer.h"
#include "viz/page/page.h"

namespace amble {

/// Those of which there is something in some frame: the library's standing posture, its walks as
/// they are blended, its starts and stops, and what is held for the whole walk. Of walks that are
/// averaged into one, a capture and its mirror image are one.
/// @pre the walk is the synthesizer's, which is the library's
std::vector<PageSource> motionSources(const AnimationBuffer& walk, const MotionLibrary& library,
                                      const WalkSynthesizer& synthesizer);

}  // namespace amble

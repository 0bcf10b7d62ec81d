/// The body of somebody who walks with a motion library.
#pragma once

#include "animation/library/motion_library.h"
#include "animation/synthesis/walk_synthesizer.h"
#include "environments/body/body.h"

namespace amble {

/// Shaped in the pose that the library's people stand in, as tall as the walker, who may stoop.
Body walkerBody(const WalkSynthesizer& walker, const MotionLibrary& library);

}  // namespace amble

/// A straight walk of the body, to measure it by.
#pragma once

#include "animation/synthesis/walk_synthesizer.h"
#include "environments/ground/scene_ground.h"

namespace amble {

struct StraightWalk {
  RootPath path;
  AnimationBuffer buffer;
};

/// From standing to standing over `length` [m], somewhere on level ground with nothing to step over
/// (contacts are not asked about); without frames where there is no ground for one.
StraightWalk straightWalk(const WalkSynthesizer& synthesizer, const SceneGround& ground,
                          double length);

}  // namespace amble

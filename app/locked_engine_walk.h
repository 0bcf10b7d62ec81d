/// A walk of a speed engine whose feet stay where they stand.
#pragma once

#include "animation/editing/foot_lock.h"
#include "animation/synthesis/engine_walk.h"
#include "base/ramp.h"

namespace amble {

struct EngineRamp {
  Ramp speed;                      ///< from the walk's begin to its end [m/s]
  double duration = 5.0;           ///< [s, > 0]
  double frame_time = 1.0 / 60.0;  ///< [s, > 0]
  double scale = 1.0;              ///< of the walker to the captured person [> 0]
};

EngineWalk lockedEngineWalk(const SpeedEngine& engine, const EngineRamp& ramp,
                            FootLock* lock = nullptr);

}  // namespace amble

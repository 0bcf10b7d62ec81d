/// A walk of a speed engine whose feet stay where they stand, on a floor that no sole goes into.
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

/// engineWalk, its soles on the floor (sole_contact.h) and its feet held (foot_lock.h) while
/// `planted` says that they stand. @param lock  if not null, what it took
EngineWalk lockedEngineWalk(const SpeedEngine& engine, const EngineRamp& ramp,
                            FootLock* lock = nullptr);

}  // namespace amble

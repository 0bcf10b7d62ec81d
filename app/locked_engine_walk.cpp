#include "app/locked_engine_walk.h"

#include <algorithm>

namespace amble {

EngineWalk lockedEngineWalk(const SpeedEngine& engine, const EngineRamp& ramp, FootLock* lock) {
  EngineWalkRequest request;
  request.speed = [&](double time) {
    return ramp.speed.at(std::clamp(time / ramp.duration, 0.0, 1.0));
  };
  request.duration = ramp.duration;
  request.frame_time = ramp.frame_time;
  request.scale = ramp.scale;
  EngineWalk walk = engineWalk(engine, request);
  walk.clip = lockFeet(walk.clip, engine.data().roles, plantsOf(walk.planted), lock);
  return walk;
}

}  // namespace amble

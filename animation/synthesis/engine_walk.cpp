#include "animation/synthesis/engine_walk.h"

#include <cassert>
#include <cmath>

namespace amble {

EngineWalk engineWalk(const SpeedEngine& engine, const EngineWalkRequest& request) {
  assert(request.duration > 0.0 && request.frame_time > 0.0 && request.scale > 0.0);
  // eq. 3: a walker so much larger does at `scale` times the speed what the captured person does.
  const auto speedAt = [&](double time) {
    return engine.clamped(request.speed(time) / request.scale);
  };
  const int last =
      std::max(1, static_cast<int>(std::lround(request.duration / request.frame_time)));
  EngineWalk walk;
  walk.clip = {"walk",
               engine.data().skeleton.scaled(request.scale),
               request.frame_time,
               PoseArray(engine.joints()),
               {}};
  Pose pose;
  pose.rotations.resize(engine.joints());
  double phase = request.phase;
  for (int i = 0; i <= last; ++i) {
    const double time = i * request.frame_time, speed = speedAt(time);
    engine.poseAt(speed, phase, pose);
    pose.p_WR *= request.scale;
    pose.p_WR.x() += walk.length;
    walk.clip.poses.append(pose);
    walk.speeds.push_back(speed * request.scale);
    walk.phases.push_back(phase);
    for (const Side side : {kLeft, kRight}) {
      walk.planted[side].push_back(engine.planted(speed, phase, side));
    }
    if (i == last) break;
    const double between = speedAt(time + 0.5 * request.frame_time);
    phase += request.frame_time * engine.frequency(between);  // eq. 5
    walk.length += request.frame_time * between * request.scale;
  }
  return walk;
}

}  // namespace amble

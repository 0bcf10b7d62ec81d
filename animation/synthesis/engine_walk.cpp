#include "animation/synthesis/engine_walk.h"

#include <cassert>
#include <cmath>

namespace amble {
namespace {

// Who slows down while he swings a foot, as he comes to a stand, puts it down sooner: else it comes
// to rest with the phase, over a floor that it hardly clears. The swing takes as long as it would
// have at the speed at which it began, times the share of that speed that is left. Walks as fast as
// those captured keep the captured timing.
void putDownInTime(const SpeedEngine& engine, double scale, EngineWalk& walk) {
  for (std::vector<bool>& planted : walk.planted) {
    bool stood = false;              // a lift-off was seen
    double swung = 0.0;              // since then [s]
    double began = 0.0, time = 0.0;  // the speed then [m/s], and how long it swings at that [s]
    for (size_t i = 0; i < planted.size(); ++i) {
      if (planted[i]) {
        stood = true;
        swung = 0.0;
        began = walk.speeds[i];
        const std::array<double, 2> both = engine.support(began / scale);
        time = (0.5 - 0.5 * (both[kLeft] + both[kRight])) / engine.frequency(began / scale);
        continue;
      }
      swung += walk.clip.frame_time;
      const bool slows = stood && walk.speeds[i] < began;
      if (slows && engine.walkShare(walk.speeds[i] / scale) < 1.0 &&
          swung > time * walk.speeds[i] / began) {
        planted[i] = true;
      }
    }
  }
}

}  // namespace

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
  putDownInTime(engine, request.scale, walk);
  return walk;
}

}  // namespace amble

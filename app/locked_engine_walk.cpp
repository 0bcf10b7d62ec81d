#include "app/locked_engine_walk.h"

#include <algorithm>
#include <cmath>

#include "animation/editing/sole_contact.h"

namespace amble {
namespace {

// Standing, as kFootLockWidth is in walks that were captured; between, by SpeedEngine::walkShare. A
// walk that is slower than captured shrinks, and its feet stand for longer than the shrunken legs
// have them: half a step is to be corrected, which would jerk within a third of a swing [s].
constexpr double kSlowWidth = 0.15;
// Of those long plants, at both ends, while the foot comes down and leaves [s].
constexpr double kLongestLoose = 0.08;

std::vector<double> widthsOf(const SpeedEngine& engine, const EngineWalk& walk, double scale) {
  std::vector<double> widths;
  for (const double speed : walk.speeds) {
    const double share = engine.walkShare(speed / scale);
    widths.push_back(share * kFootLockWidth + (1.0 - share) * kSlowWidth);
  }
  return widths;
}

/// For how many frames a foot that stands in the first or last one has stood before, or stands on
/// after it (`step` -1, 1), at the speed that is walked there; as many as the walk has where it
/// does not leave, or was put down sooner than the phase has it.
int standsBeyond(const SpeedEngine& engine, const EngineWalk& walk, double scale, Side side,
                 int step) {
  const int frames = walk.clip.frames();
  const size_t end = step < 0 ? 0 : walk.speeds.size() - 1;
  const double speed = walk.speeds[end] / scale;
  const double on = step * walk.clip.frame_time * engine.frequency(speed);
  const auto stands = [&](int i) { return engine.planted(speed, walk.phases[end] + i * on, side); };
  if (!stands(0)) return frames;
  int beyond = 0;
  while (beyond < frames && stands(beyond + 1)) ++beyond;
  return beyond;
}

/// Those that the walk's ends cut began before it, or go on after it, by the captured timing.
FootPlants plantsOfWalk(const SpeedEngine& engine, const EngineWalk& walk, double scale) {
  FootPlants plants = plantsOf(walk.planted);
  const int last = plants.frames - 1;
  for (const Side side : {kLeft, kRight}) {
    for (FootPlant& plant : plants.plants[side]) {
      if (plant.first == 0) plant.strike -= standsBeyond(engine, walk, scale, side, -1);
      if (plant.last == last) plant.lift_off += standsBeyond(engine, walk, scale, side, 1);
    }
  }
  return plants;
}

/// Where the feet of a clip are on the floor and held.
Clip held(const EngineData& data, double scale, const Clip& clip, const FootPlants& plants,
          const LockOptions& options, FootLock& took) {
  WalkTracks tracks = tracksOf(clip, data.roles);
  const auto feet = makeFootShapes(clip.skeleton, data.roles, data.stature * scale);
  took.farthest = restOnFloor(clip, data.roles, feet, plants, tracks);
  took.farthest = std::max(took.farthest, lockTracks(plants, clip.frame_time, options, tracks));
  return followTracks(clip, data.roles, tracks, &took.fit);
}

}  // namespace

EngineWalk lockedEngineWalk(const SpeedEngine& engine, const EngineRamp& ramp, FootLock* lock) {
  EngineWalkRequest request;
  // Of whole frames, that the last has the speed to which the ramp leads: who stops stands in it.
  request.frame_time = ramp.frame_time;
  request.duration = std::max(1.0, std::round(ramp.duration / ramp.frame_time)) * ramp.frame_time;
  request.speed = [&](double time) {
    return ramp.speed.at(std::clamp(time / request.duration, 0.0, 1.0));
  };
  request.scale = ramp.scale;
  request.phase = phaseToStand(engine, request);
  EngineWalk walk = engineWalk(engine, request);
  const LockOptions options{widthsOf(engine, walk, ramp.scale), kLongestLoose,
                            isStanding(walk.speeds.front()), isStanding(walk.speeds.back())};
  FootLock took;
  walk.clip = held(engine.data(), ramp.scale, walk.clip, plantsOfWalk(engine, walk, ramp.scale),
                   options, took);
  if (lock != nullptr) *lock = took;
  return walk;
}

}  // namespace amble

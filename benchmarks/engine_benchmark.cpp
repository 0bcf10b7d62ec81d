// The speed engine of Glardon et al.: a cycle for a new speed, and a pose at any speed and phase.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>

#include "animation/library/motion_library_reader.h"
#include "animation/preparation/gait_space_fit.h"

namespace {

using namespace amble;

// A walk of a library as the cycles that engines are fitted to.
EngineCycle cycleOf(const WalkCycle& walk, int clip) {
  EngineCycle cycle;
  cycle.clip = clip;
  cycle.speed = walk.speed;
  cycle.period = walk.period;
  cycle.channels.resize(walk.series.channels(), kEnginePhases);
  for (int i = 0; i < kEnginePhases; ++i) {
    cycle.channels.col(i) = fourierAt(walk.series, static_cast<double>(i) / kEnginePhases);
  }
  return cycle;
}

// Of the straight walks of the library `default`, of whomever they are.
SpeedEngine engineOfLibrary() {
  const MotionLibrary library = openMotionLibrary("default");
  EngineData data;
  data.skeleton = library.skeleton;
  data.roles = library.roles;
  data.stature = library.stature;
  data.stand = library.stand();
  data.mean_posture = library.stand().rotations;
  std::vector<EngineCycle> cycles;
  std::vector<EngineClip> clips;
  for (const Motion& motion : library.motions) {
    if (motion.kind != MotionKind::kWalk || motion.turning) continue;
    cycles.push_back(cycleOf(motion.cycle, static_cast<int>(clips.size())));
    clips.push_back({motion.source,
                     motion.cycle.speed,
                     1.0 / motion.cycle.period,
                     1,
                     motion.cycle.capture,
                     {}});
  }
  std::sort(clips.begin(), clips.end(),
            [](const EngineClip& a, const EngineClip& b) { return a.speed < b.speed; });
  data.walk = fitGaitSpace(cycles, library.roles.meanLeg(library.skeleton), 0.8);
  data.walk->clips = std::move(clips);
  return SpeedEngine(std::move(data));
}

// Glardon's update (§5): the whole cycle of another speed.
void engineCycle(benchmark::State& state) {
  const SpeedEngine engine = engineOfLibrary();
  Eigen::MatrixXd cycle;
  double speed = 0.0;
  for (auto _ : state) {
    engine.cycleAt(speed, cycle);
    benchmark::DoNotOptimize(cycle.data());
    speed = std::fmod(speed + 0.01, engine.fastest());
  }
}
BENCHMARK(engineCycle);

// What is made a frame where the speed changes from frame to frame.
void enginePose(benchmark::State& state) {
  const SpeedEngine engine = engineOfLibrary();
  Pose pose;
  pose.rotations.resize(engine.joints());
  double speed = 0.0, phase = 0.0;
  for (auto _ : state) {
    engine.poseAt(speed, phase, pose);
    benchmark::DoNotOptimize(pose.rotations.data());
    speed = std::fmod(speed + 0.001, engine.fastest());
    phase += engine.frequency(speed) / 60.0;
  }
}
BENCHMARK(enginePose);

}  // namespace

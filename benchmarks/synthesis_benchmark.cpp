// Synthesis of walks and forward kinematics, in poses/s.

#include <benchmark/benchmark.h>

#include <cmath>

#include "animation/ground/ground.h"
#include "animation/library/motion_library_reader.h"
#include "animation/synthesis/walk_synthesizer.h"
#include "base/rotation.h"

namespace {

using namespace amble;

// Ten metres of a quarter of a circle to the left, as one edge.
RootPath quarter() {
  const double radius = 20.0 / kPi;
  const double handle = 4.0 / 3.0 * std::tan(kPi / 8.0) / std::sqrt(2.0);  // in chords
  const Eigen::Vector2d begin(0.0, 0.0), end(radius, radius);
  return RootPath(std::vector<Bezier>{makeBezier(begin, 0.0, end, kPi / 2.0, handle)});
}

// A walk that exists: its path, and where it ends.
struct Edge {
  RootPath path = quarter();
  Stance from, to;

  Edge() {
    const auto end = path.at(path.length());
    to.position.head<2>() = end.position;
    to.heading = end.heading;
  }
};

void synthesizeWalk(benchmark::State& state) {
  const MotionLibrary library = openMotionLibrary("default");
  const FlatGround ground;
  const WalkSynthesizer synthesizer(library, ground, {});
  const Edge edge;
  AnimationBuffer walk;
  int64_t poses = 0;
  for (auto _ : state) {
    const WalkResult result = synthesizer.walk(edge.from, edge.to, edge.path, true, walk);
    if (result.refused != WalkRule::kNone) {
      state.SkipWithError("the walk was refused");
      break;
    }
    poses += walk.size();
  }
  state.SetItemsProcessed(poses);
}
BENCHMARK(synthesizeWalk)->Unit(benchmark::kMillisecond);

void placeJoints(benchmark::State& state) {
  const MotionLibrary library = openMotionLibrary("default");
  const FlatGround ground;
  const WalkSynthesizer synthesizer(library, ground, {});
  AnimationBuffer standing;
  synthesizer.stand({}, standing);
  std::vector<JointFrame> frames(synthesizer.skeleton().size());
  for (auto _ : state) {
    forwardKinematics(synthesizer.skeleton(), standing.poses[0], frames);
    benchmark::DoNotOptimize(frames.data());
  }
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(placeJoints);

}  // namespace

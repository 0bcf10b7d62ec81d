// Foot plants, in frames a second on one core: the detector on paths that are there, what reading
// those paths off a clip adds (forward kinematics), and beside them the detector that anybody
// would write first: one height, one speed, as in the thesis (§3.1.1) but without its second
// stage. Given a long walk drawn from formulas, at 120 Hz on CMU's number of joints.

#include <benchmark/benchmark.h>

#include <cmath>

#include "animation/analysis/classify_clip.h"
#include "animation/analysis/foot_plants.h"
#include "animation/analysis/gait_events.h"
#include "base/ease.h"
#include "base/rotation.h"

namespace {

using amble::Clip;
using amble::FootPaths;
using amble::Side;

constexpr int kFrames = 120 * 300;  // five minutes
constexpr double kFrameTime = 1.0 / 120.0;
constexpr double kSpeed = 1.3;    // [m/s]
constexpr double kPeriod = 1.1;   // of two steps [s]
constexpr double kStance = 0.62;  // share of the period
constexpr double kLeg = 0.83;     // [m]
constexpr int kJoints = 31;

// Ankle and toe: stand, then swing on a smooth curve.
FootPaths walk() {
  FootPaths paths;
  for (const Side side : {amble::kLeft, amble::kRight}) {
    Eigen::MatrixXd& path = paths[side];
    path.resize(kFrames, 6);
    for (int i = 0; i < kFrames; ++i) {
      const double phase = i * kFrameTime / kPeriod + (side == amble::kRight ? 0.5 : 0.0);
      const double cycle = std::floor(phase);
      const double u = std::max(0.0, (phase - cycle - kStance) / (1.0 - kStance));
      const double x = kSpeed * kPeriod * (cycle + amble::smoothstep(u));
      const double z = 0.12 * std::sin(amble::kPi * u) * std::sin(amble::kPi * u);
      const double y = side == amble::kLeft ? 0.08 : -0.08;
      path.row(i) << x, y, 0.08 + z, x + 0.13, y, 0.03 + 0.8 * z;
    }
  }
  return paths;
}

const FootPaths& paths() {
  static const FootPaths kPaths = walk();
  return kPaths;
}

// A chain of joints that waves, with two legs in it: the kinematics cost what a capture's do.
const Clip& clip() {
  static const Clip kClip = [] {
    std::vector<amble::Joint> joints(kJoints);
    for (int i = 0; i < kJoints; ++i) {
      joints[i].parent = i - 1;
      joints[i].offset = {0.0, 0.0, i == 0 ? 0.0 : -0.1};
    }
    Clip made{"chain", amble::Skeleton(joints), kFrameTime, amble::PoseArray(kJoints), {}};
    made.poses.resize(kFrames);
    for (int i = 0; i < kFrames; ++i) {
      for (int j = 0; j < kJoints; ++j) {
        made.poses.rotations(i)[j] =
            amble::expRotation(0.2 * std::sin(0.05 * i + j) * Eigen::Vector3d(0.6, 0.48, 0.64));
      }
    }
    return made;
  }();
  return kClip;
}

amble::JointRoles roles() {
  amble::JointRoles roles;
  roles.legs[amble::kLeft] = {1, 2, 3, 4};
  roles.legs[amble::kRight] = {5, 6, 7, 8};
  return roles;
}

void countFrames(benchmark::State& state) {
  state.SetItemsProcessed(state.iterations() * static_cast<int64_t>(kFrames));
}

void detectPlants(benchmark::State& state) {
  for (auto _ : state) {
    benchmark::DoNotOptimize(amble::detectPlants(paths(), {kLeg, kLeg}, kFrameTime));
  }
  countFrames(state);
}
BENCHMARK(detectPlants)->Unit(benchmark::kMillisecond);

void kinematicsOfAClip(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(amble::footPaths(clip(), roles()));
  countFrames(state);
}
BENCHMARK(kinematicsOfAClip)->Unit(benchmark::kMillisecond);

// The peer: low and slow by one threshold each, nothing filtered, nothing closed.
void fixedThresholds(benchmark::State& state) {
  for (auto _ : state) {
    std::array<std::vector<bool>, 2> planted;
    for (const Side side : {amble::kLeft, amble::kRight}) {
      const Eigen::MatrixXd& path = paths()[side];
      planted[side].resize(kFrames);
      for (int i = 1; i < kFrames; ++i) {
        for (const int j : {0, 3}) {
          const double height = path(i, j + 2) - (j == 0 ? 0.08 : 0.03);
          const double speed =
              (path.block<1, 3>(i, j) - path.block<1, 3>(i - 1, j)).norm() / kFrameTime;
          if (height < 0.05 && speed < 0.4) planted[side][i] = true;
        }
      }
    }
    benchmark::DoNotOptimize(amble::plantsOf(planted));
  }
  countFrames(state);
}
BENCHMARK(fixedThresholds)->Unit(benchmark::kMillisecond);

void eventsAndClass(benchmark::State& state) {
  const amble::FootPlants plants = amble::detectPlants(paths(), {kLeg, kLeg}, kFrameTime);
  for (auto _ : state) {
    const auto curves = amble::footCurves(paths(), {kLeg, kLeg}, kFrameTime, plants);
    benchmark::DoNotOptimize(amble::findGaitEvents(curves, kFrameTime, plants, paths()));
    benchmark::DoNotOptimize(amble::classifyClip(plants, kFrameTime));
  }
  countFrames(state);
}
BENCHMARK(eventsAndClass)->Unit(benchmark::kMillisecond);

}  // namespace

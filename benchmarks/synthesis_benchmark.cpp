// Synthesis of walks and forward kinematics, in poses/s; beside poses as plain Eigen makes them.

#include <benchmark/benchmark.h>

#include <cmath>

#include "animation/body/two_link.h"
#include "animation/ground/ground.h"
#include "animation/library/fourier.h"
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

// What anybody would write with Eigen, a pose at a time: every channel of a straight and a turning
// cycle as a sum of cosines and sines, blended; rotation vectors to quaternions; transforms of all
// joints; both legs to where their ankles are to be, and transforms of all joints once more.
struct NaiveSynthesis {
  const MotionLibrary& library;
  std::vector<const WalkCycle*> cycles;
  std::vector<Eigen::Isometry3d> X_WJ;
  Pose pose;

  explicit NaiveSynthesis(const MotionLibrary& the_library)
      : library(the_library), X_WJ(library.skeleton.size()) {
    for (const Motion& motion : library.motions)
      if (motion.kind == MotionKind::kWalk) cycles.push_back(&motion.cycle);
    cycles.resize(2);
    pose.rotations.resize(library.skeleton.size());
  }

  static Eigen::VectorXd channelsOf(const FourierSeries& series, double phase) {
    Eigen::VectorXd channels = series.alpha.col(0);
    for (int k = 1; k <= series.harmonics(); ++k)
      channels += std::cos(2.0 * kPi * k * phase) * series.alpha.col(k) +
                  std::sin(2.0 * kPi * k * phase) * series.beta.col(k);
    return channels;
  }

  void placeAll() {
    for (int j = 0; j < library.skeleton.size(); ++j) {
      const Joint& joint = library.skeleton.joint(j);
      const Eigen::Vector3d at = j == 0 ? pose.p_WR : joint.offset;
      const Eigen::Isometry3d X_PJ = Eigen::Translation3d(at) * pose.rotations[j];
      X_WJ[j] = j == 0 ? X_PJ : X_WJ[joint.parent] * X_PJ;
    }
  }

  void bend(const LegJoints& leg, const Eigen::Vector3d& ankle) {
    const TwoLink links{X_WJ[leg.up_leg].translation(), X_WJ[leg.leg].translation(),
                        X_WJ[leg.foot].translation(), X_WJ[leg.up_leg].linear().col(0)};
    const auto solved = solveTwoLink(links, ankle);
    if (!solved) return;
    const auto local = [&](int joint, const Eigen::Quaterniond& turn) {
      const Eigen::Matrix3d parent = X_WJ[library.skeleton.joint(joint).parent].linear();
      pose.rotations[joint] = parent.transpose() * turn.toRotationMatrix() * X_WJ[joint].linear();
    };
    local(leg.up_leg, solved->thigh);
    local(leg.leg, solved->shank);
  }

  void make(double phase) {
    const Eigen::VectorXd channels =
        0.7 * channelsOf(cycles[0]->series, phase) + 0.3 * channelsOf(cycles[1]->series, phase);
    pose.p_WR = channels.head<3>();
    for (int j = 0; j < library.skeleton.size(); ++j) {
      const Eigen::Vector3d v = channels.segment<3>(3 + 3 * j);
      const double angle = v.norm();
      pose.rotations[j] = library.stand().rotations[j] *
                          Eigen::Quaterniond(Eigen::AngleAxisd(angle, v / std::max(angle, 1e-12)));
    }
    placeAll();
    for (const LegJoints& leg : library.roles.legs)
      bend(leg, X_WJ[leg.foot].translation() + Eigen::Vector3d(0.0, 0.0, 0.01));
    placeAll();
  }
};

void synthesizeWithPlainEigen(benchmark::State& state) {
  const MotionLibrary library = openMotionLibrary("default");
  NaiveSynthesis naive(library);
  double phase = 0.0;
  for (auto _ : state) {
    naive.make(phase);
    benchmark::DoNotOptimize(naive.X_WJ.data());
    phase = std::fmod(phase + 0.014, 1.0);
  }
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(synthesizeWithPlainEigen);

}  // namespace

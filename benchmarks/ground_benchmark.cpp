/// How fast the ground answers in a scene of a million triangles: height and normal under a point
/// and under a sole, what lies in a foot's way, a foothold; beside them what FCL needs for the same
/// height, a thin rod let down on a tree of the same triangles.
#include <benchmark/benchmark.h>
#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/narrowphase/distance.h>

#include <cmath>
#include <cstdlib>
#include <memory>
#include <random>

#include "animation/library/motion_library_reader.h"
#include "animation/steps/foothold.h"
#include "animation/synthesis/walk_synthesizer.h"
#include "environments/ground/ground_cells.h"
#include "environments/ground/scene_ground.h"

namespace amble {
namespace {

// Of a smoke test, for which a hundredth is enough.
const bool kQuick = std::getenv("AMBLE_QUICK") != nullptr;
const int kSide = kQuick ? 71 : 708;         // squares a side, of two triangles each: 1,002,528
const double kLength = kQuick ? 9.0 : 90.0;  // [m]

// Rolling ground, up to 13 degrees steep.
TriangleMesh hills() {
  TriangleMesh mesh;
  for (int j = 0; j <= kSide; ++j) {
    for (int i = 0; i <= kSide; ++i) {
      const double x = kLength * i / kSide, y = kLength * j / kSide;
      mesh.vertices.emplace_back(x, y, 0.4 * std::sin(0.4 * x) + 0.1 * std::sin(0.7 * y));
    }
  }
  for (int j = 0; j < kSide; ++j) {
    for (int i = 0; i < kSide; ++i) {
      const int a = j * (kSide + 1) + i, b = a + 1, c = a + kSide + 2, d = a + kSide + 1;
      mesh.triangles.push_back({a, b, c});
      mesh.triangles.push_back({a, c, d});
    }
  }
  return mesh;
}

const SceneGround& ground() {
  static const SceneGround made = [] {
    Scene scene;
    scene.objects.push_back({"hills", "", hills(), Eigen::Isometry3d::Identity(), Role::kAuto});
    return SceneGround(scene);
  }();
  return made;
}

// Places on the ground, the same in every run.
const std::vector<Eigen::Vector3d>& places() {
  static const std::vector<Eigen::Vector3d> made = [] {
    std::mt19937_64 generator(1);
    std::uniform_real_distribution<double> along(1.0, kLength - 1.0);
    std::vector<Eigen::Vector3d> all;
    for (int i = 0; i < 4096; ++i) {
      const double x = along(generator), y = along(generator);
      all.emplace_back(x, y, 0.4 * std::sin(0.4 * x) + 0.1 * std::sin(0.7 * y));
    }
    return all;
  }();
  return made;
}

void heightAndNormal(benchmark::State& state) {
  ground();
  size_t i = 0;
  for (auto _ : state) {
    const Eigen::Vector3d& p = places()[i++ % places().size()];
    benchmark::DoNotOptimize(ground().surface(p.x(), p.y(), p.z(), 0.3));
  }
}
BENCHMARK(heightAndNormal)->Unit(benchmark::kNanosecond);

// Heel, ball and tip.
void heightAndNormalUnderASole(benchmark::State& state) {
  ground();
  size_t i = 0;
  for (auto _ : state) {
    const Eigen::Vector3d& p = places()[i++ % places().size()];
    for (const double along : {-0.05, 0.12, 0.2})
      benchmark::DoNotOptimize(ground().surface(p.x() + along, p.y(), p.z(), 0.3));
  }
}
BENCHMARK(heightAndNormalUnderASole)->Unit(benchmark::kNanosecond);

void crestOfASwing(benchmark::State& state) {
  ground();
  size_t i = 0;
  for (auto _ : state) {
    const Eigen::Vector2d p = places()[i++ % places().size()].head<2>();
    benchmark::DoNotOptimize(ground().crest(p, p + Eigen::Vector2d(0.6, 0.1), 0.05, -1.0, 1.0));
  }
}
BENCHMARK(crestOfASwing)->Unit(benchmark::kNanosecond);

// A whole sole put down: where it stands and how it lies.
void footPlacement(benchmark::State& state) {
  ground();
  static const MotionLibrary library = openMotionLibrary("default");
  static const WalkSynthesizer walker(library, ground(), {});
  const FootholdFinder finder(ground(), walker.feet(), {});
  size_t i = 0;
  for (auto _ : state) {
    FootPlace place;
    place.position = places()[i % places().size()];
    place.heading = 0.1 * static_cast<double>(i++ % 63);
    benchmark::DoNotOptimize(finder.at(place, kLeft, 0.3));
  }
}
BENCHMARK(footPlacement)->Unit(benchmark::kNanosecond);

// The peer: distance of a rod over the place to FCL's tree.
void heightByFcl(benchmark::State& state) {
  using Tree = fcl::BVHModel<fcl::OBBRSSd>;
  static const std::shared_ptr<Tree> tree = [] {
    const TriangleMesh mesh = hills();
    auto made = std::make_shared<Tree>();
    std::vector<fcl::Triangle> triangles;
    for (const auto& t : mesh.triangles) triangles.emplace_back(t[0], t[1], t[2]);
    made->beginModel();
    made->addSubModel(mesh.vertices, triangles);
    made->endModel();
    return made;
  }();
  const fcl::Cylinderd rod(1e-4, 0.2);
  size_t i = 0;
  for (auto _ : state) {
    fcl::Transform3d X = fcl::Transform3d::Identity();
    X.translation() = places()[i++ % places().size()] + Eigen::Vector3d(0.0, 0.0, 0.3);
    fcl::DistanceRequestd request(false, false, 0.0, 0.0, 1e-6, fcl::GST_INDEP);
    fcl::DistanceResultd result;
    benchmark::DoNotOptimize(
        fcl::distance(tree.get(), fcl::Transform3d::Identity(), &rod, X, request, result));
  }
}
BENCHMARK(heightByFcl)->Unit(benchmark::kNanosecond);

}  // namespace
}  // namespace amble

/// How fast whole bodies are checked in the living room: poses a second of the collision world, at
/// frames and between them, by our own trees and by FCL behind them; beside the usual way: FCL's
/// own manager, DynamicAABBTreeCollisionManager, with a tree an object of the boxes that are named,
/// asked once a capsule and frame. And single capsules near things, exactly, without any cheaper
/// test before: yes or no, and distances.
#include <benchmark/benchmark.h>
#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/geometry/shape/capsule.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/collision_object.h>

#include <cmath>

#include "base/data_directory.h"
#include "base/rotation.h"
#include "environments/collision/obstacle_set.h"
#include "environments/scene/parity.h"
#include "scenarios/run_scenario.h"

namespace amble {
namespace {

// The living room's walk, planned once.
const RunResult& planned() {
  static const RunResult result =
      runScenario(readScenario(dataDirectory() / "scenarios" / "living-room.yaml"));
  return result;
}

const AnimationBuffer& walkOf(const RunResult& result) { return result.outcome.walk.buffer; }

void countPoses(benchmark::State& state, long long poses) {
  state.counters["poses/s"] =
      benchmark::Counter(static_cast<double>(poses), benchmark::Counter::kIsRate);
}

// The world of that walk, by the checker that the benchmark's argument numbers.
CollisionWorld worldOf(const RunResult& result, const benchmark::State& state) {
  const Problem& problem = *result.problem;
  return CollisionWorld(problem.scene, problem.ground, problem.synthesizer.skeleton(), problem.body,
                        {}, static_cast<Checker>(state.range(0)));
}

void byChecker(benchmark::internal::Benchmark* benchmark) {
  for (const Checker checker : {Checker::kFast, Checker::kFcl})
    benchmark->Arg(static_cast<int>(checker));
  benchmark->ArgName("fcl")->Unit(benchmark::kMillisecond);
}

void wholeBodyCheck(benchmark::State& state) {
  const RunResult& result = planned();
  const AnimationBuffer& walk = walkOf(result);
  const CollisionWorld world = worldOf(result, state);
  const auto scratch = world.makeScratch();
  for (auto _ : state) {
    if (world.check(walk.poses, walk.soles, false, *scratch)) state.SkipWithError("a contact");
  }
  countPoses(state, state.iterations() * walk.size());
}
BENCHMARK(wholeBodyCheck)->Apply(byChecker);

void wholeBodyClearance(benchmark::State& state) {
  const RunResult& result = planned();
  const AnimationBuffer& walk = walkOf(result);
  const CollisionWorld world = worldOf(result, state);
  const auto scratch = world.makeScratch();
  for (auto _ : state) {
    benchmark::DoNotOptimize(world.clearance(walk.poses, 2.0, *scratch));
  }
  countPoses(state, state.iterations() * walk.size());
}
BENCHMARK(wholeBodyClearance)->Apply(byChecker);

// The body's capsules along the walk, as if it led through the furniture: each a little beside
// where it is, so that some touch and most are near to something.
std::vector<Capsule> capsulesNearThings(const RunResult& result) {
  const Problem& problem = *result.problem;
  const AnimationBuffer& walk = walkOf(result);
  std::vector<JointFrame> joints(problem.synthesizer.skeleton().size());
  std::vector<Eigen::Vector3d> from(problem.body.parts.size()), to(from.size());
  std::vector<Capsule> capsules;
  for (int i = 0; i < walk.size(); i += 20) {
    forwardKinematics(problem.synthesizer.skeleton(), walk.poses[i], joints);
    placeBody(problem.body, joints, from, to);
    for (int direction = 0; direction < 8; ++direction) {
      const Eigen::Vector3d aside = 0.7 * Eigen::Vector3d(std::cos(kPi / 4.0 * direction),
                                                          std::sin(kPi / 4.0 * direction), 0.0);
      for (size_t part = 0; part < from.size(); ++part)
        capsules.push_back({from[part] + aside, to[part] + aside, problem.body.parts[part].radius});
    }
  }
  return capsules;
}

ObstacleSet obstaclesOf(const RunResult& result, const benchmark::State& state) {
  const Problem& problem = *result.problem;
  std::vector<Obstacle> obstacles;
  for (size_t i = 0; i < problem.scene.objects.size(); ++i) {
    const SceneObject& object = problem.scene.objects[i];
    if (object.role == Role::kIgnore || problem.ground.isGround(static_cast<int>(i))) continue;
    const bool is_mesh = std::holds_alternative<TriangleMesh>(object.shape);
    obstacles.push_back({static_cast<int>(i), object.shape, object.X_WO,
                         is_mesh ? closedPart(worldMesh(object)) : TriangleMesh{}});
  }
  return ObstacleSet(obstacles, {}, static_cast<Checker>(state.range(0)));
}

void makeObstacles(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(obstaclesOf(planned(), state));
}
BENCHMARK(makeObstacles)->Apply(byChecker);

void touchACapsule(benchmark::State& state) {
  const std::vector<Capsule> capsules = capsulesNearThings(planned());
  const ObstacleSet obstacles = obstaclesOf(planned(), state);
  const auto scratch = ObstacleSet::makeScratch();
  for (auto _ : state)
    for (const Capsule& capsule : capsules)
      benchmark::DoNotOptimize(obstacles.touched(capsule, *scratch));
  state.SetItemsProcessed(state.iterations() * static_cast<int64_t>(capsules.size()));
}
BENCHMARK(touchACapsule)->Apply(byChecker);

void distanceOfACapsule(benchmark::State& state) {
  const std::vector<Capsule> capsules = capsulesNearThings(planned());
  const ObstacleSet obstacles = obstaclesOf(planned(), state);
  const auto scratch = ObstacleSet::makeScratch();
  for (auto _ : state)
    for (const Capsule& capsule : capsules)
      benchmark::DoNotOptimize(obstacles.nearest(capsule, 1.0, *scratch));
  state.SetItemsProcessed(state.iterations() * static_cast<int64_t>(capsules.size()));
}
BENCHMARK(distanceOfACapsule)->Apply(byChecker);

// Every object of the scene as FCL's users have them: a tree of boxes over its triangles, in FCL's
// own broad phase.
template <typename Bv>
class UsualWorld {
 public:
  explicit UsualWorld(const Scene& scene) {
    for (const SceneObject& object : scene.objects) {
      if (object.role == Role::kIgnore) continue;
      const TriangleMesh mesh = worldMesh(object);
      const auto model = std::make_shared<fcl::BVHModel<Bv>>();
      std::vector<fcl::Triangle> triangles;
      for (const auto& t : mesh.triangles) triangles.emplace_back(t[0], t[1], t[2]);
      model->beginModel();
      model->addSubModel(mesh.vertices, triangles);
      model->endModel();
      objects_.push_back(std::make_unique<fcl::CollisionObjectd>(model));
      objects_.back()->computeAABB();
      manager_.registerObject(objects_.back().get());
    }
    manager_.setup();
  }

  // Whether the capsule touches anything.
  bool touches(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius) {
    const Eigen::Vector3d axis = to - from;
    fcl::CollisionObjectd capsule(std::make_shared<fcl::Capsuled>(radius, axis.norm()));
    capsule.setTransform(
        Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), axis).toRotationMatrix(),
        0.5 * (from + to));
    capsule.computeAABB();
    bool touched = false;
    manager_.collide(&capsule, &touched, [](auto* a, auto* b, void* found) {
      fcl::CollisionRequestd request;
      request.gjk_solver_type = fcl::GST_LIBCCD;
      fcl::CollisionResultd result;
      return *static_cast<bool*>(found) = fcl::collide(a, b, request, result) > 0;
    });
    return touched;
  }

 private:
  std::vector<std::unique_ptr<fcl::CollisionObjectd>> objects_;
  fcl::DynamicAABBTreeCollisionManagerd manager_;
};

// Frames only: the usual way says nothing of what lies between them.
template <typename Bv>
void fclManager(benchmark::State& state) {
  const RunResult& result = planned();
  const Problem& problem = *result.problem;
  const AnimationBuffer& walk = walkOf(result);
  UsualWorld<Bv> world(problem.scene);
  std::vector<JointFrame> joints(problem.synthesizer.skeleton().size());
  std::vector<Eigen::Vector3d> from(problem.body.parts.size()), to(from.size());
  constexpr int kEvery = 10;  // enough frames of the walk for a mean
  long long poses = 0;
  for (auto _ : state) {
    for (int i = 0; i < walk.size(); i += kEvery, ++poses) {
      forwardKinematics(problem.synthesizer.skeleton(), walk.poses[i], joints);
      placeBody(problem.body, joints, from, to);
      for (size_t part = 0; part < from.size(); ++part) {
        benchmark::DoNotOptimize(
            world.touches(from[part], to[part], problem.body.parts[part].radius));
      }
    }
  }
  countPoses(state, poses);
}
BENCHMARK(fclManager<fcl::OBBRSSd>)->Unit(benchmark::kMillisecond);
BENCHMARK(fclManager<fcl::OBBd>)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace amble

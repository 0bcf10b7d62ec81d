/// How fast whole bodies are checked in the living room: poses a second of the collision world, at
/// frames and between them, beside the usual way: FCL's own manager,
/// DynamicAABBTreeCollisionManager, with a tree of boxes an object, asked once a capsule and frame.
#include <benchmark/benchmark.h>
#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/geometry/shape/capsule.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/collision_object.h>

#include "base/data_directory.h"
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

void wholeBodyCheck(benchmark::State& state) {
  const RunResult& result = planned();
  const AnimationBuffer& walk = walkOf(result);
  const CollisionWorld& world = result.problem->world;
  const auto scratch = world.makeScratch();
  for (auto _ : state) {
    if (world.check(walk.poses, walk.soles, false, *scratch)) state.SkipWithError("a contact");
  }
  countPoses(state, state.iterations() * walk.size());
}
BENCHMARK(wholeBodyCheck)->Unit(benchmark::kMillisecond);

void wholeBodyClearance(benchmark::State& state) {
  const RunResult& result = planned();
  const AnimationBuffer& walk = walkOf(result);
  const CollisionWorld& world = result.problem->world;
  const auto scratch = world.makeScratch();
  for (auto _ : state) {
    benchmark::DoNotOptimize(world.clearance(walk.poses, 2.0, *scratch));
  }
  countPoses(state, state.iterations() * walk.size());
}
BENCHMARK(wholeBodyClearance)->Unit(benchmark::kMillisecond);

// Every object of the scene as FCL's users have them: a tree of boxes over its triangles, in FCL's
// own broad phase.
class UsualWorld {
 public:
  explicit UsualWorld(const Scene& scene) {
    for (const SceneObject& object : scene.objects) {
      if (object.role == Role::kIgnore) continue;
      const TriangleMesh mesh = worldMesh(object);
      const auto model = std::make_shared<fcl::BVHModel<fcl::OBBRSSd>>();
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
void fclManagerACapsule(benchmark::State& state) {
  const RunResult& result = planned();
  const Problem& problem = *result.problem;
  const AnimationBuffer& walk = walkOf(result);
  UsualWorld world(problem.scene);
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
BENCHMARK(fclManagerACapsule)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace amble

/// How fast whole bodies are checked in the living room: poses a second of the collision world, at
/// frames and between them, by our own trees and by FCL behind them; beside the usual way: FCL's
/// own manager, DynamicAABBTreeCollisionManager, with a tree an object of the boxes that are named
/// (d: doubles, f: floats), or one tree of all, asked once a capsule and frame. And single capsules
/// near things, exactly, without any cheaper test before: yes or no, and distances.
#include <benchmark/benchmark.h>
#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/geometry/shape/capsule.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/collision_object.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

#include "base/data_directory.h"
#include "base/rotation.h"
#include "environments/collision/obstacle_set.h"
#include "environments/scene/parity.h"
#include "environments/scene/triangle_grid.h"
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

// The same with the poses made anew, as planning has it: synthesis is on our side only.
void synthesisAndCheck(benchmark::State& state) {
  const RunResult& result = planned();
  const Walk& walk = result.outcome.walk;
  const CollisionWorld world = worldOf(result, state);
  const auto scratch = world.makeScratch();
  AnimationBuffer buffer;
  long long poses = 0;
  for (auto _ : state) {
    for (size_t i = 1; i < walk.stances.size(); ++i) {
      const Stance &from = walk.stances[i - 1], &to = walk.stances[i];
      const Eigen::Vector2d a = from.position.head<2>(), b = to.position.head<2>();
      if ((b - a).norm() < 0.5) continue;
      const RootPath path({makeBezier(a, from.heading, b, to.heading, 1.0 / 3.0)});
      if (result.problem->synthesizer.walk(from, to, path, true, buffer).refused != WalkRule::kNone)
        continue;
      benchmark::DoNotOptimize(world.check(buffer.poses, buffer.soles, false, *scratch));
      poses += buffer.size();
    }
  }
  countPoses(state, poses);
}
BENCHMARK(synthesisAndCheck)->Apply(byChecker);

// Distances by brute force, apart from the code that is measured: every triangle whose box is near
// enough, the point of the axis that is nearest by golden section, since its distance is convex.
class BruteForce {
 public:
  explicit BruteForce(const Scene& scene) {
    for (const SceneObject& object : scene.objects) {
      if (object.role == Role::kIgnore) continue;
      const TriangleMesh mesh = worldMesh(object);
      for (const auto& t : mesh.triangles) {
        triangles_.push_back({mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]});
        Eigen::AlignedBox3d box;
        for (const Eigen::Vector3d& corner : triangles_.back()) box.extend(corner);
        boxes_.push_back(box);
      }
    }
  }

  static constexpr double kFarthest = 1.0;  // larger clearances are not told apart [m]

  // Of a body: the least of its capsules' [m].
  double clearance(std::span<const Capsule> body) const {
    double least = kFarthest;
    for (const Capsule& capsule : body) {
      Eigen::AlignedBox3d axis(capsule.from);
      axis.extend(capsule.to);
      for (size_t i = 0; i < triangles_.size(); ++i) {
        const double reach = least + capsule.radius;
        if (boxes_[i].squaredExteriorDistance(axis) >= reach * reach) continue;
        least = std::min(least, distance(capsule, triangles_[i]) - capsule.radius);
      }
    }
    return least;
  }

 private:
  static double distance(const Capsule& capsule, const Triangle3& t) {
    constexpr double kGolden = 0.6180339887498949;
    const auto at = [&](double s) {
      return distance(Eigen::Vector3d(capsule.from + s * (capsule.to - capsule.from)), t);
    };
    double low = 0.0, high = 1.0, a = 1.0 - kGolden, b = kGolden, at_a = at(a), at_b = at(b);
    for (int i = 0; i < 75; ++i) {
      if (at_a < at_b) {
        high = b, b = a, at_b = at_a;
        at_a = at(a = high - kGolden * (high - low));
      } else {
        low = a, a = b, at_a = at_b;
        at_b = at(b = low + kGolden * (high - low));
      }
    }
    return std::min({at(0.0), at(1.0), at_a, at_b});
  }

  // Of a point: to the plane where it lies over the triangle, else to the nearest side.
  static double distance(const Eigen::Vector3d& p, const Triangle3& t) {
    const Eigen::Vector3d normal = (t[1] - t[0]).cross(t[2] - t[0]).normalized();
    bool over = true;
    double least = HUGE_VAL;
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d side = t[(k + 1) % 3] - t[k], to = p - t[k];
      over = over && side.cross(to).dot(normal) >= 0.0;
      const double share = std::clamp(side.dot(to) / side.squaredNorm(), 0.0, 1.0);
      least = std::min(least, (to - share * side).norm());
    }
    return over ? std::abs(normal.dot(p - t[0])) : least;
  }

  std::vector<Triangle3> triangles_;
  std::vector<Eigen::AlignedBox3d> boxes_;
};

// Bodies of the walk, each a little beside where it is: free ones near to things.
std::vector<std::vector<Capsule>> bodiesNearThings(const RunResult& result,
                                                   const CollisionWorld& world) {
  const std::vector<Capsule> capsules = capsulesNearThings(result);
  const size_t parts = result.problem->body.parts.size();
  const auto scratch = world.makeScratch();
  std::vector<std::vector<Capsule>> bodies;
  for (size_t i = 0; i + parts <= capsules.size(); i += parts) {
    const std::span<const Capsule> body(&capsules[i], parts);
    if (std::none_of(body.begin(), body.end(), [&](const Capsule& c) {
          return world.touched(c.from, c.to, c.radius, *scratch) >= 0;
        }))
      bodies.emplace_back(body.begin(), body.end());
  }
  return bodies;
}

// 100,000 bodies of all breadths and more, half of them within 1 mm to 1e-6 m of a contact: `wrong`
// counts the decisions that the brute-force distances contradict.
void decisions(benchmark::State& state) {
  constexpr int kBodies = 126000;  // a fifth is left out
  const RunResult& result = planned();
  Scene scene = result.problem->scene;
  // Without the ground and what is no mesh of triangles.
  for (size_t i = 0; i < scene.objects.size(); ++i) {
    const Shape& shape = scene.objects[i].shape;
    if (result.problem->ground.isGround(static_cast<int>(i)) ||
        !(std::holds_alternative<TriangleMesh>(shape) || std::holds_alternative<Box>(shape)))
      scene.objects[i].role = Role::kIgnore;
  }
  const Problem& problem = *result.problem;
  const CollisionWorld world(scene, problem.ground, problem.synthesizer.skeleton(), problem.body);
  const auto bodies = bodiesNearThings(result, world);
  const BruteForce exact(scene);
  const int each = kBodies / static_cast<int>(bodies.size()) + 1;
  const auto scratch = world.makeScratch();
  std::mt19937_64 generator(1);
  std::uniform_real_distribution<double> power(-6.0, -3.0), gaps(-0.1, 0.2), coin(0.0, 1.0);
  int wrong = 0, asked = 0, near = 0;
  for (auto _ : state) {
    for (const std::vector<Capsule>& body : bodies) {
      const double clearance = exact.clearance(body);
      if (clearance >= BruteForce::kFarthest) continue;
      for (int k = 0; k < each; ++k) {
        const bool is_near = k % 2 == 0;
        const double tiny = (coin(generator) < 0.5 ? -1.0 : 1.0) * std::pow(10.0, power(generator));
        const double gap = is_near ? tiny : gaps(generator);
        if (gap > clearance) continue;
        const bool touches = std::any_of(body.begin(), body.end(), [&](const Capsule& c) {
          return world.touched(c.from, c.to, c.radius + clearance - gap, *scratch) >= 0;
        });
        ++asked;
        near += is_near;
        wrong += touches != (gap < 0.0);
      }
    }
  }
  state.counters["wrong"] = wrong;
  state.counters["bodies"] = asked;
  state.counters["near"] = near;
}
BENCHMARK(decisions)->Iterations(1)->Unit(benchmark::kSecond);

// Every object of the scene as FCL's users have them: a tree of boxes over its triangles, in FCL's
// own broad phase; or all triangles in one tree.
template <typename Bv>
class UsualWorld {
 public:
  using S = typename Bv::S;
  using Point = fcl::Vector3<S>;

  UsualWorld(const Scene& scene, bool merged) {
    auto model = std::make_shared<fcl::BVHModel<Bv>>();
    for (const SceneObject& object : scene.objects) {
      if (object.role == Role::kIgnore) continue;
      if (!model) model = std::make_shared<fcl::BVHModel<Bv>>();
      if (model->build_state == fcl::BVH_BUILD_STATE_EMPTY) model->beginModel();
      const TriangleMesh mesh = worldMesh(object);
      std::vector<fcl::Triangle> triangles;
      for (const auto& t : mesh.triangles) triangles.emplace_back(t[0], t[1], t[2]);
      std::vector<Point> vertices;
      for (const Eigen::Vector3d& v : mesh.vertices) vertices.push_back(v.cast<S>());
      model->addSubModel(vertices, triangles);
      if (!merged) add(std::exchange(model, nullptr));
    }
    if (merged) add(model);
    manager_.setup();
  }

  // Whether the capsule touches anything.
  bool touches(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius) {
    const Point axis = (to - from).cast<S>();
    fcl::CollisionObject<S> capsule(
        std::make_shared<fcl::Capsule<S>>(static_cast<S>(radius), axis.norm()));
    capsule.setTransform(
        Eigen::Quaternion<S>::FromTwoVectors(Point::UnitZ(), axis).toRotationMatrix(),
        (0.5 * (from + to)).cast<S>());
    capsule.computeAABB();
    bool touched = false;
    manager_.collide(&capsule, &touched, [](auto* a, auto* b, void* found) {
      fcl::CollisionRequest<S> request;
      request.gjk_solver_type = fcl::GST_LIBCCD;
      fcl::CollisionResult<S> result;
      return *static_cast<bool*>(found) = fcl::collide(a, b, request, result) > 0;
    });
    return touched;
  }

 private:
  void add(std::shared_ptr<fcl::BVHModel<Bv>> model) {
    model->endModel();
    objects_.push_back(std::make_unique<fcl::CollisionObject<S>>(std::move(model)));
    objects_.back()->computeAABB();
    manager_.registerObject(objects_.back().get());
  }

  std::vector<std::unique_ptr<fcl::CollisionObject<S>>> objects_;
  fcl::DynamicAABBTreeCollisionManager<S> manager_;
};

// Frames only: the usual way says nothing of what lies between them.
template <typename Bv, bool kMerged>
void usualCheck(benchmark::State& state) {
  const RunResult& result = planned();
  const Problem& problem = *result.problem;
  const AnimationBuffer& walk = walkOf(result);
  UsualWorld<Bv> world(problem.scene, kMerged);
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
template <typename Bv>
void fclManager(benchmark::State& state) {
  usualCheck<Bv, false>(state);
}
template <typename Bv>
void fclMerged(benchmark::State& state) {
  usualCheck<Bv, true>(state);
}
BENCHMARK(fclManager<fcl::OBBRSSd>)->Unit(benchmark::kMillisecond);
BENCHMARK(fclManager<fcl::OBBd>)->Unit(benchmark::kMillisecond);
BENCHMARK(fclManager<fcl::OBBf>)->Unit(benchmark::kMillisecond);
BENCHMARK(fclMerged<fcl::OBBRSSd>)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace amble

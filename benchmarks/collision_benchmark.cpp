/// How fast whole bodies are checked along the walks of scenarios: poses a second of the collision
/// world, at frames and between them, by our own trees and by FCL behind them; and with the poses
/// made anew. Beside the usual way: FCL's own manager, DynamicAABBTreeCollisionManager, with a tree
/// an object of the boxes that are named (d: doubles, f: floats), or one tree of all, asked once a
/// capsule and frame, at frames only; what has ground in a manager of its own, which soles are not
/// asked against, as FCL's users have it who want to be fast. In the first scenario, single
/// capsules near things, exactly, without any cheaper test before: yes or no, and distances.
///
///   collision_benchmark [GOOGLE'S OPTIONS] [SCENARIO...]
#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/geometry/shape/capsule.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/collision_object.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/rotation.h"
#include "benchmarks/scenarios.h"
#include "environments/collision/obstacle_set.h"
#include "environments/scene/scene_pieces.h"
#include "environments/scene/triangle_grid.h"
#include "scenarios/problem.h"

namespace amble {
namespace {

const AnimationBuffer& walkOf(const RunResult& result) { return result.outcome.walk.buffer; }

void countPoses(benchmark::State& state, long long poses) {
  state.counters["poses/s"] =
      benchmark::Counter(static_cast<double>(poses), benchmark::Counter::kIsRate);
}

CollisionWorld worldOf(const RunResult& result, Checker checker) {
  const Problem& problem = *result.problem;
  return CollisionWorld(problem.scene, problem.ground, problem.synthesizer.skeleton(), problem.body,
                        {}, checker);
}

void wholeBodyCheck(benchmark::State& state, const std::string& scenario, Checker checker) {
  const RunResult& result = planned(scenario);
  const AnimationBuffer& walk = walkOf(result);
  const CollisionWorld world = worldOf(result, checker);
  const auto scratch = world.makeScratch();
  for (auto _ : state) {
    if (world.check(walk.poses, walk.soles, false, *scratch)) state.SkipWithError("a contact");
  }
  countPoses(state, state.iterations() * walk.size());
}

void wholeBodyClearance(benchmark::State& state, const std::string& scenario, Checker checker) {
  const RunResult& result = planned(scenario);
  const AnimationBuffer& walk = walkOf(result);
  const CollisionWorld world = worldOf(result, checker);
  const auto scratch = world.makeScratch();
  for (auto _ : state) {
    benchmark::DoNotOptimize(world.clearance(walk.poses, 2.0, *scratch));
  }
  countPoses(state, state.iterations() * walk.size());
}

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

ObstacleSet obstaclesOf(const RunResult& result, Checker checker) {
  const Problem& problem = *result.problem;
  std::vector<Obstacle> obstacles;
  for (size_t i = 0; i < problem.scene.objects.size(); ++i) {
    const SceneObject& object = problem.scene.objects[i];
    if (object.role == Role::kIgnore || problem.ground.isGround(static_cast<int>(i))) continue;
    const bool is_mesh = std::holds_alternative<TriangleMesh>(object.shape);
    obstacles.push_back(
        {static_cast<int>(i), object.shape, object.X_WO,
         is_mesh ? solidOf(static_cast<int>(i), problem.ground.pieces()) : SolidMesh{}});
  }
  return ObstacleSet(obstacles, {}, checker);
}

void makeObstacles(benchmark::State& state, const std::string& scenario, Checker checker) {
  for (auto _ : state) benchmark::DoNotOptimize(obstaclesOf(planned(scenario), checker));
}

void touchACapsule(benchmark::State& state, const std::string& scenario, Checker checker) {
  const std::vector<Capsule> capsules = capsulesNearThings(planned(scenario));
  const ObstacleSet obstacles = obstaclesOf(planned(scenario), checker);
  const auto scratch = ObstacleSet::makeScratch();
  for (auto _ : state)
    for (const Capsule& capsule : capsules)
      benchmark::DoNotOptimize(obstacles.touched(capsule, *scratch));
  state.SetItemsProcessed(state.iterations() * static_cast<int64_t>(capsules.size()));
}

void distanceOfACapsule(benchmark::State& state, const std::string& scenario, Checker checker) {
  const std::vector<Capsule> capsules = capsulesNearThings(planned(scenario));
  const ObstacleSet obstacles = obstaclesOf(planned(scenario), checker);
  const auto scratch = ObstacleSet::makeScratch();
  for (auto _ : state)
    for (const Capsule& capsule : capsules)
      benchmark::DoNotOptimize(obstacles.nearest(capsule, 1.0, *scratch));
  state.SetItemsProcessed(state.iterations() * static_cast<int64_t>(capsules.size()));
}

// An edge of a walk that is made anew: its ends and its path.
struct Edge {
  Stance from, to;
  RootPath path;
};

// Those that are found to be free as they are made here, so that each check goes all the way; the
// first of some paths that is, of each.
std::vector<Edge> freeEdges(const RunResult& result, const CollisionWorld& world,
                            CollisionScratch& scratch) {
  constexpr double kShortest = 0.5;  // [m]
  const Walk& walk = result.outcome.walk;
  AnimationBuffer buffer;
  std::vector<Edge> edges;
  for (size_t i = 1; i < walk.stances.size(); ++i) {
    const Stance &from = walk.stances[i - 1], &to = walk.stances[i];
    const Eigen::Vector2d a = from.position.head<2>(), b = to.position.head<2>();
    if ((b - a).norm() < kShortest) continue;
    for (const double reach : {1.0 / 3.0, 0.25, 0.4, 0.2, 0.5}) {
      Edge edge{from, to, RootPath({makeBezier(a, from.heading, b, to.heading, reach)})};
      const WalkResult made = result.problem->synthesizer.walk(from, to, edge.path, true, buffer);
      if (made.refused != WalkRule::kNone ||
          world.check(buffer.poses, buffer.soles, false, scratch))
        continue;
      edges.push_back(std::move(edge));
      break;
    }
  }
  return edges;
}

// The same with the poses made anew, as planning has it: synthesis is on our side only.
void synthesisAndCheck(benchmark::State& state, const std::string& scenario, Checker checker) {
  const RunResult& result = planned(scenario);
  const CollisionWorld world = worldOf(result, checker);
  const auto scratch = world.makeScratch();
  const std::vector<Edge> edges = freeEdges(result, world, *scratch);
  if (edges.empty()) state.SkipWithError("no edge");
  AnimationBuffer buffer;
  long long poses = 0;
  for (auto _ : state) {
    for (const Edge& edge : edges) {
      result.problem->synthesizer.walk(edge.from, edge.to, edge.path, true, buffer);
      benchmark::DoNotOptimize(world.check(buffer.poses, buffer.soles, false, *scratch));
      poses += buffer.size();
    }
  }
  countPoses(state, poses);
}

// Objects as FCL's users have them: a tree of boxes over the triangles of each, in FCL's own broad
// phase; or all triangles in one tree.
template <typename Bv>
class UsualSet {
 public:
  using S = typename Bv::S;
  using Point = fcl::Vector3<S>;
  using Object = fcl::CollisionObject<S>;

  explicit UsualSet(bool merged) : merged_(merged) {}

  void add(const SceneObject& object) {
    if (!model_) model_ = std::make_shared<fcl::BVHModel<Bv>>();
    if (model_->build_state == fcl::BVH_BUILD_STATE_EMPTY) model_->beginModel();
    const TriangleMesh mesh = worldMesh(object);
    std::vector<fcl::Triangle> triangles;
    for (const auto& t : mesh.triangles) triangles.emplace_back(t[0], t[1], t[2]);
    std::vector<Point> vertices;
    for (const Eigen::Vector3d& v : mesh.vertices) vertices.push_back(v.cast<S>());
    model_->addSubModel(vertices, triangles);
    if (!merged_) registerModel();
  }

  void setup() {
    if (model_) registerModel();
    manager_.setup();
  }

  bool touches(Object& capsule) {
    bool touched = false;
    manager_.collide(&capsule, &touched, [](Object* a, Object* b, void* found) {
      fcl::CollisionRequest<S> request;
      request.gjk_solver_type = fcl::GST_LIBCCD;
      fcl::CollisionResult<S> result;
      return *static_cast<bool*>(found) = fcl::collide(a, b, request, result) > 0;
    });
    return touched;
  }

 private:
  void registerModel() {
    model_->endModel();
    objects_.push_back(std::make_unique<Object>(std::exchange(model_, nullptr)));
    objects_.back()->computeAABB();
    manager_.registerObject(objects_.back().get());
  }

  bool merged_;
  std::shared_ptr<fcl::BVHModel<Bv>> model_;  // that is filled
  std::vector<std::unique_ptr<Object>> objects_;
  fcl::DynamicAABBTreeCollisionManager<S> manager_;
};

// A scene and a body as FCL's users have them, the body's capsules made once.
template <typename Bv>
class UsualWorld {
 public:
  using S = typename Bv::S;
  using Point = fcl::Vector3<S>;

  UsualWorld(const Problem& problem, bool merged) : obstacles_(merged), ground_(merged) {
    for (size_t i = 0; i < problem.scene.objects.size(); ++i) {
      const SceneObject& object = problem.scene.objects[i];
      if (object.role == Role::kIgnore) continue;
      (problem.ground.isGround(static_cast<int>(i)) ? ground_ : obstacles_).add(object);
    }
    obstacles_.setup();
    ground_.setup();
    for (const BodyPart& part : problem.body.parts) {
      const S length = static_cast<S>((part.to - part.from).norm());
      capsules_.emplace_back(
          std::make_shared<fcl::Capsule<S>>(static_cast<S>(part.radius), length));
      soles_.push_back(part.sole >= 0);
    }
  }

  // Whether a part of the body touches anything but the ground under its soles.
  bool touches(size_t part, const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
    fcl::CollisionObject<S>& capsule = capsules_[part];
    const Point axis = (to - from).cast<S>();
    capsule.setTransform(
        Eigen::Quaternion<S>::FromTwoVectors(Point::UnitZ(), axis).toRotationMatrix(),
        (0.5 * (from + to)).cast<S>());
    capsule.computeAABB();
    return obstacles_.touches(capsule) || (!soles_[part] && ground_.touches(capsule));
  }

 private:
  UsualSet<Bv> obstacles_, ground_;
  std::vector<fcl::CollisionObject<S>> capsules_;  // of the body's parts
  std::vector<bool> soles_;
};

// Frames only: the usual way says nothing of what lies between them.
template <typename Bv>
void usualCheck(benchmark::State& state, const std::string& scenario, bool merged) {
  constexpr int kEvery = 10;  // enough frames of the walk for a mean
  const RunResult& result = planned(scenario);
  const Problem& problem = *result.problem;
  const AnimationBuffer& walk = walkOf(result);
  UsualWorld<Bv> world(problem, merged);
  std::vector<JointFrame> joints(problem.synthesizer.skeleton().size());
  std::vector<Eigen::Vector3d> from(problem.body.parts.size()), to(from.size());
  long long poses = 0, touching = 0;
  for (auto _ : state) {
    for (int i = 0; i < walk.size(); i += kEvery, ++poses) {
      forwardKinematics(problem.synthesizer.skeleton(), walk.poses[i], joints);
      placeBody(problem.body, joints, from, to);
      bool touched = false;
      for (size_t part = 0; part < from.size() && !touched; ++part)
        touched = world.touches(part, from[part], to[part]);
      touching += touched;
    }
  }
  countPoses(state, poses);
  // Soles apart, walks touch nothing; where FCL says otherwise it saves work.
  state.counters["touching"] = static_cast<double>(touching) / static_cast<double>(poses);
}

using Measure = void (*)(benchmark::State&, const std::string&, Checker);

void addRow(const std::string& measure, const std::string& scenario,
            const std::function<void(benchmark::State&)>& run) {
  benchmark::RegisterBenchmark(rowName(measure, scenario).c_str(), run)
      ->Unit(benchmark::kMillisecond);
}

// By our own trees, and by FCL behind them.
void addBoth(const std::string& measure, const std::string& scenario, Measure run) {
  for (const Checker checker : {Checker::kFast, Checker::kFcl}) {
    addRow(checker == Checker::kFast ? measure : measure + "ByFcl", scenario,
           [=](benchmark::State& state) { run(state, scenario, checker); });
  }
}

template <typename Bv>
void addUsual(const std::string& measure, const std::string& scenario, bool merged) {
  addRow(measure, scenario,
         [=](benchmark::State& state) { usualCheck<Bv>(state, scenario, merged); });
}

void addRows(const std::string& scenario) {
  addBoth("wholeBodyCheck", scenario, wholeBodyCheck);
  addBoth("synthesisAndCheck", scenario, synthesisAndCheck);
  addBoth("wholeBodyClearance", scenario, wholeBodyClearance);
  addUsual<fcl::OBBRSSd>("fclManager<OBBRSSd>", scenario, false);
  addUsual<fcl::OBBd>("fclManager<OBBd>", scenario, false);
  addUsual<fcl::OBBf>("fclManager<OBBf>", scenario, false);
  addUsual<fcl::OBBRSSd>("fclMerged<OBBRSSd>", scenario, true);
  static bool first = true;
  if (!std::exchange(first, false)) return;
  addBoth("makeObstacles", scenario, makeObstacles);
  addBoth("touchACapsule", scenario, touchACapsule);
  addBoth("distanceOfACapsule", scenario, distanceOfACapsule);
}

}  // namespace
}  // namespace amble

int main(int argc, char** argv) {
  return amble::runOnScenarios(
      argc, argv, {"living-room", "apartment", "maze", "rubble", "stairs-up", "rolling-terrain"},
      amble::addRows);
}

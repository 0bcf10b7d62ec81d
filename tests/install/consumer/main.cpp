// A project of somebody else, with what docs/cpp.md names: runs a scenario that comes with Amble;
// makes two seconds of a walk along a path, writes it and reads it back; plans around a table in a
// room that it makes itself.
#include <cmath>
#include <cstdio>

#include "animation/captures/bvh.h"
#include "animation/captures/motion_reader.h"
#include "animation/library/motion_library_reader.h"
#include "animation/synthesis/walk_synthesizer.h"
#include "base/data_directory.h"
#include "environments/body/body.h"
#include "environments/collision/collision_world.h"
#include "environments/ground/scene_ground.h"
#include "planner/legs/planner.h"
#include "planner/plan_walk.h"
#include "scenarios/run_scenario.h"
#include "scenarios/scenario.h"

namespace {

bool runsAScenario() {
  const amble::RunResult run =
      amble::runScenario(amble::readScenario(amble::dataDirectory() / "scenarios/kerb.yaml"));
  std::printf("kerb: %.2f m in %.2f s\n", run.report.length, run.report.duration);
  return run.report.status == amble::PlanStatus::kSolved && !run.bvh.empty();
}

bool walksAndReadsBack(const amble::MotionLibrary& library) {
  const amble::FlatGround ground;
  const amble::WalkSynthesizer synthesizer(library, ground, {});
  const double length = 2.0 * synthesizer.settings().speed;
  const amble::RootPath path({amble::makeBezier({0.0, 0.0}, 0.0, {length, 0.0}, 0.0)});
  amble::Stance from, to;
  to.position.x() = length;
  amble::AnimationBuffer walk;
  if (synthesizer.walk(from, to, path, true, walk).refused != amble::WalkRule::kNone) return false;

  const amble::Clip clip{"walk", synthesizer.skeleton(), walk.frame_time, walk.poses, {}};
  amble::writeBvh("walk.bvh", clip, {});
  const amble::Clip read = amble::readMotion("walk.bvh").clip;
  const double walked = read.poses.p_WR(read.frames() - 1).x() - read.poses.p_WR(0).x();
  std::printf("%zu motions; %.2f s, %.3f m\n", library.motions.size(), read.duration(), walked);
  return read.frames() == clip.frames() && std::abs(walked - length) < 0.05;
}

amble::SceneObject box(const char* name, const Eigen::Vector3d& size, const Eigen::Vector3d& at) {
  return {name, "", amble::Box{size}, Eigen::Isometry3d(Eigen::Translation3d(at))};
}

bool plansAroundATable(const amble::MotionLibrary& library) {
  amble::Scene scene;
  scene.objects = {box("floor", {6, 4, 0.1}, {3, 2, -0.05}),
                   box("table", {0.8, 1.6, 0.75}, {3, 2, 0.375})};
  const amble::SceneGround ground(scene);
  const amble::WalkSynthesizer walker(library, ground, {});
  const amble::Body body = amble::makeBody(walker.skeleton(), walker.roles(), walker.stature(),
                                           amble::soleHeights(walker.feet()));
  const amble::CollisionWorld world(scene, ground, walker.skeleton(), body);
  amble::PlanRequest request;
  request.synthesizer = &walker;
  request.world = &world;
  request.ground = &ground;
  request.bounds = {Eigen::Vector2d(0, 0), Eigen::Vector2d(6, 4)};
  request.start = {{1, 2, 0}, 0.0};
  request.goal = {{5, 2, 0}, 0.0};
  request.limits.max_failures = amble::Planner::kFailures;
  const amble::PlanOutcome once = amble::planWalk(request);
  const amble::Planner planner(request);
  const amble::PlanOutcome again = planner.plan({request.start, request.goal});
  std::printf("around: %.2f m, %.2f m\n", once.walk.path.length(), again.walk.path.length());
  for (const amble::PlanOutcome* outcome : {&once, &again})
    if (outcome->status != amble::PlanStatus::kSolved || outcome->walk.path.length() <= 4.0)
      return false;
  return true;
}

}  // namespace

int main() {
  const amble::MotionLibrary library = amble::openMotionLibrary("default");
  return runsAScenario() && walksAndReadsBack(library) && plansAroundATable(library) ? 0 : 1;
}

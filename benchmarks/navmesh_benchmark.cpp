/// Recast and Detour on the scenes of scenarios, beside what of ours is nearest to them: the map
/// with the first way over it, and the proof that there is none; and beside what they are no
/// substitute for: walks that are animated and checked, for the body's bounding cylinder or for the
/// body.
///
/// Recast answers another question: where a cylinder's axis may be, to a cell, at the same cost
/// whatever is done there. Where a cylinder is enough it wins by far. Its agent reaches as far as
/// the walking body does to its sides, with the character's height, climb and slope; the bounding
/// cylinder of `planOfCylinder` holds strides too. `loading` is all that ours does before: scene,
/// library, ground, collision world.
///
///   navmesh_benchmark [GOOGLE'S OPTIONS] [SCENARIO...]
#include <algorithm>
#include <memory>

#include "benchmarks/navigation_mesh.h"
#include "benchmarks/scenarios.h"
#include "planner/plan_walk.h"
#include "planner/steering/straight_walk.h"
#include "planner/steering/walk_steering.h"
#include "scenarios/problem.h"

namespace amble {
namespace {

// What is asked for, loaded once a program.
struct Asked {
  std::unique_ptr<const Problem> problem;
  PlanRequest request;
  NavigationAgent agent;
};

std::unique_ptr<const Problem> load(const std::string& scenario) {
  constexpr double kFrameTime = 1.0 / 60.0;
  return std::make_unique<const Problem>(readScenario(scenarioFile(scenario)), kFrameTime);
}

const Asked& asked(const std::string& name) {
  static std::map<std::string, Asked> all;
  Asked& made = all[name];
  if (made.problem) return made;
  made.problem = load(name);
  const Problem& problem = *made.problem;
  const Scenario& scenario = problem.scenario;
  made.request.synthesizer = &problem.synthesizer;
  made.request.world = &problem.world;
  made.request.ground = &problem.ground;
  made.request.bounds = problem.bounds();
  made.request.start = {problem.stand(scenario.start, "start"), scenario.start.heading,
                        scenario.walk.from_standing};
  made.request.goal = {problem.stand(scenario.goal, "goal"), scenario.goal.heading,
                       scenario.walk.to_standing};
  made.request.comfort = scenario.walk.comfort;
  made.request.limits.seed = scenario.planner.seed;
  made.request.limits.max_failures = scenario.planner.max_failures;
  const GroundLimits& limits = scenario.character.limits;
  const Eigen::AlignedBox1d breadth = walkingBreadth(straightWalk(problem.synthesizer),
                                                     problem.synthesizer.skeleton(), problem.body);
  made.agent = {std::max(-breadth.min()[0], breadth.max()[0]), problem.synthesizer.stature(),
                limits.max_climb, limits.max_slope};
  return made;
}

// As the map has it, or as Recast's manual has it for rooms, so that the radius is not rounded up
// by a cell.
double cellOf(const Asked& of, bool fine) {
  return fine ? ClearanceMap::kCell : 1.001 * of.agent.radius / 3.0;
}

void recastBuild(benchmark::State& state, const std::string& scenario, bool fine) {
  const Asked& of = asked(scenario);
  const NavigationInput input(of.problem->scene);
  const double cell = cellOf(of, fine);
  for (auto _ : state) {
    const NavigationMesh mesh(input, of.agent, cell);
    state.counters["polygons"] = mesh.polygons();
  }
  state.counters["cell"] = cell;
  state.counters["triangles"] = static_cast<double>(input.triangles.size() / 3);
}

void detourQuery(benchmark::State& state, const std::string& scenario, bool fine) {
  const Asked& of = asked(scenario);
  const NavigationMesh mesh(NavigationInput(of.problem->scene), of.agent, cellOf(of, fine));
  std::optional<double> length;
  for (auto _ : state) length = mesh.query(of.request.start.position, of.request.goal.position);
  state.SetLabel(length ? "found" : "no way");
  state.counters["length"] = length.value_or(0.0);
}

void loading(benchmark::State& state, const std::string& scenario) {
  for (auto _ : state) benchmark::DoNotOptimize(load(scenario));
}

bool never() { return false; }

void mapAndWay(benchmark::State& state, const std::string& scenario) {
  const Asked& of = asked(scenario);
  const PlanRequest& request = of.request;
  const WalkSteering steering(*request.synthesizer, *request.world, *request.ground);
  bool found = false;
  for (auto _ : state) {
    const auto guide =
        steering.guide(request.start.position, request.goal.position, request.bounds, never, 1);
    found = guide && guide->next();
  }
  state.SetLabel(found ? "found" : "no way");
}

void proof(benchmark::State& state, const std::string& scenario) {
  const Asked& of = asked(scenario);
  const PlanRequest& request = of.request;
  const WalkSteering steering(*request.synthesizer, *request.world, *request.ground);
  const auto scratch = steering.makeScratch();
  bool shut = false;
  for (auto _ : state)
    shut = steering.shutOff(request.start.position, request.goal.position, never, {&scratch, 1})
               .has_value();
  state.SetLabel(shut ? "no walk, proved" : "nothing known");
}

void plan(benchmark::State& state, const std::string& scenario, const std::string& planner) {
  PlanRequest request = asked(scenario).request;
  request.planner = planner;
  PlanOutcome outcome;
  for (auto _ : state) outcome = planWalk(request);
  state.SetLabel(statusName(outcome.status));
  state.counters["length"] = outcome.walk.path.length();
}

void addRows(const std::string& scenario) {
  const auto add = [&](const std::string& measure, auto run, benchmark::TimeUnit unit,
                       auto... arguments) {
    return benchmark::RegisterBenchmark(
               rowName(measure, scenario).c_str(),
               [=](benchmark::State& state) { run(state, scenario, arguments...); })
        ->Unit(unit);
  };
  add("recastBuild", recastBuild, benchmark::kMillisecond, false);
  add("recastBuildFine", recastBuild, benchmark::kMillisecond, true);
  add("detourQuery", detourQuery, benchmark::kMicrosecond, false);
  add("detourQueryFine", detourQuery, benchmark::kMicrosecond, true);
  // In threads, and meshes in a child, whose work no thread's clock counts.
  add("loading", loading, benchmark::kMillisecond)->UseRealTime();
  add("mapAndWay", mapAndWay, benchmark::kMillisecond);
  add("proof", proof, benchmark::kMillisecond);
  add("planOfCylinder", plan, benchmark::kMillisecond, "cylinder");
  add("plan", plan, benchmark::kMillisecond, "visibility");
}

}  // namespace
}  // namespace amble

int main(int argc, char** argv) {
  return amble::runOnScenarios(argc, argv, {"living-room", "apartment", "stairs-up", "sealed-goal"},
                               amble::addRows);
}

// Edge validation in the living room, and roadmap, query and refinement of every scenario.

#include <benchmark/benchmark.h>

#include <filesystem>

#include "planner/steering/walk_steering.h"
#include "scenarios/check_scenarios.h"
#include "scenarios/find_scenarios.h"
#include "scenarios/problem.h"
#include "scenarios/run_scenario.h"
#include "test_paths.h"

namespace {

using namespace amble;

const std::filesystem::path kScenarios = std::filesystem::path(AMBLE_SOURCE_DIR) / "scenarios";

// Edges from the start to places on a grid, valid or not; `poses` are those that were checked.
void validateEdges(benchmark::State& state) {
  const Problem problem(readScenario(kScenarios / "living-room.yaml"), 1.0 / 60.0);
  const WalkSteering steering(problem.synthesizer, problem.world, problem.ground);
  const auto scratch = steering.makeScratch();
  const Eigen::AlignedBox2d bounds = problem.bounds();
  Waypoint from;
  from.stance.position = problem.stand(problem.scenario.start, "start");
  from.stance.heading = problem.scenario.start.heading.value_or(0.0);
  constexpr int kSide = 12;
  int64_t poses = 0, edges = 0;
  for (auto _ : state) {
    const int cell = static_cast<int>(edges % (kSide * kSide));
    const Eigen::Vector2d share((cell % kSide + 0.5) / kSide,
                                (static_cast<int>(cell / kSide) + 0.5) / kSide);
    Waypoint to;
    to.stance.position.head<2>() = bounds.min() + bounds.sizes().cwiseProduct(share);
    to.stance.position.z() = problem.floor;
    to.any_heading = true;
    poses += steering.steer(from, to, *scratch).poses;
    ++edges;
  }
  state.SetItemsProcessed(edges);
  state.counters["poses"] =
      benchmark::Counter(static_cast<double>(poses), benchmark::Counter::kIsRate);
}
BENCHMARK(validateEdges)->Unit(benchmark::kMillisecond);

void planScenario(benchmark::State& state, const std::filesystem::path& file) {
  for (auto _ : state) {
    const Report report = runScenario(readScenario(file)).report;
    state.counters["roadmap_s"] = report.times.roadmap;
    state.counters["query_s"] = report.times.search;
    state.counters["refine_s"] = report.times.refine;
    state.counters["guards"] = report.roadmap.guards;
    state.counters["edges"] = report.roadmap.edges;
    state.SetLabel(statusName(report.status));
  }
}

// One each for the scenarios whose data is here.
const bool registered = [] {
  for (const auto& file : findScenarios({kScenarios})) {
    if (!missingData(readScenario(file)).empty()) continue;
    const std::string name = "planScenario/" + file.file.stem().string();
    benchmark::RegisterBenchmark(
        name.c_str(), [file](benchmark::State& state) { planScenario(state, file.file); })
        ->Unit(benchmark::kMillisecond)
        ->Iterations(1);
  }
  return true;
}();

}  // namespace

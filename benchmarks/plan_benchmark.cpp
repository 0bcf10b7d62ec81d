// Edge validation in the living room, new starts and goals there on a kept roadmap and without one,
// and roadmap, query and refinement of every scenario.
//
// With --ompl=FOLDER instead: every planner on every scenario, in the log format of OMPL's
// benchmarks, a file a scenario, for its ompl_benchmark_statistics.py and for Planner Arena.
// Options then: --runs=N (10), each by a seed of its own, --seconds=S (10) a run, and names of
// scenarios.

#include <benchmark/benchmark.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/tools/benchmark/Benchmark.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "planner/legs/planners.h"
#include "planner/ompl/quiet_ompl.h"
#include "planner/ompl/roadmap_planner.h"
#include "planner/roadmap/kept_roadmap.h"
#include "planner/roadmap/stance_sampler.h"
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

// The living room with another start and goal each time, on a roadmap that is kept and has been
// asked before, and, beside it, each from nothing: the search until there are checked edges, and
// what refinement takes then, a query.
void newEnds(benchmark::State& state, bool warm) {
  const Problem problem(readScenario(kScenarios / "living-room.yaml"), 1.0 / 60.0);
  PlanRequest request = problem.request();
  request.limits.max_failures = Planner::kFailures;
  const Planner planner(request, Planner::grow(request));
  request.limits.max_failures = problem.scenario.planner.max_failures;
  const WalkSteering steering(problem.synthesizer, problem.world, problem.ground,
                              {request.comfort, request.within});
  const auto scratch = steering.makeScratch();
  const StanceSampler sampler(steering, request.bounds);
  std::vector<PlanEnd> ends;
  for (uint64_t i = 0; ends.size() < 24; ++i)
    if (const auto sample = sampler.draw(77, 2 * i, *scratch))
      ends.push_back({sample->stance.position, sample->stance.heading, true});
  const auto plan = [&](size_t i) {
    const PlanQuery query{ends[i % ends.size()], ends[(i + 1) % ends.size()]};
    if (warm) return planner.plan(query);
    request.start = query.start;
    request.goal = query.goal;
    return planWalk(request);
  };
  if (warm)
    for (size_t i = 0; i < ends.size(); ++i) plan(i);
  std::vector<double> searches, refinements;
  for (auto _ : state) {
    const PlanOutcome outcome = plan(searches.size());
    searches.push_back(outcome.times.roadmap + outcome.times.search);
    refinements.push_back(outcome.times.refine);
  }
  for (auto* times : {&searches, &refinements}) std::sort(times->begin(), times->end());
  state.counters["search_median_s"] = searches[searches.size() / 2];
  state.counters["search_max_s"] = searches.back();
  state.counters["refine_median_s"] = refinements[refinements.size() / 2];
}
BENCHMARK_CAPTURE(newEnds, warm, true)->Unit(benchmark::kMillisecond)->Iterations(24);
BENCHMARK_CAPTURE(newEnds, cold, false)->Unit(benchmark::kMillisecond)->Iterations(24);

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

struct OmplOptions {
  std::filesystem::path folder;  // empty: Google's benchmarks are run
  int runs = 10;
  double seconds = 10.0;           // a run [s]
  std::vector<std::string> names;  // of scenarios; none: all
};

Waypoint endOf(const Problem& problem, const Place& place, const char* key, bool stands) {
  Waypoint at;
  at.stance.position = problem.stand(place, key);
  at.stance.heading = place.heading.value_or(0.0);
  at.stance.standing = stands;
  at.any_heading = !place.heading;
  return at;
}

// What OMPL does not measure itself.
void addProperties(const ompl::base::PlannerPtr& planner,
                   ompl::tools::Benchmark::RunProperties& run) {
  const auto& space = *planner->getSpaceInformation();
  SteeringCount count = effortOf(space).steering;
  long long samples = effortOf(space).samples;
  if (const SampledRoadmap* roadmap = roadmapOf(*planner)) {
    count.add(roadmap->steering());
    samples += roadmap->samples();
  }
  run["samples INTEGER"] = std::to_string(samples);
  run["edges steered INTEGER"] = std::to_string(count.asked);
  run["poses checked INTEGER"] = std::to_string(count.poses);
  const auto& problem = *planner->getProblemDefinition();
  if (!problem.hasExactSolution()) return;
  const auto& path = static_cast<ompl::geometric::PathGeometric&>(*problem.getSolutionPath());
  double duration = 0.0;
  for (size_t i = 0; i + 1 < path.getStateCount(); ++i) {
    const SteerResult& walk = motionOf(space, path.getState(i), path.getState(i + 1));
    if (walk.edge) duration += walk.edge->duration;
  }
  run["walk duration REAL"] = std::to_string(duration);
}

// Every planner that is one of OMPL's kind, from start to goal.
void logScenario(const std::filesystem::path& file, const OmplOptions& options) {
  const Problem problem(readScenario(file), 1.0 / 60.0);
  const Scenario& scenario = problem.scenario;
  const WalkSteering steering(problem.synthesizer, problem.world, problem.ground);
  const OmplSpacePtr space = makeWalkSpace(steering, problem.bounds(), 1);
  const OmplProblemPtr asked =
      makeProblem(space, endOf(problem, scenario.start, "start", scenario.walk.from_standing),
                  endOf(problem, scenario.goal, "goal", scenario.walk.to_standing));
  ompl::geometric::SimpleSetup setup(space);
  setup.getProblemDefinition()->addStartState(asked->getStartState(0));
  setup.setGoal(asked->getGoal());
  ompl::tools::Benchmark log(setup, scenario.name);
  SearchLimits limits;
  limits.max_failures = scenario.planner.max_failures;
  for (const PlannerEntry& entry : planners()) {
    if (!entry.make) continue;
    const OmplPlannerPtr planner = entry.make(space, limits);
    planner->setName(entry.name);
    if (!setup.getPlanner()) setup.setPlanner(planner);
    log.addPlanner(planner);
  }
  std::uint64_t seed = 0;
  log.setPlannerSwitchEvent([&](const auto&) { seed = 0; });
  log.setPreRunEvent([&](const auto&) { restart(*space, ++seed); });
  log.setPostRunEvent(addProperties);
  constexpr double kMostMemory = 4096.0;   // [MB]
  constexpr double kBetweenUpdates = 0.5;  // [s]
  log.benchmark({options.seconds, kMostMemory, static_cast<unsigned>(options.runs), kBetweenUpdates,
                 false, false, false});
  std::filesystem::create_directories(options.folder);
  const std::filesystem::path out = options.folder / (scenario.name + ".log");
  std::ostringstream text;
  log.saveResultsToStream(text);
  // Debian's library does not know its version, without which the readers stop at the first line.
  std::string results = text.str();
  const std::string unversioned = "OMPL version \n";
  if (results.starts_with(unversioned))
    results.replace(0, unversioned.size(), "OMPL version 1.5.2\n");
  std::ofstream(out) << results;
  std::printf("%s\n", out.c_str());
}

OmplOptions readOptions(int argc, char** argv) {
  OmplOptions options;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    const std::string value = word.substr(word.find('=') + 1);
    if (word.starts_with("--ompl="))
      options.folder = value;
    else if (word.starts_with("--runs="))
      options.runs = std::stoi(value);
    else if (word.starts_with("--seconds="))
      options.seconds = std::stod(value);
    else
      options.names.push_back(word);
  }
  return options;
}

void logAll(const OmplOptions& options) {
  const QuietOmpl quiet;
  const auto& names = options.names;
  for (const auto& file : findScenarios({kScenarios})) {
    const bool is_asked = names.empty() || std::find(names.begin(), names.end(),
                                                     file.file.stem().string()) != names.end();
    if (is_asked && missingData(readScenario(file)).empty()) logScenario(file.file, options);
  }
}

}  // namespace

int main(int argc, char** argv) {
  const OmplOptions options = readOptions(argc, argv);
  if (!options.folder.empty()) {
    logAll(options);
    return 0;
  }
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}

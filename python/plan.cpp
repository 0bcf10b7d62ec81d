#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "python/asked.h"
#include "python/module.h"
#include "python/stoppable.h"
#include "python/text.h"
#include "python/walk.h"
#include "scenarios/problem.h"

namespace amble {
namespace {

namespace py = pybind11;

std::shared_ptr<PythonWalk> plan(const std::filesystem::path& file,
                                 const std::optional<std::string>& text, const Asked& asked) {
  const auto walk = std::make_shared<PythonWalk>();
  walk->command = asked.command;
  runStoppable(asked.threads, [&](const std::atomic<bool>& stop) {
    const Scenario scenario = scenarioOf(file, text, asked);
    if (!scenario.queries.empty()) {
      scenario.source.fail("queries", "it asks for several walks", "amble.plan_queries()");
    }
    walk->result = runScenario(scenario, optionsOf(asked, stop));
  });
  return walk;
}

// A walk of its own, of what the visitor of a query is shown: what was loaded they share.
std::shared_ptr<PythonWalk> walkOf(RunResult& result, const std::string& command) {
  const auto walk = std::make_shared<PythonWalk>();
  walk->command = command;
  if (result.problem)
    walk->result.problem =
        std::make_unique<const Problem>(*result.problem, result.problem->scenario);
  walk->result.outcome = std::move(result.outcome);
  walk->result.report = result.report;
  walk->result.joint_names = result.joint_names;
  walk->result.bvh = std::move(result.bvh);
  return walk;
}

py::dict planQueries(const std::filesystem::path& file, const std::optional<std::string>& text,
                     const Asked& asked) {
  std::vector<std::pair<std::string, std::shared_ptr<PythonWalk>>> walks;
  runStoppable(asked.threads, [&](const std::atomic<bool>& stop) {
    const Scenario scenario = scenarioOf(file, text, asked);
    if (scenario.queries.empty()) {
      scenario.source.fail("start", "it asks for one walk", "'queries:', or amble.plan()");
    }
    runQueries(scenario, optionsOf(asked, stop),
               [&](const ScenarioQuery& query, RunResult& result) {
                 walks.emplace_back(query.name, walkOf(result, asked.command));
               });
  });
  py::dict out;
  for (const auto& [name, walk] : walks) out[toText(name)] = walk;
  return out;
}

}  // namespace

Scenario scenarioOf(const std::filesystem::path& file, const std::optional<std::string>& text,
                    const Asked& asked) {
  Scenario scenario = text ? readScenario(ScenarioFile{file, *text}) : readScenario(file);
  if (text) scenario.name = file.string().substr(1, file.string().size() - 2);  // of "<name>"
  if (asked.planner) {
    scenario.planner.name = *asked.planner;
    scenario.source.lines.erase("planner.name");
  }
  if (asked.seed) scenario.planner.seed = static_cast<std::uint64_t>(*asked.seed);
  if (asked.time_limit) scenario.planner.time_limit = *asked.time_limit;
  return scenario;
}

RunOptions optionsOf(const Asked& asked, const std::atomic<bool>& stop) {
  RunOptions options;
  options.threads = asked.threads;
  options.frame_time = 1.0 / asked.fps;
  options.names = asked.names;
  options.roadmap = asked.roadmap;
  options.stop = &stop;
  return options;
}

void bindPlan(py::module_& module) {
  py::class_<Asked>(module, "Asked")
      .def(py::init<>())
      .def_readwrite("planner", &Asked::planner)
      .def_readwrite("seed", &Asked::seed)
      .def_readwrite("time_limit", &Asked::time_limit)
      .def_readwrite("fps", &Asked::fps)
      .def_readwrite("names", &Asked::names)
      .def_readwrite("command", &Asked::command)
      .def_readwrite("roadmap", &Asked::roadmap)
      .def_readwrite("threads", &Asked::threads);
  module.def("plan", &plan);
  module.def("plan_queries", &planQueries);
  module.def("planners", [] {
    py::dict out;
    for (const PlannerInfo& planner : listPlanners())
      out[toText(planner.name)] = toText(planner.explanation);
    return out;
  });
}

}  // namespace amble

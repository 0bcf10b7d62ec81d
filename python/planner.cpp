#include "python/planner.h"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "planner/roadmap/roadmap_file.h"
#include "python/asked.h"
#include "python/module.h"
#include "python/stoppable.h"
#include "python/walk.h"
#include "scenarios/input_digests.h"
#include "scenarios/kept_roadmaps.h"

namespace amble {
namespace {

namespace py = pybind11;

using PlannerPtr = std::shared_ptr<PythonPlanner>;

/// Reads all that the text names, and has a roadmap grow or reads a kept one.
void make(const std::filesystem::path& name, const std::string& text, const Asked& asked,
          int max_failures, const std::atomic<bool>& stop, PythonPlanner& made) {
  Scenario scenario = readScenario(ScenarioFile{name, text});
  scenario.has_ends = false;
  scenario.source.sha256.clear();
  made.frame_time = 1.0 / asked.fps;
  const StopRequest request_to_stop{&stop, deadlineIn(scenario.planner.time_limit)};
  made.problem = std::make_unique<const Problem>(scenario, made.frame_time,
                                                 LoadLimits{.stop = request_to_stop});
  made.inputs = inputDigests(*made.problem, asked.roadmap);
  PlanRequest request = made.problem->request();
  request.limits.threads = asked.threads;
  if (!asked.roadmap.empty()) {
    made.planner.emplace(request, openRoadmap(asked.roadmap, *made.problem));
    return;
  }
  PlanRequest growing = request;
  growing.limits.max_failures = max_failures;
  growing.limits.stop = &stop;
  growing.limits.deadline = request_to_stop.deadline;
  KeptRoadmap roadmap = Planner::grow(growing);
  if (growing.limits.timeIsUp()) {
    scenario.source.fail("planner.time_limit", "the time limit passed before the roadmap was whole",
                         "a longer one");
  }
  made.planner.emplace(request, std::move(roadmap));
}

PlannerPtr makePlanner(const std::filesystem::path& name, const std::string& text,
                       const Asked& asked, int max_failures) {
  const auto made = std::make_shared<PythonPlanner>();
  runStoppable(asked.threads, [&](const std::atomic<bool>& stop) {
    make(name, text, asked, max_failures, stop, *made);
  });
  return made;
}

/// @param text  that of the planner's scene, walker and settings, with ends
std::shared_ptr<PythonWalk> planWith(const PlannerPtr& planner, const std::filesystem::path& name,
                                     const std::string& text, const Asked& asked) {
  const auto walk = std::make_shared<PythonWalk>();
  walk->command = asked.command;
  runStoppable(asked.threads, [&](const std::atomic<bool>& stop) {
    const Scenario scenario = scenarioOf(name, text, asked);
    std::map<std::string, std::string> inputs = planner->inputs;
    inputs[name.string()] = scenario.source.sha256;
    RunOptions options = optionsOf(asked, stop);
    options.frame_time = planner->frame_time;
    walk->result = runProblem(std::make_unique<const Problem>(*planner->problem, scenario), inputs,
                              &*planner->planner, options);
  });
  return walk;
}

void save(const PythonPlanner& planner, const std::filesystem::path& file) {
  const py::gil_scoped_release released;
  KeptRoadmap roadmap = planner.planner->roadmap();
  roadmap.source = roadmapSource(*planner.problem);
  writeRoadmap(roadmap, file);
}

py::dict roadmapOf(const PythonPlanner& planner) {
  const KeptRoadmap& roadmap = planner.planner->roadmap();
  py::dict out;
  out["guards"] = roadmap.count(NodeKind::kGuard);
  out["connectors"] = roadmap.count(NodeKind::kConnector);
  out["edges"] = roadmap.edges.size();
  out["samples"] = roadmap.samples;
  out["coverage"] = roadmap.coverage;
  return out;
}

}  // namespace

void bindPlanner(py::module_& module) {
  module.attr("roadmap_failures") = Planner::kFailures;
  module.def("make_planner", &makePlanner);
  py::class_<PythonPlanner, PlannerPtr>(module, "Planner")
      .def("plan", &planWith)
      .def("save", &save)
      .def_property_readonly("roadmap", &roadmapOf);
}

}  // namespace amble

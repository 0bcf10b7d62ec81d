#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "python/module.h"
#include "python/stoppable.h"
#include "python/walk.h"

namespace amble {
namespace {

namespace py = pybind11;

/// What the caller asks for in place of what the scenario has.
struct Asked {
  std::optional<std::string> planner;
  std::optional<int> seed;
  std::optional<double> time_limit;
  double fps = 60.0;
  std::string names;
  std::string command;  ///< that repeats the run
  std::filesystem::path roadmap;
  int threads = 1;
};

// @param text  of the scenario, for one that is in no file; it is called `name` then
Scenario scenarioOf(const std::filesystem::path& file, const std::optional<std::string>& text,
                    const Asked& asked) {
  Scenario scenario = text ? readScenario(ScenarioFile{file, *text}) : readScenario(file);
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

std::shared_ptr<PythonWalk> plan(const std::filesystem::path& file,
                                 const std::optional<std::string>& text, const Asked& asked) {
  const auto walk = std::make_shared<PythonWalk>();
  walk->command = asked.command;
  runStoppable([&](const std::atomic<bool>& stop) {
    walk->result = runScenario(scenarioOf(file, text, asked), optionsOf(asked, stop));
  });
  return walk;
}

}  // namespace

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
}

}  // namespace amble

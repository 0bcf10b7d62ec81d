#include "python/walk.h"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <sstream>

#include "app/write_formats.h"
#include "python/arrays.h"
#include "python/module.h"
#include "python/text.h"
#include "scenarios/export_walk.h"
#include "scenarios/problem.h"

namespace amble {
namespace {

namespace py = pybind11;

std::string reportOf(PythonWalk& walk) {
  const std::lock_guard<std::mutex> held(walk.report);
  std::ostringstream out;
  writeJson(out, walk.result.report);
  return std::move(out).str();
}

// At each frame, of the poses that the file has: those that the report was measured on.
std::vector<double> clearancesOf(const PythonWalk& walk) {
  const RunResult& result = walk.result;
  const Problem& problem = *result.problem;
  const PoseArray poses = exportWalk(problem.scenario.name, problem.synthesizer.skeleton(),
                                     result.outcome.walk.buffer, result.report.bvh_unit)
                              .poses;
  const CollisionScratchPtr scratch = problem.world.makeScratch();
  std::vector<double> clearances;
  PoseArray one(poses.joints());
  for (int frame = 0; frame < poses.size(); ++frame) {
    one.clear();
    one.append(poses[frame]);
    const Clearance near = problem.world.clearance(one, kMostClearance, *scratch);
    clearances.push_back(near.object < 0 ? kMostClearance : near.distance);
  }
  return clearances;
}

py::object clearanceArray(const PythonWalk& walk) {
  std::vector<double> clearances;
  {
    const py::gil_scoped_release released;
    clearances = clearancesOf(walk);
  }
  return numbersArray(clearances);
}

py::dict arraysOfWalk(const std::shared_ptr<PythonWalk>& walk) {
  const RunResult& result = walk->result;
  return arraysOf(result.outcome.walk.buffer, result.problem->synthesizer.skeleton(),
                  result.report.joint_names, ownerOf(walk));
}

void writeFolder(PythonWalk& walk, const std::filesystem::path& folder,
                 std::vector<std::string> formats, std::vector<std::string> views, int threads) {
  const py::gil_scoped_release released;
  checkPrograms(formats);
  const ResultWishes wishes{.formats = std::move(formats),
                            .views = std::move(views),
                            .threads = threads,
                            .command = walk.command};
  const std::lock_guard<std::mutex> held(walk.report);
  writeFormats(walk.result, folder, wishes);
}

void writeOne(PythonWalk& walk, const std::filesystem::path& file, int threads) {
  const py::gil_scoped_release released;
  const std::lock_guard<std::mutex> held(walk.report);
  writeFormat(walk.result, file, {.threads = threads, .command = walk.command});
}

}  // namespace

void bindWalk(py::module_& module) {
  module.def("format_names", &formatNames);
  module.def("usual_formats", &usualFormats);
  module.def("view_names", &viewNames);
  py::class_<PythonWalk, std::shared_ptr<PythonWalk>>(module, "Walk")
      .def_property_readonly(
          "status", [](const PythonWalk& walk) { return statusName(walk.result.report.status); })
      .def_property_readonly("why",
                             [](const PythonWalk& walk) { return toText(walk.result.report.why); })
      .def_property_readonly("bvh",
                             [](const PythonWalk& walk) { return py::bytes(walk.result.bvh); })
      .def_property_readonly("report", [](PythonWalk& walk) { return toText(reportOf(walk)); })
      .def("arrays", &arraysOfWalk)
      .def("clearance", &clearanceArray)
      .def("write_folder", &writeFolder)
      .def("write_file", &writeOne);
}

}  // namespace amble

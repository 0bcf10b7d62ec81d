#include "python/walk.h"

#include <pybind11/numpy.h>

#include <sstream>

#include "python/module.h"
#include "python/text.h"
#include "python/walk_arrays.h"

namespace amble {
namespace {

namespace py = pybind11;

std::string reportOf(const PythonWalk& walk) {
  std::ostringstream out;
  writeJson(out, walk.result.report);
  return std::move(out).str();
}

}  // namespace

void bindWalk(py::module_& module) {
  py::class_<PythonWalk, std::shared_ptr<PythonWalk>>(module, "Walk")
      .def_property_readonly(
          "status", [](const PythonWalk& walk) { return statusName(walk.result.report.status); })
      .def_property_readonly("why",
                             [](const PythonWalk& walk) { return toText(walk.result.report.why); })
      .def_property_readonly("bvh",
                             [](const PythonWalk& walk) { return py::bytes(walk.result.bvh); })
      .def_property_readonly("bvh_sha256",
                             [](const PythonWalk& walk) { return walk.result.bvhDigest(); })
      .def_property_readonly("report",
                             [](const PythonWalk& walk) { return toText(reportOf(walk)); })
      .def("arrays", [](const std::shared_ptr<PythonWalk>& walk) { return walkArrays(walk); });
}

}  // namespace amble

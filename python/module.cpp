#include "python/module.h"

#include <pybind11/stl/filesystem.h>

#include "base/data_directory.h"
#include "base/parallel.h"
#include "base/version.h"

PYBIND11_MODULE(_amble, module) {
  module.attr("version") = amble::version();
  module.def("use_data_directory", &amble::useDataDirectory);
  module.def(
      "data_directory", &amble::dataDirectory,
      "The folder of what comes with Amble: animation/motions, environments/scenes, scenarios.");
  module.def("usual_threads", &amble::usualThreads);
  amble::bindErrors(module);
  amble::bindWalk(module);
  amble::bindPlan(module);
  amble::bindPlanner(module);
  amble::bindClips(module);
  amble::bindGraph(module);
  amble::bindAnimate(module);
}

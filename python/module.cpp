#include "python/module.h"

#include "base/data_directory.h"
#include "base/parallel.h"
#include "base/version.h"

PYBIND11_MODULE(_amble, module) {
  module.attr("version") = amble::version();
  module.def("data_directory", [] { return amble::dataDirectory().string(); });
  module.def("usual_threads", &amble::usualThreads);
  amble::bindErrors(module);
  amble::bindWalk(module);
  amble::bindPlan(module);
}

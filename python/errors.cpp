#include "base/error.h"
#include "base/stop_request.h"
#include "base/text.h"
#include "python/module.h"
#include "python/text.h"

namespace amble {
namespace {

namespace py = pybind11;

// As the program prints it: on one line, whatever a file's name holds.
py::str shown(const std::string& text) { return toText(withoutControls(text)); }

void raiseInputError(const InputError& error) {
  const py::object kind = py::module_::import("amble._errors").attr("InputError");
  const py::object line = error.line() > 0 ? py::object(py::int_(error.line())) : py::none();
  const py::object made = kind(shown(error.what()), toText(error.file()), line,
                               shown(error.problem()), shown(error.expected()));
  PyErr_SetObject(kind.ptr(), made.ptr());
}

}  // namespace

void bindErrors(py::module_&) {
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const InputError& error) {
      raiseInputError(error);
    } catch (const Stopped& stopped) {
      PyErr_SetString(PyExc_TimeoutError, stopped.what());
    }
  });
}

}  // namespace amble

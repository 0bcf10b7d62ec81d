/// The parts of the module `amble._amble`, which the Python files of amble/ are written on.
///
/// Everything that takes longer than a millisecond lets go of the interpreter's lock (GIL) while it
/// works, so that other threads run. What is wrong with the input is amble.InputError.
#pragma once

#include <pybind11/pybind11.h>

namespace amble {

void bindErrors(pybind11::module_& module);
void bindWalk(pybind11::module_& module);
void bindPlan(pybind11::module_& module);
void bindPlanner(pybind11::module_& module);
void bindClips(pybind11::module_& module);
void bindGraph(pybind11::module_& module);
void bindAnimate(pybind11::module_& module);

}  // namespace amble

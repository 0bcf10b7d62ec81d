/// A walk's numbers as NumPy arrays, under the names that walk.npz has (docs/files.md).
#pragma once

#include <pybind11/pybind11.h>

#include <memory>

#include "python/walk.h"

namespace amble {

/// By name. What lies in memory as NumPy can see it is a view, which keeps the walk; quaternions,
/// which NumPy has as (w, x, y, z), and the joints' places in World are made once, here. None may
/// be written to. @pre there is a walk
pybind11::dict walkArrays(const std::shared_ptr<const PythonWalk>& walk);

/// At each frame of the file, to what is nearest; at most kClearanceLimit [m]. Called without the
/// interpreter's lock. @pre there is a walk
std::vector<double> clearances(const PythonWalk& walk);

}  // namespace amble

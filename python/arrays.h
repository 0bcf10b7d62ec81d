/// Motions as NumPy arrays, under the names that walk.npz has (docs/files.md).
///
/// What lies in memory as NumPy can see it is a view, which keeps its owner; quaternions, which
/// NumPy has as (w, x, y, z), and the joints' places in World are made once. None may be written
/// to.
#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <string>
#include <vector>

#include "animation/body/clip.h"
#include "animation/synthesis/animation_buffer.h"

namespace amble {

/// What keeps the memory that views look at.
template <typename T>
pybind11::capsule ownerOf(const std::shared_ptr<T>& kept) {
  return pybind11::capsule(new std::shared_ptr<T>(kept),
                           [](void* held) { delete static_cast<std::shared_ptr<T>*>(held); });
}

/// By name. @param names  of joints
pybind11::dict arraysOf(const Clip& clip, const std::vector<std::string>& names,
                        const pybind11::capsule& owner);
/// The same of a walk of ours, with its path and prints.
pybind11::dict arraysOf(const AnimationBuffer& walk, const Skeleton& skeleton,
                        const std::vector<std::string>& names, const pybind11::capsule& owner);

/// A column a side: whether the foot is planted.
pybind11::object plantedArray(const std::vector<bool>& left, const std::vector<bool>& right);
pybind11::object numbersArray(const std::vector<double>& numbers);

}  // namespace amble

/// Motion libraries as files (DESIGN.md, section 5, Motion library), written.
#pragma once

#include <filesystem>

#include "animation/library/motion_library.h"

namespace amble {

/// Writes the library and, beside it, the BVH of its skeleton; folders that are not there are made.
/// A BVH that holds the skeleton already stays as it is: it may be the capture that a library
/// names. Nothing is lost: only libraries and their skeletons are written over. @throws InputError
void writeMotionLibrary(const MotionLibrary& library, const std::filesystem::path& file);

}  // namespace amble

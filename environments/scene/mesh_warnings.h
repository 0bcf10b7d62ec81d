/// What a mesh file is likely not meant to be: too large for its unit, too far from its origin for
/// its numbers; and what was passed over in it.
#pragma once

#include <string>
#include <vector>

#include "environments/scene/mesh_reader.h"

namespace amble {

/// @param scale  of the file's unit [m]; `is_guessed` where the scene does not say it
/// @param y_up  the scene says that y is up in the file
std::vector<std::string> meshWarnings(const std::string& object, const MeshFile& file, double scale,
                                      bool is_guessed, bool y_up);

}  // namespace amble

/// What a mesh file says of itself, read before its reader is let at it: that cannot read all that
/// it takes in.
#pragma once

#include <filesystem>

namespace amble {

/// IFC: the schema must be IFC2X3 (Assimp reads IFC4 with IFC2X3's tables and falls over). glTF and
/// GLB: of the extensions that are required only such as change how things look may be unknown; a
/// GLB's lengths must be those of the file. Other formats say nothing.
/// @throws InputError
void checkMeshHeader(const std::filesystem::path& file);

}  // namespace amble

/// What Assimp makes of a mesh file, unguarded: readMesh is for everybody else.
#pragma once

#include <filesystem>

#include "environments/scene/mesh_reader.h"

namespace amble {

inline constexpr const char* kMeshFormats = "OBJ, glTF or GLB, PLY, STL, DAE, FBX or IFC";

/// Ending of the file's name in lower case, with its dot.
std::string meshEnding(const std::filesystem::path& file);
/// Whether Assimp has a reader for files of this ending.
bool isMeshEnding(const std::string& ending);

/// @throws InputError as readMesh says; may crash, and fill memory and time, where it does not.
MeshFile importMesh(const std::filesystem::path& file);

}  // namespace amble

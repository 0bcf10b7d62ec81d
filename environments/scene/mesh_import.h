/// What Assimp makes of a mesh file, unguarded: readMesh is for everybody else. OBJ files have a
/// reader of their own (obj_import.h).
#pragma once

#include <filesystem>

#include "environments/scene/mesh_reader.h"

namespace amble {

/// Corners that a face may have: to cut it into triangles takes time of their square, a tenth of a
/// second for so many.
inline constexpr int kMostCorners = 10000;

inline constexpr const char* kMeshFormats = "OBJ, glTF or GLB, PLY, STL, DAE, FBX or IFC";

/// Ending of the file's name in lower case, with its dot.
std::string meshEnding(const std::filesystem::path& file);
/// Whether there is a reader for files of this ending.
bool isMeshEnding(const std::string& ending);

/// @throws InputError as readMesh says; may crash, and fill memory and time, where it does not.
MeshFile importMesh(const std::filesystem::path& file);

}  // namespace amble

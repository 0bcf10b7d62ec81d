/// What tinyobjloader makes of an OBJ's text, unguarded: readMesh is for everybody else.
#pragma once

#include <string>

#include "environments/scene/mesh_reader.h"

namespace amble {

/// Parts by object or group (`o`, `g`), with the materials that their later faces have as further
/// names. Of a face only its vertices count; materials, normals, points, lines and curves are
/// passed over, and so are faces of fewer than three corners, of which the mesh file warns.
/// Coordinates are floats, rounded as Assimp rounds those of text in other formats.
/// @param name  stands for it in messages
/// @throws InputError as readMesh says, with the line
MeshFile parseObj(std::string text, const std::string& name);

}  // namespace amble

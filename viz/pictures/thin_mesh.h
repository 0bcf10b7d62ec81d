/// Fewer triangles, for looking at.
#pragma once

#include <vector>

#include "environments/scene/mesh.h"

namespace amble {

/// Corners within a cell of a grid become one, their mean, and triangles that have lost a corner so
/// are left out (J. Rossignac and P. Borrel, "Multi-resolution 3D approximations for rendering
/// complex scenes", 1993). Nothing moves by more than a cell's diagonal. Linear in triangles.
/// @param cell  [m, > 0]
TriangleMesh thinMesh(const TriangleMesh& mesh, double cell);

/// The smallest cell, of those that grow by a half, by which all of these have `most` triangles at
/// most, or one of 10 m or so; 0 where they have no more [m].
double thinningCell(const std::vector<const TriangleMesh*>& meshes, size_t most);

}  // namespace amble

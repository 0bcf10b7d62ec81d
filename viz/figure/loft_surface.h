/// Lofts become triangles.
#pragma once

#include <vector>

#include "environments/scene/mesh.h"
#include "viz/figure/loft.h"

namespace amble {

/// The surface of all groups together by marching tetrahedra (Doi and Koide 1991, each cube cut
/// into the six tetrahedra of Kuhn): always closed and without edges of more than two triangles.
/// @param cell  of the grid [m, > 0]; larger where the grid had more than some million cells
TriangleMesh loftSurface(const std::vector<LoftGroup>& groups, double cell);

}  // namespace amble

/// A thing as FCL has it: the reference that our own answers are measured against, and the answer
/// for cylinders.
///
/// Yes or no is asked with libccd in double precision (exact to 1e-6 m). Distances are asked of FCL
/// with its own solver for primitives, where libccd errs by millimetres, and of OBBRSS trees for
/// meshes.
#pragma once

#include "environments/collision/surface.h"
#include "environments/scene/scene.h"

namespace amble {

/// @pre a mesh has triangles.
SurfacePtr makeFclSurface(const Shape& shape, const Eigen::Isometry3d& X_WO);

}  // namespace amble

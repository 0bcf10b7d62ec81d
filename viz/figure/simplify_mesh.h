/// Fewer triangles for nearly the same shape.
#pragma once

#include "environments/scene/mesh.h"

namespace amble {

/// Edges are collapsed, the cheap ones first, by the quadric error of Garland and Heckbert
/// (Surface simplification using quadric error metrics, SIGGRAPH 1997), until `triangles` or fewer
/// are left or none may go: none does that would turn a triangle over or join what was apart.
/// A closed surface whose edges have two triangles each is one afterwards.
/// @pre `mesh` is such a surface
TriangleMesh simplifyMesh(const TriangleMesh& mesh, int triangles);

}  // namespace amble

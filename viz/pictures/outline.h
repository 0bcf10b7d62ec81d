/// Outlines of things seen from above, between two heights: what a plan view draws.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "environments/scene/mesh.h"

namespace amble {

/// Closed, counter-clockwise around what is covered, clockwise around holes [m].
using Outline = std::vector<Eigen::Vector2d>;

struct OutlineSettings {
  double low = 0.05;   ///< what is lower is not seen [m, World z]
  double high = 1.80;  ///< what is higher is not seen [m, > low]
  double cell = 0.01;  ///< of the grid that is traced [m, > 0]; outlines are right to about this
};

/// Everything that the mesh covers between the heights: its surface there and, where it is closed,
/// the inside. Holes and pieces smaller than a few cells are dropped, corners are kept. Cost:
/// linear in triangles and cells.
std::vector<Outline> traceOutlines(const TriangleMesh& mesh, const OutlineSettings& settings);

/// The same of a convex mesh, exactly: one outline at most.
std::vector<Outline> traceConvexOutline(const TriangleMesh& mesh, const OutlineSettings& settings);

/// Area inside, holes taken off [m^2].
double coveredArea(const std::vector<Outline>& outlines);

}  // namespace amble

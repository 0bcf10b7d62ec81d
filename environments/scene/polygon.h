/// Faces of more than three corners, cut into triangles.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

namespace amble {

/// Triangles of corners' indices, two fewer than there are corners, that turn as the polygon does;
/// each of its sides is a side of one triangle. Where it does not cross itself, seen along its
/// normal, and has an area, they cover it once. It may be bent, and corners may lie on a line.
/// Convex ones are cut from their first corner. Time is of the square of the corners that are not
/// convex, as a rule. @pre at least three
std::vector<std::array<int, 3>> cutPolygon(const std::vector<Eigen::Vector3d>& corners);

}  // namespace amble

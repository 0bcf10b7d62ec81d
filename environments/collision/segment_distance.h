/// Distances of a segment to a segment and to a triangle, squared, in doubles: what a capsule's
/// touch comes down to.
///
/// Exact but for rounding: the closest points of two segments as in Ericson, "Real-Time Collision
/// Detection" (2005), 5.1.9. A segment and a triangle are closest where the one passes through the
/// other, at an end of the segment over the triangle, or at an edge of the triangle.
#pragma once

#include "environments/scene/triangle_grid.h"

namespace amble {

/// Ends of a segment [m, World]; equal ones are a point.
struct Segment {
  Eigen::Vector3d from, to;
};

double squaredDistance(const Segment& a, const Segment& b);  ///< [m^2, >= 0]
/// @pre the triangle has an area.
double squaredDistance(const Segment& s, const Triangle3& t);  ///< [m^2, >= 0]
/// Whether that is at most `square` [m^2], sooner said where the segment is off the triangle's
/// plane.
bool isWithin(double square, const Segment& s, const Triangle3& t);

}  // namespace amble

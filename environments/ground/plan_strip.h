/// A strip about a segment of the plane, and what of triangles is over boxes in it: of what crests
/// are found (Ground::crest).
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <optional>
#include <utility>

#include "animation/ground/ground.h"
#include "environments/scene/triangle_grid.h"

namespace amble {

/// What is near to a segment of the plane, in the segment's own frame: along it and aside.
struct PlanStrip {
  Eigen::Vector2d origin, along, aside;
  Eigen::AlignedBox2d box;  ///< in its frame

  PlanStrip(const PlanSegment& segment, double half_width);

  /// A triangle in its frame; heights stay [m].
  Triangle3 local(const Triangle3& t) const;
  Eigen::AlignedBox2d plan() const;  ///< around it, in the plane
};

/// The plane of a triangle that is given in a strip's frame: what of it is over a box is no higher
/// than over its middle and half of its sides, up the slope.
struct StripPlane {
  double height = HUGE_VAL;         ///< over the frame's origin [m]; infinite: it stands upright
  double along = 0.0, aside = 0.0;  ///< its slope [1]

  explicit StripPlane(const Triangle3& own);
  double highestOver(const Eigen::AlignedBox2d& box) const;  ///< or a little more [m]
};

/// Of a level triangle, in a strip's frame: every piece of the strip that ends after the one and
/// begins before the other holds a point of it, by more than rounding. Of others, and of those
/// beside the strip, none.
std::pair<double, double> surelyMet(const Triangle3& own, double half_width);

/// The highest point of what of a triangle is over a box, where the triangle holds the corner of
/// the box that is up its slope: that over this corner, without clipping; else none [m].
std::optional<double> heightUpSlope(const Triangle3& own, const Eigen::AlignedBox2d& box);

/// The highest point of what of a triangle is over a box, if that lies between the two heights;
/// else -infinity [m].
double crestWithin(const Triangle3& own, const Eigen::AlignedBox2d& box, double low, double high);

}  // namespace amble

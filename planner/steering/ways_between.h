/// What may lead from one waypoint to another, before anything is animated: stage 1 of steering,
/// its root paths (Pettré §3), and what stands for them where there is no way to walk.
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "planner/steering/steering.h"

namespace amble {

/// One way to walk from one stance to the other: the headings of the root path's two ends, and its
/// handles.
struct Way {
  double leave = 0.0;         ///< [rad]
  double arrive = 0.0;        ///< [rad]
  double handle = 1.0 / 3.0;  ///< of makeBezier [1]
};

/// Root paths, the ones that are likeliest to be wanted first.
std::vector<Way> waysBetween(const Waypoint& from, const Waypoint& to);

/// The edge of such a way, not judged yet.
WalkEdge makeEdge(const Waypoint& from, const Waypoint& to, const Way& way);

/// Turning on the spot from one heading to the other, or by small steps beside it, where there is
/// no way to walk.
WalkEdge makeTurn(const Waypoint& from, const Waypoint& to);

/// Whether the edge's root path stays in the bounds, if there are any [m]. Its ends lie in them; a
/// curve between them need not.
bool staysWithin(const WalkEdge& edge, const std::optional<Eigen::AlignedBox2d>& bounds);

/// Where one may turn, or step aside, from the one to the other: standing, on one level.
bool onOneFloor(const Waypoint& from, const Waypoint& to);

/// Whether who walks at the one is at the other as well, without a step.
bool isThere(const Waypoint& from, const Waypoint& to);

}  // namespace amble

/// A walk as the edges that it is made of.
#pragma once

#include <utility>
#include <vector>

#include "planner/steering/steering.h"

namespace amble {

/// Where it is in plan [m, World].
inline Eigen::Vector2d inPlan(const Stance& stance) { return stance.position.head<2>(); }

/// Edges that follow one another: edges[i].to is edges[i + 1].from.
struct EdgePath {
  std::vector<WalkEdge> edges;
  /// By node (edges.size() + 1 of them): the walk must pass through its position. True for both
  /// ends.
  std::vector<bool> pinned;
  Waypoint start, goal;  ///< the ends as asked for: a heading that was free is free to be changed

  int last() const { return static_cast<int>(edges.size()); }  ///< node
  Waypoint node(int i) const;
  double duration() const;  ///< [s]
  double length() const;    ///< [m]
  int stops() const;        ///< nodes between the ends at which the walk stands
};

}  // namespace amble

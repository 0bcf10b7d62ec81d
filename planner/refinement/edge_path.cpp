#include "planner/refinement/edge_path.h"

#include <algorithm>

namespace amble {

Waypoint EdgePath::node(int i) const {
  if (i == 0) return start;
  if (i == last()) return goal;
  return {edges[i].from, false, false};
}

double EdgePath::duration() const {
  double sum = 0.0;
  for (const WalkEdge& edge : edges) sum += edge.duration;
  return sum;
}

double EdgePath::length() const {
  double sum = 0.0;
  for (const WalkEdge& edge : edges) sum += edge.length;
  return sum;
}

int EdgePath::stops() const {
  return static_cast<int>(std::count_if(edges.begin() + (edges.empty() ? 0 : 1), edges.end(),
                                        [](const WalkEdge& edge) { return edge.from.standing; }));
}

}  // namespace amble

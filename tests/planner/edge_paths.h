/// Walks made of edges, for tests of what makes them better.
#pragma once

#include <vector>

#include "base/sample_stream.h"
#include "planner/refinement/edge_path.h"
#include "tests/planner/disc_steering.h"

namespace amble {

/// A walk over waypoints, which steering allows.
inline EdgePath pathOver(const Steering& steering, const std::vector<Waypoint>& waypoints) {
  const SteeringScratchPtr scratch = steering.makeScratch();
  EdgePath path;
  path.start = waypoints.front();
  path.goal = waypoints.back();
  path.pinned.assign(waypoints.size(), false);
  path.pinned.front() = path.pinned.back() = true;
  for (size_t i = 0; i + 1 < waypoints.size(); ++i) {
    path.edges.push_back(steering.steer(waypoints[i], waypoints[i + 1], *scratch).edge.value());
  }
  return path;
}

/// Standing, one after another along x, to either side of it.
inline std::vector<Waypoint> drawnPlaces(std::uint64_t seed, int count) {
  SampleStream random(seed, 0);
  std::vector<Waypoint> places;
  for (int i = 0; i < count; ++i)
    places.push_back(standing(1.8 * i + random.uniform(-0.5, 0.5), random.uniform(-3, 3), 0.0));
  return places;
}

}  // namespace amble

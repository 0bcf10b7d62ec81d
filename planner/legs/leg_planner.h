/// A planner as planWalk asks it: leg by leg.
#pragma once

#include <memory>

#include "planner/plan_request.h"
#include "planner/roadmap/sampled_roadmap.h"
#include "planner/steering/walk_steering.h"

namespace amble {

/// A leg leads from the start, or a via point, to the next or the goal.
class LegPlanner {
 public:
  virtual ~LegPlanner() = default;
  /// Checked edges from one waypoint to the other, or none.
  virtual std::optional<std::vector<WalkEdge>> solve(const Waypoint& from, const Waypoint& to) = 0;
  /// What most often stood in the way of the leg that was asked for last.
  virtual std::optional<Obstruction> why() const = 0;
  /// Edges that were refused, of that leg, in the order in which they were asked; until it is asked
  /// for another.
  virtual std::vector<const RefusedEdge*> refused() const = 0;
  /// Writes roadmap, counts and times.
  virtual void describe(PlanOutcome& outcome) const = 0;
};
using LegPlannerPtr = std::unique_ptr<LegPlanner>;

template <typename Edge>  // RefusedEdge, or what is one
std::vector<const RefusedEdge*> pointersTo(const std::vector<Edge>& edges) {
  std::vector<const RefusedEdge*> pointers;
  for (const Edge& edge : edges) pointers.push_back(&edge);
  return pointers;
}

std::vector<SteeringFailure> failuresOf(const std::vector<RefusedEdge>& refused);

/// Refusals of edges that lead from where one gets from the start to where one gets to the goal
/// from; all, if hardly any does. Of these, where a way over a map is known, those near the place
/// on it where there are most.
std::vector<SteeringFailure> inTheWay(const SampledRoadmap& roadmap, const Waypoint& from,
                                      const Waypoint& to);

/// The root path of an edge, to be drawn; nothing where it only turns [m].
std::vector<Eigen::Vector2d> lineOf(const WalkEdge& walk);

/// Writes graph and counts of a roadmap.
void describeRoadmap(const SampledRoadmap& roadmap, PlanOutcome& outcome);
/// Writes refused edges: the nearest to where a walk was stopped, if it was.
void describeRefused(std::vector<const RefusedEdge*> refused,
                     const std::optional<Eigen::Vector3d>& stopped_at, PlanOutcome& outcome);
void describeCount(const SteeringCount& count, PlanOutcome& outcome);

}  // namespace amble

/// The planners by name, as planWalk asks them: leg by leg.
#pragma once

#include <memory>

#include "planner/plan_request.h"
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
  /// Writes roadmap, counts and times.
  virtual void describe(PlanOutcome& outcome) const = 0;
};

/// @throws std::invalid_argument where the name is unknown. @pre all outlive it.
std::unique_ptr<LegPlanner> makeLegPlanner(const PlanRequest& request, const WalkSteering& steering,
                                           const SearchLimits& limits);

/// An object as reports name it: its name in the scene, with that of its part of a mesh file where
/// it is one.
std::string nameOf(const SceneObject& object);

/// The refusals in few words: the rule and object that refused most often, and of these the part of
/// the body that did.
std::optional<Obstruction> mostOften(const std::vector<SteeringFailure>& refusals,
                                     const Scene& scene, const Body& body);

}  // namespace amble

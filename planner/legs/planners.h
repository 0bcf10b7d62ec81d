/// The planners by name: the one table that `amble plan --list-planners`, the check of scenarios
/// and planWalk read.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "planner/legs/leg_planner.h"
#include "planner/ompl/ompl_query.h"

namespace amble {

struct PlannerEntry {
  std::string name;
  std::string explanation;  ///< one line
  /// As a planner of OMPL in a space of stances; none for `cylinder`, which plans in one of its
  /// own.
  std::function<OmplPlannerPtr(const OmplSpacePtr&, const SearchLimits&)> make;
};

/// The default first.
const std::vector<PlannerEntry>& planners();

/// @throws std::invalid_argument where the name is unknown.
const PlannerEntry& findPlanner(const std::string& name);

/// The request's planner. @pre all outlive it. @throws std::invalid_argument where its name is
/// unknown.
LegPlannerPtr makeLegPlanner(const PlanRequest& request, const WalkSteering& steering,
                             const SearchLimits& limits);

}  // namespace amble

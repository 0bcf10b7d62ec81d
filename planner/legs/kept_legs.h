/// Legs over a kept roadmap; where it knows no way, those of the request's own planner, as without
/// it. So there is a walk, or a proof that there is none, wherever a search from nothing has it.
#pragma once

#include "planner/legs/leg_planner.h"
#include "planner/roadmap/kept_search.h"

namespace amble {

/// @pre all outlive it.
LegPlannerPtr makeKeptLegs(const PlanRequest& request, const WalkSteering& steering,
                           const KeptSearch& kept);

}  // namespace amble

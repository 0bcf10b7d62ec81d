/// Legs by a planner of OMPL, our roadmaps or OMPL's trees, which grow anew for each.
#pragma once

#include "planner/legs/leg_planner.h"
#include "planner/ompl/ompl_query.h"

namespace amble {

/// @param planner  in `space`. @pre request and limits outlive it.
LegPlannerPtr makeOmplLegs(const PlanRequest& request, const SearchLimits& limits,
                           OmplSpacePtr space, OmplPlannerPtr planner);

}  // namespace amble

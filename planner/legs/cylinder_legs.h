/// Legs by the planner `cylinder`, which is there to compare with.
#pragma once

#include "planner/legs/leg_planner.h"

namespace amble {

/// Plans for the bounding cylinder on a visibility roadmap of its own, then animates the body along
/// the path, which turns on the spot at its corners; a contact invalidates the path, and it is
/// tried again with another seed. @pre all outlive it.
LegPlannerPtr makeCylinderLegs(const PlanRequest& request, const WalkSteering& steering,
                               const SearchLimits& limits);

}  // namespace amble

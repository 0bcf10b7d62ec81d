/// One run: what planWalk and Planner share. Start, via points and goal are settled, the legs
/// between them walked, one after another, and the walk refined and checked as a whole.
#pragma once

#include <functional>

#include "planner/legs/leg_planner.h"

namespace amble {

/// Makes the planner of a run's legs. What it is given outlives it.
using LegPlannerMaker = std::function<LegPlannerPtr(const PlanRequest&, const WalkSteering&)>;

/// @pre checkRequest() has accepted the request; the steering is of its synthesizer, world, ground
/// and comfort.
PlanOutcome runPlan(const PlanRequest& request, const WalkSteering& steering,
                    const LegPlannerMaker& make);

/// @throws std::invalid_argument if the request is incomplete or a number is out of its range.
void checkRequest(const PlanRequest& request);

}  // namespace amble

/// What most often stood in the way of a walk, from the refusals of a search: for the report of why
/// there is none.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "planner/plan_request.h"
#include "planner/steering/ground_reach.h"
#include "planner/steering/steering.h"

namespace amble {

/// The refusals in few words: the rule and object that refused most often, of these the part of the
/// body that did, and one of the places where it happened. None where nothing was refused.
std::optional<Obstruction> mostOften(const std::vector<SteeringFailure>& refusals,
                                     const Scene& scene, const Body& body);

/// The same, and measured: how wide and high it is there, and between what.
std::optional<Obstruction> whatStoodInTheWay(const std::vector<SteeringFailure>& all,
                                             const PlanRequest& request);

/// Of an end that is blocked: by what, and the nearest place where the body could stand as it is to
/// stand there.
Obstruction whatBlocks(const SteeringFailure& failure, const Waypoint& end,
                       const PlanRequest& request, const Steering& steering);

/// Of things that shut the body off.
Obstruction whatShutsOff(const SteeringFailure& barrier, const PlanRequest& request);

/// Of ground that does not lead there.
Obstruction whatTheGroundLacks(const GroundGap& gap, const PlanRequest& request);

/// One line for people: the rule, what it is about, where, how much there is and what would do.
std::string describe(const Obstruction& why);

/// Middles of two feet in one step are no farther apart [m].
double longestStep(const WalkSynthesizer& synthesizer);

}  // namespace amble

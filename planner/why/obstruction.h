/// What most often stood in the way of a walk, from the refusals of a search: for the report of why
/// there is none.
#pragma once

#include <optional>
#include <vector>

#include "planner/plan_request.h"
#include "planner/steering/ground_reach.h"
#include "planner/steering/walk_steering.h"

namespace amble {

/// The refusals in few words: the rule and object that refused most often, of these the part of the
/// body that did, and one of the places where it happened. None where nothing was refused.
std::optional<Obstruction> mostOften(const std::vector<SteeringFailure>& refusals,
                                     const Scene& scene, const Body& body);

/// The same, and measured: what is missing there, and what would do.
/// @param narrow  where the way hardly has room, if it is known: it is looked at first
std::optional<Obstruction> whatStoodInTheWay(const std::vector<SteeringFailure>& all,
                                             const PlanRequest& request,
                                             const std::optional<WayGuide::Narrow>& narrow = {});

/// Of refusals those near the place on a way where there are most.
/// @param way  from place to place, on the ground [m, World]
std::vector<SteeringFailure> whereMostWereRefused(const std::vector<SteeringFailure>& refusals,
                                                  const std::vector<Eigen::Vector3d>& way);

/// Of an end that is blocked: by what, and the nearest place where the body could stand as it is to
/// stand there.
Obstruction whatBlocks(const SteeringFailure& failure, const Waypoint& end,
                       const PlanRequest& request, const Steering& steering);

/// Of things that shut the body off.
Obstruction whatShutsOff(const SteeringFailure& barrier, const PlanRequest& request);

/// Of ground that does not lead there.
Obstruction whatTheGroundLacks(const GroundGap& gap, const PlanRequest& request);

/// Of the walks that were refused near the place of a contact, those of kMostReplayed, the one that
/// comes nearest to passing: which part it has in which object, and how deep at most, is written
/// into `why`. Cost: some milliseconds. @param threads  [>= 1]
void addLeastOverlap(const std::vector<const RefusedEdge*>& refused, const WalkSteering& steering,
                     int threads, Obstruction& why);
inline constexpr int kMostReplayed = 12;

}  // namespace amble

/// How far one gets where there is no walk, over a map of the room that the body has
/// (ClearanceMap).
///
/// Places with room for the body that are joined to the start. Where they lead to the goal though
/// no walk was found, they are cut off: at whatever is no wider than the narrowest place of the
/// widest way, if there is hardly room at that place; else around the place where a walk was
/// stopped, as little of it as parts start and goal. It shows, and proves nothing.
#pragma once

#include <optional>

#include "environments/map/clearance_map.h"
#include "planner/plan_request.h"

namespace amble {

/// None where the start is not on the map, or where the goal is reached all the same.
/// @param from, to  ends of the leg that is not walked [m, World]
/// @param stopped_at  [m, World]
std::optional<ReachedRegion> reachedRegion(const ClearanceMap& map, const Eigen::Vector3d& from,
                                           const Eigen::Vector3d& to,
                                           const Eigen::Vector3d& stopped_at);

}  // namespace amble

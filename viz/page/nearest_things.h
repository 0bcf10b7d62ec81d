/// What is nearest to a body in each frame of a motion, with the two points.
#pragma once

#include "animation/body/pose.h"
#include "environments/collision/collision_world.h"
#include "viz/page/page.h"

namespace amble {

/// How far things are looked for [m].
inline constexpr double kNearLimit = 1.0;

/// Distances are the collision world's; the points are where the part's axis and the thing's
/// surface are closest. @pre the world is of the skeleton's body
PageClearance nearestThings(const CollisionWorld& world, const Skeleton& skeleton,
                            const PoseArray& poses);

}  // namespace amble

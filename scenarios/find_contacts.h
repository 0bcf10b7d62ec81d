/// All that the body of a motion touches, and when.
#pragma once

#include <vector>

#include "environments/collision/collision_world.h"
#include "scenarios/walk_findings.h"

namespace amble {

/// Every part that touches something at a frame, with the first object of the scene that it
/// touches; between two frames, where the first of them is free, the part that touches something
/// first. Those of one pair on end are one. Both soles may touch ground at any time, as deep as
/// planted ones. In order of start. A motion that touches nothing costs one check of all of it.
std::vector<ContactSpan> findContacts(const CollisionWorld& world, const PoseArray& poses,
                                      double frame_time);

}  // namespace amble

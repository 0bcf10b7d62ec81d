/// A prepared walk cycle seen in a mirror: left is right, half a period on.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "animation/body/joint_roles.h"
#include "animation/body/skeleton.h"
#include "animation/library/walk_cycle.h"

namespace amble {

/// Nothing is searched or measured again: speed and period are the cycle's, the turn rate is its
/// negative. Pose by pose as mirrorClip does it, so that it works on any rig.
/// @param reference  the library's reference rotations, root against heading first
WalkCycle mirrorCycle(const WalkCycle& cycle, const Skeleton& skeleton, const JointRoles& roles,
                      const std::vector<Eigen::Quaterniond>& reference);

}  // namespace amble

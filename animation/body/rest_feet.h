/// Whether a rig's rest pose shows its feet flat, as FootShape reads them.
#pragma once

#include "animation/body/joint_roles.h"
#include "animation/body/skeleton.h"

namespace amble {

/// How far below the ankle's level the toe joint is seen from there, in the rest pose, of the worse
/// of both feet [rad, 0 to pi / 2]. @pre the roles have toe joints
double restFootDrop(const Skeleton& skeleton, const JointRoles& roles);

/// Flat feet have 20 to 50 degrees. More, and they hang down: little says then which way the sole
/// faces, and it may be read to roll the wrong way [rad].
inline constexpr double kHangingFoot = 1.1;

}  // namespace amble

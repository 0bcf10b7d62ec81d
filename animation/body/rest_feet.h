/// Whether a rig's rest pose shows its feet flat, as FootShape reads them.
#pragma once

#include <array>

#include "animation/body/joint_roles.h"
#include "animation/body/skeleton.h"

namespace amble {

/// How far below the ankle's level the toe joint is seen from there, in the rest pose, of the worse
/// of both feet [rad, 0 to pi / 2]. @pre the roles have toe joints
double restFootDrop(const Skeleton& skeleton, const JointRoles& roles);

/// Flat feet have 20 to 50 degrees. More, and they hang down: little says then which way the sole
/// faces, and it may be read to roll the wrong way [rad].
inline constexpr double kHangingFoot = 1.1;

/// How far below the ankle's level each toe joint lies in the rest pose, by Side [rad, -pi/2 to
/// pi/2]: how a foot stands, as FootShape reads it. @pre toe joints
std::array<double, 2> footDrops(const Skeleton& skeleton, const JointRoles& roles);

/// The same rig with feet of these drops at rest: turned about their ankles, each across the way
/// that it points; toes stay level. @pre no foot points straight up or down
Skeleton withFootDrops(const Skeleton& skeleton, const JointRoles& roles,
                       const std::array<double, 2>& drops);

}  // namespace amble

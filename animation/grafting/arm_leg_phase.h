/// Whether arms swing against the opposite legs.
#pragma once

#include <array>

#include "animation/body/clip.h"
#include "animation/body/joint_roles.h"

namespace amble {

/// By Side of the arm: correlation, over frames [first, last], of how far its hand is before its
/// shoulder with how far the opposite ankle is before the middle of the hips, both along the
/// pelvis' heading [-1 to 1]. Near 1 in a walk with swinging arms; says nothing of arms that do
/// not swing. 0 where one of both does not move at all.
std::array<double, 2> armLegPhase(const Clip& clip, const JointRoles& roles, int first, int last);

}  // namespace amble

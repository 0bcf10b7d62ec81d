/// Toes for rigs whose feet are one bone, so that they can roll as all feet do.
#pragma once

#include <string>

#include "animation/body/clip.h"
#include "animation/body/joint_roles.h"

namespace amble {

/// Every foot has a toe joint afterwards: a child of the foot that is there already; else one that
/// is put where the foot's tip says that its ball is, and never turns. Rigs that have toes stay as
/// they are.
/// @throws InputError naming `file` where a foot has neither toe, child nor tip
void addToes(Clip& clip, JointRoles& roles, const std::string& file);

}  // namespace amble

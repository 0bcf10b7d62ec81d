/// How a captured person begins or ends to walk.
#pragma once

#include <array>
#include <string>

#include "animation/body/clip.h"
#include "animation/body/joint_roles.h"
#include "animation/library/motion_library.h"

namespace amble {

/// The first start of a level clip that stands at first, or its last stop. @param frames  what it
/// was measured over. @throws InputError naming `file` where the clip does not stand and then walk.
Transition fitTransition(const Clip& level, const JointRoles& roles, bool start,
                         const std::string& file, std::array<int, 2>& frames);

}  // namespace amble

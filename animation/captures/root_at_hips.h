/// Rigs with a scene node, a reference or a motion root above the hips, which carry the motion.
#pragma once

#include "animation/body/clip.h"
#include "animation/body/joint_roles.h"

namespace amble {

/// Where joints on the way from the root to the hips move against their parents, as position
/// channels of hips below a root that stands still do, the hips become the root: what is above them
/// is folded into their place in each frame, joints that do not hang on them are left out.
/// @param clip  z up, or in its file's axes with z taken for up. @return whether it was so
bool rootAtHips(Clip& clip, JointRoles& roles);

}  // namespace amble

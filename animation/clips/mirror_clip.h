/// A motion seen in a mirror: left is right.
#pragma once

#include "animation/body/clip.h"
#include "animation/body/joint_roles.h"

namespace amble {

/// World is mirrored in the plane y = 0; every joint then moves as its partner of the other side
/// did. Works on any rig: the mirrored motion is that of a mirrored rig, carried over to the clip's
/// own. @pre no moving joints but the root
Clip mirrorClip(const Clip& clip, const JointRoles& roles);

}  // namespace amble

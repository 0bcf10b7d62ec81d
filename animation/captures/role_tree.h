/// Whose joint is whose by the shape of the skeleton alone, for rigs whose names say nothing.
#pragma once

#include "animation/body/clip.h"
#include "animation/body/joint_roles.h"

namespace amble {

/// Two pairs of twins make a person: limbs of one joint that are alike in shape and length. Legs
/// are the pair nearer to the root, arms the other; in each the two longest bones in a row are
/// thigh and shank, upper arm and forearm. Left is left of where the feet point, or the knees where
/// there are no toes, with the head up: mean over the clip, or the rest pose where it has no
/// frames. No axis and no unit of the file matters. @return -1 in each role that is not found.
JointRoles rolesByTree(const Clip& clip);

}  // namespace amble

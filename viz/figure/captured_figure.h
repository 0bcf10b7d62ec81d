/// The figure of whoever a capture is of.
#pragma once

#include "animation/body/clip.h"
#include "animation/body/joint_roles.h"
#include "viz/figure/figure.h"

namespace amble {

/// makeFigure() of the capture's body, or bones where no person is known. @pre the clip has frames
Figure capturedFigure(const Clip& clip, const JointRoles& roles);

}  // namespace amble

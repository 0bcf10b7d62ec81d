/// The pelvis of a rig of any kind: where it faces and where it is, told by its hip joints.
#pragma once

#include <span>
#include <vector>

#include "animation/body/clip.h"
#include "animation/body/joint_roles.h"

namespace amble {

/// Which way the pelvis faces: across the line between the hip joints [rad].
double pelvisHeading(std::span<const JointFrame> joints, const JointRoles& roles);

/// Heading of the pelvis at each frame, across the line of the hip joints, without jumps [rad].
std::vector<double> pelvisHeadings(const Clip& clip, const JointRoles& roles);

/// Middle of the two hip joints at each frame [m, World].
std::vector<Eigen::Vector3d> pelvisPath(const Clip& clip, const JointRoles& roles);

}  // namespace amble

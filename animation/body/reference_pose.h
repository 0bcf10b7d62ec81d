/// A pose in which a rig is upright and faces ahead: what two rigs are compared in, and where their
/// knees' axes are read.
#pragma once

#include <array>
#include <vector>

#include "animation/body/clip.h"
#include "animation/body/joint_roles.h"

namespace amble {

/// The mean pose of a clip, feet and toes from the times at which they stand, where there are such.
/// @pre clip in World
ReferencePose meanPose(const Clip& clip, const JointRoles& roles);
/// The rig's rest pose where somebody stands in it; else (rigs whose joints all point along their
/// bones) the mean pose of the clip, feet from the times at which they stand. @pre clip in World
ReferencePose referenceOf(const Clip& clip, const JointRoles& roles);
/// The rest pose where somebody stands in it, else that of a standing posture.
ReferencePose referenceOf(const Skeleton& skeleton, const JointRoles& roles,
                          const std::vector<Eigen::Quaterniond>& stand);
/// Axes about which the knees bend, in the thighs' joint frames, by Side: left in the reference.
std::array<Eigen::Vector3d, 2> kneeAxes(const JointRoles& roles, const ReferencePose& reference);

/// Frames of the joints in such a pose, the root at the origin, in the heading frame.
std::vector<JointFrame> posed(const Skeleton& skeleton,
                              const std::vector<Eigen::Quaterniond>& q_HJ);
/// Mean length of thigh and shank together, of both legs [m].
double legOf(const Skeleton& skeleton, const JointRoles& roles);

}  // namespace amble

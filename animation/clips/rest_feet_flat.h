/// Feet that hang down in a rig's rest pose, seen flat there as they are where somebody stands.
#pragma once

#include <optional>
#include <vector>

#include "animation/body/clip.h"
#include "animation/body/joint_roles.h"

namespace amble {

/// The same motion with other joint frames: q_WJ becomes q_WJ * turns[j], and every joint and tip
/// stays where it is. @pre one turn a joint [unit], the root's the identity
Clip withTurnedFrames(const Clip& clip, const std::vector<Eigen::Quaterniond>& turns);

/// How far below the ankle's level the toe joint is seen from there while feet stand: the median
/// over both feet [rad, -pi/2 to pi/2]. None where no foot ever stands. @pre clip level, toe joints
std::optional<double> standingFootDrop(const Clip& clip, const JointRoles& roles);

/// Where the feet hang down in the rest pose (rest_feet.h), the joints point along their bones, and
/// nobody stands as it shows. Frames of feet and toes are turned about the hips' line, so that at
/// rest ankles are over the toe joints as they are while they stand, and toes level: flat, as
/// FootShape reads them. Both feet are of one drop, and the rig says how they roll and turn: single
/// stances of a capture are off by ten degrees in each. Frames of arms and hands are turned about
/// their bones, as they are twisted in the clip's mean pose. Joints and tips stay where they are.
/// @return whether that was so: feet hang, and stand in the clip. @pre clip level, toe joints
bool restFeetFlat(Clip& clip, const JointRoles& roles);

}  // namespace amble

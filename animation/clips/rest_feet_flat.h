/// Feet that a rig's rest pose shows flat as they are where somebody stands, whatever it showed.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "animation/body/clip.h"
#include "animation/body/joint_roles.h"

namespace amble {

/// The same motion with other joint frames: q_WJ becomes q_WJ * turns[j], and every joint and tip
/// stays where it is. @pre one turn a joint [unit], the root's the identity
Clip withTurnedFrames(const Clip& clip, const std::vector<Eigen::Quaterniond>& turns);

/// How far below the ankle's level the toe joint is seen from there while feet stand: the median of
/// each foot, by Side [rad, -pi/2 to pi/2]; a foot that never stands is as the other. None where no
/// foot does. @pre clip level, toe joints
std::optional<std::array<double, 2>> standingFootDrops(const Clip& clip, const JointRoles& roles);

/// The same motion of a rig whose feet drop by so much at rest, and whose toes are level there
/// (footDrops). Joints and tips stay where they are. @pre toe joints
Clip withFeetAtRest(const Clip& clip, const JointRoles& roles, const std::array<double, 2>& drops);

/// Feet are flat at rest as they stand in the clip: each foot has a sole of its own, for markers
/// tilt the left and the right foot of one person by up to ten degrees differently, and a foot that
/// stands as its rig says instead is seen to be bent by that. Frames of feet and toes are turned so
/// that at rest ankles are over the toe joints as they are while they stand, and toes level: flat,
/// as FootShape reads them. How they roll and turn the rig says: single stances of a capture are
/// off by ten degrees in each. Where the feet hang down in the rest pose (rest_feet.h), joints
/// point along their bones, and nobody stands as it shows: frames of arms and hands are then turned
/// about their bones, as they are twisted in the clip's mean pose. Joints and tips stay where they
/// are.
/// @return whether anything was turned: feet stand in the clip, and otherwise than at rest.
/// @pre clip level, toe joints
bool restFeetFlat(Clip& clip, const JointRoles& roles);

}  // namespace amble

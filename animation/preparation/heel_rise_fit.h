/// How far heels rise before the toes leave: as far as legs that bend as captured need it.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <vector>

#include "animation/body/foot_shape.h"
#include "animation/body/joint_roles.h"
#include "animation/body/skeleton.h"
#include "animation/library/walk_cycle.h"

namespace amble {

/// Captured feet slide on before they leave, ours stay, and behind hips that are as captured the
/// leg would be straighter. So the pitch of both feet around lift-off becomes the one at which
/// knees bend as captured, as near to the captured pitch and as smooth as may be (least squares
/// over the cycle), and swings are fitted anew to the captured ankle. Of a walk whose series, feet
/// and prints are known, straight on or around a circle.
/// @param reference  the rotations that the series is against
void fitHeelRise(const Skeleton& skeleton, const JointRoles& roles,
                 const std::array<FootShape, 2>& shapes,
                 const std::vector<Eigen::Quaterniond>& reference, WalkCycle& cycle);

}  // namespace amble

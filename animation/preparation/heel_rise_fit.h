/// How heels rise, toes roll and feet swing, and where prints lie, so that legs bend as captured.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <vector>

#include "animation/body/foot_shape.h"
#include "animation/body/joint_roles.h"
#include "animation/body/skeleton.h"
#include "animation/library/walk_cycle.h"

namespace amble {

/// Captured feet slide as they land and before they leave, sink into floors and swing through them;
/// ours stay, and legs between captured hips and such feet would bend otherwise than captured. What
/// that costs is shared: least squares over the cycle of both legs, of knees, ankles and of how far
/// legs go forward from the hip, as made of the pitches of the feet, of how far they roll over the
/// tips of their toes before they leave, of the swings' ways, of the prints' way forward and of the
/// pelvis', which goes by up to four waves a cycle, some millimetres, beside its captured way
/// (along the path and up, its mean where it was); all as near to what was captured and as smooth
/// as may be. Captured is the mean cycle: the series, which says how feet are pitched, too. Legs
/// that would be too long there are bent, and their heels risen, as they are in a walk
/// (raisedPitch), all as long as legs that bear may be. Gauss and Newton, half a step at a time. Of
/// a walk whose series, feet and prints are known, straight on or around a circle. Costs some tens
/// of milliseconds.
/// @param reference  the rotations that the series is against
void fitHeelRise(const Skeleton& skeleton, const JointRoles& roles,
                 const std::array<FootShape, 2>& shapes,
                 const std::vector<Eigen::Quaterniond>& reference, WalkCycle& cycle);

}  // namespace amble

/// A motion carried over to another skeleton, by joint role and leg length.
///
/// Every joint with a role turns in World as its counterpart does, but for a fixed rotation that
/// brings two reference poses together: both upright and facing the same way, each bone of the
/// target along its counterpart. The root moves as far as the legs are long: with the ratio of leg
/// lengths. Joints without a role keep their rotation of the target's reference.
#pragma once

#include <array>
#include <vector>

#include "animation/body/clip.h"
#include "animation/body/joint_roles.h"

namespace amble {

/// A pose of a rig in which it is upright, seen from its heading (x forward, y left, z up).
struct ReferencePose {
  std::vector<Eigen::Quaterniond> q_HJ;  ///< of each joint in the heading frame
};

/// The rig's rest pose where somebody stands in it; else (rigs whose joints all point along their
/// bones) the mean pose of the clip, feet from the times at which they stand. @pre clip in World
ReferencePose referenceOf(const Clip& clip, const JointRoles& roles);
/// The rest pose where somebody stands in it, else that of a standing posture.
ReferencePose referenceOf(const Skeleton& skeleton, const JointRoles& roles,
                          const std::vector<Eigen::Quaterniond>& stand);
/// Axes about which the knees bend, in the thighs' joint frames, by Side: left in the reference.
std::array<Eigen::Vector3d, 2> kneeAxes(const JointRoles& roles, const ReferencePose& reference);

/// A rig with its roles and reference; a view.
struct UprightRig {
  const Skeleton& skeleton;
  const JointRoles& roles;
  const ReferencePose& reference;
};

/// The clip, of rig `from`, on the skeleton of rig `to`. Feet come out at the height that the
/// target's proportions give: fit the floor again. @pre roles as guessJointRoles requires them, and
/// toes; no moving joints but the root
Clip carriedOver(const Clip& clip, const UprightRig& from, const UprightRig& to);

}  // namespace amble

/// A motion carried over to another skeleton, by joint role and leg length.
///
/// Every joint with a role turns in World as its counterpart does, but for a fixed rotation that
/// brings two reference poses together: both upright and facing the same way, each bone of the
/// target along its counterpart. The root moves as far as the legs are long: with the ratio of leg
/// lengths. Joints without a role keep their rotation of the target's reference.
#pragma once

#include "animation/body/clip.h"
#include "animation/body/joint_roles.h"
#include "animation/body/reference_pose.h"

namespace amble {

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

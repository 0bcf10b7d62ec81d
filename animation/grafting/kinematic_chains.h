/// Independent kinematic chains of a hierarchy (Shanbhag's thesis, §5.1.2 and §5.2): the lists of
/// joints between a leaf and the joint where the tree branches, or between two such joints.
///
/// Any hierarchy has them; the joints' roles only name them. The thesis' lists share the joints at
/// which they meet; here a joint is of one chain, that which ends with it, since its turn moves all
/// chains that hang on it alike.
#pragma once

#include <string>
#include <vector>

#include "animation/body/joint_roles.h"

namespace amble {

struct KinematicChain {
  /// `left_arm`, `right_arm`, `head`, `trunk`, `left_leg`, `right_leg`, `root`; of others (fingers,
  /// tails) the first joint's name.
  std::string name;
  std::string limb;   ///< the name of these that it is a part of (fingers: of their arm), or ""
  int hangs_on = -1;  ///< the joint above its first one; -1 for the root's
  std::vector<int> joints;  ///< from there outwards [>= 1]
};

/// Every joint is in one of them; in the order of their first joints.
std::vector<KinematicChain> kinematicChains(const Skeleton& skeleton, const JointRoles& roles);

/// Root, hips and legs: whatever the legs hang on, and what hangs on them. One value a joint.
std::vector<bool> lowerBody(const Skeleton& skeleton, const JointRoles& roles);

/// `upper`, all that is not the lower body; the limbs that the rig has; other chains' names.
std::vector<std::string> graftableChains(const Skeleton& skeleton, const JointRoles& roles);

/// The joints of some of these: of a limb all that hangs on it too (an arm has its fingers). In the
/// skeleton's order. @throws InputError naming `file` for a name that is none of them
std::vector<int> graftedJoints(const Skeleton& skeleton, const JointRoles& roles,
                               const std::vector<std::string>& chains, const std::string& file);

}  // namespace amble

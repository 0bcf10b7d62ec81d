/// Whose joint is whose: the joints that walking needs, by role, in any rig.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "animation/body/skeleton.h"

namespace amble {

/// Left first, so that `legs[kLeft]` reads well.
enum Side : int { kLeft = 0, kRight = 1 };
constexpr Side other(Side side) { return side == kLeft ? kRight : kLeft; }

struct LegJoints {
  int up_leg = -1;  ///< hip joint
  int leg = -1;     ///< knee
  int foot = -1;    ///< ankle
  int toe = -1;     ///< ball of the foot; -1 where the rig has none
};

struct ArmJoints {
  int shoulder = -1;  ///< clavicle; -1 where the rig has none
  int arm = -1;       ///< shoulder joint
  int fore_arm = -1;  ///< elbow
  int hand = -1;      ///< wrist; -1 where the rig has none
};

struct JointRoles {
  int hips = 0;
  int spine = -1;  ///< first joint of the trunk above the hips
  int chest = -1;  ///< the joint that neck and arms hang on
  int neck = -1;
  int head = -1;
  std::array<LegJoints, 2> legs;  ///< by Side
  std::array<ArmJoints, 2> arms;  ///< by Side

  double legLength(const Skeleton& skeleton, Side side) const;  ///< thigh + shank [m]
  double meanLeg(const Skeleton& skeleton) const;               ///< of both sides [m]
};

/// Guessed from names of the common rigs (MotionBuilder, 3ds Max Biped, Daz, Acclaim, Mixamo,
/// Rokoko, H-Anim, VRM, Unreal, OptiTrack, SMPL, Kinect, Auto-Rig Pro).
/// @throws InputError naming `file` and the first role for which no joint was found (hips, both
/// legs, both arms, head).
JointRoles guessJointRoles(const Skeleton& skeleton, const std::string& file);
/// The same without the refusal: -1 where no name fits. @pre the skeleton has joints.
JointRoles rolesByName(const Skeleton& skeleton);
/// The first role that a person cannot do without (as above) and has no joint; "" where all have.
std::string missingRole(const JointRoles& roles);

/// Role names as a motion library's `joints:` writes them (`hips`, `left_up_leg`, ... ,
/// `right_hand`), and the joint index of each. `setRole` returns false where the name is no role.
bool setRole(JointRoles& roles, std::string_view role, int joint);
/// -1 where the role is empty or unknown.
int roleJoint(const JointRoles& roles, std::string_view role);
/// Every role's name, hips first.
const std::vector<std::string>& roleNames();

/// The unit a capture was written in, from its leg length: the candidate (m, cm, inch, CMU's
/// 0.056444 m, mm) that makes thigh + shank nearest to 0.83 m. @return metres per unit
double guessUnit(const Skeleton& skeleton_in_file_units, const JointRoles& roles);

}  // namespace amble

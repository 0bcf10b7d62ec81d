/// Feet that stand while one motion is mixed into another (Shanbhag's thesis, §4.3.1): in each of
/// the four cases of a contact [k, l] against the blend's interval the foot goes along the way of
/// one of the motions, or from the one's to the other's.
///
/// The leg is solved by inverse kinematics towards that foot, place and turn. Between contacts what
/// was corrected fades over the rest of the blend, and over kHoldFade at least, where the foot is
/// off the ground for so long.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "animation/body/clip.h"
#include "animation/body/joint_roles.h"

namespace amble {

/// By Side: whether the foot stands, one value a frame.
using PlantedFrames = std::array<std::vector<bool>, 2>;

/// The thesis' cases, by its numbers.
enum class ContactCase {
  kBefore = 1,  ///< it stands as the blend begins: along the way of the motion before
  kAfter = 2,   ///< it stands as the blend ends: along the way of the motion after
  kWithin = 3,  ///< it strikes and leaves within the blend: along the way of the nearer one
  kSlips = 4,   ///< it stands throughout: from the one's place to the other's
};

struct FootHold {
  Side side = kLeft;
  ContactCase which = ContactCase::kBefore;
  int first = 0, last = 0;  ///< frames; of the blend's, the first of which is 0, or of the motion's
  /// How far off the way that it was to go the toe came to be at most, along the ground [m]; where
  /// it slips, how far that takes it.
  double slip = 0.0;
};

/// A foot at a frame [World].
struct FootFrame {
  JointFrame joint;
  Eigen::Vector3d toe =
      Eigen::Vector3d::Zero();  ///< its toe joint, or its joint where there is none
};
/// By Side.
using FootFrames = std::array<FootFrame, 2>;
FootFrame footFrame(std::span<const JointFrame> joints, const LegJoints& leg);

/// The contacts of a foot over a blend of `before.size()` frames. @param before  whether it stands
/// in the motion before, one value for each frame of the blend @param after  the same
/// @param gap  shorter times off the ground are none [frames]
std::vector<FootHold> contactsOf(Side side, const std::vector<bool>& before,
                                 const std::vector<bool>& after, int gap);

/// A blend in a clip.
struct BlendFeet {
  int first = 0;                         ///< frame of the clip that is the first of the blend
  std::span<const FootFrames> before;    ///< where the motion before has its feet, a frame each
  std::span<const FootFrames> after;     ///< the motion after
  std::array<Eigen::Vector3d, 2> knees;  ///< knees' axes (reference_pose.h)
};

/// Over about so long a correction fades [s]: by trial, a third of a swing.
inline constexpr double kHoldFade = 0.15;

/// Moves the feet of the clip as `holds` say and writes their slips. @param planted  the clip's:
/// feet that stand outside of the blend stay @pre holds of the blend, in order of time by side
void holdFeet(Clip& clip, const JointRoles& roles, const PlantedFrames& planted,
              const BlendFeet& blend, std::vector<FootHold>& holds);

}  // namespace amble

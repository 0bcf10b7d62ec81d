/// Arms that are in the body brought out of it, by as little as does it.
#pragma once

#include <array>

#include "animation/body/clip.h"
#include "animation/body/joint_roles.h"
#include "environments/collision/arm_depths.h"

namespace amble {

struct ArmClearing {
  std::array<double, 2> turned = {0, 0};  ///< most that an arm was turned, by Side [rad]
  std::array<int, 2> frames = {0, 0};     ///< in which it was turned, by Side
};

/// An arm that is deeper than allowed within frames [first, last] turns in its shoulder joint,
/// outwards, forwards or half of both, as the pelvis sees it, whichever does with the least: by
/// one smooth curve over the frames, at each no less than the smallest angle at which no pair of
/// the arm is deeper than allowed. The curve begins and ends within kSmoothOver of the frames that
/// need it. Frames for which kMostTurned does not do stay in the way as far as that leaves them.
/// @param allowed  by pair of armPairs() [m, >= 0]
ArmClearing clearArms(const Body& body, const JointRoles& roles, const Eigen::VectorXd& allowed,
                      int first, int last, Clip& clip);

inline constexpr double kSmoothOver = 0.3;  ///< an arm makes way so long before it must [s]
/// Farther is another movement; by trial [rad].
inline constexpr double kMostTurned = 0.7;
/// Capsules are no skin: as deep as this beyond what is allowed is nothing to see [m].
inline constexpr double kDepthTolerance = 0.005;

}  // namespace amble

/// What is likely wrong in a capture, for its reader to warn of: a root that jumps, noise, walking
/// on the spot, a frame time that makes nobody's cadence.
#pragma once

#include <string>
#include <vector>

#include "animation/body/clip.h"
#include "animation/body/joint_roles.h"

namespace amble {

struct RootJump {
  int frame = 0;          ///< the last before it
  double distance = 0.0;  ///< [m]
};

/// Where the root goes farther between two frames than a person can, and far more than about it.
/// @param clip  metres
std::vector<RootJump> rootJumps(const Clip& clip);

/// Deviation of the joints' turns by noise that is another in each frame: that of the middle joint,
/// an axis [rad]. Of movement, however fast, it is next to none. 0 for fewer than 4 frames.
double jointJitter(const Clip& clip);
/// More of it is noise; by trial [rad].
inline constexpr double kNoisy = 0.0157;

/// For people, one a line. @param clip  World, metres. @pre the roles are a person's
std::vector<std::string> captureWarnings(const Clip& clip, const JointRoles& roles);

}  // namespace amble

/// How a person steps, told without units of length: for readers that do not know theirs yet, or
/// doubt the file's frame time.
#pragma once

#include "animation/body/clip.h"
#include "animation/body/joint_roles.h"

namespace amble {

struct StepRhythm {
  int steps = 0;            ///< the feet pass one another so often; few say nothing [>= 0]
  double cadence = 0.0;     ///< [steps/s]; 0 where there are no two steps
  double least_step = 0.0;  ///< shortest time of a step; 0 as above [s]
  double speed = 0.0;       ///< of the pelvis, along its path while it steps [leg lengths/s]
  /// Of the pelvis over the lower foot, forwards: on the spot it is that of the ground below
  /// [leg lengths/s].
  double ground_speed = 0.0;
};

/// Slower is a shuffle or a sway from foot to foot, whose cadence may be any. [leg lengths/s]
inline constexpr double kWalkingSpeed = 0.4;

/// @param clip  z up, any unit. @pre the roles are a person's
StepRhythm stepRhythm(const Clip& clip, const JointRoles& roles);

/// Cadence over that which people of such legs have at such a speed [1]: Inman's f = 0.743 sqrt(V),
/// V in leg lengths a second (Glardon et al., eq. 4), with the leg's own pendulum against an
/// adult's. A frame time that is k times too short makes it sqrt(k). 0 where they do not move.
/// @param leg  thigh and shank [m, > 0]
double cadenceOverUsual(const StepRhythm& rhythm, double leg);

}  // namespace amble

/// What a step measures, whoever walks it: a capture, a walk of ours in poses, or one that was
/// exported.
///
/// Stride, lift and climb are those of GaitParameters (steps/gait_parameters.h). Whoever measures
/// says where soles are; what is made of that is written here, once.
#pragma once

#include <Eigen/Core>

#include "animation/body/joint_roles.h"

namespace amble {

/// One step: a foot leaves its print and lands before the other one's. What was not seen, or what a
/// measure does not look at, is 0.
struct StepMeasure {
  Side side = kLeft;                             ///< of the foot that lands
  double strike = 0.0;                           ///< when it lands, by the clip's clock [s, >= 0]
  double lift_off = 0.0;                         ///< when it leaves this print again [s, >= strike]
  double duration = 0.0;                         ///< since the other foot's strike [s, >= 0]
  Eigen::Vector3d at = Eigen::Vector3d::Zero();  ///< the print [m, World]
  /// From the other foot's print to this one, along the way: what both papers call stride and gait
  /// analysis step length [m].
  double stride = 0.0;
  double width = 0.0;  ///< across it, positive where feet do not cross [m]
  /// Highest rise of the sole, at its lowest point, over the line from the foot's last print to
  /// this one [m, >= 0].
  double lift = 0.0;
  double climb = 0.0;           ///< of this print over the other foot's [m]
  double two_steps = 0.0;       ///< from the foot's last print to this one, in plan [m, >= 0]
  double slide = 0.0;           ///< largest drift of the sole on this print [m, >= 0]
  double tilt = 0.0;            ///< between the sole's and the ground's normal there [rad, 0 to pi]
  double supported = 0.0;       ///< share of the sole's length that has ground below it [0, 1]
  double toe_clearance = 0.0;   ///< least rise of the toe in the middle of the swing [m, >= 0]
  double speed = 0.0;           ///< of the pelvis, from strike to strike [m/s, >= 0]
  double turn_rate = 0.0;       ///< of the pelvis' heading, mean, left positive [rad/s]
  double double_support = 0.0;  ///< share of the step with both feet planted [0, 1]
};

}  // namespace amble

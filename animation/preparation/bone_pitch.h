/// How a foot is pitched, read off the bone from its ankle to its toe joint rather than off its
/// frame, which markers roll by up to 30 degrees: so it is pitched as it is seen to roll.
#pragma once

#include <Eigen/Geometry>

#include "animation/body/foot_shape.h"

namespace amble {

/// How far that bone goes down as seen from beside a heading [rad]. @param bone  in World
double seenDown(const Eigen::Vector3d& bone, double heading);

/// The same of a sole that lies flat [rad].
double flatDrop(const FootShape& shape);

/// The pitch at which the bone is seen to go down by so much, of a foot that is turned from the
/// heading and rolled so [rad].
double pitchOfBone(double down, double yaw, double roll, const FootShape& shape);

}  // namespace amble

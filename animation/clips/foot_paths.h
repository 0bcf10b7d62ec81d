/// Where the two joints of each foot that tell of plants are: ankle and toe, over a whole clip.
#pragma once

#include <Eigen/Core>
#include <array>

#include "animation/body/clip.h"
#include "animation/body/joint_roles.h"

namespace amble {

/// By Side: a row a frame, columns ankle x y z, toe x y z [m, World]. Where the rig has no toe
/// joint its place is taken by the tip of the foot joint, or by the ankle.
using FootPaths = std::array<Eigen::MatrixXd, 2>;

/// One forward kinematics a frame.
FootPaths footPaths(const Clip& clip, const JointRoles& roles);

/// Whether ankle and toe are slower than 0.3 leg lengths a second about a frame: walking feet swing
/// at four; found by trial. @pre a frame before and one after; leg's length [m], frame time [s]
bool stands(const Eigen::MatrixXd& path, Eigen::Index frame, double leg, double frame_time);

/// Leg lengths by Side [m].
std::array<double, 2> legLengths(const Clip& clip, const JointRoles& roles);

}  // namespace amble

/// The pose in which the figure is modelled: upright, arms and legs apart, so that nothing that
/// only lies against something else runs into it.
#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

#include "animation/body/joint_roles.h"
#include "animation/body/skeleton.h"
#include "environments/body/body.h"

namespace amble {

/// Index of the part of that name, or -1.
int findPart(const Body& body, const std::string& name);
/// "left thigh" of kLeft and "thigh".
int findPart(const Body& body, Side side, const std::string& name);

/// Whether it has all the parts that makeBody() makes.
bool isPerson(const Body& body);

/// X_WJ by joint: z up, facing +x, the root at the origin. From the pose in which the body was
/// shaped: arms are raised to 45 degrees, legs straightened and put apart, soles level; twists are
/// kept. Of a body that has not all the parts of makeBody()'s it is that pose itself.
std::vector<JointFrame> modelPose(const Skeleton& skeleton, const Body& body);

}  // namespace amble

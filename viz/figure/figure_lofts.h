/// The lofts of a figure: a body's parts, given the shape of a person in plain clothes.
#pragma once

#include <span>
#include <vector>

#include "animation/body/pose.h"
#include "environments/body/body.h"
#include "viz/figure/loft.h"

namespace amble {

/// How large somebody of this head is beside the survey's mean man (environments/body/body.cpp), or
/// 0 without a head [> 0].
double sizeOf(const Body& body);

/// In the pose that `frames` are, as modelPose() makes it. Parts that makeBody() does not make are
/// capsules.
std::vector<LoftGroup> figureLofts(const Body& body, std::span<const JointFrame> frames);

}  // namespace amble

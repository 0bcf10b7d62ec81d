/// What the steps of an animated walk measure, from its poses, beside what they were asked to be.
#pragma once

#include <array>
#include <vector>

#include "animation/body/foot_shape.h"
#include "animation/body/skeleton.h"
#include "animation/body/step_measure.h"
#include "animation/ground/ground.h"
#include "animation/synthesis/animation_buffer.h"

namespace amble {

/// What a step was asked to be, and what it came to.
struct JudgedStep {
  GaitParameters asked;
  StepMeasure achieved;
};

/// Of every footprint that a foot swings to within the buffer: stride, lift, climb, tilt and
/// support, where the sole lies flattest in the middle of its stance. @param feet  by Side
std::vector<JudgedStep> measureWalkSteps(const Skeleton& skeleton, const JointRoles& roles,
                                         const std::array<FootShape, 2>& feet,
                                         const AnimationBuffer& walk, const Ground& ground);

/// The largest share by which a parameter misses what was asked, over all steps; what is asked to
/// be less than 2 cm is compared with 2 cm [1, >= 0].
GaitParameters largestMiss(const std::vector<JudgedStep>& steps);

}  // namespace amble

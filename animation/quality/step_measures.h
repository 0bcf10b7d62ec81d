/// What the steps of an animated walk measure, from its poses, beside what they were asked to be.
#pragma once

#include <array>
#include <vector>

#include "animation/body/foot_shape.h"
#include "animation/body/skeleton.h"
#include "animation/ground/ground.h"
#include "animation/synthesis/animation_buffer.h"

namespace amble {

/// One step: from the foot's last print to the one it lands on.
struct StepMeasure {
  Side side = kLeft;
  int frame = 0;  ///< in the middle of its stance
  GaitParameters asked;
  GaitParameters achieved;
  double tilt = 0.0;       ///< between the sole's and the ground's normal at that frame [rad]
  double supported = 1.0;  ///< share of the sole's length with ground within 12 mm below [0, 1]
};

/// Of every footprint that a foot swings to within the buffer. @param feet  by Side
std::vector<StepMeasure> measureWalkSteps(const Skeleton& skeleton, const JointRoles& roles,
                                          const std::array<FootShape, 2>& feet,
                                          const AnimationBuffer& walk, const Ground& ground);

/// The largest share by which a parameter misses what was asked, over all steps; what is asked to
/// be less than 2 cm is compared with 2 cm [1].
GaitParameters largestMiss(const std::vector<StepMeasure>& steps);

}  // namespace amble

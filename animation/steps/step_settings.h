/// What a character's steps depend on beside the ground, and what is found of them everywhere.
#pragma once

#include <algorithm>
#include <array>

#include "animation/steps/foothold.h"
#include "animation/steps/footsteps.h"
#include "animation/steps/speed_profile.h"
#include "animation/steps/unevenness.h"
#include "animation/steps/walk_rule.h"

namespace amble {

struct StepSettings {
  FootPlacement placement;  ///< at the plan's speed on the level
  SpeedLimits limits;       ///< with the character's law
  GroundLimits footholds;
  double scale = 1.0;  ///< of the character to the captured subject [> 0]
  std::array<double, 2> captured_lift = {0.05, 0.05};  ///< by Side [m, > 0]

  /// How far over or under a foot its next ground may lie [m].
  double reach() const { return footholds.highestStep() + Unevenness::kLevel; }
};

}  // namespace amble

/// The feet of a stance on its ground: where they stand there, and how high the root path is.
#pragma once

#include <array>

#include "animation/steps/stance.h"
#include "animation/steps/step_settings.h"
#include "animation/steps/swing_cycles.h"

namespace amble {

struct StanceFeet {
  WalkRule refused = WalkRule::kNone;
  FootPlacement placement;        ///< of its own pace and its slope's
  std::array<FootPlace, 2> feet;  ///< by Side
  double height = 0.0;            ///< of the root path there [m, World]
  double rise = 0.0;              ///< of a walking stance's front foot over its rear one [m]
  bool level = true;              ///< both on level ground at the stance's own height
};

/// Where a whole sole of either foot stands; refused where one does not, or one stands higher.
StanceFeet findStanceFeet(const StepSettings& settings, const FootholdFinder& holds,
                          const SwingCycles& cycles, const Stance& stance);

/// Rise per metre of the ground between the places where a walking stance's feet would be [1, up
/// positive]; 0 where there is none.
double slopeUnder(const StepSettings& settings, const FootholdFinder& holds, const Stance& stance);

/// The rule that a foothold's refusal breaks.
WalkRule ruleOf(Foothold::Refusal refusal);

/// Whether a foot stands on level ground at a height, but for rugs (Unevenness::kLevel).
bool onLevel(const FootPlace& place, double height);

}  // namespace amble

/// Which rule refused a walk (DESIGN.md, section 3, stage 2, limits, and stage 3, animation). The
/// names are what reports count.
#pragma once

#include <string_view>

namespace amble {

enum class WalkRule {
  kNone,        ///< nothing refused
  kStepLength,  ///< no whole number of steps within the library's stride range fits the length of
                ///< the path
  kTurnRate,    ///< turns faster than the library's walks, or, at a walking stance, than the plan's
                ///< speed allows
  kReach,       ///< a leg cannot reach its footprint
  kNoGround,    ///< no ground under a footprint
  kFoothold,    ///< no place within reach where a whole sole stands on one surface
  kSlope,       ///< steeper than the character walks
  kStepHeight,  ///< a step up, down or over that is higher than the character takes
};
std::string_view walkRuleName(WalkRule rule);  ///< "step_length", "turn_rate", ...; "none"

}  // namespace amble

/// Which rule refused a walk (DESIGN.md, section 3, stage 2, limits, and stage 3, animation). The
/// names are what reports count.
#pragma once

#include <string_view>

namespace amble {

enum class WalkRule {
  /// Nothing refused.
  kNone,
  /// No whole number of steps within the library's stride range fits the length of the path.
  kStepLength,
  /// Turns faster than the library's walks, or, at a walking stance, than the plan's speed allows.
  kTurnRate,
  /// A leg cannot reach its footprint.
  kReach,
  /// No ground under a footprint.
  kNoGround,
  /// No place within reach where a whole sole stands on one surface.
  kFoothold,
  /// Steeper than the character walks.
  kSlope,
  /// A step up, down or over that is higher than the character takes.
  kStepHeight,
};
std::string_view walkRuleName(WalkRule rule);  ///< "step_length", "turn_rate", ...; "none"

}  // namespace amble

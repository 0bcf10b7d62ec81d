/// Which rule refused a walk, of all four stages (DESIGN.md, section 3). The names are what reports
/// count.
#pragma once

#include <string_view>

namespace amble {

enum class WalkRule {
  /// Nothing refused.
  kNone,
  /// Stage 1, root path: none leads from the one stance to the other.
  kNoCurve,
  /// No root path at all: things shut the body off.
  kDisconnected,
  /// A root path that would leave the bounds.
  kBounds,
  /// Stage 2, limits: no whole number of steps within the library's stride range fits the length of
  /// the path.
  kStepLength,
  /// Turns faster than the library's walks, or, at a walking stance, than the plan's speed allows.
  kTurnRate,
  /// Stage 3, animation: a leg cannot reach its footprint.
  kReach,
  /// No ground under a footprint.
  kNoGround,
  /// No place within reach where a whole sole stands on one surface.
  kFoothold,
  /// Steeper than the character walks.
  kSlope,
  /// A step up, down or over that is higher than the character takes.
  kStepHeight,
  /// Stage 4, validation: the body touches something, or nearly.
  kContact,
};
inline constexpr int kWalkRules = static_cast<int>(WalkRule::kContact) + 1;
std::string_view walkRuleName(WalkRule rule);  ///< "step_length", "turn_rate", ...; "none"

}  // namespace amble

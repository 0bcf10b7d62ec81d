/// How far legs are stretched, as shares of thigh and shank together, and how hips give way where a
/// leg would have to be longer.
#pragma once

#include <array>

namespace amble {

/// Distances from hip to ankle, as shares of the leg's length [1]. The knee's angle goes with the
/// square root of what is missing to 1: at 0.998 it is bent by 7 degrees, at 0.9999 by 1.6.
struct LegReach {
  /// A leg may be as long as the captured one is at that moment, and as this. Higher, and knees
  /// snap where steps and slopes stretch them; lower, and people walk over rubble crouching. By
  /// trial.
  static constexpr double kStraight = 0.998;
  /// No leg is longer: captured ones are straight at times, but over a straight knee the hip does
  /// not move without the foot.
  static constexpr double kLongest = 0.99988;
  /// A leg stretched farther is refused (WalkRule::kReach).
  static constexpr double kRefused = 0.9999;
};

/// How hips give way where a leg would be longer than it may. By trial.
struct HipDip {
  /// What is missing at a frame lowers the hips so long before and after: shorter shows as a jolt,
  /// longer lowers steps that need it not [s].
  static constexpr double kTime = 0.25;
  static constexpr double kDeepest = 0.15;  ///< deeper is refused: it looks like a stumble [m]
  /// Between a stance, which stays as it is, and a dip beside it hips sink and rise within so long,
  /// of these the time in which they jolt least [s].
  static constexpr std::array<double, 7> kFades = {0.3, 0.2, 0.133, 0.089, 0.059, 0.03, 0.015};
  static constexpr double kAtOnce = 0.004;  ///< beside a stance, more in a frame is a jolt [m]
  /// Hips that are lower at a stance come back within so long [s].
  static constexpr double kRecovery = 0.6;
};

}  // namespace amble

/// How far legs are stretched, as shares of thigh and shank together, and how hips give way where a
/// leg would have to be longer.
#pragma once

#include <algorithm>
#include <array>

#include "base/ease.h"

namespace amble {

/// How little a leg bears: 0 from strike until shortly before lift-off, 1 while its foot swings on,
/// 0 again shortly before the next strike [0, 1]. @param at  FootState::at
inline double unloaded(double at) {
  constexpr double kFrom = 0.95, kBy = 1.1, kUntil = 1.5, kAgainBy = 1.9;  // by trial
  if (at <= kFrom || at >= kAgainBy) return 0.0;
  return smoothstep((at - kFrom) / (kBy - kFrom)) *
         smoothstep((kAgainBy - at) / (kAgainBy - kUntil));
}

/// Distances from hip to ankle, as shares of the leg's length [1]. The knee's angle goes with the
/// square root of what is missing to 1: at 0.998 it is bent by 7 degrees, at 0.9999 by 1.6.
struct LegReach {
  /// A leg may be as long as the captured one is at that moment, and as this. Higher, and knees
  /// snap where steps and slopes stretch them; lower, and people walk over rubble crouching. By
  /// trial.
  static constexpr double kStraight = 0.998;
  /// The same of a leg that does not bear (unloaded). A foot that has left the ground goes on fast:
  /// where that begins over a knee all but straight, as up stairs, where feet first go up, the knee
  /// snaps and the foot with it. By trial: lower, and hips sink at more long steps.
  static constexpr double kSwinging = 0.985;
  /// No leg is longer: captured ones are straight at times, but over a straight knee the hip does
  /// not move without the foot.
  static constexpr double kLongest = 0.99988;
  /// A leg stretched farther is refused (WalkRule::kReach).
  static constexpr double kRefused = 0.9999;
};

/// How long a leg may be [m]. @param captured  how long the captured one is at that moment [m]
/// @param length  of thigh and shank [m] @param unloaded  as of unloaded()
inline double longestLeg(double captured, double length, double unloaded) {
  const double most = LegReach::kStraight - unloaded * (LegReach::kStraight - LegReach::kSwinging);
  return std::clamp(captured, most * length, LegReach::kLongest * length);
}

/// How hips give way where a leg would be longer than it may. By trial.
struct HipDip {
  /// What is missing at a frame lowers the hips so long before and after: shorter shows as a jolt,
  /// longer lowers steps that need it not [s].
  static constexpr double kTime = 0.25;
  /// Hips that give way far do so by up to so much more than is missing [m], by half of it where
  /// so much is [m]: else a leg is at its straightest for a moment, and its knee snaps to and fro.
  /// Where little is missing, as in captured turns, by hardly any more.
  static constexpr double kMore = 0.01, kFar = 0.015;
  static constexpr double kDeepest = 0.15;  ///< deeper is refused: it looks like a stumble [m]
  /// Between a stance, which stays as it is, and a dip beside it hips sink and rise within so long,
  /// of these the time in which they jolt least [s].
  static constexpr std::array<double, 7> kFades = {0.3, 0.2, 0.133, 0.089, 0.059, 0.03, 0.015};
  static constexpr double kAtOnce = 0.004;  ///< beside a stance, more in a frame is a jolt [m]
  /// Hips that are lower at a stance come back within so long [s].
  static constexpr double kRecovery = 0.6;
};

}  // namespace amble

/// How far legs are stretched, as shares of thigh and shank together, and how hips give way where a
/// leg would have to be longer.
#pragma once

namespace amble {

/// Distances from hip to ankle, as shares of the leg's length [1]. The knee's angle goes with the
/// square root of what is missing to 1: at 0.9975 it is bent by 8 degrees, at 0.99 by 16, so the
/// last thousandths turn the knee fastest. In order:
///   kUneven < kStanding < kStraight < kHeel < kDip < kLongest.
struct LegReach {
  /// Of a leg on uneven ground, where legs are bent and stretched more from frame to frame: higher,
  /// and knees snap at the foot of a step; lower, and people walk over rubble crouching. By trial.
  static constexpr double kUneven = 0.992;
  /// Of both legs while standing: captured people stand on straight legs, which have no room to
  /// turn on the spot or to step off from.
  static constexpr double kStanding = 0.995;
  /// Of the straight walk, which is lowered until its legs reach no farther: a knee bent by 8
  /// degrees. Captured walkers reach 0.999, where the knee would turn by 5 degrees for every
  /// millimetre of the hip.
  static constexpr double kStraight = 0.9975;
  /// Of a leg behind: its heel rises instead. Higher, and the knee locks before the heel lifts.
  static constexpr double kHeel = 0.998;
  /// So much less than kHeel around lift-off: the knee flexes before the toe leaves (pre-swing).
  /// Without it the leg leaves the ground straight.
  static constexpr double kPreSwing = 0.03;
  /// Where pre-swing begins and ends (FootState::at: 0.75 of the stance, half of the swing).
  static constexpr double kPreSwingFrom = 0.75, kPreSwingTo = 1.5;
  /// Where a leg on level ground would stretch farther the hips dip.
  static constexpr double kDip = 0.999;
  /// A leg stretched farther is refused (WalkRule::kReach): the knee would snap.
  static constexpr double kLongest = 0.9995;
};

/// How hips dip where a leg would be too short. All by trial.
struct HipDip {
  /// On level ground a dip is spread over so long before and after: shorter shows as a jolt, longer
  /// lowers steps that need it not [s].
  static constexpr double kTime = 0.3;
  static constexpr double kDeepest = 0.04;  ///< deeper is refused: it looks like a stumble [m]
  /// A dip near a stance, which stays as it is, fades so fast at most [m/s] and in no less than
  /// kShortestFade [s].
  static constexpr double kSpeed = 0.03;
  static constexpr double kShortestFade = 0.03;

  /// The same on uneven ground, where dips are deeper, in longer curves [s, m, m/s].
  static constexpr double kUnevenTime = 0.16;
  static constexpr double kUnevenDeepest = 0.15;
  static constexpr double kUnevenSpeed = 0.25;
  /// So much of a heel's further rise (HeelRise) is used there: a foot that stands behind for
  /// longer than on the level would go up on its toes' tips [0 to 1].
  static constexpr double kUnevenHeel = 0.4;
};

}  // namespace amble

/// How standing becomes walking and walking standing, in the first and the last step.
#pragma once

namespace amble {

/// By trial, on captured starts and stops: weight is shifted before a foot leaves and after one has
/// landed.
struct StartAndStop {
  /// The first foot leaves the ground after this share of the first step; earlier, and it is lifted
  /// off the weight that it carries; later, and its swing is a flick [steps].
  static constexpr double kFirstLift = 0.30;
  /// The last foot lands so much before the end of the last step; the rest is settling [steps].
  static constexpr double kLastStrike = 0.12;
  /// The foot of a first step lingers while the body gains speed: its swing runs as this power of
  /// time [1, >= 1].
  static constexpr double kFirstDelay = 1.3;
  /// A first step pushes off with this much of the heel's rise: whole, it would be on tiptoe
  /// [0 to 1].
  static constexpr double kFirstRoll = 0.5;
  /// The standing posture is left within this share of the first step, before its foot lands, and
  /// taken on within as much of the last; less, and the trunk jerks [steps].
  static constexpr double kStandingShare = 0.85;
};

/// When the foot that steps beside standing swings, counted from standing [steps].
struct EndSwing {
  bool captured = false;  ///< both are (TransitionSequence::swing); else as StartAndStop has them
  double lift_off = 0.0, strike = 0.0;
};

}  // namespace amble

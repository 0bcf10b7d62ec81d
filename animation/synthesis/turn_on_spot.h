/// Turning on the spot, or to a place beside it: small steps in pairs, from standing to standing.
/// The foot on the inside opens, the other closes.
///
/// Where a turn is captured, the body goes over it as it did there, and our steps keep up with its
/// pelvis: people pivot on feet that stand, by 50 degrees and more, ours are put down when the
/// pelvis is halfway between them. The captured clock waits where steps cannot be so quick.
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "animation/library/turn_sequence.h"
#include "animation/steps/step_placer.h"
#include "animation/synthesis/animation_buffer.h"
#include "base/cubic_spline.h"

namespace amble {

/// How people turn where they stand.
struct SpotTurnGait {
  /// Most that one pair of steps turns: more, and the foot on the outside would swing through the
  /// other [rad].
  static constexpr double kPair = 45.0 * kDegree;
  /// The same at least, of who stands with his toes far out: feet twist farther then [rad].
  static constexpr double kLeastPair = 15.0 * kDegree;
  /// Of a step, for a captured subject; grows with the root of scale (Froude). A pair's time keeps
  /// the peak turn rate near the 84 degrees/s that people reach (QUALITY.md) [s].
  static constexpr double kStepTime = 0.45;
  /// Pairs that turn less are quicker, down to this share [1].
  static constexpr double kQuickest = 0.8;
  /// Of a step, one pair of which turns by `pair` [rad, >= 0].
  static double stepTime(double pair) {
    return kStepTime * std::clamp(pair / kPair, kQuickest, 1.0);
  }
  /// The quickest step of a captured turn, scaling as that [s], and how much higher a foot is
  /// lifted in those than SpotStep has it [1]. By trial: quicker ones jerk knees more than walks
  /// do, and in lower ones who looks for planted feet sees a foot of a small person hardly leave
  /// the ground.
  static constexpr double kQuickStep = 0.33, kQuickLift = 1.15;
  /// Most that a foot is turned against the pelvis [rad].
  static constexpr double kTwist = 30.0 * kDegree;
  /// Of the root towards the standing foot; by trial: without it, the swinging foot is lifted off
  /// weight that it still carries [m].
  static constexpr double kSway = 0.02;
};

/// When a captured turn is where.
struct CapturedTurnTime {
  int turn = 0;               ///< of CapturedTurns
  CubicSpline clock;          ///< TurnSequence's, over time [s]
  std::vector<double> nodes;  ///< when each step begins, and when the last one ends [s]
};

/// The steps of a turn. Where refused, nothing but `steps` and `first` may be asked.
struct SpotTurn {
  WalkRule refused = WalkRule::kNone;
  int steps = 0;  ///< two a pair
  Side first = kLeft;
  Stance from, end;
  StanceFeet from_feet, end_feet;
  double angle = 0.0;                               ///< [rad, left positive]
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();  ///< from begin to end, on the ground [m]
  double step_time = 0.0;   ///< of a captured turn: its first and last step at most [s]
  int frames = 0;           ///< intervals; there is one frame more
  double frame_time = 0.0;  ///< [s]
  double scale = 1.0;       ///< of the character to the captured subject
  std::optional<Footsteps> feet;
  /// Share of the turn that the pelvis has done at a progress [steps], or of a captured turn at a
  /// moment of its clock: halfway between the feet as each is put down, so that neither is twisted
  /// against it by more than half of a pair and its toe out.
  CubicSpline done;
  std::optional<CapturedTurnTime> captured;  ///< none: by formula, all steps of one time
};

/// What is to be turned.
struct SpotTurnRequest {
  Stance at;
  double angle = 0.0;        ///< [rad, left positive, |angle| <= 2 pi]
  double end_heading = 0.0;  ///< at.heading + angle but for rounding [rad]
  double scale = 1.0;        ///< of the character to the captured subject [> 0]
  double frame_time = 0.0;   ///< [s, > 0]
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();  ///< on the way [m]
  /// A captured turn to the same side, scaled; null: by formula.
  const TurnSequence* sequence = nullptr;
  int captured = -1;  ///< which of CapturedTurns it is
};

SpotTurn planSpotTurn(const StepPlacer& placer, const SpotTurnRequest& request);

/// The state of a frame between the first and the last, which are the stances.
/// @param standing  that of the first frame
FrameState spotTurnState(const SpotTurn& turn, const FrameState& standing, int frame);

}  // namespace amble

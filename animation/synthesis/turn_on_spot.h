/// Turning on the spot, or to a place beside it: small steps in pairs, from standing to standing.
/// The foot on the inside opens, the other closes.
#pragma once

#include <optional>

#include "animation/steps/step_placer.h"
#include "animation/synthesis/animation_buffer.h"
#include "base/cubic_spline.h"

namespace amble {

/// How people turn where they stand.
struct SpotTurnGait {
  /// Most that one pair of steps turns: more, and the foot on the outside would swing through the
  /// other [rad].
  static constexpr double kPair = 45.0 * kDegree;
  /// Of a step, for a captured subject; grows with the root of scale (Froude). A pair's time keeps
  /// the peak turn rate near the 84 degrees/s that people reach (QUALITY.md) [s].
  static constexpr double kStepTime = 0.45;
  /// Of the root towards the standing foot; by trial: without it, the swinging foot is lifted off
  /// weight that it still carries [m].
  static constexpr double kSway = 0.02;
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
  double step_time = 0.0;                           ///< [s]
  int frames = 0;                                   ///< intervals; there is one frame more
  double scale = 1.0;                               ///< of the character to the captured subject
  std::optional<Footsteps> feet;
  /// Share of the turn that the pelvis has done at a progress [steps]: halfway between the feet as
  /// each is put down, so that neither is twisted against it by more than half of a pair and its
  /// toe out.
  CubicSpline done;
};

/// @param angle  [rad, left positive, |angle| <= 2 pi]; @param scale  of the character to the
/// captured subject [> 0]; @param frame_time  [s, > 0]; @param shift  on the way [m]
SpotTurn planSpotTurn(const StepPlacer& placer, const Stance& at, double angle, double scale,
                      double frame_time, const Eigen::Vector3d& shift = Eigen::Vector3d::Zero());

/// The state of a frame between the first and the last, which are the stances.
/// @param standing  that of the first frame
FrameState spotTurnState(const SpotTurn& turn, const FrameState& standing, int frame);

}  // namespace amble

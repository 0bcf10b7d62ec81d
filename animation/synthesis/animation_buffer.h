/// The animation buffer (Pettré §4): samples of a root path that sub-controllers turn into poses.
#pragma once

#include <array>
#include <vector>

#include "animation/body/joint_roles.h"
#include "animation/body/pose.h"
#include "animation/steps/foot_state.h"
#include "animation/steps/gait_parameters.h"
#include "animation/steps/sole_phase.h"

namespace amble {

/// That a frame is in a captured start or stop (TransitionBlend).
struct TransitionMoment {
  bool there = false;
  Side side = kLeft;   ///< that steps beside standing
  double clock = 0.0;  ///< TransitionSequence's [steps]
};

/// That a frame is in a captured turn on the spot (CapturedTurns).
struct SpotTurnMoment {
  int turn = -1;       ///< which; -1: none
  double clock = 0.0;  ///< TurnSequence's [0 to 1]
};

/// What is known of a frame beside its pose.
struct FrameState {
  /// Of the root path, on the ground [m, World].
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  double arc = 0.0;        ///< walked along the root path since the buffer's begin [m, >= 0]
  double heading = 0.0;    ///< of the root path [rad]
  double speed = 0.0;      ///< along the root path [m/s, >= 0]
  double turn_rate = 0.0;  ///< left positive [rad/s]
  /// Turn rate that the cycles are blended for: turn_rate without its jumps; 0 at stances [rad/s].
  double blended_turn_rate = 0.0;
  /// By how much slower a walk the cycles are blended for than the plan's (WalkDepartures), without
  /// jumps; a stance's own there [m/s, >= 0].
  double slower = 0.0;
  double phase = 0.0;        ///< of the walk cycle [cycles, 0 <= . < 1]
  double step_length = 0.0;  ///< to which the cycles are warped here [m, >= 0]
  double standing = 0.0;     ///< rather than walking, 1 at standing stances [0, 1]
  /// Share of the posture `stand`: all of `standing` but where a captured start or stop has it
  /// [0, 1].
  double posture = 0.0;
  double lean = 0.0;  ///< of pelvis and trunk, forwards, beside the cycle's [rad]
  double sway = 0.0;  ///< weight shift to the left beside that of the walk cycle [m]
  /// Of the body to the left of the root path, beside stances that walk: there it goes straight on
  /// (WalkSynthesizer::kTurnIn) [rad].
  double facing = 0.0;
  TransitionMoment start, stop;
  SpotTurnMoment spot;
  std::array<FootState, 2> feet;               ///< by Side
  std::array<bool, 2> planted = {true, true};  ///< by Side: the foot's sole is on the ground
};

/// One placing of one foot.
struct Footprint {
  Side side = kLeft;
  /// Middle of the sole's length, on the ground [m, World].
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  double heading = 0.0;  ///< of the foot [rad]
  int first_frame = 0;   ///< of the buffer, in which it is planted
  int last_frame = 0;    ///< the same, the last
  /// What the step that ends here was asked to be; of a print that the buffer begins with, all 0.
  GaitParameters gait;
};

/// Frames at a fixed rate. `poses[i]` is what is validated and exported for frame i.
struct AnimationBuffer {
  double frame_time = 1.0 / 60.0;  ///< [s, > 0]
  PoseArray poses;
  std::vector<FrameState> states;     ///< as many as poses
  std::vector<SolePhases> soles;      ///< as many as poses, of the feet's states
  std::vector<Footprint> footprints;  ///< in order of first_frame

  int size() const { return poses.size(); }
  /// Appends `next`, whose first frame repeats our last one (it is dropped); a footprint that goes
  /// on is merged.
  void append(const AnimationBuffer& next);
  /// Sets planted flags, soles and footprints from the feet's states.
  void markFootprints();
};

}  // namespace amble

/// The animation buffer (Pettré §4): samples of a root path that sub-controllers turn into poses.
#pragma once

#include <array>
#include <vector>

#include "animation/body/joint_roles.h"
#include "animation/body/pose.h"
#include "animation/steps/gait_parameters.h"

namespace amble {

/// Where a foot stands: middle of the sole's length on the ground [m, World], heading [rad] and the
/// normal of the plane that the sole lies in [unit, z > 0].
struct FootPlace {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  double heading = 0.0;
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
};

/// How a swing departs from the captured one, to clear what lies between its prints.
struct SwingShape {
  double lift = 1.0;   ///< times the captured height [> 0]
  double extra = 0.0;  ///< height added to that [m, >= 0]
  double rise = 0.5;   ///< shares of the swing over which it is added, and taken away [> 0, < 1]
  double fall = 0.5;
  /// Shares of the swing, at its begin and at its end, in which the foot goes up and down only
  /// [>= 0, together < 0.6].
  double delay = 0.0, early = 0.0;
};

/// What a foot is about in a frame.
struct FootState {
  FootPlace from;  ///< where it stands, or stood last
  FootPlace to;    ///< where it goes while it swings; else `from`
  /// 0 to 1: planted, from strike to lift-off; above 1 to 2: swinging, from lift-off to strike.
  double at = 0.0;
  /// How much of the captured heel strike is kept: 0 lands flat, -1 on the ball [-1, 1].
  double strike_roll = 1.0;
  double lift_roll = 1.0;  ///< how much of the captured rise of the heel is kept [0, 1]
  SwingShape swing;        ///< of the swing that the foot is in

  bool planted() const { return at <= 1.0; }
};

/// What is known of a frame beside its pose.
struct FrameState {
  Eigen::Vector3d position =
      Eigen::Vector3d::Zero();  ///< of the root path, on the ground [m, World]
  double arc = 0.0;        ///< distance walked along the root path since the buffer's begin [m]
  double heading = 0.0;    ///< of the root path [rad]
  double speed = 0.0;      ///< along the root path [m/s, >= 0]
  double turn_rate = 0.0;  ///< [rad/s], left positive
  /// Turn rate that the cycles are blended for: turn_rate without its jumps; 0 at stances [rad/s].
  double blended_turn_rate = 0.0;
  double phase = 0.0;             ///< of the walk cycle [cycles, 0 <= . < 1]
  double step_length = 0.0;       ///< to which the cycles are warped here [m]
  double standing = 0.0;          ///< share of the standing posture, 1 at standing stances [0, 1]
  double lean = 0.0;              ///< of pelvis and trunk, forwards, beside the cycle's [rad]
  double crouch = 0.0;            ///< of the root below its height on the level [m]
  double sway = 0.0;              ///< weight shift to the left beside that of the walk cycle [m]
  std::array<FootState, 2> feet;  ///< by Side
  std::array<bool, 2> planted = {true, true};  ///< by Side: the foot's sole is on the ground
};

/// One placing of one foot.
struct Footprint {
  Side side = kLeft;
  Eigen::Vector3d position =
      Eigen::Vector3d::Zero();  ///< middle of the sole's length, on the ground [m, World]
  double heading = 0.0;         ///< of the foot [rad]
  int first_frame = 0;          ///< first and last frame of the buffer in which it is planted
  int last_frame = 0;
  /// What the step that ends here was asked to be; of a print that the buffer begins with, all 0.
  GaitParameters gait;
};

/// Frames at a fixed rate. `poses[i]` is what is validated and exported for frame i.
struct AnimationBuffer {
  double frame_time = 1.0 / 60.0;  ///< [s]
  PoseArray poses;
  std::vector<FrameState> states;     ///< as many as poses
  std::vector<Footprint> footprints;  ///< in order of first_frame

  int size() const { return poses.size(); }
  /// Appends `next`, whose first frame repeats our last one (it is dropped); a footprint that goes
  /// on is merged.
  void append(const AnimationBuffer& next);
  /// Sets planted flags and footprints from the feet's states.
  void markFootprints();
};

}  // namespace amble

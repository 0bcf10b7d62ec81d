/// From a root path to an animated walk: one edge of the roadmap (DESIGN.md, section 3, stages 2
/// and 3).
///
/// The walk is Pettré's (§4.2): along the root path, cycles of the library are warped to the local
/// speed, blended to the local turn rate and played by distance walked; then each foot is held on
/// its footprints by two-link inverse kinematics. Every walk between two stances is a whole number
/// of steps and of frames, begins and ends in the pose of its stances to the bit, and depends on
/// nothing but its arguments.
#pragma once

#include <functional>
#include <memory>
#include <span>

#include "animation/body/joint_roles.h"
#include "animation/ground/ground.h"
#include "animation/ground/ground_limits.h"
#include "animation/steps/root_path.h"
#include "animation/steps/stance.h"
#include "animation/steps/walk_rule.h"
#include "animation/synthesis/animation_buffer.h"
#include "base/rotation.h"

namespace amble {

struct FootShape;      // foot_shape.h
struct MotionLibrary;  // motion_library.h

struct CharacterSettings {
  /// Stature, with which limbs and stride scale; 0: the library's own [m, 0.5 to 2.5].
  double height = 0.0;
  double speed = 1.2;              ///< on the straight [m/s, 0.3 to 2.0]
  double frame_time = 1.0 / 60.0;  ///< [s, 1/240 to 1/24]
  GroundLimits limits = {};
  /// Movements and postures of the library that are held for the whole walk (findAction), the later
  /// over the earlier.
  std::vector<std::string> actions = {};
};

struct WalkResult {
  WalkRule refused = WalkRule::kNone;
  int steps = 0;
  Side leading = kLeft;   ///< the foot in front at the end, if the walk ends walking
  bool unwanted = false;  ///< it was planned, perhaps not to its end, and not animated (WalkFilter)
};

/// Const after construction: threads may share it. Buffers are the caller's, and keep their memory
/// from call to call.
class WalkSynthesizer {
 public:
  /// @pre ground and library outlive the synthesizer. @throws std::invalid_argument for settings
  /// out of range and for an action that findAction does not find.
  WalkSynthesizer(const MotionLibrary& library, const Ground& ground,
                  const CharacterSettings& settings);
  /// The same walker on other ground. Cost: some tenths of a millisecond. @pre as above
  std::unique_ptr<WalkSynthesizer> on(const Ground& ground) const;
  ~WalkSynthesizer();

  const CharacterSettings& settings() const;
  const Skeleton& skeleton() const;  ///< scaled to the height
  const JointRoles& roles() const;
  const std::array<FootShape, 2>& feet() const;  ///< by Side
  double stature() const;                        ///< [m]
  double scale() const;                          ///< of the walker against who was captured [> 0]
  double capturedStep() const;                   ///< step length of the captured walk, scaled [m]
  double capturedLift() const;      ///< GaitParameters::lift of the captured walk, scaled [m]
  JointFrame standingHead() const;  ///< the head's joint when standing at (0, 0, 0) on the level
  /// What ends between these heights over level ground no foot of a walk swings over, whichever
  /// step it is; what goes on higher is a wall [m].
  Eigen::AlignedBox1d tooHighToSwingOver() const;
  double stepLength() const;   ///< of the straight walk at the plan's speed [m]
  double maxTurnRate() const;  ///< fastest turn of a walk [rad/s]
  /// How long before a stance that walks the body begins to go straight on, and after it is as its
  /// path's curve again; by trial: sooner, and the pelvis jerks [s]. Meanwhile it faces beside the
  /// path by 4/27 of that times the turn rate at most (FrameState::facing).
  static constexpr double kTurnIn = 0.25;
  double shortestWalk() const;  ///< from standing to standing [m]

  /// Walks along `path` from one stance to another; `path` begins at from.position and ends at
  /// to.position with their headings. The foot that leads at the end is given back; where
  /// `any_leading` is false it must be to.leading. `out` is overwritten: first frame is stance
  /// `from`, last frame stance `to`. On refusal its content is unspecified, and where `is_wanted`
  /// says no: whether anything would refuse such a walk is not known.
  WalkResult walk(const Stance& from, const Stance& to, const RootPath& path, bool any_leading,
                  AnimationBuffer& out, const GaitWishes& wishes = {},
                  const WalkFilter& is_wanted = {}) const;

  /// What is known of such a walk without much work: what refuses it, or that it is not wanted.
  /// Where neither is so it may still be refused.
  WalkResult outlook(const Stance& from, const Stance& to, const RootPath& path, bool any_leading,
                     const WalkFilter& is_wanted) const;

  /// Turns on the spot by `angle` [rad, left positive, |angle| <= 2 pi] from standing at `at` to
  /// standing, in small steps.
  WalkResult turnOnSpot(const Stance& at, double angle, AnimationBuffer& out) const;

  /// The same to standing somewhere else, not far: a few small steps, in any direction.
  /// @pre the two are kSmallSteps apart at most
  WalkResult smallSteps(const Stance& from, const Eigen::Vector3d& to, double angle,
                        AnimationBuffer& out) const;
  static constexpr double kSmallSteps = 0.2;  ///< nearer places are walked to so [m]

  /// One frame, standing.
  WalkResult stand(const Stance& at, AnimationBuffer& out) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace amble

/// Where a foot is to be in a frame: the captured swing between its prints, the captured roll about
/// heel and ball.
#pragma once

#include <Eigen/Geometry>

#include "animation/body/foot_shape.h"
#include "animation/steps/foot_blend.h"
#include "animation/steps/foot_state.h"
#include "base/rotation.h"

namespace amble {

/// How a heel behind the walker rises farther than captured, as it does when people take longer
/// steps.
struct HeelRise {
  /// By trial: more, and the walker goes on tiptoe [rad].
  static constexpr double kMost = 35.0 * kDegree;
  /// A ball of the foot so far behind the hip lets its heel rise freely, one under the hip not at
  /// all: a standing leg would be lifted by its toes [m].
  static constexpr double kBehind = 0.16;
  /// A heel rises until its ankle is nearest to the hip but for so much: from there on a degree
  /// gives hardly a millimetre, and the foot would turn over in a frame. Of a leg that does not
  /// bear, whose foot goes on fast, more. By trial [rad].
  static constexpr double kLeastYield = 25.0 * kDegree, kYieldSwinging = 45.0 * kDegree;
  /// Over which the heel begins to rise before the leg is at its longest; at once, and the knee
  /// jerks; over more, and captured knees that are straight come out bent, which those of legs that
  /// do not bear are not [m].
  static constexpr double kSoftReach = 0.003, kSoftSwinging = 0.005;
  static constexpr double kRests = 6.0;  ///< so many times that nearer it does not rise at all [1]
};

/// Downhill a ball that is lifted over the tip of its toes goes forward, too, out of the ground's
/// plane: it stays down for longer, and the heel is raised by as much instead. All by trial, so
/// that no foot is seen to drift by 2 mm while it stands.
struct ToesDown {
  static constexpr double kSteep = 0.12;  ///< the fall along the foot at which all of it does [1]
  /// Until when, and over how long the toes then roll as captured [stances].
  static constexpr double kUntil = 0.8, kOver = 0.15;
};

/// Where a foot is to be: the ankle, the foot's rotation and how far the toes bend.
struct FootTarget {
  Eigen::Vector3d ankle;    ///< [m, World]
  Eigen::Quaterniond q_WF;  ///< foot joint in World
  double toe_bend = 0.0;    ///< against the foot, up positive [rad]
};

/// A sole before it is a target: where it is, how its ground lies and how it is rolled.
struct Sole {
  FootPlace place;
  double pitch = 0.0, roll = 0.0;  ///< toes down, and over to the right, positive [rad]
  /// How far the toes are rolled over their tip: the place is that of a sole whose ball is lifted
  /// by it [rad, >= 0].
  double toes = 0.0;
  double unloaded = 0.0;  ///< how little its leg bears (leg_reach.h) [0, 1]
};
Sole soleOf(const FootState& state, const FootBlend& cycle, const FootShape& shape);

/// Where the hip is over a sole, and how little the leg between them bears.
struct HipOverSole {
  Eigen::Vector3d p_S;    ///< in the frame of the sole, as if it were not rolled [m]
  double behind = 0.0;    ///< that the ball is behind it, in plan along the sole [m]
  double unloaded = 0.0;  ///< Sole::unloaded
};

/// The pitch of a sole whose ankle is so far from `hip` [World] and should be `longest` away at
/// most (HeelRise) [rad].
double raisedPitch(const Sole& sole, const FootShape& shape, const Eigen::Vector3d& hip,
                   double distance, double longest);
/// The same of a sole of this pitch [rad].
double raisedPitch(double pitch, const FootShape& shape, const HipOverSole& hip, double distance,
                   double longest);
/// Nearer by so much than `longest`, and the pitch is the sole's own: raisedPitch need not be asked
/// [m].
inline constexpr double kHeelRests = HeelRise::kRests * HeelRise::kSoftSwinging;

/// Where the foot is to be in a frame, as FootController has it of many at once. Behind the walker,
/// where the leg from `hip` [World] would be longer than `longest` [m], the heel rises farther than
/// captured (HeelRise).
FootTarget footTarget(const FootState& state, const FootBlend& cycle, const FootShape& shape,
                      const Eigen::Vector3d& hip, double longest);

/// Whether a swing goes from one print to another on one level.
bool isLevelSwing(const FootState& state);
/// The lift of a swing (GaitParameters::lift), from the prints, rolls and shape that a state of it
/// has [m].
double swingLift(FootState state, const FootBlend& cycle, const FootShape& shape);
/// SwingShape::lift that makes the swing's lift what is asked [m]; what is added to clear things
/// stays beside it.
double liftFactor(double lift, FootState state, const FootBlend& cycle, const FootShape& shape);

}  // namespace amble

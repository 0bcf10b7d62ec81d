/// A walk of ours against QUALITY.md's bars.
///
/// Plants are the walk's own, not detected ones. A bar that is a share of an anchor uses what the
/// captures measure that the walk is made from. Bars of the path and of feet that turn are those of
/// grown people, with legs of 0.75 to 1 m: of others lengths are their legs' share of the nearest
/// of these, rates fall with its root (Froude).
#pragma once

#include <string>
#include <vector>

namespace amble {

struct AnimationBuffer;  // animation_buffer.h
struct Clip;             // clip.h
struct JointRoles;       // joint_roles.h
struct MotionLibrary;    // motion_library.h
class Ground;            // ground.h
struct JudgedStep;       // step_measures.h
struct Stance;           // stance.h
class WalkSynthesizer;   // walk_synthesizer.h

/// Where the root is and the pelvis faces in a stance's own pose, seen from the root path's end
/// there: ahead and to the left [m], left positive [rad]. In mid-walk a pelvis sways and turns with
/// each step, which is no error; who stands has it over the path, and is judged so.
struct StancePelvis {
  double ahead = 0.0, left = 0.0;  ///< [m]
  double turned = 0.0;             ///< [rad]
};

/// All 0 of a stance that stands. @pre the walker can be in it
StancePelvis pelvisOf(const WalkSynthesizer& walker, const Stance& stance);

/// What the captures measure that a walk is made from, by measureGait. Noisy ones are no anchors
/// (QUALITY.md): of a root faster than 12 m/s² or with a joint jerk above 130 m/s³.
struct QualityAnchors {
  /// The largest of the library's walks; of noisy ones alone 12 at most [m/s², >= 0].
  double root_acceleration = 0.0;
  /// Of the straight walks, not of their mirror images, at the walk's speed, between those
  /// captured; of noisy ones, who may be the only ones as fast, 130 [m/s³, >= 0].
  double joint_jerk = 0.0;
  double pops = 0.0;  ///< the largest of the walks; 0 of noisy ones alone [1, >= 0]
  StancePelvis end;   ///< of the stance in which the walk ends
};

/// Of a library's walks, for a character `scale` times the captured subject who walks at `speed`
/// [m/s]. Lengths grow with scale, times with its root (Froude).
QualityAnchors anchorsOf(const MotionLibrary& library, double scale, double speed);

/// One measure beside its bar.
struct QualityLine {
  std::string measure;
  double value = 0.0;
  double bar = 0.0;  ///< holds where value <= bar
  std::string unit;

  bool holds() const { return value <= bar; }
};

/// @param clip  the walk as it is exported: its frames are the buffer's. @pre walk.size() > 0
std::vector<QualityLine> judgeWalk(const Clip& clip, const JointRoles& roles,
                                   const AnimationBuffer& walk, const Ground& ground,
                                   const QualityAnchors& anchors);

/// Its steps: how far the worst misses what it was asked to be, how its sole lies on the ground.
std::vector<QualityLine> judgeSteps(const std::vector<JudgedStep>& steps);

}  // namespace amble

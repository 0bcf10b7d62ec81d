/// The motion library (Pettré §4.1): prepared motions of one skeleton, with where they come from.
///
/// Data only: motion_library_reader.h reads it, motion_library_writer.h writes it (DESIGN.md,
/// section 5); preparation/ makes it from captures.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "animation/body/joint_roles.h"
#include "animation/body/skeleton.h"
#include "animation/library/transition.h"
#include "animation/library/turn_sequence.h"
#include "animation/library/walk_cycle.h"

namespace amble {

struct FootShape;  // foot_shape.h

enum class MotionKind {
  kWalk,        ///< a cycle of the whole body
  kMovement,    ///< what chains of joints do while walking, as a cycle that goes with the steps
  kPosture,     ///< a pose to hold, of the whole body or of chains of joints
  kStart,       ///< how walking begins
  kStop,        ///< how it ends
  kBlocking,    ///< a pose for which the walker stops
  kTurnOnSpot,  ///< how somebody who stands turns about
};
const std::vector<std::string>& motionKindNames();  ///< as files have them, by MotionKind

inline bool isTransition(MotionKind kind) {
  return kind == MotionKind::kStart || kind == MotionKind::kStop;
}

/// Whether motions of a kind have a `style:` (library_style.h): what the legs do.
inline bool hasStyle(MotionKind kind) {
  return kind == MotionKind::kWalk || isTransition(kind) || kind == MotionKind::kTurnOnSpot;
}

/// Whether motions of a kind have a posture: the mean of all frames that were given.
inline bool isPose(MotionKind kind) {
  return kind == MotionKind::kPosture || kind == MotionKind::kBlocking;
}

/// Whether motions of a kind may be of some chains of joints only.
inline bool hasChains(MotionKind kind) { return kind == MotionKind::kMovement || isPose(kind); }

/// Whether a motion of a kind has a left and a right: the mirror image of one is another.
inline bool isForBothSides(MotionKind kind) {
  return kind == MotionKind::kWalk || kind == MotionKind::kTurnOnSpot;
}

/// When a motion may be used (Pettré §4.1, "chronological validity").
struct Validity {
  enum class When { kAlways, kAtStart, kAtEnd, kBetween, kClearanceAbove };
  When when = When::kAlways;
  double from = 0.0, to = 0.0;  ///< of kBetween [s, 0 <= from <= to]
  double clearance = 0.0;       ///< of kClearanceAbove [m, >= 0]
};

struct MotionSource {
  std::string clip;                    ///< path below the captures' folder
  std::array<int, 2> frames = {0, 0};  ///< of the clip: first and last [>= 0]
  bool mirrored = false;
  std::string licence;
  std::string credit;
  /// Where `clip` is a speed engine, which has no frames: how fast it walks, the person that it was
  /// fitted to being as large as captured [m/s, > 0].
  std::optional<double> speed = std::nullopt;
  /// The frames that alone were looked at, where not all were: first and last [>= 0].
  std::optional<std::array<int, 2>> within = std::nullopt;
};
/// Which part of what: "walk.bvh frames 30 to 150", "anna.yaml at 0.8 m/s".
std::string partText(const MotionSource& source);

/// Walks and movements have a cycle, postures a pose, starts and stops a transition, turns on the
/// spot a turn; checked when read and when built.
struct Motion {
  std::string name;
  MotionKind kind = MotionKind::kWalk;
  bool turning = false;  ///< of a walk
  std::string style;     ///< whose manner it is (library_style.h); "": nobody's in particular
  Validity valid;
  std::vector<std::string> chains;  ///< of joints, by name (chainJoints); empty: all
  WalkCycle cycle;                  ///< of a walk or a movement
  Posture posture;                  ///< of a posture or a blocking motion
  Transition transition;            ///< of a start or a stop
  TurnSequence turn;                ///< of a turn on the spot
  MotionSource source;
};

struct MotionLibrary {
  std::filesystem::path file;
  std::string skeleton_file;  ///< BVH beside the library; its hierarchy only is read
  Skeleton skeleton;          ///< [m]
  JointRoles roles;
  double stature = 0.0;  ///< of the captured subject, from leg length [m, 0.3 to 3]
  std::vector<Motion> motions;

  const Motion* find(const std::string& motion) const;  ///< by name; null where there is none
  /// The posture `stand`, whose rotations are the reference of every cycle's rotation vectors.
  const Posture& stand() const { return find("stand")->posture; }
  std::array<FootShape, 2> feet() const;  ///< by Side
};

/// What a library lacks that walking needs; `problem` is empty where it lacks nothing.
struct MotionLack {
  std::string problem, expected;
};
/// A posture `stand` and a straight walk are needed.
MotionLack whatItLacks(const MotionLibrary& library);

/// The chains of joints that a movement or a posture may move beside the steps: `left_arm`,
/// `right_arm`, `trunk`, `head`. Not the legs: where feet go is the steps'.
const std::vector<std::string>& chainNames();
/// The joints of a chain; none where the name is no chain's, or the rig has no such joint.
std::vector<int> chainJoints(const Skeleton& skeleton, const JointRoles& roles,
                             const std::string& chain);

}  // namespace amble

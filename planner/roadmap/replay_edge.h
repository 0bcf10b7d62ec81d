/// An edge of a roadmap once more, frame by frame, walked or refused: for who looks at it.
///
/// Steering depends on its arguments only, so what it made, or refused, for two waypoints it makes
/// or refuses again; the frames of a walk are those that were checked, to the bit. Of a refused
/// edge the proposal is shown whose refusal was the answer, from its begin to where it fails. That
/// is its first contact in time, between frames too; steering, which looks at the likeliest part
/// first and at the body's core before its limbs, may have named another.
#pragma once

#include "planner/plan_request.h"
#include "planner/steering/walk_steering.h"

namespace amble {

struct EdgeReplay {
  /// All frames, those after the stop too; only standing at `from` where no root path leads, or
  /// nothing of it can be animated.
  AnimationBuffer buffer;
  /// Where it fails.
  struct Stop {
    WalkRule rule = WalkRule::kNone;
    int frame = 0;         ///< of the buffer, or the one before the moment of contact
    double between = 0.0;  ///< how far towards the next [0 to 1)
    int part = -1;         ///< of the body, where it touches something
    int object = -1;       ///< of the scene, the same
    /// The part that touches, at that frame; else where the walk was to go on [m, World].
    Eigen::Vector3d at = Eigen::Vector3d::Zero();
  };
  std::optional<Stop> stop;  ///< none of a walk
};

EdgeReplay replayEdge(const WalkSteering& steering, const Waypoint& from, const Waypoint& to);

/// What steering is asked about a node of a picture, or an end of a refused edge.
Waypoint waypointOf(const RoadmapPicture::Node& node);

}  // namespace amble

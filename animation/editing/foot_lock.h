/// Planted feet held where they stand: what captured feet slide is taken out of any clip.
///
/// A foot is moved as a whole, along the ground, by the least smooth curve that holds its toe joint
/// (the tip of its foot where the rig has none) while it stands; in the swing the correction of one
/// plant goes over into that of the next. The pelvis goes half of the way with the feet, more with
/// the one that stands, so that neither legs nor steps pay for all of it (Kovar, Schreiner &
/// Gleicher, Footskate Cleanup, 2002, have the same aims). Heights stay, and how feet roll and
/// turn.
#pragma once

#include "animation/analysis/foot_plants.h"
#include "animation/editing/walk_tracks.h"

namespace amble {

/// What it took.
struct FootLock {
  double farthest = 0.0;  ///< a foot is moved by no more [m, >= 0]
  TrackFit fit;
};

/// The clip with its feet held, on whatever ground. Costs about two forward kinematics a frame.
/// @param plants  of this clip. @pre no joint_positions that move
Clip lockFeet(const Clip& clip, const JointRoles& roles, const FootPlants& plants,
              FootLock* lock = nullptr);

/// The same of tracks, which legs are to follow. @return how far a foot is moved at most [m, >= 0]
double lockTracks(const FootPlants& plants, double frame_time, WalkTracks& tracks);

}  // namespace amble

/// Planted feet held where they stand: what captured feet slide is taken out of any clip.
///
/// A foot is moved as a whole, along the ground, by the least smooth curve that holds its toe joint
/// (the tip of its foot where the rig has none) while it stands, to the clip's begin and end where
/// its foot comes down or leaves outside of it; in the swing the correction of one plant goes over
/// into that of the next. The pelvis goes half of the way with the feet, more with the one that
/// stands, so that neither legs nor steps pay for all of it (Kovar, Schreiner & Gleicher, Footskate
/// Cleanup, 2002, have the same aims). Heights stay, and how feet roll and turn.
#pragma once

#include <limits>
#include <vector>

#include "animation/analysis/foot_plants.h"
#include "animation/editing/walk_tracks.h"

namespace amble {

/// What it took.
struct FootLock {
  double farthest = 0.0;  ///< a foot is moved by no more [m, >= 0]
  TrackFit fit;
};

/// Corrections come and go over about twice so long: a third of a swing. The middle of a captured
/// swing stays as it was [s].
inline constexpr double kFootLockWidth = 0.035;

/// The clip with its feet held, on whatever ground. Costs about two forward kinematics a frame.
/// @param plants  of this clip. @pre no joint_positions that move
Clip lockFeet(const Clip& clip, const JointRoles& roles, const FootPlants& plants,
              FootLock* lock = nullptr);

/// The same of tracks, which legs are to follow. @return how far a foot is moved at most [m, >= 0]
double lockTracks(const FootPlants& plants, double frame_time, WalkTracks& tracks);
/// How feet are held that are made and not captured.
struct LockOptions {
  /// In place of kFootLockWidth, a value a frame [s, > 0]
  std::vector<double> widths;
  /// A foot that stands for long is held but for that at both ends [s, >= 0].
  double longest_loose = std::numeric_limits<double>::infinity();
  /// Whether who walks stands still in the first, in the last frame: feet that stand then are held
  /// where they are there, else in the mean of where they are while they stand; and until they
  /// leave or sooner after they come down, for they do so slowly.
  bool stands_at_begin = false, stands_at_end = false;
};
/// The same of such a walk.
double lockTracks(const FootPlants& plants, double frame_time, const LockOptions& options,
                  WalkTracks& tracks);

/// Moves feet, and the pelvis with them, more with the one that stands: along the ground half of
/// the way, up and down all of it.
/// @param shifts  by Side; a row a frame, columns x y z [m, World]. @pre rows == plants.frames
void shiftFeet(const std::array<Eigen::MatrixXd, 2>& shifts, const FootPlants& plants,
               double frame_time, WalkTracks& tracks);

}  // namespace amble

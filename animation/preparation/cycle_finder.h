/// Where a clip walks in whole, steady cycles: what Pettré (§4.1) leaves to the user.
#pragma once

#include <string>
#include <vector>

#include "animation/library/walk_cycle.h"
#include "animation/preparation/gait_track.h"
#include "animation/preparation/walk_cycle_fit.h"

namespace amble {

/// A walk has double supports, and a cycle begins in the middle of one; a run flies instead, and a
/// cycle begins in the middle of a flight: between the one foot's strike and the other's lift-off
/// in both, so that phases of walks and runs are alike.
enum class Gait { kWalk, kRun };

/// A cycle, from one double support (flight) to the next but one.
struct Stretch {
  double begin, middle, end;  ///< middles of the double supports [frames, rising]
  Side leading;               ///< in front at begin
  double closure;  ///< rms distance of the joints between the ends, seen from the root [m, >= 0]
  double turn;     ///< of the pelvis [rad], left positive
  double speed;    ///< from end to end [m/s, >= 0]
  double aside;    ///< between travel and the pelvis' heading: 0 ahead, pi backwards [rad, 0 to pi]
};

/// Frame of a phase after its begin [cycles, 0 to 1], such that its middle comes at 0.5 and its
/// ends keep their rate.
double frameAt(const Stretch& stretch, double phase);

/// A change from one foot to the other: a double support, or a flight.
struct FootChange {
  double strike;    ///< of the foot in front [frames]
  double lift_off;  ///< of the other: after the strike in a walk, before it in a run [frames]

  double middle() const { return 0.5 * (strike + lift_off); }
};
/// Those in which `leading` comes down in front.
std::vector<FootChange> footChanges(const GaitTrack& track, Side leading, Gait gait = Gait::kWalk);

/// Every whole cycle in the clip, of steps with either foot in front, steady or not.
std::vector<Stretch> wholeCycles(const GaitTrack& track, const CycleOptions& options,
                                 Gait gait = Gait::kWalk);

/// The most cyclic stretch first, then those that walk like it: as fast, turning as much, nearly
/// as closed. Stretches that begin with either foot count; those of neighbouring steps overlap.
/// Only stretches that walk ahead; and, unless a turn is looked for, straight ones.
/// @throws InputError naming the clip, with the reason, where nothing can be cut from it.
std::vector<Stretch> findStretches(const GaitTrack& track, const CycleOptions& options,
                                   Gait gait = Gait::kWalk);

}  // namespace amble

/// The line or circle that a captured cycle is fitted with, and the cycle as seen from there.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <vector>

#include "animation/preparation/cycle_finder.h"

namespace amble {

/// The path's point and heading at the cycle's begin, and how they go on.
struct FittedPath {
  Eigen::Vector2d start;         ///< [m]
  double heading, length, turn;  ///< of one cycle [rad, m, rad]

  Eigen::Vector2d at(double u) const;  ///< @param u  [cycles]
  double headingAt(double u) const { return heading + turn * u; }
  /// A point as seen from the path's at u: forward and left [m].
  Eigen::Vector2d seen(const Eigen::Vector2d& p, double u) const;
};

/// Of all lines (circles, where it is `turning`) the one whose ends are those of the cycle's root,
/// moved aside as a whole, across its begin, by the mean of the root's errors across it at `count`
/// even phases: of a line they then have none, of a circle a little.
FittedPath fitPath(const GaitTrack& track, const Stretch& stretch, bool turning, int count);

/// Rows: the channels of WalkCycle::series; columns: `count` even phases after the stretch's begin.
/// What its ends differ by is spread over the cycle.
/// @param reference  rotations against which the channels' vectors are, the root's against the
/// heading of the path first
Eigen::MatrixXd closedSamples(const GaitTrack& track, const Stretch& stretch,
                              const FittedPath& path,
                              const std::vector<Eigen::Quaterniond>& reference, int count);

}  // namespace amble

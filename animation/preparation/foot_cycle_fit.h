/// How the feet of a captured walk go from print to print: the part of a walk cycle's preparation
/// that looks at feet.
#pragma once

#include <Eigen/Core>
#include <array>
#include <string>

#include "animation/library/walk_cycle.h"
#include "animation/preparation/cycle_path.h"
#include "animation/preparation/gait_track.h"

namespace amble {

/// Whether there is a swing of the foot that begins or ends within the frames [begin, end), with a
/// plant before and after it.
bool hasSwing(const GaitTrack& track, Side side, double begin, double end);

/// The swing of one foot from plant to plant, and its pitch in them; its phases stay 0.
/// @param own_soles  whether the clip stands on soles of its own; otherwise each of the stances is
/// taken to be flat, in the mean, however it tilts the foot
FootCycle fitSwing(const GaitTrack& track, Side side, const FootShape& shape, const Plant& from,
                   const Plant& to, bool own_soles);

/// The swing of one foot that begins within the frames [begin, end), and the stances around it.
/// @throws InputError naming `clip` where there is none.
FootCycle fitFootCycle(const GaitTrack& track, Side side, const FootShape& shape, double begin,
                       double end, const std::string& clip);

/// The same of a stretch, its phases as if the left foot had led.
FootCycle fitFootCycle(const GaitTrack& track, Side side, const FootShape& shape,
                       const Stretch& stretch, const std::string& clip);

/// Where a walk puts its feet.
struct FootPlacing {
  double width = 0.0;   ///< between the lines of left and right footprints [m]
  double left = 0.0;    ///< of the path, where their middle is [m]
  double height = 0.0;  ///< mean of the two footprints over the floor [m]
  /// Before the path's point half of a step before or behind, by Side [m].
  std::array<double, 2> forward = {0, 0};
  std::array<double, 2> toe_out = {0, 0};  ///< against the path there, left positive [rad]
  /// Largest distance of a standing ankle from its mean, in the middle half of its stance [m, >=
  /// 0].
  double slide = 0.0;
};

/// At the double support at frame `begin`, where the cycle of `path` begins, whose front foot is
/// `leading`.
FootPlacing measurePlacing(const GaitTrack& track, double begin, const FittedPath& path,
                           Side leading);

}  // namespace amble

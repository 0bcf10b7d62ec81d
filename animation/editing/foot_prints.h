/// Where the feet of a walk stand, one print after the other, and how far a foot is on its way from
/// one to the next: what an edit moves.
#pragma once

#include <array>
#include <vector>

#include "animation/editing/captured_walk.h"
#include "animation/editing/walk_tracks.h"

namespace amble {

struct FootPrint {
  int first = 0, last = 0;  ///< frames in which the foot stands [0 <= first <= last]
  int middle = 0;           ///< of them
  Eigen::Vector2d toe;      ///< then [m, World]
  Eigen::Vector2d at;       ///< middle between ankle and toe, as they stand [m, World]
  /// Where a foot that is in the air at the clip's begin or end is then: no print, but it goes with
  /// the others.
  bool in_air = false;
  Eigen::Vector2d shift = Eigen::Vector2d::Zero();  ///< how far the edit moves it [m]
  double height = 0.0;                              ///< on what it is put [m]
};
/// By Side, in order of time, at least one each; the clip lies between the first and the last.
using FootPrints = std::array<std::vector<FootPrint>, 2>;

/// As the tracks have them, not moved yet.
FootPrints footPrints(const CapturedWalk& walk, const WalkTracks& tracks);

/// The prints between which a foot is at a frame; the same twice where it is on its first or last.
struct PrintPair {
  const FootPrint &from, &to;
};
PrintPair printsAt(const std::vector<FootPrint>& prints, int frame);

/// The share of the way between two prints that the toe has gone: along the line between them, as
/// the thesis scales displacements; of a foot that is put down where it was, by the time of its
/// swing [1, about 0 to 1; 0 on the first, 1 on the second].
double progress(const PrintPair& prints, const FootTrack& foot, int frame);

}  // namespace amble

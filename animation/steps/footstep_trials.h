/// Where feet could be put down along a root path: every place that is tried, on the lines of the
/// left and of the right foot, with the foothold that is there.
#pragma once

#include <array>
#include <functional>
#include <utility>
#include <vector>

#include "animation/steps/foothold.h"
#include "animation/steps/footsteps.h"
#include "animation/steps/root_path.h"

namespace amble {

/// How places are tried.
struct TrialGrid {
  static constexpr double kSpacing = 0.02;  ///< along the path: a tread of 0.22 m has eleven [m]
  /// Outwards of a foot's line, the first that stands is taken: past a table's leg, not around it
  /// [m].
  static constexpr std::array<double, 3> kAside = {0.0, 0.04, 0.08};
  /// Up to which ground that is out of a step's reach is seen, to say so [m].
  static constexpr double kFar = 1.5;
  /// To which the ends of surfaces shorter than kNarrow, which draw a foot towards their middle,
  /// are found [m].
  static constexpr double kNarrow = 0.3, kFinest = 0.001;
};

struct FootTrial {
  double arc = 0.0;  ///< along the path, going on straight beyond its ends [m]
  Foothold hold;
  double aside = 0.0;  ///< outwards of the foot's line, one of TrialGrid::kAside [m]
  double tilt = 0.0;   ///< of the sole along the foot, up positive [1]

  bool stands() const { return hold.refusal == Foothold::Refusal::kNone; }
};

/// Where a foot is put down beside the path, at an arc at which even steps would have it [m].
using PrintAlong = std::function<PrintPlace(Side side, double arc)>;

/// Whose feet, along what.
struct TrialRequest {
  const RootPath& path;
  PrintAlong print;
  double begin = 0.0, end = 0.0;  ///< arcs between which places are tried [m]
  double from_height = 0.0;       ///< of the ground at the begin [m, World]
};

struct FootTrials {
  double begin = 0.0;                           ///< places lie every kSpacing from here on [m]
  std::array<std::vector<FootTrial>, 2> lines;  ///< by Side, as many of either
  std::array<int, 4> refusals = {0, 0, 0, 0};   ///< places that do not stand, by Refusal
  int out_of_step = 0;  ///< places whose ground lies higher or lower than a step

  int count() const { return static_cast<int>(lines[kLeft].size()); }
  int refused(Foothold::Refusal why) const { return refusals[static_cast<int>(why)]; }
};

FootTrials tryPlaces(const TrialRequest& request, const FootholdFinder& holds);

/// The foothold at another arc of a trial's line.
Foothold holdAt(const TrialRequest& request, const FootholdFinder& holds, Side side,
                const FootTrial& trial, double arc);

/// Arcs around place k on which a foot stands as well, on the same surface [m].
std::pair<double, double> surfaceAround(const TrialRequest& request, const FootholdFinder& holds,
                                        const FootTrials& trials, Side side, int k);

/// Whether `found` supports at least as much of a foot as `hold` does (overhang of 1e-9 is
/// rounding).
bool standsLike(const Foothold& hold, const Foothold& found);

}  // namespace amble

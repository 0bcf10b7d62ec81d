/// Stride, lift and climb: the parameters of a step that captured walks are edited by (Shanbhag &
/// Chandran §3.3; Shanbhag's thesis, §6.2.3).
#pragma once

#include <functional>
#include <span>

#include "animation/body/joint_roles.h"

namespace amble {

struct GaitParameters {
  /// From the other foot's print to this one's along the walk, in plan: S parallel of the thesis'
  /// eq. 6.8. What both papers call stride is gait analysis' step length [m].
  double stride = 0.0;
  /// Highest rise of the sole, at its lowest point, over the line from the foot's last print to
  /// this one. The papers lift the ankle; but an ankle also rises as the foot rolls off, which is
  /// no lift that clears anything [m].
  double lift = 0.0;
  double climb = 0.0;  ///< of this print over the other foot's: S perpendicular of eq. 6.8 [m]
};

/// What a walk is asked to be, by arc of its root path [m]; what is not asked is the library's own,
/// which gives the captured motion back. Climb is the ground's.
struct GaitWishes {
  /// GaitParameters::stride, 0.6 to 1.4 of the captured; the cadence stays that of the plan's speed
  /// [m].
  std::function<double(double)> stride = {};
  std::function<double(double)> lift = {};  ///< GaitParameters::lift, 0.5 to 3 of the captured [m]
};

/// Asked what a walk will be before it is animated: whether it is to be, or planned further. Most
/// of a walk's cost comes after that. First as soon as it is known how long it takes and where its
/// feet stand, with lifts of 0, and where that is wanted once more with the lifts. Before steps are
/// chosen for the ground with fewer intervals than there can be, without steps.
/// @param intervals  between its frames; @param leading  the foot in front at its end
/// @param gait  of its steps, in their order
using WalkFilter =
    std::function<bool(int intervals, Side leading, std::span<const GaitParameters> gait)>;

}  // namespace amble

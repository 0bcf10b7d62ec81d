/// Footsteps that are chosen for the ground: along a root path, where whole soles stand, as near to
/// the wanted step lengths as may be.
///
/// Places are tried every kSpacing along the path, on the lines of the left and of the right foot.
/// Of all sequences that alternate between them the cheapest is taken (dynamic programming: costs
/// add up from step to step), then its places are evened out within the surfaces that they stand
/// on. So on a stair every tread gets one foot, in its middle, and the steps before it give way.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "animation/steps/foothold.h"
#include "animation/steps/footsteps.h"
#include "animation/steps/root_path.h"
#include "animation/steps/walk_rule.h"

namespace amble {

/// A point of the path, going on straight beyond its ends; at height z.
GroundPoint pathPoint(const RootPath& path, double arc, double z);

/// How much higher `b` is than where the slope under both leads from `a`: a step up or down [m].
double stepHeight(const FootPlace& a, const FootPlace& b);

/// What is asked for.
struct FootstepRequest {
  const RootPath& path;
  const FootPlacement& placement;
  Stance from, to;
  std::array<FootPlace, 2> from_feet, to_feet;  ///< by Side, on the ground
  /// The same at the end with the other foot leading, where either may; else as to_feet.
  std::array<FootPlace, 2> to_other_feet;
  bool any_leading = false;
  Side preferred = kLeft;                 ///< to step first, from standing
  std::function<double(double)> wanted;   ///< step length at an arc, on the level [m]
  double shortest = 0.15, longest = 0.9;  ///< steps [m]
};

struct FootstepPlan {
  WalkRule refused = WalkRule::kNone;
  int steps = 0;
  Side first = kLeft;
  std::vector<double> arcs;       ///< of placings -1, 0, ... steps, along the path [m]
  std::vector<FootPlace> places;  ///< the same
};

/// Refused as kFoothold, kSlope, kStepHeight or kNoGround, whichever was most often in the way.
FootstepPlan planFootsteps(const FootstepRequest& request, const FootholdFinder& holds);

}  // namespace amble

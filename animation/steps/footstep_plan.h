/// Footsteps that are chosen for the ground: along a root path, where whole soles stand, as near to
/// the wanted step lengths as may be.
///
/// Places are tried along the path, on the lines of the left and of the right foot (FootTrials). Of
/// all sequences that alternate between them the cheapest is taken (dynamic programming: costs
/// add up from step to step), then its places are evened out within the surfaces that they stand
/// on. So on a stair every tread gets one foot, in its middle (nearer to the edge that it came over
/// where the next riser is high), and the steps before it give way.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "animation/steps/foothold.h"
#include "animation/steps/footstep_trials.h"
#include "animation/steps/footsteps.h"
#include "animation/steps/root_path.h"
#include "animation/steps/walk_rule.h"

namespace amble {

/// What is weighed against that of a step twice as long as wanted, which costs 1. By trial.
struct FootstepCosts {
  /// Of a sole that overhangs by all of its length: less, and feet stand on edges where a shorter
  /// step would have stood whole.
  static constexpr double kOverhang = 2.0;
  /// Of passing over a tread; less, and stairs are taken two at a time.
  static constexpr double kSkip = 0.5;
  /// Of a foot put down farthest beside its line: cheaper than a step by a third too long.
  static constexpr double kAside = 0.1;
  /// What lies between two prints is a tread where its tilt differs from the line's by more [1].
  static constexpr double kTreadTilt = 0.08;
  /// Surfaces as short as this have feet in their middle, those of TrialGrid::kNarrow anywhere [m].
  static constexpr double kNarrowest = 0.15;
  /// Knees bend over the toes by more the higher the next step is: beyond so high [m] feet stand by
  /// so much times the rest [1] farther before its riser than they need, else shank and thigh enter
  /// the nosing. By trial: at 1, flights of 0.28 m are climbed at up to 1.2 m/s only.
  static constexpr double kKneeClears = 0.2, kKneeRoom = 2.0;
  static constexpr int kSweeps = 40;  ///< of evening out: places move by less than 1 mm after them
};

/// What is asked for.
struct FootstepRequest {
  const RootPath& path;
  const FootPlacement& placement;
  Stance from, to;
  std::array<FootPlace, 2> from_feet, to_feet;  ///< by Side, on the ground
  /// The same at the end with the other foot leading, where either may; else as to_feet.
  std::array<FootPlace, 2> to_other_feet;
  bool any_leading = false;
  Side preferred = kLeft;  ///< to step first, from standing
  PrintAlong print;
  std::function<double(double)> wanted;   ///< step length at an arc, on the level [m]
  double shortest = 0.15, longest = 0.9;  ///< steps [m]
};

struct FootstepPlan {
  WalkRule refused = WalkRule::kNone;
  int steps = 0;
  Side first = kLeft;
  /// Of placings -1, 0, ... steps, along the path, if no foot were staggered (PrintPlace) [m].
  std::vector<double> arcs;
  std::vector<FootPlace> places;  ///< the same
};

/// Refused as kFoothold, kSlope, kStepHeight or kNoGround, whichever was most often in the way.
FootstepPlan planFootsteps(const FootstepRequest& request, const FootholdFinder& holds);

}  // namespace amble

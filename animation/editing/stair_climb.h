/// A straight walk taken up or down stairs (Shanbhag's thesis, §6.2.3, synthesizing climb; Shanbhag
/// & Chandran, §3.3.3).
///
/// The texts add the climb to a foot's path linearly, which takes it through the nosing of a stair.
/// Here each print is put on a tread of its own, the swing leaves the one and gets to the other as
/// early or late as it must, and what its sole then is still short of clearing is added as one
/// smooth curve.
#pragma once

#include <string>

#include "animation/editing/foot_prints.h"
#include "animation/editing/walk_path.h"
#include "animation/ground/stair_ground.h"

namespace amble {

struct StairSize {
  double rise = 0.17;   ///< negative: down [m]
  double going = 0.29;  ///< from nosing to nosing [m, > 0]
};

struct StairClimb {
  std::string refused;  ///< why there is none, or ""
  Stairs stairs;        ///< as they lie from where the walk begins; no print is outside
  Eigen::Vector2d origin = Eigen::Vector2d::Zero();  ///< where that is [m, World]
};

/// Moves root and feet: each step goes to the next tread, but one that puts a foot beside the
/// other.
StairClimb climbStairs(const CapturedWalk& walk, const WalkPath& path, const StairSize& size,
                       FootPrints& prints, WalkTracks& tracks);

}  // namespace amble

/// What the ground does along a line: where it ends, is too steep, rises too high, or has treads
/// too short for a sole.
#pragma once

#include "planner/plan_request.h"

namespace amble {

/// The first such thing from one place to another is written into `why`, with how much there is and
/// what would do. Of whatever lies there the highest below the hips counts, be it ground or not.
/// @param from, to  on the ground [m, World]
/// @return whether there is something
bool measureGround(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                   const PlanRequest& request, Obstruction& why);

/// The highest step on the way, in the same way, where it is none too high in itself.
bool measureRise(const Eigen::Vector3d& from, const Eigen::Vector3d& to, const PlanRequest& request,
                 Obstruction& why);

/// That is stepped up, or down: what is natural is, whatever is let [m].
double highestStep(const GroundLimits& limits, bool up);

/// Middles of two feet in one step are no farther apart [m].
double longestStep(const WalkSynthesizer& synthesizer);

/// Of a break in the ground that is stepped over, at most [m].
double longestBreak(const WalkSynthesizer& synthesizer);

}  // namespace amble

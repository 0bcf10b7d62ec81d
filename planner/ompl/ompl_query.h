/// One query to a planner of OMPL, ours or theirs: from one waypoint to another.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "planner/ompl/walk_space.h"
#include "planner/search_limits.h"

namespace ompl::base {
class Planner;
class ProblemDefinition;
}  // namespace ompl::base

namespace amble {

using OmplPlannerPtr = std::shared_ptr<ompl::base::Planner>;
using OmplProblemPtr = std::shared_ptr<ompl::base::ProblemDefinition>;

/// Start and goal, where the goal is met exactly.
OmplProblemPtr makeProblem(const OmplSpacePtr& space, const Waypoint& from, const Waypoint& to);

/// The edges of the walk that the planner finds, or none: those that were checked when it grew,
/// none of them steered again. Stops at limits.stopped(), or after `max_samples` of the space's
/// sampler [> 0]. The planner is asked anew: what a former query left in it is cleared, a roadmap
/// is kept.
std::optional<std::vector<WalkEdge>> solveWith(ompl::base::Planner& planner, const Waypoint& from,
                                               const Waypoint& to, const SearchLimits& limits,
                                               long long max_samples);

}  // namespace amble

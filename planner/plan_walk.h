/// From a problem to a walk: the roadmap, the search, the refinement, and one more check of the
/// whole (DESIGN.md, section 3).
#pragma once

#include <string>
#include <vector>

#include "planner/plan_request.h"

namespace amble {

/// Plans one walk. A fixed, counted effort decides; a deadline or a stop only ends it early, and is
/// reported.
/// @throws std::invalid_argument if the request is incomplete, a number is out of its range, or the
/// planner is unknown.
PlanOutcome planWalk(const PlanRequest& request);

struct PlannerInfo {
  std::string name;
  std::string explanation;  ///< one line
};
/// What legs/planners.h has, for users of the library; the default first.
std::vector<PlannerInfo> listPlanners();

}  // namespace amble

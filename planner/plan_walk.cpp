#include "planner/plan_walk.h"

#include "planner/legs/plan_run.h"
#include "planner/legs/planners.h"

namespace amble {

PlanOutcome planWalk(const PlanRequest& request) {
  checkRequest(request);
  const WalkSteering steering(*request.synthesizer, *request.world, *request.ground,
                              {request.comfort, request.within});
  return runPlan(request, steering, [](const PlanRequest& asked, const WalkSteering& by) {
    return makeLegPlanner(asked, by, asked.limits);
  });
}

std::vector<PlannerInfo> listPlanners() {
  std::vector<PlannerInfo> list;
  for (const PlannerEntry& entry : planners()) list.push_back({entry.name, entry.explanation});
  return list;
}

}  // namespace amble

#include "planner/ompl/ompl_query.h"

#include <ompl/base/Planner.h>
#include <ompl/base/ProblemDefinition.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/goals/GoalState.h>
#include <ompl/geometric/PathGeometric.h>

#include "planner/ompl/quiet_ompl.h"

namespace amble {
namespace {

namespace ob = ompl::base;

// The edges of a solution; nothing where a motion of it was never walked in its direction.
std::optional<std::vector<WalkEdge>> edgesAlong(const std::vector<ob::State*>& states,
                                                const ob::SpaceInformation& space) {
  std::vector<WalkEdge> edges;
  if (states.size() == 1) {  // already there: an edge that stays
    edges.emplace_back();
    edges.back().from = edges.back().to = waypointOf(states.front()).stance;
  }
  for (size_t i = 0; i + 1 < states.size(); ++i) {
    const SteerResult& result = motionOf(space, states[i], states[i + 1]);
    if (!result.edge) return std::nullopt;
    edges.push_back(*result.edge);
  }
  return edges;
}

}  // namespace

OmplProblemPtr makeProblem(const OmplSpacePtr& space, const Waypoint& from, const Waypoint& to) {
  const auto problem = std::make_shared<ob::ProblemDefinition>(space);
  ob::State* state = space->allocState();
  setWaypoint(*space, from, state);
  problem->addStartState(state);
  setWaypoint(*space, to, state);
  const auto goal = std::make_shared<ob::GoalState>(space);
  goal->setState(state);
  problem->setGoal(goal);
  space->freeState(state);
  return problem;
}

std::optional<std::vector<WalkEdge>> solveWith(ob::Planner& planner, const Waypoint& from,
                                               const Waypoint& to, const SearchLimits& limits,
                                               long long max_samples) {
  const QuietOmpl quiet;
  const auto space = planner.getSpaceInformation();
  const OmplProblemPtr problem = makeProblem(space, from, to);
  planner.setProblemDefinition(problem);
  if (!planner.isSetup()) planner.setup();  // before any clearing: SST's needs it
  planner.clearQuery();
  const SpaceEffort& effort = effortOf(*space);
  const long long last = effort.samples + max_samples;
  planner.solve(
      ob::PlannerTerminationCondition([&] { return limits.stopped() || effort.samples >= last; }));
  if (!problem->hasExactSolution()) return std::nullopt;
  const auto path =
      std::static_pointer_cast<ompl::geometric::PathGeometric>(problem->getSolutionPath());
  return edgesAlong(path->getStates(), *space);
}

}  // namespace amble

#include "planner/ompl/roadmap_planner.h"

#include <ompl/base/Planner.h>
#include <ompl/base/PlannerData.h>
#include <ompl/base/ProblemDefinition.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/geometric/PathGeometric.h>

#include <utility>

namespace amble {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;

class RoadmapPlanner : public ob::Planner {
 public:
  RoadmapPlanner(const OmplSpacePtr& space, std::unique_ptr<SampledRoadmap> roadmap,
                 const SearchLimits& limits)
      : Planner(space, "Amble roadmap"), roadmap_(std::move(roadmap)), limits_(limits) {
    specs_.directed = true;
    specs_.multithreaded = true;
    specs_.recognizedGoal = ob::GOAL_STATE;
  }

  ob::PlannerStatus solve(const ob::PlannerTerminationCondition& ptc) override;
  void clear() override {
    Planner::clear();
    roadmap_->clear();
  }
  void clearQuery() override {
    pis_.clear();
    pis_.update();
  }
  void getPlannerData(ob::PlannerData& data) const override;

  const SampledRoadmap& roadmap() const { return *roadmap_; }

 private:
  const Roadmap& graph() const { return roadmap_->roadmap(); }
  int insert(const ob::State* state, bool start) {
    const Waypoint& at = waypointOf(state);
    const bool both_ways = at.stance.standing && !at.any_heading;
    return roadmap_->insert(at, both_ways || !start, both_ways || start, limits_.threads);
  }
  void addSolution(int from, const std::vector<int>& edges);

  std::unique_ptr<SampledRoadmap> roadmap_;
  const SearchLimits limits_;
};

ob::PlannerStatus RoadmapPlanner::solve(const ob::PlannerTerminationCondition& ptc) {
  checkValidity();
  const ob::State* start = pis_.nextStart();
  const ob::State* goal = pis_.nextGoal();
  if (!start) return ob::PlannerStatus::INVALID_START;
  if (!goal) return ob::PlannerStatus::INVALID_GOAL;
  const int from = insert(start, true), to = insert(goal, false);
  SearchLimits limits = limits_;
  limits.seed = seedOf(*si_);
  limits.interrupted = [&ptc] { return ptc.eval(); };
  if (!roadmap_->connect(from, to, limits)) return ob::PlannerStatus::TIMEOUT;
  const auto edges = graph().shortestPath(from, to);
  if (!edges) return ob::PlannerStatus::TIMEOUT;
  addSolution(from, *edges);
  return ob::PlannerStatus::EXACT_SOLUTION;
}

// The graph's edges along the way; the space learns them, so that nobody checks them again.
void RoadmapPlanner::addSolution(int from, const std::vector<int>& edges) {
  const auto path = std::make_shared<og::PathGeometric>(si_);
  ob::State* state = si_->allocState();
  const auto append = [&](int node) {
    setWaypoint(*si_, graph().nodes()[node].at, state);
    path->append(state);
  };
  append(from);
  for (const int edge : edges) {
    append(graph().edges()[edge].to);
    const auto& states = path->getStates();
    learnEdge(*si_, states[states.size() - 2], states.back(), graph().edges()[edge].walk);
  }
  si_->freeState(state);
  pdef_->addSolutionPath(path, false, 0.0, getName());
}

void RoadmapPlanner::getPlannerData(ob::PlannerData& data) const {
  Planner::getPlannerData(data);
  std::vector<unsigned int> vertex;
  std::vector<ob::State*> states;
  for (const RoadmapNode& node : graph().nodes()) {
    states.push_back(si_->allocState());
    setWaypoint(*si_, node.at, states.back());
    vertex.push_back(data.addVertex(ob::PlannerDataVertex(states.back())));
  }
  for (const RoadmapEdge& edge : graph().edges()) data.addEdge(vertex[edge.from], vertex[edge.to]);
  data.decoupleFromPlanner();  // it has copies of the states then
  si_->freeStates(states);
}

}  // namespace

OmplPlannerPtr makeRoadmapPlanner(const OmplSpacePtr& space,
                                  std::unique_ptr<SampledRoadmap> roadmap,
                                  const SearchLimits& limits) {
  return std::make_shared<RoadmapPlanner>(space, std::move(roadmap), limits);
}

const SampledRoadmap* roadmapOf(const ob::Planner& planner) {
  const auto* own = dynamic_cast<const RoadmapPlanner*>(&planner);
  return own ? &own->roadmap() : nullptr;
}

}  // namespace amble

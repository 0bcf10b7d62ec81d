#include "planner/legs/planner.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "planner/legs/kept_legs.h"
#include "planner/legs/leg_planner.h"
#include "planner/legs/plan_run.h"
#include "planner/roadmap/kept_roadmap.h"
#include "planner/roadmap/visibility_roadmap.h"
#include "planner/steering/ways_between.h"

namespace amble {
namespace {

WalkSteering steeringOf(const PlanRequest& problem) {
  checkRequest(problem);
  return {*problem.synthesizer, *problem.world, *problem.ground, {problem.comfort, problem.within}};
}

KeptRoadmap checked(KeptRoadmap roadmap) {
  const int nodes = static_cast<int>(roadmap.nodes.size());
  const auto is_there = [&](int node) { return node >= 0 && node < nodes; };
  for (const KeptRoadmap::Edge& edge : roadmap.edges) {
    if (!is_there(edge.from) || !is_there(edge.to) || !(edge.cost >= 0.0))
      throw std::invalid_argument(
          "an edge of the roadmap leads nowhere, or costs less than nothing");
  }
  return roadmap;
}

}  // namespace

struct Planner::Parts {
  Parts(const PlanRequest& the_problem, KeptRoadmap roadmap)
      : problem(the_problem),
        steering(steeringOf(problem)),
        search(steering, checked(std::move(roadmap))) {}

  const PlanRequest problem;
  const WalkSteering steering;
  const KeptSearch search;
};

KeptRoadmap Planner::grow(const PlanRequest& problem) {
  const WalkSteering steering = steeringOf(problem);
  VisibilityRoadmap roadmap(StanceSampler(steering, problem.bounds));
  roadmap.fill(problem.limits);
  KeptRoadmap kept = keep(roadmap);
  kept.seed = problem.limits.seed;
  kept.max_failures = problem.limits.max_failures;
  return kept;
}

Planner::Planner(const PlanRequest& problem) : Planner(problem, grow(problem)) {}

Planner::Planner(const PlanRequest& problem, KeptRoadmap roadmap)
    : parts_(std::make_unique<const Parts>(problem, std::move(roadmap))) {}
Planner::~Planner() = default;
Planner::Planner(Planner&&) noexcept = default;

PlanOutcome Planner::plan(const PlanQuery& query, const SearchLimits& limits) const {
  PlanRequest request = parts_->problem;
  request.start = query.start;
  request.goal = query.goal;
  request.via = query.via;
  request.limits = limits;
  checkRequest(request);
  return runPlan(request, parts_->steering, [&](const PlanRequest& asked, const WalkSteering& by) {
    return makeKeptLegs(asked, by, parts_->search);
  });
}

const SearchLimits& Planner::limits() const { return parts_->problem.limits; }

const KeptRoadmap& Planner::roadmap() const { return parts_->search.roadmap(); }

RoadmapPicture Planner::picture() const {
  RoadmapPicture picture;
  for (const KeptRoadmap::Node& node : roadmap().nodes)
    picture.nodes.push_back({node.stance, node.kind});
  for (const KeptRoadmap::Edge& edge : roadmap().edges) {
    const Waypoint from{.stance = roadmap().nodes[edge.from].stance},
        to{.stance = roadmap().nodes[edge.to].stance};
    const std::vector<Way> ways = waysBetween(from, to);
    picture.edges.push_back({edge.from, edge.to, {}});
    if (!ways.empty()) picture.edges.back().line = lineOf(makeEdge(from, to, ways.front()));
  }
  return picture;
}

}  // namespace amble

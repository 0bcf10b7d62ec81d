#include "planner/legs/leg_planner.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>
#include <tuple>

#include "planner/ompl/ompl_border.h"
#include "planner/refine_walk.h"
#include "planner/roadmap/nearest_roadmap.h"
#include "planner/roadmap/visibility_roadmap.h"
#include "planner/steering/cylinder_steering.h"

namespace amble {
namespace {

// A tree draws many samples for each that a roadmap's failures count: RRT ends after so many times
// max_failures.
constexpr int kTreeSamplesPerFailure = 4;
// How often `cylinder` plans anew, with another seed, when the animated body touches something on
// its path.
constexpr int kCylinderAttempts = 10;
constexpr double kMeasuredWalk = 3.0;  // long enough for strides at full speed [m]
constexpr double kThinnestCylinder =
    0.3;  // where there is no ground for that walk: half of two elbows' breadth [m]

double seconds(std::chrono::steady_clock::time_point since) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - since).count();
}

/// Solves on a roadmap through OMPL's interface.
std::optional<std::vector<Waypoint>> solveOn(SampledRoadmap& roadmap, const Steering& steering,
                                             const Eigen::AlignedBox2d& bounds,
                                             const Waypoint& from, const Waypoint& to,
                                             const SearchLimits& limits) {
  const OmplSpacePtr space = makeWalkSpace(steering, bounds, limits.seed);
  const OmplPlannerPtr planner = makeRoadmapPlanner(space, roadmap, limits);
  return solveWith(*planner, from, to, limits, 1);
}

/// The edges between waypoints that were found to be joined, asked for again.
std::optional<std::vector<WalkEdge>> edgesAlong(const std::vector<Waypoint>& waypoints,
                                                const Steering& steering, SteeringCount& count,
                                                std::vector<SteeringFailure>* refused) {
  const SteeringScratchPtr scratch = steering.makeScratch();
  std::vector<WalkEdge> edges;
  if (waypoints.size() == 1) {  // already there: an edge that stays
    edges.emplace_back();
    edges.back().from = edges.back().to = waypoints.front().stance;
  }
  for (size_t i = 0; i + 1 < waypoints.size(); ++i) {
    SteerResult result = steering.steer(waypoints[i], waypoints[i + 1], *scratch);
    count.add(result);
    if (!result.edge) {
      if (refused) refused->push_back(result.failure);
      return std::nullopt;
    }
    edges.push_back(std::move(*result.edge));
  }
  return edges;
}

int findNode(const Roadmap& roadmap, const Waypoint& at, bool last) {
  int found = -1;
  for (int node = 0; node < roadmap.size(); ++node) {
    const Stance& stance = roadmap.nodes()[node].at.stance;
    if (stance.position != at.stance.position || stance.heading != at.stance.heading) continue;
    if (found < 0 || last) found = node;
  }
  return found;
}

/// Refusals of edges that lead from where one gets from the start to where one gets to the goal
/// from; all, if none does.
std::vector<SteeringFailure> inTheWay(const SampledRoadmap& roadmap, const Waypoint& from,
                                      const Waypoint& to) {
  const int start = findNode(roadmap.roadmap(), from, false),
            goal = findNode(roadmap.roadmap(), to, true);
  std::vector<SteeringFailure> relevant, all;
  if (start < 0 || goal < 0) return all;
  const std::vector<bool> here = roadmap.roadmap().reachableFrom(start),
                          there = roadmap.roadmap().reaching(goal);
  for (const RefusedEdge& edge : roadmap.refused()) {
    all.push_back(edge.failure);
    if (here[edge.from] && there[edge.to]) relevant.push_back(edge.failure);
  }
  return relevant.empty() ? all : relevant;
}

void describeRoadmap(const SampledRoadmap& roadmap, PlanOutcome& outcome) {
  for (const RoadmapNode& node : roadmap.roadmap().nodes())
    outcome.roadmap.nodes.push_back({node.at.stance, node.kind});
  for (const RoadmapEdge& edge : roadmap.roadmap().edges())
    outcome.roadmap.edges.push_back({edge.from, edge.to});
  outcome.guards = roadmap.roadmap().count(NodeKind::kGuard);
  outcome.connectors = roadmap.roadmap().count(NodeKind::kConnector);
  outcome.edges = static_cast<int>(roadmap.roadmap().edges().size());
  outcome.samples += roadmap.samples();
  outcome.coverage = roadmap.coverage();
}

void describeCount(const SteeringCount& count, PlanOutcome& outcome) {
  for (const auto& [rule, times] : count.refusals) outcome.refusals[rule] += times;
  outcome.poses_checked += count.poses;
}

class RoadmapLegs : public LegPlanner {
 public:
  RoadmapLegs(const PlanRequest& request, const WalkSteering& steering, const SearchLimits& limits,
              std::unique_ptr<SampledRoadmap> roadmap)
      : request_(request), steering_(steering), limits_(limits), roadmap_(std::move(roadmap)) {}

  std::optional<std::vector<WalkEdge>> solve(const Waypoint& from, const Waypoint& to) override {
    from_ = from;
    to_ = to;
    auto begin = std::chrono::steady_clock::now();
    const auto waypoints = solveOn(*roadmap_, steering_, request_.bounds, from, to, limits_);
    times_.roadmap += seconds(begin);
    if (!waypoints) return std::nullopt;
    begin = std::chrono::steady_clock::now();
    auto edges = edgesAlong(*waypoints, steering_, count_, nullptr);
    times_.search += seconds(begin);
    return edges;
  }
  std::optional<Obstruction> why() const override {
    return mostOften(inTheWay(*roadmap_, from_, to_), request_.world->scene(),
                     request_.world->body());
  }
  void describe(PlanOutcome& outcome) const override {
    describeRoadmap(*roadmap_, outcome);
    describeCount(roadmap_->steering(), outcome);
    describeCount(count_, outcome);
    outcome.times.roadmap += times_.roadmap;
    outcome.times.search += times_.search;
  }

 private:
  const PlanRequest& request_;
  const WalkSteering& steering_;
  const SearchLimits& limits_;
  std::unique_ptr<SampledRoadmap> roadmap_;
  Waypoint from_, to_;
  SteeringCount count_;
  PlanTimes times_;
};

class RrtLegs : public LegPlanner {
 public:
  RrtLegs(const PlanRequest& request, const WalkSteering& steering, const SearchLimits& limits)
      : request_(request),
        steering_(steering),
        limits_(limits),
        space_(makeWalkSpace(steering, request.bounds, limits.seed)),
        planner_(makeRrtPlanner(space_, limits.seed)) {}

  std::optional<std::vector<WalkEdge>> solve(const Waypoint& from, const Waypoint& to) override {
    const auto begin = std::chrono::steady_clock::now();
    const long long samples = static_cast<long long>(kTreeSamplesPerFailure) * limits_.max_failures;
    const auto waypoints = solveWith(*planner_, from, to, limits_, samples);
    times_.roadmap += seconds(begin);
    if (!waypoints) return std::nullopt;
    return edgesAlong(*waypoints, steering_, count_, nullptr);
  }
  std::optional<Obstruction> why() const override {
    return mostOften(effortOf(space_).refused, request_.world->scene(), request_.world->body());
  }
  void describe(PlanOutcome& outcome) const override {
    const OmplEffort effort = effortOf(space_);
    outcome.samples += effort.samples;
    describeCount(effort.steering, outcome);
    describeCount(count_, outcome);
    outcome.times.roadmap += times_.roadmap;
  }

 private:
  const PlanRequest& request_;
  const WalkSteering& steering_;
  const SearchLimits& limits_;
  OmplSpacePtr space_;
  OmplPlannerPtr planner_;
  SteeringCount count_;
  PlanTimes times_;
};

/// Plans for the bounding cylinder on a visibility roadmap of its own, then animates the body along
/// the path, which turns on the spot at its corners; a contact invalidates the path, and it is
/// tried again with another seed.
class CylinderLegs : public LegPlanner {
 public:
  CylinderLegs(const PlanRequest& request, const WalkSteering& steering, const SearchLimits& limits)
      : request_(request),
        steering_(steering),
        limits_(limits),
        cylinder_(request.world->scene(), *request.ground, cylinderOf(request)) {}

  std::optional<std::vector<WalkEdge>> solve(const Waypoint& from, const Waypoint& to) override {
    refused_by_body_.clear();
    for (int attempt = 0; attempt < kCylinderAttempts && !limits_.stopped(); ++attempt) {
      const auto path = pathOfCylinder(from, to, attempt);
      if (!path) return std::nullopt;
      auto edges = edgesAlong(*path, steering_, count_, &refused_by_body_);
      if (edges) return edges;
    }
    return std::nullopt;
  }
  std::optional<Obstruction> why() const override {
    return why_cylinder_ ? why_cylinder_ : whyBody();
  }
  void describe(PlanOutcome& outcome) const override {
    if (roadmap_) describeRoadmap(*roadmap_, outcome);
    describeCount(count_, outcome);
    outcome.times.roadmap += times_.roadmap;
  }

 private:
  static CylinderSteering::Settings cylinderOf(const PlanRequest& request) {
    const WalkSynthesizer& synthesizer = *request.synthesizer;
    const StraightWalk walk = straightWalk(synthesizer, *request.ground, kMeasuredWalk);
    const double radius = boundingRadius(walk, synthesizer.skeleton(), request.world->body());
    return {std::max(radius, kThinnestCylinder), synthesizer.stature(),
            synthesizer.settings().speed};
  }
  std::optional<Obstruction> whyBody() const {
    return mostOften(refused_by_body_, request_.world->scene(), request_.world->body());
  }
  std::optional<std::vector<Waypoint>> pathOfCylinder(const Waypoint& from, const Waypoint& to,
                                                      int attempt);

  const PlanRequest& request_;
  const WalkSteering& steering_;
  const SearchLimits& limits_;
  CylinderSteering cylinder_;
  std::unique_ptr<VisibilityRoadmap> roadmap_;  // of the last attempt
  std::vector<SteeringFailure> refused_by_body_;
  std::optional<Obstruction> why_cylinder_;
  SteeringCount count_;
  PlanTimes times_;
};

std::optional<std::vector<Waypoint>> CylinderLegs::pathOfCylinder(const Waypoint& from,
                                                                  const Waypoint& to, int attempt) {
  const auto begin = std::chrono::steady_clock::now();
  SearchLimits limits = limits_;
  limits.seed += static_cast<std::uint64_t>(attempt);
  roadmap_ = std::make_unique<VisibilityRoadmap>(cylinder_, request_.bounds);
  const auto waypoints = solveOn(*roadmap_, cylinder_, request_.bounds, from, to, limits);
  count_.add(roadmap_->steering());
  std::optional<std::vector<Waypoint>> path;
  if (waypoints) {
    SteeringCount ignored;
    EdgePath edges{*edgesAlong(*waypoints, cylinder_, count_, nullptr), {}, from, to};
    edges.pinned.assign(edges.edges.size() + 1, false);
    edges = refineWalk(cylinder_, std::move(edges), {.walk_on = false}, limits, ignored);
    path.emplace(1, from);
    for (size_t i = 1; i < edges.edges.size(); ++i) {  // corners, headed as the walk goes on
      path->push_back({edges.edges[i].from});
      path->back().stance.heading = edges.edges[i].path.at(0.0).heading;
    }
    path->push_back(to);
  } else {
    why_cylinder_ = mostOften(inTheWay(*roadmap_, from, to), request_.world->scene(),
                              Body{{{"bounding cylinder", 0, {}, {}, 0.0, -1}}, {}});
  }
  times_.roadmap += seconds(begin);
  return path;
}

}  // namespace

std::string nameOf(const SceneObject& object) {
  return object.part.empty() ? object.name : object.name + ": " + object.part;
}

std::optional<Obstruction> mostOften(const std::vector<SteeringFailure>& refusals,
                                     const Scene& scene, const Body& body) {
  using Key = std::tuple<std::string, int>;  // rule, object or part
  const auto best = [](const std::map<Key, long long>& counts) {
    return std::max_element(counts.begin(), counts.end(),
                            [](auto& a, auto& b) { return a.second < b.second; });
  };
  if (refusals.empty()) return std::nullopt;
  std::map<Key, long long> by_object, by_part;
  for (const SteeringFailure& failure : refusals)
    ++by_object[{std::string(failure.rule), failure.object}];
  const auto [rule, object] = best(by_object)->first;
  Obstruction why;
  why.rule = rule;
  why.count = best(by_object)->second;
  why.gap = HUGE_VAL;
  for (const SteeringFailure& failure : refusals) {
    if (failure.rule != rule || failure.object != object) continue;
    ++by_part[{rule, failure.part}];
    why.gap = std::min(why.gap, failure.gap);
  }
  const int part = std::get<1>(best(by_part)->first);
  if (object >= 0) why.object = nameOf(scene.objects[object]);
  if (part >= 0) why.part = body.parts[part].name;
  return why;
}

std::unique_ptr<LegPlanner> makeLegPlanner(const PlanRequest& request, const WalkSteering& steering,
                                           const SearchLimits& limits) {
  if (request.planner == "visibility") {
    return std::make_unique<RoadmapLegs>(
        request, steering, limits, std::make_unique<VisibilityRoadmap>(steering, request.bounds));
  }
  if (request.planner == "prm") {
    return std::make_unique<RoadmapLegs>(
        request, steering, limits, std::make_unique<NearestRoadmap>(steering, request.bounds));
  }
  if (request.planner == "rrt") return std::make_unique<RrtLegs>(request, steering, limits);
  if (request.planner == "cylinder")
    return std::make_unique<CylinderLegs>(request, steering, limits);
  throw std::invalid_argument("unknown planner: " + request.planner);
}

}  // namespace amble

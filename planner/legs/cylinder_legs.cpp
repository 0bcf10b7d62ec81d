#include "planner/legs/cylinder_legs.h"

#include <algorithm>

#include "base/stopwatch.h"
#include "planner/ompl/roadmap_planner.h"
#include "planner/refine_walk.h"
#include "planner/roadmap/visibility_roadmap.h"
#include "planner/steering/cylinder_steering.h"
#include "planner/why/obstruction.h"

namespace amble {
namespace {

// How often a path is planned anew, with another seed, when the animated body touches something on
// it.
constexpr int kAttempts = 10;
// Where there is no ground for that walk: half of two elbows' breadth [m]
constexpr double kThinnestCylinder = 0.3;

CylinderSteering::Settings cylinderOf(const PlanRequest& request) {
  const WalkSynthesizer& synthesizer = *request.synthesizer;
  const StraightWalk walk = straightWalk(synthesizer);
  const double radius = boundingRadius(walk, synthesizer.skeleton(), request.world->body());
  return {std::max(radius, kThinnestCylinder), synthesizer.stature(), synthesizer.settings().speed};
}

class CylinderLegs : public LegPlanner {
 public:
  CylinderLegs(const PlanRequest& request, const WalkSteering& steering, const SearchLimits& limits)
      : request_(request),
        steering_(steering),
        limits_(limits),
        cylinder_(request.world->scene(), *request.ground, cylinderOf(request)),
        space_(makeWalkSpace(cylinder_, request.bounds, limits.seed)) {}

  std::optional<std::vector<WalkEdge>> solve(const Waypoint& from, const Waypoint& to) override {
    refused_by_body_.clear();
    for (int attempt = 0; attempt < kAttempts && !limits_.stopped(); ++attempt) {
      const auto path = pathOfCylinder(from, to, attempt);
      if (!path) return std::nullopt;
      if (auto edges = animated(*path)) return edges;
    }
    return std::nullopt;
  }
  std::optional<Obstruction> why() const override {
    if (why_cylinder_) return why_cylinder_;
    return whatStoodInTheWay(failuresOf(refused_by_body_), request_);
  }
  std::vector<const RefusedEdge*> refused() const override { return pointersTo(refused_by_body_); }
  void describe(PlanOutcome& outcome) const override {
    if (planner_) describeRoadmap(*roadmapOf(*planner_), outcome);
    describeCount(count_, outcome);
    outcome.times.roadmap += seconds_;
  }

 private:
  std::optional<std::vector<Waypoint>> pathOfCylinder(const Waypoint& from, const Waypoint& to,
                                                      int attempt);
  std::vector<Waypoint> corners(std::vector<WalkEdge> edges, const Waypoint& from,
                                const Waypoint& to, const SearchLimits& limits) const;
  std::optional<std::vector<WalkEdge>> animated(const std::vector<Waypoint>& path);

  const PlanRequest& request_;
  const WalkSteering& steering_;
  const SearchLimits& limits_;
  const CylinderSteering cylinder_;
  const OmplSpacePtr space_;
  OmplPlannerPtr planner_;  // of the last attempt
  std::vector<RefusedEdge> refused_by_body_;
  std::optional<Obstruction> why_cylinder_;
  SteeringCount count_;
  double seconds_ = 0.0;
};

std::optional<std::vector<Waypoint>> CylinderLegs::pathOfCylinder(const Waypoint& from,
                                                                  const Waypoint& to, int attempt) {
  const Stopwatch watch;
  SearchLimits limits = limits_;
  limits.seed += static_cast<std::uint64_t>(attempt);
  restart(*space_, limits.seed);
  planner_ =
      makeRoadmapPlanner(space_, std::make_unique<VisibilityRoadmap>(samplerOf(*space_)), limits);
  auto edges = solveWith(*planner_, from, to, limits, 1);
  const SampledRoadmap& roadmap = *roadmapOf(*planner_);
  count_.add(roadmap.steering());
  std::optional<std::vector<Waypoint>> path;
  if (edges) {
    path = corners(std::move(*edges), from, to, limits);
  } else {
    why_cylinder_ = mostOften(inTheWay(roadmap, from, to), request_.world->scene(),
                              Body{{{"bounding cylinder", 0, {}, {}, 0.0, -1}}});
  }
  seconds_ += watch.seconds();
  return path;
}

// Corners of the path, made shorter, headed as the walk goes on from there.
std::vector<Waypoint> CylinderLegs::corners(std::vector<WalkEdge> edges, const Waypoint& from,
                                            const Waypoint& to, const SearchLimits& limits) const {
  SteeringCount ignored;
  EdgePath walk{std::move(edges), {}, from, to};
  walk.pinned.assign(walk.edges.size() + 1, false);
  walk = refineWalk(cylinder_, std::move(walk), {.walk_on = false}, limits, ignored);
  std::vector<Waypoint> path = {from};
  for (size_t i = 1; i < walk.edges.size(); ++i) {
    path.push_back({walk.edges[i].from});
    path.back().stance.heading = walk.edges[i].path.at(0.0).heading;
  }
  path.push_back(to);
  return path;
}

// The body's own edges along the path, or none where one is refused.
std::optional<std::vector<WalkEdge>> CylinderLegs::animated(const std::vector<Waypoint>& path) {
  const SteeringScratchPtr scratch = steering_.makeScratch();
  std::vector<WalkEdge> edges;
  for (size_t i = 0; i + 1 < path.size(); ++i) {
    SteerResult result = steering_.steer(path[i], path[i + 1], *scratch);
    count_.add(result);
    if (!result.edge) {
      refused_by_body_.push_back({path[i], path[i + 1], result.failure});
      return std::nullopt;
    }
    edges.push_back(std::move(*result.edge));
  }
  return edges;
}

}  // namespace

LegPlannerPtr makeCylinderLegs(const PlanRequest& request, const WalkSteering& steering,
                               const SearchLimits& limits) {
  return std::make_unique<CylinderLegs>(request, steering, limits);
}

}  // namespace amble

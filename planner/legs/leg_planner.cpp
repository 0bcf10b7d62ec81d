#include "planner/legs/leg_planner.h"

namespace amble {
namespace {

constexpr double kLineSpacing = 0.1;  // between points of an edge's picture [m]
constexpr size_t kFew = 20;           // refusals that say less than all do

int findNode(const Roadmap& roadmap, const Waypoint& at, bool last) {
  int found = -1;
  for (int node = 0; node < roadmap.size(); ++node) {
    const Stance& stance = roadmap.nodes()[node].at.stance;
    if (stance.position != at.stance.position || stance.heading != at.stance.heading) continue;
    if (found < 0 || last) found = node;
  }
  return found;
}

// The root path of an edge; nothing where it only turns.
std::vector<Eigen::Vector2d> lineOf(const WalkEdge& walk) {
  std::vector<Eigen::Vector2d> line;
  if (walk.path.empty()) return line;
  const int count = 1 + static_cast<int>(walk.length / kLineSpacing);
  for (int i = 0; i <= count; ++i) line.push_back(walk.path.at(walk.length * i / count).position);
  return line;
}

}  // namespace

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
  return relevant.size() < kFew ? all : relevant;
}

void describeRoadmap(const SampledRoadmap& roadmap, PlanOutcome& outcome) {
  for (const RoadmapNode& node : roadmap.roadmap().nodes())
    outcome.roadmap.nodes.push_back({node.at.stance, node.kind});
  for (const RoadmapEdge& edge : roadmap.roadmap().edges())
    outcome.roadmap.edges.push_back({edge.from, edge.to, lineOf(edge.walk)});
  outcome.guards = roadmap.roadmap().count(NodeKind::kGuard);
  outcome.connectors = roadmap.roadmap().count(NodeKind::kConnector);
  outcome.edges = static_cast<int>(roadmap.roadmap().edges().size());
  outcome.samples += roadmap.samples();
  outcome.coverage = roadmap.coverage();
  outcome.proved = roadmap.shutOff().has_value();
}

void describeCount(const SteeringCount& count, PlanOutcome& outcome) {
  for (const auto& [rule, times] : count.refusals) outcome.refusals[rule] += times;
  outcome.poses_checked += count.poses;
}

}  // namespace amble

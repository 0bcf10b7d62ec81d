#include "planner/legs/leg_planner.h"

#include <algorithm>
#include <utility>

#include "planner/why/obstruction.h"

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

RoadmapPicture::Node pictureOf(const Waypoint& at, NodeKind kind) {
  return {at.stance, kind, at.any_heading, at.any_leading};
}

// Of as many as there are so many, evenly spread over their order.
std::vector<const RefusedEdge*> thinned(const std::vector<const RefusedEdge*>& edges, size_t most) {
  std::vector<const RefusedEdge*> few;
  const size_t count = std::min(most, edges.size());
  for (size_t i = 0; i < count; ++i) few.push_back(edges[i * edges.size() / count]);
  return few;
}

// The nearest to a place, in the order that they have.
std::vector<const RefusedEdge*> nearest(const std::vector<const RefusedEdge*>& edges,
                                        const Eigen::Vector3d& place, size_t most) {
  std::vector<std::pair<double, size_t>> order;
  for (size_t i = 0; i < edges.size(); ++i)
    order.emplace_back((edges[i]->failure.at - place).squaredNorm(), i);
  const size_t count = std::min(most, order.size());
  std::nth_element(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count), order.end());
  order.resize(count);
  std::sort(order.begin(), order.end(),
            [](const auto& a, const auto& b) { return a.second < b.second; });
  std::vector<const RefusedEdge*> few;
  for (const auto& [distance, i] : order) few.push_back(edges[i]);
  return few;
}

}  // namespace

std::vector<Eigen::Vector2d> lineOf(const WalkEdge& walk) {
  std::vector<Eigen::Vector2d> line;
  if (walk.path.empty()) return line;
  const int count = 1 + static_cast<int>(walk.length / kLineSpacing);
  for (int i = 0; i <= count; ++i) line.push_back(walk.path.at(walk.length * i / count).position);
  return line;
}

std::vector<SteeringFailure> failuresOf(const std::vector<RefusedEdge>& refused) {
  std::vector<SteeringFailure> failures;
  for (const RefusedEdge& edge : refused) failures.push_back(edge.failure);
  return failures;
}

std::vector<SteeringFailure> inTheWay(const SampledRoadmap& roadmap, const Waypoint& from,
                                      const Waypoint& to) {
  const int start = findNode(roadmap.roadmap(), from, false),
            goal = findNode(roadmap.roadmap(), to, true);
  std::vector<SteeringFailure> relevant, all;
  if (start < 0 || goal < 0) return all;
  const std::vector<bool> here = roadmap.roadmap().reachableFrom(start),
                          there = roadmap.roadmap().reaching(goal);
  for (const RefusedLink& link : roadmap.refused()) {
    if (link.from_node < 0) continue;
    all.push_back(link.failure);
    if (here[link.from_node] && there[link.to_node]) relevant.push_back(link.failure);
  }
  return whereMostWereRefused(relevant.size() < kFew ? all : relevant, roadmap.way());
}

void describeRoadmap(const SampledRoadmap& roadmap, PlanOutcome& outcome) {
  for (const RoadmapNode& node : roadmap.roadmap().nodes())
    outcome.roadmap.nodes.push_back(pictureOf(node.at, node.kind));
  for (const RoadmapEdge& edge : roadmap.roadmap().edges())
    outcome.roadmap.edges.push_back({edge.from, edge.to, lineOf(edge.walk)});
  outcome.guards = roadmap.roadmap().count(NodeKind::kGuard);
  outcome.connectors = roadmap.roadmap().count(NodeKind::kConnector);
  outcome.edges = static_cast<int>(roadmap.roadmap().edges().size());
  outcome.samples += roadmap.samples();
  outcome.coverage = roadmap.coverage();
  outcome.proved = roadmap.shutOff().has_value();
}

void describeRefused(std::vector<const RefusedEdge*> refused,
                     const std::optional<Eigen::Vector3d>& stopped_at, PlanOutcome& outcome) {
  constexpr size_t kMost = RoadmapPicture::kMostRefused;
  refused = stopped_at ? nearest(refused, *stopped_at, kMost) : thinned(refused, kMost);
  for (const RefusedEdge* edge : refused) {
    const SteeringFailure& why = edge->failure;
    outcome.roadmap.refused.push_back({pictureOf(edge->from, NodeKind::kSample),
                                       pictureOf(edge->to, NodeKind::kSample), why.rule, why.part,
                                       why.object, why.at});
  }
}

void describeCount(const SteeringCount& count, PlanOutcome& outcome) {
  for (const auto& [rule, times] : count.refusals) outcome.refusals[rule] += times;
  outcome.poses_checked += count.poses;
}

}  // namespace amble

#include "planner/roadmap/nearest_roadmap.h"

#include <algorithm>

namespace amble {

Verdict NearestRoadmap::judge(Candidate& candidate, SteeringScratch& scratch) const {
  std::vector<std::pair<double, int>> order;
  for (int node = 0; node < roadmap().size(); ++node) {
    const Eigen::Vector3d& position = roadmap().nodes()[node].at.stance.position;
    order.emplace_back((position - candidate.at.stance.position).squaredNorm(), node);
  }
  std::sort(order.begin(), order.end());
  if (order.size() > kNeighbours) order.resize(kNeighbours);
  Verdict verdict;
  verdict.keep = true;
  verdict.kind = NodeKind::kSample;
  for (const auto& [distance, node] : order) {
    const RoadmapNode& other = roadmap().nodes()[node];
    if (candidate.leave && other.enter) ask(candidate, {node, true}, verdict, scratch);
    if (candidate.enter && other.leave) ask(candidate, {node, false}, verdict, scratch);
  }
  return verdict;
}

}  // namespace amble

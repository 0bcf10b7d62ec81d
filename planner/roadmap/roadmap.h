/// A roadmap of directed edges: nodes are waypoints, an edge was checked in its own direction only
/// (DESIGN.md, section 8).
///
/// Components are the strongly connected ones. Roadmaps of the visibility PRM stay tiny (tens of
/// nodes), so questions are answered by plain searches over the edges: O(nodes + edges) each.
#pragma once

#include <optional>
#include <vector>

#include "planner/plan_request.h"
#include "planner/steering/steering.h"

namespace amble {

struct RoadmapNode {
  Waypoint at;
  NodeKind kind = NodeKind::kSample;
  bool enter = true;  ///< edges may end here
  bool leave = true;  ///< edges may begin here
};

struct RoadmapEdge {
  int from = -1;
  int to = -1;
  WalkEdge walk;
};

class Roadmap {
 public:
  int addNode(RoadmapNode node);
  /// @pre there is no edge from `from` to `to` yet.
  int addEdge(int from, int to, WalkEdge walk);

  const std::vector<RoadmapNode>& nodes() const { return nodes_; }
  const std::vector<RoadmapEdge>& edges() const { return edges_; }
  int size() const { return static_cast<int>(nodes_.size()); }
  int count(NodeKind kind) const;
  bool hasEdge(int from, int to) const;

  /// By node: whether walks lead there from `node`, itself included.
  std::vector<bool> reachableFrom(int node) const { return search(node, out_, &RoadmapEdge::to); }
  /// By node: whether walks lead from there to `node`, itself included.
  std::vector<bool> reaching(int node) const { return search(node, in_, &RoadmapEdge::from); }
  /// By node: its strongly connected component, numbered in the order of their lowest nodes.
  std::vector<int> components() const;

  /// Edges of the walk of least cost, time and effort, or none (Dijkstra). Of equal ones the one
  /// found from lower nodes.
  std::optional<std::vector<int>> shortestPath(int from, int to) const;

 private:
  std::vector<bool> search(int node, const std::vector<std::vector<int>>& edges_of,
                           int RoadmapEdge::*next) const;

  std::vector<RoadmapNode> nodes_;
  std::vector<RoadmapEdge> edges_;
  std::vector<std::vector<int>> out_, in_;  // edges of each node
};

}  // namespace amble

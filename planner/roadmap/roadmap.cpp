#include "planner/roadmap/roadmap.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <set>
#include <utility>

namespace amble {

int Roadmap::addNode(RoadmapNode node) {
  nodes_.push_back(std::move(node));
  out_.emplace_back();
  in_.emplace_back();
  return size() - 1;
}

int Roadmap::addEdge(int from, int to, WalkEdge walk) {
  assert(!hasEdge(from, to));
  const int edge = static_cast<int>(edges_.size());
  edges_.push_back({from, to, std::move(walk)});
  out_[from].push_back(edge);
  in_[to].push_back(edge);
  return edge;
}

int Roadmap::count(NodeKind kind) const {
  return static_cast<int>(std::count_if(
      nodes_.begin(), nodes_.end(), [&](const RoadmapNode& node) { return node.kind == kind; }));
}

bool Roadmap::hasEdge(int from, int to) const {
  return std::any_of(out_[from].begin(), out_[from].end(),
                     [&](int edge) { return edges_[edge].to == to; });
}

std::vector<bool> Roadmap::search(int node, const std::vector<std::vector<int>>& edges_of,
                                  int RoadmapEdge::*next) const {
  std::vector<bool> seen(nodes_.size(), false);
  std::vector<int> open = {node};
  seen[node] = true;
  while (!open.empty()) {
    const int at = open.back();
    open.pop_back();
    for (const int edge : edges_of[at]) {
      const int neighbour = edges_[edge].*next;
      if (seen[neighbour]) continue;
      seen[neighbour] = true;
      open.push_back(neighbour);
    }
  }
  return seen;
}

std::vector<int> Roadmap::components() const {
  std::vector<int> component(nodes_.size(), -1);
  int count = 0;
  for (int node = 0; node < size(); ++node) {
    if (component[node] >= 0) continue;
    const std::vector<bool> after = reachableFrom(node);
    const std::vector<bool> before = reaching(node);
    for (int other = node; other < size(); ++other) {
      if (after[other] && before[other]) component[other] = count;
    }
    ++count;
  }
  return component;
}

std::optional<std::vector<int>> Roadmap::shortestPath(int from, int to) const {
  std::vector<double> time(nodes_.size(), std::numeric_limits<double>::infinity());
  std::vector<int> by(nodes_.size(), -1);  // the edge a node was reached by
  std::set<std::pair<double, int>> open = {{0.0, from}};
  time[from] = 0.0;
  while (!open.empty()) {
    const int at = open.begin()->second;
    open.erase(open.begin());
    if (at == to) break;
    for (const int edge : out_[at]) {
      const int next = edges_[edge].to;
      const double arrival = time[at] + edges_[edge].walk.cost();
      if (arrival >= time[next]) continue;
      open.erase({time[next], next});
      time[next] = arrival;
      by[next] = edge;
      open.insert({arrival, next});
    }
  }
  if (from != to && by[to] < 0) return std::nullopt;
  std::vector<int> path;
  for (int at = to; at != from; at = edges_[by[at]].from) path.push_back(by[at]);
  std::reverse(path.begin(), path.end());
  return path;
}

}  // namespace amble

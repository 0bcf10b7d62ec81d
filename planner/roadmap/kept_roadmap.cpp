#include "planner/roadmap/kept_roadmap.h"

#include <algorithm>

#include "base/sha256.h"
#include "base/text.h"
#include "planner/roadmap/sampled_roadmap.h"

namespace amble {

int KeptRoadmap::count(NodeKind kind) const {
  return static_cast<int>(std::count_if(nodes.begin(), nodes.end(),
                                        [&](const Node& node) { return node.kind == kind; }));
}

// Tarjan (SIAM Journal on Computing 1(2), 1972), without recursion: a file may hold a chain of any
// length.
int KeptRoadmap::pieces() const {
  const int size = static_cast<int>(nodes.size());
  std::vector<std::vector<int>> next(size);
  for (const Edge& edge : edges) next[edge.from].push_back(edge.to);
  std::vector<int> index(size, -1), low(size, 0), open, way;
  std::vector<size_t> done(size, 0);  // edges of each node that were followed
  std::vector<bool> is_open(size, false);
  int count = 0, pieces = 0;
  const auto enter = [&](int node) {
    index[node] = low[node] = count++;
    way.push_back(node);
    open.push_back(node);
    is_open[node] = true;
  };
  const auto leave = [&](int node) {
    way.pop_back();
    if (!way.empty()) low[way.back()] = std::min(low[way.back()], low[node]);
    if (low[node] < index[node]) return;
    ++pieces;
    int last = -1;
    while (last != node) {
      last = open.back();
      open.pop_back();
      is_open[last] = false;
    }
  };
  for (int first = 0; first < size; ++first) {
    if (index[first] < 0) enter(first);
    while (!way.empty()) {
      const int node = way.back();
      if (done[node] == next[node].size()) {
        leave(node);
        continue;
      }
      const int to = next[node][done[node]++];
      if (index[to] < 0)
        enter(to);
      else if (is_open[to])
        low[node] = std::min(low[node], index[to]);
    }
  }
  return pieces;
}

// "speed 1.2, was 1" for each value that is another, or is not in both; nothing where none is.
static std::vector<std::string> changes(const RoadmapSource::Values& then,
                                        const RoadmapSource::Values& now) {
  constexpr size_t kLongest = 40;  // of a value that is told: digests are not
  std::vector<std::string> list;
  for (const auto& [key, value] : now) {
    const auto old = then.find(key);
    if (old != then.end() && old->second == value) continue;
    std::string text = key;
    if (value.size() <= kLongest) text += " " + value;
    if (old != then.end() && old->second.size() <= kLongest) text += ", was " + old->second;
    list.push_back(text);
  }
  for (const auto& [key, value] : then)
    if (!now.contains(key)) list.push_back(key + " is gone");
  return list;
}

std::string whatChanged(const RoadmapSource& then, const RoadmapSource& now) {
  std::vector<std::string> parts;
  const auto old = then.parts(), now_parts = now.parts();
  for (size_t i = 0; i < old.size(); ++i) {
    const std::vector<std::string> list = changes(*old[i].second, *now_parts[i].second);
    if (!list.empty()) parts.push_back(std::string(old[i].first) + " (" + joined(list, "; ") + ")");
  }
  return joined(parts, ", ", " and ");
}

std::string digestOf(const RoadmapSource::Values& values) {
  std::string text;
  for (const auto& [key, value] : values) text += key + " " + value + "\n";
  return sha256(text);
}

KeptRoadmap keep(const SampledRoadmap& grown) {
  KeptRoadmap kept;
  for (const RoadmapNode& node : grown.roadmap().nodes())
    kept.nodes.push_back({node.at.stance, node.kind});
  for (const RoadmapEdge& edge : grown.roadmap().edges())
    kept.edges.push_back({edge.from, edge.to, edge.walk.cost()});
  kept.samples = grown.samples();
  kept.coverage = grown.coverage();
  return kept;
}

}  // namespace amble

#include "planner/roadmap/kept_roadmap.h"

#include <algorithm>

#include "base/sha256.h"
#include "base/text.h"
#include "planner/roadmap/sampled_roadmap.h"

namespace amble {

namespace {

// Strongly connected components, counted (Tarjan, SIAM Journal on Computing 1(2), 1972), without
// recursion: a file may hold a chain of any length.
class PieceCount {
 public:
  explicit PieceCount(const KeptRoadmap& roadmap)
      : next_(roadmap.nodes.size()),
        index_(roadmap.nodes.size(), -1),
        low_(roadmap.nodes.size(), 0),
        followed_(roadmap.nodes.size(), 0),
        is_open_(roadmap.nodes.size(), false) {
    for (const KeptRoadmap::Edge& edge : roadmap.edges) next_[edge.from].push_back(edge.to);
    for (size_t node = 0; node < next_.size(); ++node)
      if (index_[node] < 0) walkFrom(static_cast<int>(node));
  }
  int pieces() const { return pieces_; }

 private:
  void enter(int node) {
    index_[node] = low_[node] = entered_++;
    way_.push_back(node);
    open_.push_back(node);
    is_open_[node] = true;
  }
  // All behind it was followed: it is the first of its piece, or leads back to one before it.
  void leave(int node) {
    way_.pop_back();
    if (!way_.empty()) low_[way_.back()] = std::min(low_[way_.back()], low_[node]);
    if (low_[node] < index_[node]) return;
    ++pieces_;
    for (int last = -1; last != node; open_.pop_back()) {
      last = open_.back();
      is_open_[last] = false;
    }
  }
  void walkFrom(int first) {
    enter(first);
    while (!way_.empty()) {
      const int node = way_.back();
      if (followed_[node] == next_[node].size()) {
        leave(node);
        continue;
      }
      const int to = next_[node][followed_[node]++];
      if (index_[to] < 0)
        enter(to);
      else if (is_open_[to])
        low_[node] = std::min(low_[node], index_[to]);
    }
  }

  std::vector<std::vector<int>> next_;
  std::vector<int> index_, low_;  // in the order of entering: its own, and the first it leads to
  std::vector<size_t> followed_;  // of each node's edges
  std::vector<bool> is_open_;     // of no piece yet
  std::vector<int> open_, way_;
  int entered_ = 0, pieces_ = 0;
};

// What a file says, for a message: short, and as text.
std::string told(const std::string& text) {
  constexpr size_t kLongest = 60;  // [bytes]
  const std::string clean = utf8Text(withoutControls(text.substr(0, kLongest)));
  return text.size() > kLongest ? clean + "..." : clean;
}

// "speed 1.2, was 1" for each value that is another, or is not in both; nothing where none is.
std::vector<std::string> changes(const RoadmapSource::Values& then,
                                 const RoadmapSource::Values& now) {
  constexpr size_t kLongest = 40;  // of a value that is told: digests are not
  constexpr size_t kMostTold = 4;
  std::vector<std::string> list;
  for (const auto& [key, value] : now) {
    const auto old = then.find(key);
    if (old != then.end() && old->second == value) continue;
    std::string text = key;
    if (value.size() <= kLongest) text += " " + value;
    if (old != then.end() && old->second.size() <= kLongest) text += ", was " + told(old->second);
    list.push_back(text);
  }
  for (const auto& [key, value] : then)
    if (!now.contains(key)) list.push_back(told(key) + " is gone");
  if (list.size() > kMostTold) {
    list.resize(kMostTold);
    list.push_back("and others");
  }
  return list;
}

}  // namespace

int KeptRoadmap::count(NodeKind kind) const {
  return static_cast<int>(std::count_if(nodes.begin(), nodes.end(),
                                        [&](const Node& node) { return node.kind == kind; }));
}

int KeptRoadmap::pieces() const { return PieceCount(*this).pieces(); }

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

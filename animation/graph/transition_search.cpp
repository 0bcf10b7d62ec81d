#include "animation/graph/transition_search.h"

#include <algorithm>
#include <limits>
#include <queue>
#include <tuple>

namespace amble {
namespace {

FrameJump jumpOf(const ClusterGraph& graph, int leave, int enter) {
  return {leave, enter, graph.error(leave, enter)};
}

GraphWay oneJump(int from, int to, const FrameJump& jump) {
  return {{jump}, jump.error, std::abs(jump.leave - from) + std::abs(to - jump.enter)};
}

bool hasRoom(const ClusterGraph& graph, const FrameJump& jump) {
  return graph.hasRoom(jump.leave) && graph.hasRoom(jump.enter);
}

// Of all single jumps from `from` on to what is before `to`, the one whose rank is least.
template <typename Rank>
std::optional<GraphWay> leastJump(const ClusterGraph& graph, const GraphCut& cut, int from, int to,
                                  const Rank& rank) {
  const int clip = graph.clipOf(from), other = graph.clipOf(to);
  std::optional<GraphWay> least, least_tight;
  for (int s = cut.sequence_of[from]; s < static_cast<int>(cut.sequences.size()); ++s) {
    const FrameSequence& leaving = cut.sequences[s];
    if (leaving.clip != clip) break;
    if (leaving.alignment < from) continue;
    for (const int r : cut.clusters[leaving.cluster].sequences) {
      const FrameSequence& entered = cut.sequences[r];
      if (r == s || entered.clip != other || entered.alignment > to) continue;
      const GraphWay way = oneJump(from, to, jumpOf(graph, leaving.alignment, entered.alignment));
      std::optional<GraphWay>& best = hasRoom(graph, way.jumps[0]) ? least : least_tight;
      if (!best || rank(way) < rank(*best)) best = way;
    }
  }
  return least ? least : least_tight;
}

/// Dijkstra over sequences: to be at one is to have come to its alignment frame, from which the
/// clip is played on or left.
class ThroughSearch {
 public:
  ThroughSearch(const ClusterGraph& graph, const GraphCut& cut, int to, int least_stay, bool tight)
      : graph_(graph),
        cut_(cut),
        to_(to),
        clip_(graph.clipOf(to)),
        least_stay_(least_stay),
        tight_(tight) {}

  std::optional<GraphWay> from(int frame) {
    reached_.assign(cut_.sequences.size(), {});
    const int first = nextFrom(cut_.sequence_of[frame], frame);
    if (first >= 0) reach(first, {0.0, 0, -1, {}});
    while (!open_.empty()) {
      const auto [error, jumps, s] = open_.top();
      open_.pop();
      if (s == kArrived) return wayBack(frame);
      if (std::tie(error, jumps) != std::tie(reached_[s].error, reached_[s].jumps)) continue;
      goOn(s);
    }
    return std::nullopt;
  }

 private:
  static constexpr int kArrived = std::numeric_limits<int>::max();
  struct Reached {
    double error = std::numeric_limits<double>::infinity();
    int jumps = 0;
    int before = -1;  // the sequence that was left, or played on from; -1: the begin
    std::optional<FrameJump> jump;
  };
  using Entry = std::tuple<double, int, int>;  // error, jumps, sequence

  // The first sequence of the clip, from `s` on, that is come to at `frame` or later; -1: none.
  int nextFrom(int s, int frame) const {
    const int clip = cut_.sequences[s].clip;
    for (; s < static_cast<int>(cut_.sequences.size()); ++s) {
      if (cut_.sequences[s].clip != clip) return -1;
      if (cut_.sequences[s].alignment >= frame) return s;
    }
    return -1;
  }

  void reach(int s, const Reached& how) {
    Reached& best = s == kArrived ? arrived_ : reached_[s];
    if (std::tie(how.error, how.jumps) >= std::tie(best.error, best.jumps)) return;
    best = how;
    open_.push({how.error, how.jumps, s});
  }

  void goOn(int s) {
    const Reached at = reached_[s];
    const FrameSequence& here = cut_.sequences[s];
    const int on = nextFrom(s, here.alignment + 1);
    if (on >= 0) reach(on, {at.error, at.jumps, s, {}});
    for (const int r : cut_.clusters[here.cluster].sequences) {
      if (r == s) continue;
      const FrameSequence& entered = cut_.sequences[r];
      const FrameJump jump = jumpOf(graph_, here.alignment, entered.alignment);
      if (!tight_ && !hasRoom(graph_, jump)) continue;
      const Reached how{at.error + jump.error, at.jumps + 1, s, jump};
      if (entered.clip == clip_ && entered.alignment <= to_) reach(kArrived, how);
      const int next = nextFrom(r, entered.alignment + least_stay_);
      if (next >= 0) reach(next, how);
    }
  }

  GraphWay wayBack(int frame) const {
    GraphWay way;
    way.error = arrived_.error;
    for (const Reached* at = &arrived_;; at = &reached_[at->before]) {
      if (at->jump) way.jumps.push_back(*at->jump);
      if (at->before < 0) break;
    }
    std::reverse(way.jumps.begin(), way.jumps.end());
    way.wait = way.jumps.front().leave - frame + to_ - way.jumps.back().enter;
    return way;
  }

  const ClusterGraph& graph_;
  const GraphCut& cut_;
  const int to_, clip_, least_stay_;
  const bool tight_;  // frames without room are taken, too
  std::vector<Reached> reached_;
  Reached arrived_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open_;
};

}  // namespace

std::optional<GraphWay> wayWithin(const ClusterGraph& graph, const GraphCut& cut, int from,
                                  int to) {
  const FrameSequence &leaving = cut.sequences[cut.sequence_of[from]],
                      &entered = cut.sequences[cut.sequence_of[to]];
  if (leaving.cluster != entered.cluster || &leaving == &entered) return std::nullopt;
  return oneJump(from, to, jumpOf(graph, leaving.alignment, entered.alignment));
}

std::optional<GraphWay> nearestWay(const ClusterGraph& graph, const GraphCut& cut, int from,
                                   int to) {
  return leastJump(graph, cut, from, to,
                   [](const GraphWay& way) { return std::make_tuple(way.wait, way.error); });
}

std::optional<GraphWay> bestWay(const ClusterGraph& graph, const GraphCut& cut, int from, int to) {
  return leastJump(graph, cut, from, to,
                   [](const GraphWay& way) { return std::make_tuple(way.error, way.wait); });
}

std::optional<GraphWay> wayThrough(const ClusterGraph& graph, const GraphCut& cut, int from, int to,
                                   const WaySearch& search) {
  if (graph.clipOf(from) == graph.clipOf(to) && from <= to) return GraphWay{{}, 0.0, to - from};
  for (const bool tight : {false, true}) {
    const auto way = ThroughSearch(graph, cut, to, search.least_stay, tight).from(from);
    if (way) return way;
  }
  return std::nullopt;
}

std::vector<FrameLoop> loopsOf(const ClusterGraph& graph, const GraphCut& cut, int clip,
                               int shortest) {
  std::vector<FrameLoop> loops;
  for (size_t s = 0; s < cut.sequences.size(); ++s) {
    const FrameSequence& later = cut.sequences[s];
    if (later.clip != clip) continue;
    for (const int r : cut.clusters[later.cluster].sequences) {
      const FrameSequence& earlier = cut.sequences[r];
      if (earlier.clip != clip || earlier.first >= later.first) continue;
      const auto [leave, enter] = bestPair(graph, later, earlier);
      if (leave - enter >= shortest) loops.push_back(jumpOf(graph, leave, enter));
    }
  }
  std::sort(loops.begin(), loops.end(), [&](const FrameLoop& a, const FrameLoop& b) {
    return std::make_tuple(!hasRoom(graph, a), a.error, a.enter, a.leave) <
           std::make_tuple(!hasRoom(graph, b), b.error, b.enter, b.leave);
  });
  return loops;
}

}  // namespace amble

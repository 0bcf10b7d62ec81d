#include "animation/graph/cluster_graph.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

#include "base/union_find.h"

namespace amble {

int GraphClip::inFile(int frame) const {
  return first_frame + static_cast<int>(std::lround((frame - first) * step));
}

int GraphClip::fromFile(int file_frame) const {
  const long frame = std::lround((file_frame - first_frame) / step);
  return frame < 0 || frame >= frames ? -1 : first + static_cast<int>(frame);
}

int ClusterGraph::clipOf(int frame) const {
  const auto after = std::upper_bound(clips.begin(), clips.end(), frame,
                                      [](int f, const GraphClip& clip) { return f < clip.first; });
  return static_cast<int>(after - clips.begin()) - 1;
}

bool ClusterGraph::hasRoom(int frame) const {
  const GraphClip& clip = clips[clipOf(frame)];
  return frame - clip.first >= kJoinRoom && clip.last() - frame >= kJoinRoom;
}

void growTrees(ClusterGraph& graph, int threads, const StopRequest& stop) {
  graph.merges.clear();
  for (int state = 0; state < kSupportStates; ++state) {
    std::vector<int> frames;
    for (int i = 0; i < graph.frames(); ++i)
      if (static_cast<int>(graph.states[i]) == state) frames.push_back(i);
    FrameFeatures features(kFeatureRows, static_cast<Eigen::Index>(frames.size()));
    for (size_t i = 0; i < frames.size(); ++i)
      features.col(static_cast<Eigen::Index>(i)) = graph.features.col(frames[i]);
    const int before = static_cast<int>(graph.merges.size());
    const int count = static_cast<int>(frames.size());
    const auto node = [&](int own) {
      return own < count ? frames[own] : graph.frames() + before + own - count;
    };
    for (const Merge& merge : agglomerate(std::move(features), threads, stop))
      graph.merges.push_back({node(merge.a), node(merge.b), merge.error});
  }
}

namespace {

// The cluster of each frame, by any of its frames.
std::vector<int> clusterRoots(const ClusterGraph& graph, double error) {
  const int frames = graph.frames(), merges = static_cast<int>(graph.merges.size());
  UnionFind clusters(frames);
  std::vector<int> any(frames + merges);  // a frame of each node
  std::vector<bool> whole(frames + merges, true);
  for (int i = 0; i < frames; ++i) any[i] = i;
  for (int k = 0; k < merges; ++k) {
    const Merge& merge = graph.merges[k];
    any[frames + k] = any[merge.a];
    whole[frames + k] =
        whole[merge.a] && whole[merge.b] && std::sqrt(static_cast<double>(merge.error)) <= error;
    if (whole[frames + k]) clusters.join(any[merge.a], any[merge.b]);
  }
  std::vector<int> roots(frames);
  for (int i = 0; i < frames; ++i) roots[i] = clusters.find(i);
  return roots;
}

void findSequences(const ClusterGraph& graph, const std::vector<int>& roots, GraphCut& cut) {
  std::vector<int> number(graph.frames(), -1);  // of a cluster, by root
  for (int i = 0, clip = 0; i < graph.frames(); ++i) {
    if (i > graph.clips[clip].last()) ++clip;
    int& cluster = number[roots[i]];
    if (cluster < 0) {
      cluster = static_cast<int>(cut.clusters.size());
      cut.clusters.push_back({graph.states[i], {}, {}, 0, 0.0});
    }
    if (i == graph.clips[clip].first || cluster != cut.sequences.back().cluster) {
      cut.clusters[cluster].sequences.push_back(static_cast<int>(cut.sequences.size()));
      cut.sequences.push_back({clip, cluster, i, i, i});
    }
    cut.sequences.back().last = i;
    cut.sequence_of.push_back(static_cast<int>(cut.sequences.size()) - 1);
    ++cut.clusters[cluster].frames;
  }
}

// Edges are what the clips themselves do: from the cluster of a sequence to that of the next.
void findEdges(GraphCut& cut) {
  std::vector<std::set<int>> next(cut.clusters.size());
  for (size_t s = 1; s < cut.sequences.size(); ++s) {
    const FrameSequence &from = cut.sequences[s - 1], &to = cut.sequences[s];
    if (from.clip == to.clip) next[from.cluster].insert(to.cluster);
  }
  for (size_t c = 0; c < next.size(); ++c)
    cut.clusters[c].next.assign(next[c].begin(), next[c].end());
}

void measureSpread(const ClusterGraph& graph, GraphCut& cut) {
  for (FrameCluster& cluster : cut.clusters) {
    Eigen::VectorXd mean = Eigen::VectorXd::Zero(kFeatureRows);
    const auto eachFrame = [&](const auto& visit) {
      for (const int s : cluster.sequences)
        for (int i = cut.sequences[s].first; i <= cut.sequences[s].last; ++i)
          visit(graph.features.col(i).cast<double>());
    };
    eachFrame([&](const auto& feature) { mean += feature; });
    mean /= cluster.frames;
    double sum = 0.0;
    eachFrame([&](const auto& feature) { sum += (feature - mean).squaredNorm(); });
    cluster.spread = std::sqrt(sum / cluster.frames);
  }
}

// One frame of each sequence, so that the errors from each to the next add up to least. The thesis
// keeps some of the best pairs of neighbours and looks for chains in them, which need not be there;
// here all pairs are kept, and the chain is found by going through the sequences once (Viterbi).
void alignCluster(const ClusterGraph& graph, const FrameCluster& cluster, GraphCut& cut) {
  std::vector<std::vector<int>> frames;
  for (const int s : cluster.sequences) frames.push_back(roomyFrames(graph, cut.sequences[s]));
  std::vector<std::vector<int>> came(frames.size());
  std::vector<double> total(frames[0].size(), 0.0);
  for (size_t k = 1; k < frames.size(); ++k) {
    std::vector<double> next;
    for (const int to : frames[k]) {
      double least = std::numeric_limits<double>::infinity();
      int best = 0;
      for (size_t i = 0; i < total.size(); ++i) {
        const double sum = total[i] + graph.error(frames[k - 1][i], to);
        if (sum < least) least = sum, best = static_cast<int>(i);
      }
      next.push_back(least);
      came[k].push_back(best);
    }
    total = std::move(next);
  }
  auto at = static_cast<int>(std::min_element(total.begin(), total.end()) - total.begin());
  // A sequence that is alone is alike to nothing: its middle.
  if (frames.size() == 1) at = static_cast<int>(total.size()) / 2;
  for (size_t k = frames.size(); k-- > 0;) {
    cut.sequences[cluster.sequences[k]].alignment = frames[k][at];
    if (k > 0) at = came[k][at];
  }
}

}  // namespace

GraphCut cutAt(const ClusterGraph& graph, double error) {
  GraphCut cut;
  cut.error = error;
  findSequences(graph, clusterRoots(graph, error), cut);
  findEdges(cut);
  measureSpread(graph, cut);
  for (const FrameCluster& cluster : cut.clusters) alignCluster(graph, cluster, cut);
  return cut;
}

std::vector<int> roomyFrames(const ClusterGraph& graph, const FrameSequence& sequence) {
  std::vector<int> roomy, all;
  for (int i = sequence.first; i <= sequence.last; ++i) {
    all.push_back(i);
    if (graph.hasRoom(i)) roomy.push_back(i);
  }
  return roomy.empty() ? all : roomy;
}

std::pair<int, int> bestPair(const ClusterGraph& graph, const FrameSequence& from,
                             const FrameSequence& to) {
  std::pair<int, int> best{from.first, to.first};
  float least = std::numeric_limits<float>::infinity();
  const std::vector<int> enters = roomyFrames(graph, to);
  for (const int i : roomyFrames(graph, from)) {
    for (const int j : enters) {
      const float e = frameError(graph.features, i, j);
      if (e < least) least = e, best = {i, j};
    }
  }
  return best;
}

}  // namespace amble

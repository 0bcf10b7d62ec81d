#include "animation/graph/cluster_graph.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "tests/animation/graph/graph_captures.h"

namespace amble {
namespace {

struct GraphOfCaptures : testing::Test {
  void SetUp() override { AMBLE_NEEDS_CAPTURES(); }
};
using GraphCutAt = GraphOfCaptures;

TEST_F(GraphCutAt, EveryFrameIsInOneSequenceAndEverySequenceInOneCluster) {
  const GraphCut cut = cutAt(someGraph(), kGraphError);
  int next = 0;
  for (size_t s = 0; s < cut.sequences.size(); ++s) {
    const FrameSequence& sequence = cut.sequences[s];
    EXPECT_EQ(sequence.first, next);
    EXPECT_LE(sequence.first, sequence.last);
    EXPECT_EQ(someGraph().clipOf(sequence.first), sequence.clip);
    EXPECT_EQ(someGraph().clipOf(sequence.last), sequence.clip);
    EXPECT_TRUE(sequence.first <= sequence.alignment && sequence.alignment <= sequence.last);
    for (int i = sequence.first; i <= sequence.last; ++i)
      EXPECT_EQ(someGraph().states[i], cut.clusters[sequence.cluster].state);
    next = sequence.last + 1;
  }
  EXPECT_EQ(next, someGraph().frames());
  size_t listed = 0;
  for (const FrameCluster& cluster : cut.clusters) listed += cluster.sequences.size();
  EXPECT_EQ(listed, cut.sequences.size());
}

TEST_F(GraphCutAt, ClustersAreThoseThatStoodWhenAgglomerationWouldHaveGoneOverTheError) {
  const ClusterGraph& graph = someGraph();
  const double error = kGraphError;
  const GraphCut cut = cutAt(graph, error);
  // Merges of each state in their order, up to the first that is over it.
  std::vector<std::vector<int>> frames(graph.frames());
  for (int i = 0; i < graph.frames(); ++i) frames[i] = {i};
  std::set<SupportState> over;
  std::set<std::vector<int>> standing(frames.begin(), frames.end());
  for (const Merge& merge : graph.merges) {
    std::vector<int> both = frames[merge.a];
    both.insert(both.end(), frames[merge.b].begin(), frames[merge.b].end());
    std::sort(both.begin(), both.end());
    const SupportState state = graph.states[both[0]];
    if (std::sqrt(static_cast<double>(merge.error)) > error) over.insert(state);
    if (!over.contains(state)) {
      standing.erase(frames[merge.a]);
      standing.erase(frames[merge.b]);
      standing.insert(both);
    }
    frames.push_back(both);
  }
  std::set<std::vector<int>> found;
  for (const FrameCluster& cluster : cut.clusters) {
    std::vector<int> own;
    for (const int s : cluster.sequences)
      for (int i = cut.sequences[s].first; i <= cut.sequences[s].last; ++i) own.push_back(i);
    found.insert(own);
  }
  EXPECT_EQ(found, standing);
}

TEST(GraphCutOfDrawn, WhatComesNearerOnlyByAMergeOverTheErrorStaysApart) {
  // A triangle whose third corner is farther from the others than they are from one another, and
  // nearer to their middle.
  ClusterGraph graph = drawnGraph({{0.0f, 2.0f, 1.0f}});
  graph.features(1, 2) = 1.9f;
  growTrees(graph, 1);
  EXPECT_EQ(cutAt(graph, 1.95).clusters.size(), 3u);
  EXPECT_EQ(cutAt(graph, 2.05).clusters.size(), 1u);
}

TEST_F(GraphCutAt, EdgesAreTheStepsOfTheClips) {
  const GraphCut cut = cutAt(someGraph(), kGraphError);
  std::set<std::pair<int, int>> edges, steps;
  for (size_t c = 0; c < cut.clusters.size(); ++c)
    for (const int next : cut.clusters[c].next) edges.insert({static_cast<int>(c), next});
  for (const GraphClip& clip : someGraph().clips)
    for (int i = clip.first; i < clip.last(); ++i)
      if (cut.sequence_of[i] != cut.sequence_of[i + 1])
        steps.insert({cut.clusterOf(i), cut.clusterOf(i + 1)});
  EXPECT_EQ(edges, steps);
}

TEST_F(GraphCutAt, AtNoErrorFramesAreAloneAndAtAnyEachStateIsOneCluster) {
  EXPECT_EQ(cutAt(someGraph(), 0.0).clusters.size(), static_cast<size_t>(someGraph().frames()));
  const std::set<SupportState> states(someGraph().states.begin(), someGraph().states.end());
  EXPECT_EQ(cutAt(someGraph(), 100.0).clusters.size(), states.size());
}

TEST_F(GraphCutAt, ACycleOfAWalkIsSomeTenClusters) {
  const ClusterGraph graph = makeGraph(graphClips({"accad_female1/Female1_B03_Walk1.bvh"}), 1);
  const GraphCut cut = cutAt(graph, kGraphError);
  // The thesis: five to ten. Between 2 and 4 s it walks steadily, 37 frames a cycle.
  std::set<int> clusters;
  for (int i = 80; i < 117; ++i) clusters.insert(cut.clusterOf(i));
  EXPECT_GE(clusters.size(), 5u);
  EXPECT_LE(clusters.size(), 16u);
}

TEST_F(GraphCutAt, AlignmentFramesAreNoWorseThanAnyOtherChain) {
  const GraphCut cut = cutAt(someGraph(), kGraphError);
  const auto chain = [&](const FrameCluster& cluster, const auto& frameOf) {
    double sum = 0.0;
    for (size_t k = 1; k < cluster.sequences.size(); ++k)
      sum += someGraph().error(frameOf(cut.sequences[cluster.sequences[k - 1]]),
                               frameOf(cut.sequences[cluster.sequences[k]]));
    return sum;
  };
  for (const FrameCluster& cluster : cut.clusters) {
    const double aligned = chain(cluster, [](const FrameSequence& s) { return s.alignment; });
    for (int part = 0; part <= 4; ++part)
      EXPECT_LE(aligned, 1e-6 + chain(cluster, [&](const FrameSequence& s) {
                           const std::vector<int> frames = roomyFrames(someGraph(), s);
                           return frames[(frames.size() - 1) * part / 4];
                         }));
  }
}

TEST_F(GraphCutAt, FramesOfTheFileAreFoundAgain) {
  for (const GraphClip& clip : someGraph().clips)
    for (int i = clip.first; i <= clip.last(); ++i) EXPECT_EQ(clip.fromFile(clip.inFile(i)), i);
}

}  // namespace
}  // namespace amble

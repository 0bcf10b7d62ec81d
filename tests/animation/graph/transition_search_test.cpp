#include "animation/graph/transition_search.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "tests/animation/graph/graph_captures.h"

namespace amble {
namespace {

struct Search : testing::Test {
  void SetUp() override {
    AMBLE_NEEDS_CAPTURES();
    cut = cutAt(someGraph(), kGraphError);
  }
  const ClusterGraph& graph = someGraph();
  GraphCut cut;

  int frame(int clip, int own) const { return graph.clips[clip].first + own; }
  void expectWay(const GraphWay& way, int from, int to) const {
    double error = 0.0;
    for (const FrameJump& jump : way.jumps) {
      EXPECT_EQ(graph.clipOf(from), graph.clipOf(jump.leave));
      EXPECT_GE(jump.leave, from);
      EXPECT_EQ(cut.clusterOf(jump.leave), cut.clusterOf(jump.enter));
      error += jump.error;
      from = jump.enter;
    }
    EXPECT_EQ(graph.clipOf(from), graph.clipOf(to));
    EXPECT_LE(from, to);
    EXPECT_NEAR(way.error, error, 1e-9);
  }
};
using TransitionSearch = Search;

TEST_F(TransitionSearch, FromAFrameOnToOneBeforeAnother) {
  const int from = frame(0, 60), to = frame(1, 120);
  for (const auto& way : {nearestWay(graph, cut, from, to), bestWay(graph, cut, from, to),
                          wayThrough(graph, cut, from, to)}) {
    ASSERT_TRUE(way);
    expectWay(*way, from, to);
  }
  EXPECT_LE(nearestWay(graph, cut, from, to)->wait, bestWay(graph, cut, from, to)->wait);
  EXPECT_LE(bestWay(graph, cut, from, to)->error, nearestWay(graph, cut, from, to)->error);
  EXPECT_LE(wayThrough(graph, cut, from, to)->error, bestWay(graph, cut, from, to)->error);
}

TEST_F(TransitionSearch, FramesOfOneClusterMeetAtItsAlignment) {
  for (const FrameCluster& cluster : cut.clusters) {
    if (cluster.sequences.size() < 2) continue;
    const FrameSequence &a = cut.sequences[cluster.sequences[0]],
                        &b = cut.sequences[cluster.sequences[1]];
    const auto way = wayWithin(graph, cut, a.last, b.first);
    ASSERT_TRUE(way);
    EXPECT_EQ(way->jumps[0].leave, a.alignment);
    EXPECT_EQ(way->jumps[0].enter, b.alignment);
    EXPECT_FALSE(wayWithin(graph, cut, a.first, a.last));
  }
}

/// Least errors of going from a frame to a sequence's alignment, by going over all jumps again and
/// again until nothing gets better (Bellman and Ford).
TEST_F(TransitionSearch, NoWayThroughOthersHasALesserError) {
  const int stay = 15;
  std::map<int, double> entered;  // by frame that is entered
  const auto leavable = [&](int s, int from) {
    const int clip = cut.sequences[s].clip, at = cut.sequences[s].alignment;
    double least = clip == graph.clipOf(from) && at >= from ? 0.0 : 1e9;
    for (const auto& [frame, error] : entered)
      if (graph.clipOf(frame) == clip && at >= frame + stay) least = std::min(least, error);
    return least;
  };
  const int from = frame(3, 700), to = frame(2, 150);
  for (bool better = true; better;) {
    better = false;
    for (size_t s = 0; s < cut.sequences.size(); ++s) {
      const double before = leavable(static_cast<int>(s), from);
      if (before >= 1e9) continue;
      for (const int r : cut.clusters[cut.sequences[s].cluster].sequences) {
        if (r == static_cast<int>(s)) continue;
        const int enter = cut.sequences[r].alignment;
        if (!graph.hasRoom(cut.sequences[s].alignment) || !graph.hasRoom(enter)) continue;
        const double error = before + graph.error(cut.sequences[s].alignment, enter);
        const auto known = entered.find(enter);
        if (known != entered.end() && known->second <= error) continue;
        entered[enter] = error;
        better = true;
      }
    }
  }
  double least = 1e9;
  for (const auto& [frame, error] : entered)
    if (graph.clipOf(frame) == 2 && frame <= to) least = std::min(least, error);
  const auto way = wayThrough(graph, cut, from, to, {stay});
  ASSERT_TRUE(way);
  expectWay(*way, from, to);
  EXPECT_NEAR(way->error, least, 1e-9);
  for (size_t k = 1; k < way->jumps.size(); ++k)
    EXPECT_GE(way->jumps[k].leave, way->jumps[k - 1].enter + stay);
}

TEST(TransitionSearchOfDrawn, AClipOnTheWayPlaysForAsLongAsItIsAskedTo) {
  // Three clips of frames that are far from one another, but that the second is at frame 8 where
  // the first is at 10, and at frame 11 where the third is at 10.
  std::vector<std::vector<float>> clips(3);
  for (int c = 0; c < 3; ++c)
    for (int i = 0; i < 21; ++i) clips[c].push_back(static_cast<float>(1000 * c + 10 * i));
  clips[1][8] = clips[0][10];
  clips[1][11] = clips[2][10];
  const ClusterGraph drawn = drawnGraph(clips);
  const GraphCut apart = cutAt(drawn, 0.5);
  const auto way = wayThrough(drawn, apart, 3, 42 + 15, {3});
  ASSERT_TRUE(way);
  ASSERT_EQ(way->jumps.size(), 2u);
  EXPECT_EQ(way->jumps[0].enter, 21 + 8);
  EXPECT_EQ(way->jumps[1].leave, 21 + 11);
  EXPECT_EQ(way->wait, 10 - 3 + 15 - 10);
  EXPECT_FALSE(wayThrough(drawn, apart, 3, 42 + 15, {4}));
  EXPECT_FALSE(bestWay(drawn, apart, 3, 42 + 15));
}

TEST_F(TransitionSearch, AClipThatGoesThereItselfNeedsNoJump) {
  const auto way = wayThrough(graph, cut, frame(0, 30), frame(0, 90));
  ASSERT_TRUE(way);
  EXPECT_TRUE(way->jumps.empty());
  EXPECT_EQ(way->wait, 60);
}

TEST_F(TransitionSearch, WhereNothingIsAlikeThereIsNone) {
  const GraphCut alone = cutAt(graph, 0.0);
  EXPECT_FALSE(nearestWay(graph, alone, frame(0, 30), frame(1, 90)));
  EXPECT_FALSE(bestWay(graph, alone, frame(0, 30), frame(1, 90)));
  EXPECT_FALSE(wayThrough(graph, alone, frame(0, 30), frame(1, 90)));
  EXPECT_TRUE(loopsOf(graph, alone, 0, 1).empty());
}

TEST_F(TransitionSearch, EndsOfClipsAreLeftAndEnteredOnlyWhereNothingElseIsAlike) {
  const FrameLoop best = loopsOf(graph, cut, 0, 12)[0];
  EXPECT_TRUE(graph.hasRoom(best.leave) && graph.hasRoom(best.enter));
}

TEST_F(TransitionSearch, AClipOfOneCycleLoopsByThatCycle) {
  for (const auto& [path, frames] : std::vector<std::pair<std::string, double>>{
           {"cmu_style_loops/142_12_EDIT_LOOP.bvh", 163.0 / 4.0},
           {"cmu_style_loops/137_33_EDIT_LOOP.bvh", 103.0 / 4.0},
           {"formats/mass_walk.bvh", 131.0 / 4.0}}) {
    const ClusterGraph cycle = makeGraph(graphClips({path}), 1);
    const auto loops = loopsOf(cycle, cutAt(cycle, kGraphError), 0, 12);
    ASSERT_FALSE(loops.empty()) << path;
    EXPECT_NEAR(loops[0].leave - loops[0].enter, frames, 1.0) << path;
    EXPECT_LT(std::sqrt(loops[0].error), 0.03) << path;
  }
}

TEST_F(TransitionSearch, LoopsOfASteadyWalkAreWholeCycles) {
  const std::vector<FrameLoop> loops = loopsOf(graph, cut, 0, 12);
  ASSERT_GE(loops.size(), 10u);
  for (size_t k = 0; k < 10; ++k) {
    const double cycles = (loops[k].leave - loops[k].enter) / 37.3;  // 1.23 to 1.27 s
    EXPECT_NEAR(cycles, std::round(cycles), 0.08) << k;
    EXPECT_GE(loops[k].error, loops[k > 0 ? k - 1 : 0].error);
  }
}

}  // namespace
}  // namespace amble

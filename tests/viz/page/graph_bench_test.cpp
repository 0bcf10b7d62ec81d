#include "viz/page/graph_bench.h"

#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "tests/animation/graph/graph_captures.h"

namespace amble {
namespace {

using nlohmann::json;

const BenchGraph& shownGraph() {
  static const BenchGraph kShown = benchOfGraph(someGraph(), someClips(), kGraphError);
  return kShown;
}

TEST(GraphBench, ATransitionLeadsFromAlignmentToAlignmentWithinOneCluster) {
  const BenchGraph& shown = shownGraph();
  ASSERT_FALSE(shown.joins.empty());
  EXPECT_LE(shown.joins.size(), static_cast<size_t>(kMostJoins));
  for (const BenchJoin& join : shown.joins) {
    for (const int frame : {join.jump.leave, join.jump.enter}) {
      const FrameSequence& sequence = shown.cut.sequences[shown.cut.sequence_of[frame]];
      EXPECT_EQ(sequence.cluster, join.cluster);
      EXPECT_EQ(sequence.alignment, frame);
      EXPECT_TRUE(someGraph().hasRoom(frame));
    }
    EXPECT_NE(shown.cut.sequence_of[join.jump.leave], shown.cut.sequence_of[join.jump.enter]);
  }
}

// By trying all pairs of sequences.
TEST(GraphBench, OfEachTwoClipsTheSmoothestTransitionIsPlayed) {
  const BenchGraph& shown = shownGraph();
  const ClusterGraph& graph = someGraph();
  std::map<std::pair<int, int>, double> least, made;
  for (const FrameSequence& a : shown.cut.sequences) {
    for (const FrameSequence& b : shown.cut.sequences) {
      if (&a == &b || a.cluster != b.cluster || !graph.hasRoom(a.alignment) ||
          !graph.hasRoom(b.alignment))
        continue;
      const double error = graph.error(a.alignment, b.alignment);
      const auto [found, is_new] = least.try_emplace({a.clip, b.clip}, error);
      if (!is_new) found->second = std::min(found->second, error);
    }
  }
  for (const BenchJoin& join : shown.joins) {
    const auto clips = std::pair(graph.clipOf(join.jump.leave), graph.clipOf(join.jump.enter));
    made.try_emplace(clips, join.jump.error);
  }
  ASSERT_LE(least.size(), static_cast<size_t>(kMostJoins));
  EXPECT_EQ(made, least);
}

TEST(GraphBench, ATransitionIsTheOneClipBeforeItsBlendAndTheOtherAfterwards) {
  const BenchGraph& shown = shownGraph();
  const auto expectSame = [](const Clip& a, int i, const Clip& b, int k) {
    for (int joint = 1; joint < a.skeleton.size(); ++joint)
      EXPECT_LT(a.poses.rotations(i)[joint].angularDistance(b.poses.rotations(k)[joint]), 1e-9);
  };
  for (size_t i = 0; i < shown.joins.size(); ++i) {
    const BenchJoin& join = shown.joins[i];
    const Clip& played = shown.clips[someClips().clips.size() + i].motion.clip;
    const PlayedRange &before = join.ranges[0], &after = join.ranges[1];
    EXPECT_EQ(played.frames(), before.last - before.first + 1 + after.last - after.first);
    EXPECT_EQ(join.report.meeting, before.last - before.first);
    if (join.report.first > 0)
      expectSame(played, 0, someClips().clips[before.clip].clip, before.first);
    if (join.report.last < played.frames() - 1)
      expectSame(played, played.frames() - 1, someClips().clips[after.clip].clip, after.last);
  }
}

TEST(GraphBench, AClusterLiesAmidItsFrames) {
  const json said = json::parse(benchGraphJson(shownGraph(), plainNumbers()));
  for (const json& cluster : said["clusters"]) {
    for (int axis = 0; axis < 2; ++axis) {
      double low = 1e9, high = -1e9;
      for (const int s : cluster["sequences"]) {
        const json& sequence = said["sequences"][s];
        const int first = someGraph().clips[sequence["clip"]].first;
        for (int i = sequence["first"]; i <= sequence["last"]; ++i) {
          low = std::min(low, said["places"][axis][first + i].get<double>());
          high = std::max(high, said["places"][axis][first + i].get<double>());
        }
      }
      EXPECT_GE(cluster["at"][axis].get<double>(), low - 1e-3);
      EXPECT_LE(cluster["at"][axis].get<double>(), high + 1e-3);
    }
  }
}

// No other plane shows more of how frames differ: tried against two of the features themselves.
TEST(GraphBench, PlacesShowMoreOfTheFramesThanAnyTwoFeatures) {
  const json said = json::parse(benchGraphJson(shownGraph(), plainNumbers()));
  const auto spreadOf = [](const Eigen::VectorXd& values) {
    return (values.array() - values.mean()).square().sum();
  };
  double shown = 0.0;
  for (const json& row : said["places"]) {
    const std::vector<double> values = row;
    shown += spreadOf(Eigen::Map<const Eigen::VectorXd>(values.data(), values.size()));
  }
  std::multiset<double> features;
  for (int row = 0; row < kFeatureRows; ++row)
    features.insert(spreadOf(someGraph().features.row(row).transpose().cast<double>()));
  EXPECT_GE(shown, *features.rbegin() + *std::next(features.rbegin()));
}

TEST(GraphBench, WhereNothingIsAlikeClipsAreShownWithoutTransitions) {
  const BenchGraph shown = benchOfGraph(someGraph(), someClips(), 0.0);
  EXPECT_EQ(shown.joins_found, 0);
  EXPECT_EQ(shown.clips.size(), someClips().clips.size());
}

}  // namespace
}  // namespace amble

#include "planner/roadmap/nearest_roadmap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tests/planner/disc_steering.h"
#include "tests/planner/search_limits_of.h"

namespace amble {
namespace {

class NearestRoadmapTest : public testing::Test {
 protected:
  NearestRoadmapTest() {
    twoRooms(steering, 0.3);  // narrower than the disc: it grows to its limit
    steering.counts = true;
  }
  void grow(NearestRoadmap& roadmap, std::uint64_t seed, int samples) {
    const int from = roadmap.insert(standing(1, 1), true, true),
              to = roadmap.insert(standing(7, 1), true, true);
    EXPECT_FALSE(roadmap.connect(from, to, limitsOf(seed, samples)));
  }
  DiscSteering steering;
};

// By brute force: of the nodes before it, the nearest by straight distance, each asked both ways.
TEST_F(NearestRoadmapTest, EveryNodeAsksItsNearestBothWaysAndNoOthers) {
  NearestRoadmap roadmap({steering, kRoom});
  grow(roadmap, 3, 40);
  const auto& nodes = roadmap.roadmap().nodes();
  std::set<std::array<double, 6>> expected;
  for (size_t i = 0; i < nodes.size(); ++i) {
    std::vector<std::pair<double, size_t>> order;
    for (size_t k = 0; k < i; ++k)
      order.emplace_back((nodes[k].at.stance.position - nodes[i].at.stance.position).norm(), k);
    std::sort(order.begin(), order.end());
    order.resize(std::min<size_t>(order.size(), NearestRoadmap::kNeighbours));
    for (const auto& [distance, k] : order) {
      expected.insert(DiscSteering::pairOf(nodes[i].at.stance, nodes[k].at.stance));
      expected.insert(DiscSteering::pairOf(nodes[k].at.stance, nodes[i].at.stance));
    }
  }
  std::set<std::array<double, 6>> asked;
  for (const auto& [pair, times] : steering.pairs) {
    EXPECT_EQ(times, 1);
    asked.insert(pair);
  }
  EXPECT_EQ(asked, expected);
}

TEST_F(NearestRoadmapTest, EveryFreeSampleIsANodeAndTheyAreCounted) {
  for (const int samples : {5, 33}) {
    NearestRoadmap roadmap({steering, kRoom});
    grow(roadmap, 1, samples);
    EXPECT_EQ(roadmap.samples(), samples);
    EXPECT_EQ(roadmap.roadmap().size(), samples + 2);
    EXPECT_EQ(roadmap.roadmap().count(NodeKind::kSample), samples + 2);
  }
}

TEST_F(NearestRoadmapTest, EdgesAreExactlyWhatSteeringAllows) {
  NearestRoadmap roadmap({steering, kRoom});
  grow(roadmap, 2, 60);
  const auto& nodes = roadmap.roadmap().nodes();
  long long free = 0;
  for (const auto& [pair, times] : steering.pairs)
    free += !steering.blockedBetween({pair[0], pair[1]}, {pair[3], pair[4]});
  EXPECT_EQ(static_cast<long long>(roadmap.roadmap().edges().size()), free);
  for (const RoadmapEdge& edge : roadmap.roadmap().edges()) {
    EXPECT_EQ(edge.walk.from.position, nodes[edge.from].at.stance.position);
    EXPECT_EQ(edge.walk.to.position, nodes[edge.to].at.stance.position);
  }
  EXPECT_EQ(roadmap.refused().size(), steering.pairs.size() - static_cast<size_t>(free));
}

// An end that can only be left is entered by nobody.
TEST_F(NearestRoadmapTest, EndsOfOneWayAreAskedThatWayOnly) {
  NearestRoadmap roadmap({steering, kRoom});
  const int start = roadmap.insert(standing(1, 1), false, true),
            goal = roadmap.insert(standing(7, 1), true, false);
  roadmap.connect(start, goal, limitsOf(1, 60));
  bool left = false, entered = false;
  for (const RoadmapEdge& edge : roadmap.roadmap().edges()) {
    EXPECT_NE(edge.to, start);
    EXPECT_NE(edge.from, goal);
    left = left || edge.from == start;
    entered = entered || edge.to == goal;
  }
  EXPECT_TRUE(left && entered);
}

TEST_F(NearestRoadmapTest, FindsTheGapThatAVisibleOneHas) {
  twoRooms(steering, 1.0);
  steering.counts = false;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    NearestRoadmap roadmap({steering, kRoom});
    const int from = roadmap.insert(standing(1, 1), true, true),
              to = roadmap.insert(standing(7, 1), true, true);
    EXPECT_TRUE(roadmap.connect(from, to, limitsOf(seed, 300))) << seed;
    EXPECT_TRUE(roadmap.roadmap().shortestPath(from, to).has_value());
  }
}

}  // namespace
}  // namespace amble

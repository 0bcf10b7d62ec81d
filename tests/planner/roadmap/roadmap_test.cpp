#include "planner/roadmap/roadmap.h"

#include <gtest/gtest.h>

namespace amble {
namespace {

WalkEdge lasting(double duration) {
  WalkEdge edge;
  edge.duration = duration;
  return edge;
}

Roadmap withNodes(int count) {
  Roadmap roadmap;
  for (int i = 0; i < count; ++i) roadmap.addNode({});
  return roadmap;
}

TEST(Roadmap, NoPathLeadsAgainstAnEdge) {
  Roadmap roadmap = withNodes(2);
  roadmap.addEdge(0, 1, lasting(1));
  EXPECT_TRUE(roadmap.shortestPath(0, 1).has_value());
  EXPECT_FALSE(roadmap.shortestPath(1, 0).has_value());
  EXPECT_TRUE(roadmap.reachableFrom(0)[1]);
  EXPECT_FALSE(roadmap.reachableFrom(1)[0]);
  EXPECT_TRUE(roadmap.reaching(1)[0]);
}

TEST(Roadmap, ComponentsAreStronglyConnected) {
  Roadmap roadmap = withNodes(5);
  roadmap.addEdge(0, 1, lasting(1));
  roadmap.addEdge(1, 2, lasting(1));
  roadmap.addEdge(2, 0, lasting(1));
  roadmap.addEdge(2, 3, lasting(1));  // one way
  roadmap.addEdge(3, 4, lasting(1));
  roadmap.addEdge(4, 3, lasting(1));
  EXPECT_EQ(roadmap.components(), (std::vector<int>{0, 0, 0, 1, 1}));
}

TEST(Roadmap, ShortestPathIsOfLeastDuration) {
  Roadmap roadmap = withNodes(4);
  roadmap.addEdge(0, 3, lasting(5));
  roadmap.addEdge(0, 1, lasting(1));
  roadmap.addEdge(1, 2, lasting(1));
  roadmap.addEdge(2, 3, lasting(1));
  EXPECT_EQ(*roadmap.shortestPath(0, 3), (std::vector<int>{1, 2, 3}));
}

TEST(Roadmap, OfEqualPathsTheOneOverLowerNodesIsTaken) {
  for (const bool swapped : {false, true}) {
    Roadmap roadmap = withNodes(4);
    const int first = swapped ? 2 : 1;
    roadmap.addEdge(0, first, lasting(1));
    roadmap.addEdge(0, 3 - first, lasting(1));
    roadmap.addEdge(first, 3, lasting(1));
    roadmap.addEdge(3 - first, 3, lasting(1));
    const auto path = roadmap.shortestPath(0, 3);
    EXPECT_EQ(roadmap.edges()[path->front()].to, 1);
  }
}

TEST(Roadmap, PathToItselfIsEmpty) { EXPECT_TRUE(withNodes(1).shortestPath(0, 0)->empty()); }

}  // namespace
}  // namespace amble

// Roadmaps of any graph, against tables over all pairs of nodes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/sample_stream.h"
#include "planner/roadmap/roadmap.h"

namespace amble {
namespace {

// Edges at random, and the least cost from each node to each by a table over all pairs (Floyd
// 1962).
struct DrawnGraph {
  explicit DrawnGraph(std::uint64_t seed) : random(seed, 0), size(2 + random.below(14)) {
    least.assign(size, std::vector<double>(size, HUGE_VAL));
    for (int i = 0; i < size; ++i) {
      roadmap.addNode({});
      least[i][i] = 0.0;
    }
    for (int i = random.below(4 * size); i > 0; --i) add(random.below(size), random.below(size));
    for (int via = 0; via < size; ++via)
      for (int a = 0; a < size; ++a)
        for (int b = 0; b < size; ++b)
          least[a][b] = std::min(least[a][b], least[a][via] + least[via][b]);
  }
  void add(int from, int to) {
    if (from == to || roadmap.hasEdge(from, to)) return;
    WalkEdge edge;
    edge.duration = 1.0 + random.below(8);
    edge.effort = random.below(3);
    edge.unease = random.below(2);
    least[from][to] = edge.cost();
    roadmap.addEdge(from, to, edge);
  }
  bool leads(int from, int to) const { return least[from][to] < HUGE_VAL; }

  SampleStream random;
  int size;
  Roadmap roadmap;
  std::vector<std::vector<double>> least;
};

template <typename Visit>
void forDrawnGraphs(Visit visit) {
  for (std::uint64_t seed = 0; seed < 80; ++seed) visit(DrawnGraph(seed));
}

TEST(RoadmapLaws, TheShortestPathCostsAsMuchAsTheTableOfAllPairsSays) {
  forDrawnGraphs([](const DrawnGraph& graph) {
    for (int from = 0; from < graph.size; ++from) {
      for (int to = 0; to < graph.size; ++to) {
        const auto path = graph.roadmap.shortestPath(from, to);
        ASSERT_EQ(path.has_value(), graph.leads(from, to));
        if (!path) continue;
        int at = from;
        double cost = 0.0;
        for (const int edge : *path) {
          EXPECT_EQ(graph.roadmap.edges()[edge].from, at);
          at = graph.roadmap.edges()[edge].to;
          cost += graph.roadmap.edges()[edge].walk.cost();
        }
        EXPECT_EQ(at, to);
        EXPECT_NEAR(cost, graph.least[from][to], 1e-9);
      }
    }
  });
}

TEST(RoadmapLaws, ReachesWhatTheTableReachesForthAndBack) {
  forDrawnGraphs([](const DrawnGraph& graph) {
    for (int node = 0; node < graph.size; ++node) {
      const auto forth = graph.roadmap.reachableFrom(node), back = graph.roadmap.reaching(node);
      for (int other = 0; other < graph.size; ++other) {
        EXPECT_EQ(forth[other], graph.leads(node, other));
        EXPECT_EQ(back[other], graph.leads(other, node));
      }
    }
  });
}

TEST(RoadmapLaws, NodesAreOfOneComponentJustWhereEachLeadsToTheOther) {
  forDrawnGraphs([](const DrawnGraph& graph) {
    const std::vector<int> component = graph.roadmap.components();
    int next = 0;
    for (int a = 0; a < graph.size; ++a) {
      EXPECT_LE(component[a], next);  // numbered by their lowest nodes
      next = std::max(next, component[a] + 1);
      for (int b = 0; b < graph.size; ++b)
        EXPECT_EQ(component[a] == component[b], graph.leads(a, b) && graph.leads(b, a));
    }
  });
}

TEST(RoadmapLaws, OneMoreEdgeMakesNoWayDearerAndPartsNothing) {
  forDrawnGraphs([](DrawnGraph graph) {
    const std::vector<int> before = graph.roadmap.components();
    const auto least = graph.least;
    graph.add(graph.random.below(graph.size), graph.random.below(graph.size));
    const std::vector<int> after = graph.roadmap.components();
    for (int a = 0; a < graph.size; ++a) {
      for (int b = 0; b < graph.size; ++b) {
        if (before[a] == before[b]) {
          EXPECT_EQ(after[a], after[b]);
        }
        double cost = 0.0;
        const auto path = graph.roadmap.shortestPath(a, b);
        if (!path) {
          EXPECT_EQ(least[a][b], HUGE_VAL);
          continue;
        }
        for (const int edge : *path) cost += graph.roadmap.edges()[edge].walk.cost();
        EXPECT_LE(cost, least[a][b] + 1e-9);
      }
    }
  });
}

}  // namespace
}  // namespace amble

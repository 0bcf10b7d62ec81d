#include "planner/roadmap/kept_search.h"

#include <gtest/gtest.h>

#include <atomic>
#include <utility>

#include "planner/roadmap/visibility_roadmap.h"
#include "tests/planner/disc_steering.h"
#include "tests/planner/search_limits_of.h"

namespace amble {
namespace {

KeptRoadmap filled(const Steering& steering, std::uint64_t seed = 1, int max_failures = 100,
                   int threads = 1) {
  VisibilityRoadmap roadmap({steering, kRoom});
  roadmap.fill(limitsOf(seed, max_failures, threads));
  return keep(roadmap);
}

std::optional<std::vector<WalkEdge>> walk(const KeptSearch& search, const Steering& steering,
                                          const Waypoint& from, const Waypoint& to) {
  SteeringCount count;
  return search.walk(from, to, {}, *steering.makeScratch(), count);
}

double cost(const std::vector<WalkEdge>& edges) {
  double sum = 0.0;
  for (const WalkEdge& edge : edges) sum += edge.cost();
  return sum;
}

std::vector<Waypoint> freePlaces(const DiscSteering& steering, int count) {
  std::vector<Waypoint> places;
  const StanceSampler sampler(steering, kRoom);
  for (std::uint64_t i = 0; static_cast<int>(places.size()) < count; ++i)
    if (const auto sample = sampler.draw(7, 2 * i, *steering.makeScratch()))
      places.push_back({sample->stance});
  return places;
}

class KeptTwoRooms : public testing::Test {
 protected:
  KeptTwoRooms() { twoRooms(steering, 0.8); }
  DiscSteering steering;
};

TEST_F(KeptTwoRooms, WalksLeadFromAnywhereToAnywhereAndAreJoined) {
  const KeptSearch search(steering, filled(steering));
  EXPECT_EQ(search.roadmap().pieces(), 1);
  for (const Waypoint& from : freePlaces(steering, 8)) {
    for (const Waypoint& to : freePlaces(steering, 8)) {
      const auto edges = walk(search, steering, from, to);
      ASSERT_TRUE(edges && !edges->empty());
      EXPECT_EQ(edges->front().from.position, from.stance.position);
      EXPECT_EQ(edges->back().to.position, to.stance.position);
      for (size_t i = 0; i < edges->size(); ++i) {
        const Eigen::Vector2d a = (*edges)[i].from.position.head<2>(),
                              b = (*edges)[i].to.position.head<2>();
        EXPECT_FALSE(steering.blockedBetween(a, b));
        if (i > 0) {
          EXPECT_EQ((*edges)[i - 1].to.position, (*edges)[i].from.position);
        }
      }
    }
  }
}

TEST_F(KeptTwoRooms, WhoIsToldToStopSteersNothingMore) {
  const KeptSearch search(steering, filled(steering));
  const std::atomic<bool> stop{true};
  SearchLimits limits;
  limits.stop = &stop;
  steering.asked = 0;
  SteeringCount count;
  EXPECT_FALSE(search.walk(standing(1, 1), standing(7, 1), limits, *steering.makeScratch(), count));
  EXPECT_EQ(steering.asked, 0);
}

TEST_F(KeptTwoRooms, WhereNothingIsBetweenOneEdgeIsSteered) {
  const KeptSearch search(steering, filled(steering));
  steering.asked = 0;
  const auto edges = walk(search, steering, standing(1, 1), standing(3, 2));
  ASSERT_TRUE(edges);
  EXPECT_EQ(edges->size(), 1u);
  EXPECT_EQ(steering.asked, 1);
}

TEST_F(KeptTwoRooms, AnEdgeOfTheRoadmapIsMadeOnce) {
  const KeptRoadmap roadmap = filled(steering);
  const KeptSearch search(steering, roadmap);
  steering.counts = true;
  for (int i = 0; i < 3; ++i) walk(search, steering, standing(1, 1), standing(7, 1, 0.1 * i));
  int made = 0;
  for (const KeptRoadmap::Edge& edge : roadmap.edges) {
    const auto asked = steering.pairs.find(
        DiscSteering::pairOf(roadmap.nodes[edge.from].stance, roadmap.nodes[edge.to].stance));
    if (asked == steering.pairs.end()) continue;
    EXPECT_EQ(asked->second, 1);
    ++made;
  }
  EXPECT_GE(made, 1);
}

TEST_F(KeptTwoRooms, WhatWasAskedBeforeChangesNoAnswerAndNoCount) {
  const KeptSearch fresh(steering, filled(steering)), used(steering, filled(steering));
  const std::vector<Waypoint> places = freePlaces(steering, 6);
  for (const Waypoint& from : places) walk(used, steering, from, places.front());
  SteeringCount of_fresh, of_used;
  const auto a = fresh.walk(places[1], places[4], {}, *steering.makeScratch(), of_fresh);
  const auto b = used.walk(places[1], places[4], {}, *steering.makeScratch(), of_used);
  ASSERT_TRUE(a && b);
  EXPECT_EQ(cost(*a), cost(*b));
  EXPECT_EQ(of_fresh.asked, of_used.asked);
  EXPECT_EQ(of_fresh.poses, of_used.poses);
  EXPECT_EQ(of_fresh.refusals, of_used.refusals);
}

TEST_F(KeptTwoRooms, NoWalkCrossesADoorAgainstItsDirection) {
  steering.doors = {{{4, 4}, {4, 5}}};  // from the east to the west only
  const KeptSearch search(steering, filled(steering));
  EXPECT_TRUE(walk(search, steering, standing(7, 1), standing(1, 1)));
  EXPECT_FALSE(walk(search, steering, standing(1, 1), standing(7, 1)));
}

// A file may lie: of what it says is walked nothing is believed.
TEST_F(KeptTwoRooms, AnEdgeThatIsNoWalkIsStruckOut) {
  KeptRoadmap lies;
  for (const double x : {1.0, 7.0}) lies.nodes.push_back({standing(x, 1).stance});
  lies.edges = {{0, 1, 0.0}, {1, 0, 0.0}};
  const KeptSearch search(steering, lies);
  EXPECT_FALSE(walk(search, steering, standing(1.5, 1), standing(6.5, 1)));
  for (const double x : {2.0, 6.0}) lies.nodes.push_back({standing(x, 4.5).stance});
  lies.edges.insert(lies.edges.end(), {{0, 2, 50.0}, {2, 3, 50.0}, {3, 1, 50.0}});
  const KeptSearch better(steering, lies);
  const auto edges = walk(better, steering, standing(1.5, 1), standing(6.5, 1));
  ASSERT_TRUE(edges);
  EXPECT_LT(cost(*edges), 50.0);
}

TEST_F(KeptTwoRooms, AFilledRoadmapEndsAtItsFailuresAndIsTheSameAtAnyNumberOfThreads) {
  VisibilityRoadmap roadmap({steering, kRoom});
  roadmap.fill(limitsOf(3, 40));
  EXPECT_EQ(roadmap.failures(), 40);
  const KeptRoadmap one = filled(steering, 3, 40, 1), five = filled(steering, 3, 40, 5);
  ASSERT_EQ(one.nodes.size(), five.nodes.size());
  for (size_t i = 0; i < one.nodes.size(); ++i)
    EXPECT_EQ(one.nodes[i].stance.position, five.nodes[i].stance.position);
  ASSERT_EQ(one.edges.size(), five.edges.size());
  for (size_t i = 0; i < one.edges.size(); ++i) EXPECT_EQ(one.edges[i].cost, five.edges[i].cost);
  EXPECT_EQ(one.samples, five.samples);
}

// Knows one way, through the gap.
class GuidedDisc : public DiscSteering {
 public:
  std::unique_ptr<WayGuide> guide(const Eigen::Vector3d& from, const Eigen::Vector3d&,
                                  const Eigen::AlignedBox2d&, const std::function<bool()>&,
                                  int) const override {
    struct Way : WayGuide {
      std::vector<Stance> stances;
      std::optional<std::vector<Stance>> next() override {
        if (stances.empty()) return std::nullopt;
        return std::exchange(stances, {});
      }
      void avoid(const Eigen::Vector3d&) override {}
      std::optional<Narrow> narrowest() const override { return std::nullopt; }
    };
    auto way = std::make_unique<Way>();
    way->stances = {standing(3.2, 4.5).stance, standing(4.8, 4.5).stance};
    if (from.x() > 4.0) std::swap(way->stances[0], way->stances[1]);
    return way;
  }
};

TEST(FilledRoadmap, PiecesAreJoinedByWaysWhichCountAsNoSamples) {
  DiscSteering alone;
  GuidedDisc guided;
  twoRooms(alone, 0.42);
  twoRooms(guided, 0.42);
  const KeptRoadmap apart = filled(alone, 1, 10), joined = filled(guided, 1, 10);
  ASSERT_GE(apart.pieces(), 2);
  EXPECT_EQ(joined.pieces(), 1);
  EXPECT_EQ(joined.samples, apart.samples);
  EXPECT_EQ(joined.coverage, apart.coverage);
}

}  // namespace
}  // namespace amble

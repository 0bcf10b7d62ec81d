#include "planner/legs/leg_planner.h"

#include <gtest/gtest.h>

#include "planner/roadmap/nearest_roadmap.h"
#include "planner/roadmap/visibility_roadmap.h"
#include "tests/planner/disc_steering.h"
#include "tests/planner/search_limits_of.h"

namespace amble {
namespace {

constexpr int kDivider = 4, kOtherDivider = 5;  // boxes of twoRooms that part them

class LegPlannerTest : public testing::Test {
 protected:
  /// @return whether walks lead from left to right
  template <typename Kind>
  bool grow(Kind& roadmap, std::uint64_t seed) {
    const int from = roadmap.insert(left, true, true), to = roadmap.insert(right, true, true);
    return roadmap.connect(from, to, limitsOf(seed, 60));
  }
  DiscSteering steering;
  Waypoint left = standing(1, 3), right = standing(7, 3, 1.0);
};

TEST_F(LegPlannerTest, WhatIsInTheWayLiesBetweenStartsPlacesAndGoals) {
  twoRooms(steering, 0.3);  // narrower than the disc
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    VisibilityRoadmap roadmap({steering, kRoom});
    ASSERT_FALSE(grow(roadmap, seed));
    const auto failures = inTheWay(roadmap, left, right);
    ASSERT_FALSE(failures.empty());
    EXPECT_LE(failures.size(), roadmap.refused().size());
    for (const SteeringFailure& failure : failures)
      EXPECT_TRUE(failure.object == kDivider || failure.object == kOtherDivider) << failure.object;
  }
}

TEST_F(LegPlannerTest, OfPlacesThatAreNoNodesNothingIsSaid) {
  twoRooms(steering, 0.3);
  VisibilityRoadmap roadmap({steering, kRoom});
  ASSERT_FALSE(grow(roadmap, 1));
  EXPECT_TRUE(inTheWay(roadmap, left, standing(7, 5)).empty());
  EXPECT_TRUE(inTheWay(roadmap, standing(0.5, 0.5), right).empty());
}

// The way back says nothing of the way there.
TEST_F(LegPlannerTest, AOneWayDoorIsInTheWayOfThoseItStopsOnly) {
  twoRooms(steering, 1.4);
  steering.doors = {{{4, 0}, {4, 6}}};  // from right to left only
  VisibilityRoadmap roadmap({steering, kRoom});
  ASSERT_FALSE(grow(roadmap, 2));
  int door = 0;
  for (const SteeringFailure& failure : inTheWay(roadmap, left, right))
    door += failure.object == 100;
  EXPECT_GT(door, 0);
}

TEST_F(LegPlannerTest, ThePictureIsTheRoadmapNodeByNode) {
  twoRooms(steering, 0.8);
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    VisibilityRoadmap roadmap({steering, kRoom});
    ASSERT_TRUE(grow(roadmap, seed));
    PlanOutcome outcome;
    outcome.samples = 7;
    describeRoadmap(roadmap, outcome);
    const Roadmap& graph = roadmap.roadmap();
    ASSERT_EQ(outcome.roadmap.nodes.size(), graph.nodes().size());
    ASSERT_EQ(outcome.roadmap.edges.size(), graph.edges().size());
    EXPECT_EQ(outcome.edges, static_cast<int>(graph.edges().size()));
    EXPECT_EQ(outcome.guards + outcome.connectors, graph.size());
    EXPECT_EQ(outcome.samples, 7 + roadmap.samples());
    EXPECT_EQ(outcome.coverage, roadmap.coverage());
    for (const RoadmapPicture::Edge& edge : outcome.roadmap.edges) {
      ASSERT_GE(edge.line.size(), 2u);
      const auto at = [&](int node) {
        return Eigen::Vector2d(outcome.roadmap.nodes[node].stance.position.head<2>());
      };
      EXPECT_LT((edge.line.front() - at(edge.from)).norm(), 1e-9);
      EXPECT_LT((edge.line.back() - at(edge.to)).norm(), 1e-9);
      double length = 0.0;
      for (size_t i = 1; i < edge.line.size(); ++i)
        length += (edge.line[i] - edge.line[i - 1]).norm();
      EXPECT_NEAR(length, (at(edge.to) - at(edge.from)).norm(), 1e-6);  // discs walk straight
    }
  }
}

TEST_F(LegPlannerTest, NodesOfOtherRoadmapsAreSamples) {
  twoRooms(steering, 0.8);
  NearestRoadmap roadmap({steering, kRoom});
  grow(roadmap, 1);
  PlanOutcome outcome;
  describeRoadmap(roadmap, outcome);
  EXPECT_EQ(outcome.guards, 0);
  EXPECT_EQ(outcome.connectors, 0);
  for (const auto& node : outcome.roadmap.nodes) EXPECT_EQ(node.kind, NodeKind::kSample);
}

// Steering that is asked for a refused edge again refuses it again, and says the same.
TEST_F(LegPlannerTest, RefusedEdgesAreWhatSteeringWasAsked) {
  twoRooms(steering, 0.8);
  VisibilityRoadmap roadmap({steering, kRoom});
  grow(roadmap, 1);
  ASSERT_FALSE(roadmap.refused().empty());
  const SteeringScratchPtr scratch = steering.makeScratch();
  for (const RefusedLink& link : roadmap.refused()) {
    const SteerResult again = steering.steer(link.from, link.to, *scratch);
    ASSERT_FALSE(again.edge.has_value());
    EXPECT_EQ(again.failure.rule, link.failure.rule);
    EXPECT_EQ(again.failure.object, link.failure.object);
    EXPECT_EQ(again.failure.at, link.failure.at);
  }
}

std::vector<RefusedEdge> refusedAlong(int count) {
  std::vector<RefusedEdge> edges(count);
  for (int i = 0; i < count; ++i) {
    edges[i].from = standing(i, 0);
    edges[i].failure.at = {static_cast<double>(i), 0, 0};
  }
  return edges;
}

TEST_F(LegPlannerTest, OfManyRefusedEdgesTheNearestToWhereAWalkStoppedAreTold) {
  const std::vector<RefusedEdge> edges = refusedAlong(1000);
  PlanOutcome outcome;
  describeRefused(pointersTo(edges), Eigen::Vector3d(700.2, 0, 0), outcome);
  const auto& told = outcome.roadmap.refused;
  ASSERT_EQ(static_cast<int>(told.size()), RoadmapPicture::kMostRefused);
  for (size_t i = 0; i < told.size(); ++i) {
    EXPECT_EQ(told[i].at.x(), 601.0 + static_cast<double>(i));
    EXPECT_EQ(told[i].from.stance.position.x(), told[i].at.x());
  }
}

TEST_F(LegPlannerTest, OfManyRefusedEdgesOfAWalkSomeAreToldFromFirstToLast) {
  const std::vector<RefusedEdge> many = refusedAlong(1000), few = refusedAlong(3);
  PlanOutcome outcome, other;
  describeRefused(pointersTo(many), {}, outcome);
  ASSERT_EQ(static_cast<int>(outcome.roadmap.refused.size()), RoadmapPicture::kMostRefused);
  for (size_t i = 0; i < outcome.roadmap.refused.size(); ++i)
    EXPECT_EQ(outcome.roadmap.refused[i].at.x(), 5.0 * static_cast<double>(i));
  describeRefused(pointersTo(few), {}, other);
  EXPECT_EQ(other.roadmap.refused.size(), few.size());
}

TEST_F(LegPlannerTest, CountsOfLegsAddUp) {
  SteeringCount first, second;
  first.refusals = {{WalkRule::kContact, 3}, {WalkRule::kTurnRate, 1}};
  first.poses = 100;
  second.refusals = {{WalkRule::kContact, 2}};
  second.poses = 11;
  PlanOutcome outcome;
  describeCount(first, outcome);
  describeCount(second, outcome);
  EXPECT_EQ(outcome.refusals[WalkRule::kContact], 5);
  EXPECT_EQ(outcome.refusals[WalkRule::kTurnRate], 1);
  EXPECT_EQ(outcome.poses_checked, 111);
}

}  // namespace
}  // namespace amble

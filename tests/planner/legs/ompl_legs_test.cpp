#include "planner/legs/ompl_legs.h"

#include <gtest/gtest.h>

#include "planner/legs/planners.h"
#include "planner/ompl/roadmap_planner.h"
#include "tests/planner/disc_steering.h"
#include "tests/planner/furnished_room.h"

namespace amble {
namespace {

/// Legs of a disc in two rooms: a request is asked for names and ground where nothing was found.
class OmplLegsTest : public testing::Test {
 protected:
  OmplLegsTest() {
    twoRooms(steering, 1.2);
    const FurnishedRoom& room = furnishedRoom();
    request.synthesizer = &room.synthesizer;
    request.world = &room.world;
    request.ground = &room.ground;
    limits.max_failures = 300;
  }
  LegPlannerPtr make(const std::string& planner) {
    const OmplSpacePtr space = makeWalkSpace(steering, kRoom, limits.seed);
    return makeOmplLegs(request, limits, space, findPlanner(planner).make(space, limits));
  }
  static std::vector<std::string> names() {
    std::vector<std::string> names;
    for (const PlannerEntry& entry : planners())
      if (entry.make) names.push_back(entry.name);
    return names;
  }
  static PlanOutcome described(const LegPlanner& legs) {
    PlanOutcome outcome;
    legs.describe(outcome);
    return outcome;
  }
  DiscSteering steering;
  PlanRequest request;
  SearchLimits limits;
  const Waypoint a = standing(1, 1), b = standing(7, 1, 1.0), c = standing(7, 5, 2.0);
};

// A leg's walk does not depend on the legs before it, with planners that keep nothing between them.
TEST_F(OmplLegsTest, ARoadmapsLegIsTheSameAloneAndAfterAnother) {
  for (const char* planner : {"visibility", "prm"}) {
    const auto alone = make(planner)->solve(b, c);
    const auto both = make(planner);
    ASSERT_TRUE(both->solve(a, b).has_value()) << planner;
    const auto after = both->solve(b, c);
    ASSERT_TRUE(alone && after) << planner;
    ASSERT_EQ(alone->size(), after->size()) << planner;
    for (size_t i = 0; i < alone->size(); ++i)
      EXPECT_EQ((*alone)[i].to.position, (*after)[i].to.position) << planner;
  }
}

TEST_F(OmplLegsTest, EveryPlannersLegsLeadFromWaypointToWaypoint) {
  for (const std::string& planner : names()) {
    const auto legs = make(planner);
    const Waypoint stops[] = {b, a, c};
    for (int i = 0; i < 2; ++i) {
      const auto edges = legs->solve(stops[i], stops[i + 1]);
      ASSERT_TRUE(edges.has_value()) << planner << i;
      EXPECT_EQ(edges->front().from.position, stops[i].stance.position) << planner;
      EXPECT_EQ(edges->back().to.position, stops[i + 1].stance.position) << planner;
      double length = 0.0;
      for (const WalkEdge& edge : *edges) {
        EXPECT_FALSE(
            steering.blockedBetween(edge.from.position.head<2>(), edge.to.position.head<2>()));
        length += edge.length;
      }
      EXPECT_GE(length, (stops[i + 1].stance.position - stops[i].stance.position).norm() - 1e-9);
    }
  }
}

TEST_F(OmplLegsTest, CountsOfAllItsLegsAreDescribed) {
  for (const std::string& planner : names()) {
    const auto legs = make(planner);
    ASSERT_TRUE(legs->solve(a, b).has_value()) << planner;
    const PlanOutcome first = described(*legs);
    ASSERT_TRUE(legs->solve(b, c).has_value()) << planner;
    const PlanOutcome both = described(*legs);
    EXPECT_GE(both.samples, first.samples) << planner;
    EXPECT_GT(both.poses_checked, first.poses_checked) << planner;
    for (const auto& [rule, count] : first.refusals)
      EXPECT_GE(both.refusals.at(rule), count) << planner;
    EXPECT_GE(both.times.roadmap, first.times.roadmap);
    const bool roadmap = planner == "visibility" || planner == "prm";
    EXPECT_EQ(both.roadmap.nodes.empty(), !roadmap) << planner;
  }
}

TEST_F(OmplLegsTest, AnInterruptionEndsEveryPlannerAtOnce) {
  twoRooms(steering, 0.3);  // nothing else would end it soon
  limits.max_failures = 1000000;
  for (const std::string& planner : names()) {
    int asked = 0;
    limits.interrupted = [&] { return ++asked > 20; };
    const auto legs = make(planner);
    EXPECT_FALSE(legs->solve(a, b).has_value()) << planner;
    EXPECT_LT(described(*legs).samples, 3000) << planner;
  }
}

TEST_F(OmplLegsTest, APassedDeadlineLeavesNoWalkAndNoSample) {
  limits.deadline = std::chrono::steady_clock::now();
  for (const std::string& planner : names()) {
    twoRooms(steering, 0.3);
    const auto legs = make(planner);
    EXPECT_FALSE(legs->solve(a, b).has_value()) << planner;
    EXPECT_LE(described(*legs).samples, 1) << planner;
  }
}

TEST_F(OmplLegsTest, WhatStoodInTheWayIsOfTheLegThatWasAskedLast) {
  for (const char* planner : {"visibility", "rrt"}) {
    const auto legs = make(planner);
    twoRooms(steering, 1.2);
    ASSERT_TRUE(legs->solve(a, b).has_value()) << planner;
    twoRooms(steering, 0.3);
    limits.max_failures = 20;
    EXPECT_FALSE(make(planner)->solve(a, b).has_value()) << planner;
    limits.max_failures = 300;
  }
}

}  // namespace
}  // namespace amble

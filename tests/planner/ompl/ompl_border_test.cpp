#include "planner/ompl/ompl_border.h"

#include <gtest/gtest.h>
#include <ompl/base/Planner.h>
#include <ompl/base/PlannerData.h>
#include <ompl/base/SpaceInformation.h>

#include "planner/roadmap/nearest_roadmap.h"
#include "planner/roadmap/visibility_roadmap.h"
#include "tests/planner/disc_steering.h"

namespace amble {
namespace {

SearchLimits limitsOf(std::uint64_t seed) {
  SearchLimits limits;
  limits.seed = seed;
  return limits;
}

void expectWalk(const DiscSteering& steering, const std::vector<Waypoint>& way,
                const Waypoint& from, const Waypoint& to) {
  EXPECT_EQ(way.front().stance.position, from.stance.position);
  EXPECT_EQ(way.back().stance.position, to.stance.position);
  for (size_t i = 0; i + 1 < way.size(); ++i) {
    EXPECT_FALSE(steering.blockedBetween(way[i].stance.position.head<2>(),
                                         way[i + 1].stance.position.head<2>()));
  }
}

class OmplBorder : public testing::Test {
 protected:
  OmplBorder() { twoRooms(steering, 0.8); }
  DiscSteering steering;
  Waypoint left = standing(1, 1), right = standing(7, 1, 1.0);
};

TEST_F(OmplBorder, SpaceAdmitsThatItIsNoMetricAndNotSymmetric) {
  const OmplSpacePtr space = makeWalkSpace(steering, kRoom, 1);
  EXPECT_FALSE(space->getStateSpace()->isMetricSpace());
  EXPECT_FALSE(space->getStateSpace()->hasSymmetricDistance());
  EXPECT_FALSE(space->getStateSpace()->hasSymmetricInterpolate());
  EXPECT_EQ(space->getStateSpace()->validSegmentCount(nullptr, nullptr), 1u);
}

TEST_F(OmplBorder, RoadmapSolvesQueriesOneAfterAnother) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const SearchLimits limits = limitsOf(seed);
    const OmplSpacePtr space = makeWalkSpace(steering, kRoom, seed);
    VisibilityRoadmap roadmap(steering, kRoom);
    const OmplPlannerPtr planner = makeRoadmapPlanner(space, roadmap, limits);
    const auto there = solveWith(*planner, left, right, limits, 1);
    ASSERT_TRUE(there.has_value());
    expectWalk(steering, *there, left, right);
    const long long samples = roadmap.samples();
    const auto back = solveWith(*planner, right, left, limits, 1);
    ASSERT_TRUE(back.has_value());
    expectWalk(steering, *back, right, left);
    EXPECT_EQ(roadmap.samples(), samples);  // a disc walks back the way it came
  }
}

TEST_F(OmplBorder, PlannerDataHasEveryEdgeInItsDirection) {
  steering.doors = {{{4, 0}, {4, 6}}};
  const SearchLimits limits = limitsOf(1);
  const OmplSpacePtr space = makeWalkSpace(steering, kRoom, 1);
  VisibilityRoadmap roadmap(steering, kRoom);
  const OmplPlannerPtr planner = makeRoadmapPlanner(space, roadmap, limits);
  ASSERT_TRUE(solveWith(*planner, right, left, limits, 1).has_value());
  ompl::base::PlannerData data(space);
  planner->getPlannerData(data);
  EXPECT_EQ(data.numEdges(), roadmap.roadmap().edges().size());
  for (const RoadmapEdge& edge : roadmap.roadmap().edges())
    EXPECT_TRUE(data.edgeExists(edge.from, edge.to));
}

TEST_F(OmplBorder, NearestRoadmapSolvesAndRepeats) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    SearchLimits limits = limitsOf(seed);
    const OmplSpacePtr space = makeWalkSpace(steering, kRoom, seed);
    NearestRoadmap one(steering, kRoom), two(steering, kRoom);
    const auto walk = solveWith(*makeRoadmapPlanner(space, one, limits), left, right, limits, 1);
    ASSERT_TRUE(walk.has_value());
    expectWalk(steering, *walk, left, right);
    limits.threads = 2;
    const auto again = solveWith(*makeRoadmapPlanner(space, two, limits), left, right, limits, 1);
    ASSERT_TRUE(again.has_value());
    ASSERT_EQ(walk->size(), again->size());
    for (size_t i = 0; i < walk->size(); ++i)
      EXPECT_EQ((*walk)[i].stance.position, (*again)[i].stance.position);
  }
}

TEST_F(OmplBorder, RrtGrowsForwardAndRepeats) {
  steering.doors = {{{4, 0}, {4, 6}}};
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const SearchLimits limits = limitsOf(seed);
    std::vector<Waypoint> first;
    for (int run = 0; run < 2; ++run) {
      const OmplSpacePtr space = makeWalkSpace(steering, kRoom, seed);
      const auto walk = solveWith(*makeRrtPlanner(space, seed), right, left, limits, 5000);
      ASSERT_TRUE(walk.has_value()) << seed;
      expectWalk(steering, *walk, right, left);
      if (run == 0) first = *walk;
      ASSERT_EQ(walk->size(), first.size());
      for (size_t i = 0; i < first.size(); ++i) {
        EXPECT_EQ((*walk)[i].stance.position, first[i].stance.position);
      }
    }
  }
}

TEST_F(OmplBorder, RrtStopsAfterItsSamples) {
  steering.doors = {{{4, 0}, {4, 6}}};
  const OmplSpacePtr space = makeWalkSpace(steering, kRoom, 1);
  EXPECT_FALSE(solveWith(*makeRrtPlanner(space, 1), left, right, limitsOf(1), 300).has_value());
  EXPECT_EQ(effortOf(space).samples, 300);
}

TEST_F(OmplBorder, FreeGoalHeadingIsMet) {
  right.any_heading = true;
  const SearchLimits limits = limitsOf(1);
  const OmplSpacePtr space = makeWalkSpace(steering, kRoom, 1);
  VisibilityRoadmap roadmap(steering, kRoom);
  const auto walk = solveWith(*makeRoadmapPlanner(space, roadmap, limits), left, right, limits, 1);
  ASSERT_TRUE(walk.has_value());
  EXPECT_TRUE(walk->back().any_heading);
}

}  // namespace
}  // namespace amble

#include "planner/ompl/roadmap_planner.h"

#include <gtest/gtest.h>
#include <ompl/base/Planner.h>
#include <ompl/base/PlannerData.h>
#include <ompl/base/ProblemDefinition.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/geometric/PathGeometric.h>

#include "planner/roadmap/nearest_roadmap.h"
#include "planner/roadmap/visibility_roadmap.h"
#include "tests/planner/disc_steering.h"

namespace amble {
namespace {

SearchLimits limitsOf(std::uint64_t seed, int threads = 1) {
  SearchLimits limits;
  limits.seed = seed;
  limits.threads = threads;
  return limits;
}

void expectWalk(const DiscSteering& steering, const std::vector<WalkEdge>& walk,
                const Waypoint& from, const Waypoint& to) {
  EXPECT_EQ(walk.front().from.position, from.stance.position);
  EXPECT_EQ(walk.back().to.position, to.stance.position);
  for (size_t i = 0; i < walk.size(); ++i) {
    EXPECT_FALSE(
        steering.blockedBetween(walk[i].from.position.head<2>(), walk[i].to.position.head<2>()));
    if (i > 0) {
      EXPECT_EQ(walk[i].from.position, walk[i - 1].to.position);
    }
  }
}

class RoadmapPlannerTest : public testing::Test {
 protected:
  RoadmapPlannerTest() { twoRooms(steering, 0.8); }
  template <typename Kind>
  OmplPlannerPtr plannerOf(const SearchLimits& limits) {
    space = makeWalkSpace(steering, kRoom, limits.seed);
    return makeRoadmapPlanner(space, std::make_unique<Kind>(samplerOf(*space)), limits);
  }
  DiscSteering steering;
  OmplSpacePtr space;
  Waypoint left = standing(1, 1), right = standing(7, 1, 1.0);
};

TEST_F(RoadmapPlannerTest, SolvesQueriesOneAfterAnotherOnOneRoadmap) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const SearchLimits limits = limitsOf(seed);
    const OmplPlannerPtr planner = plannerOf<VisibilityRoadmap>(limits);
    const auto there = solveWith(*planner, left, right, limits, 1);
    ASSERT_TRUE(there.has_value());
    expectWalk(steering, *there, left, right);
    const long long samples = roadmapOf(*planner)->samples();
    const auto back = solveWith(*planner, right, left, limits, 1);
    ASSERT_TRUE(back.has_value());
    expectWalk(steering, *back, right, left);
    EXPECT_EQ(roadmapOf(*planner)->samples(), samples);  // a disc walks back the way it came
  }
}

TEST_F(RoadmapPlannerTest, SolutionIsOfTheGraphsOwnEdges) {
  steering.counts = true;
  const SearchLimits limits = limitsOf(3);
  const OmplPlannerPtr planner = plannerOf<VisibilityRoadmap>(limits);
  ASSERT_TRUE(solveWith(*planner, left, right, limits, 1).has_value());
  for (const auto& [pair, times] : steering.pairs) EXPECT_EQ(times, 1);
  const long long asked = steering.asked;
  const auto path = planner->getProblemDefinition()->getSolutionPath();
  EXPECT_TRUE(path->check());  // OMPL asks the motion validator, which knows them
  EXPECT_EQ(steering.asked, asked);
}

TEST_F(RoadmapPlannerTest, PlannerDataHasEveryEdgeInItsDirection) {
  steering.doors = {{{4, 0}, {4, 6}}};
  const SearchLimits limits = limitsOf(1);
  const OmplPlannerPtr planner = plannerOf<VisibilityRoadmap>(limits);
  ASSERT_TRUE(solveWith(*planner, right, left, limits, 1).has_value());
  ompl::base::PlannerData data(space);
  planner->getPlannerData(data);
  const Roadmap& graph = roadmapOf(*planner)->roadmap();
  EXPECT_EQ(data.numEdges(), graph.edges().size());
  for (const RoadmapEdge& edge : graph.edges()) EXPECT_TRUE(data.edgeExists(edge.from, edge.to));
}

TEST_F(RoadmapPlannerTest, NearestRoadmapRepeatsAtAnyNumberOfThreads) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const auto walk =
        solveWith(*plannerOf<NearestRoadmap>(limitsOf(seed)), left, right, limitsOf(seed), 1);
    ASSERT_TRUE(walk.has_value());
    expectWalk(steering, *walk, left, right);
    const auto again =
        solveWith(*plannerOf<NearestRoadmap>(limitsOf(seed, 2)), left, right, limitsOf(seed, 2), 1);
    ASSERT_TRUE(again.has_value());
    ASSERT_EQ(walk->size(), again->size());
    for (size_t i = 0; i < walk->size(); ++i)
      EXPECT_EQ((*walk)[i].to.position, (*again)[i].to.position);
  }
}

TEST_F(RoadmapPlannerTest, FreeGoalHeadingIsMet) {
  right.any_heading = true;
  const auto walk =
      solveWith(*plannerOf<VisibilityRoadmap>(limitsOf(1)), left, right, limitsOf(1), 1);
  ASSERT_TRUE(walk.has_value());
  const WalkEdge& last = walk->back();
  const Eigen::Vector3d way = last.to.position - last.from.position;
  EXPECT_NEAR(wrapAngle(last.to.heading - std::atan2(way.y(), way.x())), 0.0, 1e-12);
}

TEST_F(RoadmapPlannerTest, GoalAtTheStartIsAnEdgeThatStays) {
  const auto walk =
      solveWith(*plannerOf<VisibilityRoadmap>(limitsOf(1)), left, left, limitsOf(1), 1);
  ASSERT_TRUE(walk.has_value());
  ASSERT_EQ(walk->size(), 1u);
  EXPECT_EQ(walk->front().duration, 0.0);
}

TEST_F(RoadmapPlannerTest, StopsWhenOmplSaysSo) {
  twoRooms(steering, 0.3);  // narrower than the disc
  SearchLimits limits = limitsOf(1);
  limits.max_failures = 1000000;
  const OmplPlannerPtr planner = plannerOf<VisibilityRoadmap>(limits);
  planner->setProblemDefinition(makeProblem(space, left, right));
  planner->setup();
  const auto status = planner->solve(ompl::base::plannerAlwaysTerminatingCondition());
  EXPECT_FALSE(static_cast<bool>(status));
  EXPECT_EQ(roadmapOf(*planner)->samples(), 0);
}

}  // namespace
}  // namespace amble

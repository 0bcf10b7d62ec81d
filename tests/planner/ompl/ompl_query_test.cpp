#include "planner/ompl/ompl_query.h"

#include <gtest/gtest.h>
#include <ompl/base/Planner.h>
#include <ompl/base/ProblemDefinition.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/goals/GoalState.h>
#include <ompl/util/Console.h>

#include <atomic>

#include "planner/legs/planners.h"
#include "planner/ompl/quiet_ompl.h"
#include "planner/ompl/roadmap_planner.h"
#include "tests/planner/disc_steering.h"

namespace amble {
namespace {

namespace ob = ompl::base;

class OmplQueryTest : public testing::Test {
 protected:
  OmplQueryTest() { twoRooms(steering, 1.2); }
  OmplPlannerPtr plannerOf(const std::string& name, const SearchLimits& limits) {
    space = makeWalkSpace(steering, kRoom, limits.seed);
    return findPlanner(name).make(space, limits);
  }
  DiscSteering steering;
  OmplSpacePtr space;
  const Waypoint left = standing(1, 1), right = standing(7, 1, 1.0);
};

TEST_F(OmplQueryTest, AProblemHasItsTwoWaypointsAsTheyAre) {
  space = makeWalkSpace(steering, kRoom, 1);
  Waypoint to = right;
  to.any_heading = true;
  to.stance.standing = false;
  const OmplProblemPtr problem = makeProblem(space, left, to);
  ASSERT_EQ(problem->getStartStateCount(), 1u);
  EXPECT_EQ(waypointOf(problem->getStartState(0)).stance.position, left.stance.position);
  const auto* goal = problem->getGoal()->as<ob::GoalState>();
  EXPECT_EQ(waypointOf(goal->getState()).stance.position, to.stance.position);
  EXPECT_TRUE(waypointOf(goal->getState()).any_heading);
  EXPECT_FALSE(waypointOf(goal->getState()).stance.standing);
  EXPECT_TRUE(goal->isSatisfied(goal->getState()));
  EXPECT_FALSE(goal->isSatisfied(problem->getStartState(0)));
}

// Start and goal see one another: no planner needs more than its goal.
TEST_F(OmplQueryTest, AStraightWalkIsFoundByEveryPlanner) {
  for (const PlannerEntry& entry : planners()) {
    if (!entry.make) continue;
    SearchLimits limits;
    limits.max_failures = 100;
    const auto planner = plannerOf(entry.name, limits);
    const auto edges = solveWith(*planner, left, standing(3, 1), limits, 500);
    ASSERT_TRUE(edges.has_value()) << entry.name;
    EXPECT_EQ(edges->back().to.position, Eigen::Vector3d(3, 1, 0)) << entry.name;
  }
}

TEST_F(OmplQueryTest, ASecondQueryForgetsTheFirst) {
  for (const PlannerEntry& entry : planners()) {
    if (!entry.make) continue;
    SearchLimits limits;
    limits.max_failures = 300;
    const auto planner = plannerOf(entry.name, limits);
    ASSERT_TRUE(solveWith(*planner, left, right, limits, 1000).has_value()) << entry.name;
    const auto back = solveWith(*planner, right, standing(1, 5), limits, 1000);
    ASSERT_TRUE(back.has_value()) << entry.name;
    EXPECT_EQ(back->front().from.position, right.stance.position) << entry.name;
    EXPECT_EQ(back->back().to.position, Eigen::Vector3d(1, 5, 0)) << entry.name;
  }
}

TEST_F(OmplQueryTest, AStopEndsEveryPlannerBeforeItsFirstSample) {
  twoRooms(steering, 0.3);
  const std::atomic<bool> stop{true};
  for (const PlannerEntry& entry : planners()) {
    if (!entry.make) continue;
    SearchLimits limits;
    limits.stop = &stop;
    const auto planner = plannerOf(entry.name, limits);
    EXPECT_FALSE(solveWith(*planner, left, right, limits, 1000).has_value()) << entry.name;
    EXPECT_LE(effortOf(*space).samples, 1) << entry.name;
  }
}

// The solution's edges are those that were checked: nothing is steered when it is read.
TEST_F(OmplQueryTest, EdgesOfASolutionWereAllSteeredOnTheWay) {
  steering.counts = true;
  for (const PlannerEntry& entry : planners()) {
    if (!entry.make) continue;
    SearchLimits limits;
    limits.max_failures = 300;
    steering.pairs.clear();
    const auto planner = plannerOf(entry.name, limits);
    const auto edges = solveWith(*planner, left, right, limits, 1000);
    ASSERT_TRUE(edges.has_value()) << entry.name;
    for (const WalkEdge& edge : *edges)
      EXPECT_EQ(steering.pairs[DiscSteering::pairOf(edge.from, edge.to)], 1) << entry.name;
  }
}

TEST(QuietOmpl, LeavesTheLogAsItWasAlsoWhereOneIsWithinAnother) {
  const auto before = ompl::msg::getLogLevel();
  for (const auto level : {ompl::msg::LOG_WARN, ompl::msg::LOG_DEBUG, ompl::msg::LOG_NONE}) {
    ompl::msg::setLogLevel(level);
    {
      const QuietOmpl outer;
      EXPECT_EQ(ompl::msg::getLogLevel(), ompl::msg::LOG_NONE);
      {
        const QuietOmpl inner;
        EXPECT_EQ(ompl::msg::getLogLevel(), ompl::msg::LOG_NONE);
      }
      EXPECT_EQ(ompl::msg::getLogLevel(), ompl::msg::LOG_NONE);
    }
    EXPECT_EQ(ompl::msg::getLogLevel(), level);
    try {
      const QuietOmpl quiet;
      throw 1;
    } catch (int) {
    }
    EXPECT_EQ(ompl::msg::getLogLevel(), level);
  }
  ompl::msg::setLogLevel(before);
}

TEST_F(OmplQueryTest, SolvingLeavesTheLogAsItWas) {
  const auto before = ompl::msg::getLogLevel();
  ompl::msg::setLogLevel(ompl::msg::LOG_ERROR);
  SearchLimits limits;
  limits.max_failures = 50;
  solveWith(*plannerOf("rrt", limits), left, right, limits, 50);
  EXPECT_EQ(ompl::msg::getLogLevel(), ompl::msg::LOG_ERROR);
  ompl::msg::setLogLevel(before);
}

}  // namespace
}  // namespace amble

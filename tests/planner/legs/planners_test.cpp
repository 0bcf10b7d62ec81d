#include "planner/legs/planners.h"

#include <gtest/gtest.h>
#include <ompl/base/Planner.h>
#include <ompl/base/ProblemDefinition.h>

#include <set>
#include <stdexcept>

#include "planner/ompl/roadmap_planner.h"
#include "planner/plan_walk.h"
#include "tests/planner/disc_steering.h"

namespace amble {
namespace {

constexpr long long kSamples = 3000;
constexpr long long kFewSamples = 1000;  // some planners use all that they are given

SearchLimits limitsOf(std::uint64_t seed) {
  SearchLimits limits;
  limits.seed = seed;
  limits.max_failures = 300;
  return limits;
}

class PlannersTest : public testing::Test {
 protected:
  PlannersTest() { twoRooms(steering, 1.4); }

  std::optional<std::vector<WalkEdge>> solve(const PlannerEntry& entry, std::uint64_t seed,
                                             long long samples = kSamples) {
    const OmplSpacePtr space = makeWalkSpace(steering, kRoom, seed);
    const OmplPlannerPtr planner = entry.make(space, limitsOf(seed));
    auto walk = solveWith(*planner, right, left, limitsOf(seed), samples);
    is_roadmap = roadmapOf(*planner) != nullptr;
    return walk;
  }

  DiscSteering steering;
  Waypoint left = standing(2, 3), right = standing(6, 3, 1.0);
  bool is_roadmap = false;  // the planner that solved last
};

TEST(PlannerTable, NamesAreUniqueAndExplainedTheDefaultFirst) {
  EXPECT_EQ(planners().front().name, PlanRequest().planner);
  std::set<std::string> names;
  for (const PlannerEntry& entry : planners()) {
    EXPECT_TRUE(names.insert(entry.name).second) << entry.name;
    EXPECT_FALSE(entry.explanation.empty());
    EXPECT_EQ(entry.explanation.find('\n'), std::string::npos);
    EXPECT_EQ(&findPlanner(entry.name), &entry);
  }
  EXPECT_THROW(findPlanner("teleport"), std::invalid_argument);
  EXPECT_EQ(listPlanners().size(), planners().size());
}

// From right to left through a door that opens that way only: a planner that takes the way back
// for granted, or walks an edge against its direction, uses motions that are refused.
TEST_F(PlannersTest, WalksHaveNoWrongWayEdgeAndEveryEdgeIsValidated) {
  steering.doors = {{{4, 0}, {4, 6}}};
  const SteeringScratchPtr scratch = steering.makeScratch();
  for (const PlannerEntry& entry : planners()) {
    if (!entry.make) continue;
    for (std::uint64_t seed = 1; seed <= 2; ++seed) {
      const auto walk = solve(entry, seed);
      ASSERT_TRUE(walk.has_value()) << entry.name << seed;
      EXPECT_EQ(walk->front().from.position, right.stance.position);
      EXPECT_EQ(walk->back().to.position, left.stance.position);
      for (size_t i = 0; i < walk->size(); ++i) {
        const WalkEdge& edge = (*walk)[i];
        EXPECT_TRUE(steering.steer({edge.from}, {edge.to}, *scratch).edge) << entry.name;
        if (i > 0) {
          EXPECT_EQ(edge.from.position, (*walk)[i - 1].to.position) << entry.name;
        }
      }
    }
  }
}

TEST_F(PlannersTest, ADoorIsNotWalkedThroughFromItsOtherSide) {
  steering.doors = {{{4, 6}, {4, 0}}};
  for (const PlannerEntry& entry : planners()) {
    if (entry.make) {
      EXPECT_FALSE(solve(entry, 1).has_value()) << entry.name;
    }
  }
}

TEST_F(PlannersTest, EachEdgeIsSteeredOnce) {
  steering.counts = true;
  for (const PlannerEntry& entry : planners()) {
    if (!entry.make) continue;
    steering.pairs.clear();
    ASSERT_TRUE(solve(entry, 2).has_value()) << entry.name;
    for (const auto& [pair, times] : steering.pairs) EXPECT_EQ(times, 1) << entry.name;
  }
}

TEST_F(PlannersTest, SameSeedGivesTheSameWalk) {
  for (const PlannerEntry& entry : planners()) {
    if (!entry.make) continue;
    const auto one = solve(entry, 4), two = solve(entry, 4);
    ASSERT_TRUE(one && two) << entry.name;
    ASSERT_EQ(one->size(), two->size()) << entry.name;
    for (size_t i = 0; i < one->size(); ++i)
      EXPECT_EQ((*one)[i].to.position, (*two)[i].to.position) << entry.name;
  }
}

TEST_F(PlannersTest, TreesStopAfterTheirSamples) {
  twoRooms(steering, 0.3);  // narrower than the disc
  for (const PlannerEntry& entry : planners()) {
    if (!entry.make) continue;
    const OmplSpacePtr space = makeWalkSpace(steering, kRoom, 1);
    const OmplPlannerPtr planner = entry.make(space, limitsOf(1));
    if (roadmapOf(*planner)) continue;
    EXPECT_FALSE(solveWith(*planner, left, right, limitsOf(1), 200).has_value()) << entry.name;
    EXPECT_GE(effortOf(*space).samples, 200) << entry.name;
    EXPECT_LE(effortOf(*space).samples, 310) << entry.name;  // EST tries up to 100 at once
  }
}

TEST_F(PlannersTest, TheSameSeedGivesTheSameWalkOnAnyNumberOfThreads) {
  for (const PlannerEntry& entry : planners()) {
    if (!entry.make) continue;
    std::vector<std::vector<WalkEdge>> walks;
    for (const int threads : {1, 2, 4}) {
      SearchLimits limits = limitsOf(6);
      limits.threads = threads;
      const OmplSpacePtr space = makeWalkSpace(steering, kRoom, 6);
      const auto walk = solveWith(*entry.make(space, limits), right, left, limits, kFewSamples);
      ASSERT_TRUE(walk.has_value()) << entry.name;
      walks.push_back(*walk);
    }
    for (const auto& walk : walks) {
      ASSERT_EQ(walk.size(), walks[0].size()) << entry.name;
      for (size_t i = 0; i < walk.size(); ++i)
        EXPECT_EQ(walk[i].to.position, walks[0][i].to.position) << entry.name;
    }
  }
}

// Round the gap's corners no walk of a disc is shorter than the taut string between them.
TEST_F(PlannersTest, NoWalkIsShorterThanTheShortest) {
  const Eigen::Vector2d from = right.stance.position.head<2>(), to = left.stance.position.head<2>();
  const Eigen::Vector2d corner(4.0, 4.5 - 0.7);  // the gap's lower side, a disc's radius off or so
  const double least = (from - corner).norm() + (corner - to).norm() - 0.1;
  for (const PlannerEntry& entry : planners()) {
    if (!entry.make) continue;
    for (std::uint64_t seed = 1; seed <= 2; ++seed) {
      const auto walk = solve(entry, seed, kFewSamples);
      ASSERT_TRUE(walk.has_value()) << entry.name;
      double length = 0.0;
      for (const WalkEdge& edge : *walk) length += edge.length;
      EXPECT_GE(length, least) << entry.name;
    }
  }
}

}  // namespace
}  // namespace amble

#include "planner/refine_walk.h"

#include <gtest/gtest.h>

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

/// A walk over waypoints, which steering allows.
EdgePath pathOver(const Steering& steering, const std::vector<Waypoint>& waypoints) {
  const SteeringScratchPtr scratch = steering.makeScratch();
  EdgePath path;
  path.start = waypoints.front();
  path.goal = waypoints.back();
  path.pinned.assign(waypoints.size(), false);
  path.pinned.front() = path.pinned.back() = true;
  for (size_t i = 0; i + 1 < waypoints.size(); ++i) {
    path.edges.push_back(steering.steer(waypoints[i], waypoints[i + 1], *scratch).edge.value());
  }
  return path;
}

EdgePath refined(const Steering& steering, const EdgePath& path, std::uint64_t seed,
                 int threads = 1, int tries = 150) {
  SteeringCount count;
  return refineWalk(steering, path, {true, tries}, limitsOf(seed, threads), count);
}

void expectSame(const EdgePath& a, const EdgePath& b) {
  ASSERT_EQ(a.edges.size(), b.edges.size());
  for (size_t i = 0; i < a.edges.size(); ++i) {
    EXPECT_EQ(a.edges[i].from.position, b.edges[i].from.position);
    EXPECT_EQ(a.edges[i].to.position, b.edges[i].to.position);
    EXPECT_EQ(a.edges[i].to.heading, b.edges[i].to.heading);
  }
}

class RefineWalk : public testing::Test {
 protected:
  RefineWalk() { twoRooms(steering, 0.8); }
  DiscSteering steering;
  // Over the gap around (4, 4.5), by a detour in each room.
  std::vector<Waypoint> crooked = {standing(1, 1),   standing(1, 5.5), standing(3, 2),
                                   standing(3, 4.5), standing(5, 4.5), standing(7, 5.5),
                                   standing(7, 1)};
};

TEST_F(RefineWalk, NeverTakesLongerAndStaysValid) {
  const EdgePath path = pathOver(steering, crooked);
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const EdgePath better = refined(steering, path, seed);
    EXPECT_LT(better.duration(), 0.8 * path.duration());
    for (const WalkEdge& edge : better.edges) {
      EXPECT_FALSE(
          steering.blockedBetween(edge.from.position.head<2>(), edge.to.position.head<2>()));
    }
  }
}

TEST_F(RefineWalk, EdgesFollowOneAnotherAndEndsStay) {
  const EdgePath better = refined(steering, pathOver(steering, crooked), 3);
  EXPECT_EQ(better.edges.front().from.position, crooked.front().stance.position);
  EXPECT_EQ(better.edges.back().to.position, crooked.back().stance.position);
  EXPECT_EQ(better.edges.back().to.heading, crooked.back().stance.heading);
  EXPECT_EQ(better.pinned.size(), better.edges.size() + 1);
  for (size_t i = 0; i + 1 < better.edges.size(); ++i) {
    EXPECT_EQ(better.edges[i].to.position, better.edges[i + 1].from.position);
    EXPECT_EQ(better.edges[i].to.heading, better.edges[i + 1].from.heading);
    EXPECT_EQ(better.edges[i].to.standing, better.edges[i + 1].from.standing);
  }
}

TEST_F(RefineWalk, WalksOnWhereItNeedNotStop) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    EXPECT_EQ(refined(steering, pathOver(steering, crooked), seed).stops(), 0) << seed;
  }
}

TEST_F(RefineWalk, PinnedPlacesArePassed) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    EdgePath path = pathOver(steering, crooked);
    path.pinned[1] = true;
    const EdgePath better = refined(steering, path, seed);
    int passed = 0;
    for (size_t i = 0; i < better.edges.size(); ++i) {
      if (better.edges[i].from.position != crooked[1].stance.position) continue;
      ++passed;
      EXPECT_TRUE(better.pinned[i]);
    }
    EXPECT_EQ(passed, 1);
  }
}

TEST_F(RefineWalk, IsTheSameAtAnyNumberOfThreads) {
  const EdgePath path = pathOver(steering, crooked);
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const EdgePath one = refined(steering, path, seed, 1);
    expectSame(one, refined(steering, path, seed, 1));
    expectSame(one, refined(steering, path, seed, 2));
    expectSame(one, refined(steering, path, seed, 5));
  }
}

TEST_F(RefineWalk, CountsTheSameAtAnyNumberOfThreads) {
  SteeringCount one, three;
  refineWalk(steering, pathOver(steering, crooked), {true, 100}, limitsOf(1, 1), one);
  refineWalk(steering, pathOver(steering, crooked), {true, 100}, limitsOf(1, 3), three);
  EXPECT_EQ(one.poses, three.poses);
  EXPECT_EQ(one.refusals, three.refusals);
}

TEST_F(RefineWalk, StraightWalkIsLeftAsItIs) {
  const EdgePath path = pathOver(steering, {standing(1, 1), standing(3, 1)});
  EXPECT_EQ(refined(steering, path, 1).edges.size(), 1u);
}

TEST_F(RefineWalk, StopFlagKeepsTheWalk) {
  const EdgePath path = pathOver(steering, crooked);
  const std::atomic<bool> stop{true};
  SearchLimits limits = limitsOf(1);
  limits.stop = &stop;
  SteeringCount count;
  expectSame(path, refineWalk(steering, path, {}, limits, count));
}

TEST_F(RefineWalk, OneWayDoorsAreKept) {
  // From left to right of x = 4 is forbidden: there is no walk through the gap that refinement may
  // invent.
  steering.doors = {{{4, 0}, {4, 6}}};
  std::vector<Waypoint> back(crooked.rbegin(), crooked.rend());
  const EdgePath better = refined(steering, pathOver(steering, back), 2);
  for (const WalkEdge& edge : better.edges) {
    EXPECT_FALSE(steering.blockedBetween(edge.from.position.head<2>(), edge.to.position.head<2>()));
  }
}

}  // namespace
}  // namespace amble

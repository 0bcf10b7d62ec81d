#include "planner/refine_walk.h"

#include <gtest/gtest.h>

#include "base/sample_stream.h"
#include "planner/roadmap/visibility_roadmap.h"
#include "tests/planner/edge_paths.h"

namespace amble {
namespace {

SearchLimits limitsOf(std::uint64_t seed, int threads = 1) {
  SearchLimits limits;
  limits.seed = seed;
  limits.threads = threads;
  return limits;
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

// A disc that makes no edge that costs more than it is asked for.
class ThriftySteering : public DiscSteering {
 public:
  mutable std::atomic<int> spared{0};
  SteerResult steerWithin(const Waypoint& from, const Waypoint& to, double most,
                          SteeringScratch& scratch) const override {
    SteerResult result = steer(from, to, scratch);
    if (!result.edge || result.edge->cost() <= most) return result;
    ++spared;
    result.edge.reset();
    result.too_dear = true;
    return result;
  }
};

TEST_F(RefineWalk, IsTheSameWhetherDearEdgesAreMadeOrNot) {
  ThriftySteering thrifty;
  twoRooms(thrifty, 0.8);
  const EdgePath path = pathOver(steering, crooked);
  for (std::uint64_t seed = 1; seed <= 5; ++seed)
    for (const int threads : {1, 3})
      expectSame(refined(steering, path, seed), refined(thrifty, path, seed, threads));
  EXPECT_GT(thrifty.spared, 100);
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

/// A walk that steering allows over random places of the two rooms, by the gap between them.
EdgePath randomPath(const DiscSteering& steering, std::uint64_t seed) {
  SampleStream stream(seed, 0);
  const SteeringScratchPtr scratch = steering.makeScratch();
  std::vector<Waypoint> places = {standing(1, 1)};
  const Waypoint gates[] = {standing(3, 4.5), standing(5, 4.5), standing(7, 1)};
  for (const Waypoint& gate : gates) {
    for (int i = 0; i < 200 && places.size() < 12; ++i) {
      const double x =
          gate.stance.position.x() < 4 ? stream.uniform(0.3, 3.6) : stream.uniform(4.4, 7.7);
      const Waypoint next = standing(x, stream.uniform(0.3, 5.7));
      const bool leads = steering.steer(places.back(), next, *scratch).edge &&
                         steering.steer(next, gate, *scratch).edge;
      if (leads && stream.uniform() < 0.5) places.push_back(next);
      if (i > 6) break;
    }
    places.push_back(gate);
  }
  return pathOver(steering, places);
}

TEST_F(RefineWalk, OfAnyWalkItTakesNoLongerStaysValidAndKeepsItsEnds) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const EdgePath path = randomPath(steering, seed);
    const EdgePath better = refined(steering, path, seed, 1, 60);
    EXPECT_LE(better.duration(), path.duration() + 1e-9);
    EXPECT_LE(better.stops(), path.stops());
    EXPECT_EQ(better.edges.front().from.position, path.edges.front().from.position);
    EXPECT_EQ(better.edges.back().to.position, path.edges.back().to.position);
    double length = 0.0, duration = 0.0;
    for (size_t i = 0; i < better.edges.size(); ++i) {
      const WalkEdge& edge = better.edges[i];
      EXPECT_FALSE(
          steering.blockedBetween(edge.from.position.head<2>(), edge.to.position.head<2>()));
      if (i > 0) {
        EXPECT_EQ(edge.from.position, better.edges[i - 1].to.position);
      }
      length += edge.length;
      duration += edge.duration;
    }
    EXPECT_NEAR(better.length(), length, 1e-12);
    EXPECT_NEAR(better.duration(), duration, 1e-12);
  }
}

TEST_F(RefineWalk, AgainItIsNoWorse) {
  const EdgePath once = refined(steering, pathOver(steering, crooked), 1);
  const EdgePath twice = refined(steering, once, 2);
  EXPECT_LE(twice.duration(), once.duration() + 1e-9);
}

TEST_F(RefineWalk, WithoutWalkingOnItStopsAtEveryNodeAndIsStillShorter) {
  const EdgePath path = pathOver(steering, crooked);
  SteeringCount count;
  const EdgePath better = refineWalk(steering, path, {.walk_on = false}, limitsOf(1), count);
  EXPECT_LE(better.duration(), path.duration());
  EXPECT_EQ(better.stops(), static_cast<int>(better.edges.size()) - 1);
}

TEST_F(RefineWalk, InterruptedInTheMiddleItIsAWalkStill) {
  const EdgePath path = pathOver(steering, crooked);
  for (const int questions : {1, 5, 30, 100}) {
    SearchLimits limits = limitsOf(1);
    int asked = 0;
    limits.interrupted = [&] { return ++asked > questions; };
    SteeringCount count;
    const EdgePath better = refineWalk(steering, path, {true, 150}, limits, count);
    EXPECT_LE(better.duration(), path.duration());
    ASSERT_FALSE(better.edges.empty());
    EXPECT_EQ(better.edges.back().to.position, path.edges.back().to.position);
    for (size_t i = 1; i < better.edges.size(); ++i)
      EXPECT_EQ(better.edges[i].from.position, better.edges[i - 1].to.position);
  }
}

}  // namespace
}  // namespace amble

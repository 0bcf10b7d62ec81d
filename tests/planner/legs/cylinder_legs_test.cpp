#include "planner/legs/cylinder_legs.h"

#include <gtest/gtest.h>

#include <atomic>

#include "planner/legs/planners.h"
#include "tests/planner/disc_steering.h"
#include "tests/planner/furnished_room.h"

namespace amble {
namespace {

/// The furnished room with a passage of that width beside its wall.
Scene roomWithPassage(double width) {
  Scene scene = furnishedScene();
  scene.objects[5] = boxObject("wall", {0.1, 4.0 - width, 2.5}, {3, 0.5 * (4.0 - width), 1.25});
  return scene;
}

struct CylinderTest {
  explicit CylinderTest(double width, const std::string& planner = "cylinder")
      : room(roomWithPassage(width)) {
    request.synthesizer = &room.synthesizer;
    request.world = &room.world;
    request.ground = &room.ground;
    request.bounds = room.bounds;
    request.planner = planner;
    request.limits.max_failures = 60;
  }
  const FurnishedRoom room;
  PlanRequest request;
  const WalkSteering steering{room.synthesizer, room.world, room.ground};
  const Waypoint from = standing(1, 1, kPi / 2), to = standing(5.3, 2.5, -kPi / 2);
};

TEST(CylinderLegs, ThroughAWidePassageItsWalkIsTheBodysOwn) {
  CylinderTest test(1.9);
  const auto legs = makeLegPlanner(test.request, test.steering, test.request.limits);
  const auto edges = legs->solve(test.from, test.to);
  ASSERT_TRUE(edges.has_value());
  EXPECT_EQ(edges->front().from.position, test.from.stance.position);
  EXPECT_EQ(edges->back().to.position, test.to.stance.position);
  EXPECT_EQ(edges->back().to.heading, test.to.stance.heading);
  const SteeringScratchPtr scratch = test.steering.makeScratch();
  for (size_t i = 0; i < edges->size(); ++i) {
    const WalkEdge& edge = (*edges)[i];
    if (i > 0) {
      EXPECT_EQ(edge.from.position, (*edges)[i - 1].to.position);
      EXPECT_EQ(edge.from.heading, (*edges)[i - 1].to.heading);
    }
    AnimationBuffer walk;
    test.steering.animate(edge, walk);
    EXPECT_FALSE(test.steering.contact(walk, *scratch).has_value());
  }
}

// What the comparison is about: a passage that a body walks through and its bounding cylinder does
// not.
TEST(CylinderLegs, FindsNothingWhereOnlyTheAnimatedBodyFits) {
  CylinderTest cylinder(0.8), body(0.8, "visibility");
  const auto legs = makeLegPlanner(cylinder.request, cylinder.steering, cylinder.request.limits);
  EXPECT_FALSE(legs->solve(cylinder.from, cylinder.to).has_value());
  const auto why = legs->why();
  ASSERT_TRUE(why.has_value());
  EXPECT_EQ(why->part, "bounding cylinder");
  EXPECT_EQ(why->rule, WalkRule::kContact);
  EXPECT_TRUE(why->object == "wall" || why->object == "north") << why->object;
  EXPECT_TRUE(makeLegPlanner(body.request, body.steering, body.request.limits)
                  ->solve(body.from, body.to)
                  .has_value());
}

TEST(CylinderLegs, TheSameSeedGivesTheSameLegOnAnyNumberOfThreads) {
  CylinderTest test(1.9);
  std::vector<std::vector<WalkEdge>> found;
  for (const int threads : {1, 2}) {
    SearchLimits limits = test.request.limits;
    limits.threads = threads;
    const auto edges =
        makeLegPlanner(test.request, test.steering, limits)->solve(test.from, test.to);
    ASSERT_TRUE(edges.has_value());
    found.push_back(*edges);
  }
  ASSERT_EQ(found[0].size(), found[1].size());
  for (size_t i = 0; i < found[0].size(); ++i) {
    EXPECT_EQ(found[0][i].to.position, found[1][i].to.position);
    EXPECT_EQ(found[0][i].duration, found[1][i].duration);
  }
}

TEST(CylinderLegs, ToldToStopItStopsBeforeItsFirstAttempt) {
  CylinderTest test(1.9);
  const std::atomic<bool> stop{true};
  SearchLimits limits = test.request.limits;
  limits.stop = &stop;
  const auto legs = makeLegPlanner(test.request, test.steering, limits);
  EXPECT_FALSE(legs->solve(test.from, test.to).has_value());
  PlanOutcome outcome;
  legs->describe(outcome);
  EXPECT_EQ(outcome.samples, 0);
  EXPECT_EQ(outcome.poses_checked, 0);
}

TEST(CylinderLegs, DescribesItsRoadmapAndWhatTheBodyCost) {
  CylinderTest test(1.9);
  const auto legs = makeLegPlanner(test.request, test.steering, test.request.limits);
  const auto edges = legs->solve(test.from, test.to);
  ASSERT_TRUE(edges.has_value());
  PlanOutcome outcome;
  legs->describe(outcome);
  EXPECT_GE(outcome.roadmap.nodes.size(), 2u);
  double frames = 0.0;
  for (const WalkEdge& edge : *edges)
    frames += edge.duration / test.room.synthesizer.settings().frame_time;
  EXPECT_GT(static_cast<double>(outcome.poses_checked), frames);
}

}  // namespace
}  // namespace amble

#include "planner/plan_walk.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <stdexcept>

#include "base/rotation.h"
#include "base/sample_stream.h"
#include "planner/steering/walk_steering.h"
#include "planner/why/obstruction_text.h"
#include "tests/planner/furnished_room.h"

namespace amble {
namespace {

PlanRequest requestIn(const FurnishedRoom& room, double goal_heading_deg = -90.0) {
  PlanRequest request;
  request.synthesizer = &room.synthesizer;
  request.world = &room.world;
  request.ground = &room.ground;
  request.bounds = room.bounds;
  request.start = {{1, 1, 0}, 90 * kDegree, true};
  request.goal = {{5.3, 2.5, 0}, goal_heading_deg * kDegree, true};
  request.limits.max_failures = 60;
  request.refine.tries = 40;
  return request;
}

void expectSameFrames(const AnimationBuffer& a, const AnimationBuffer& b) {
  ASSERT_EQ(a.size(), b.size());
  for (int i = 0; i < a.size(); ++i) {
    ASSERT_EQ(a.poses.p_WR(i), b.poses.p_WR(i));
    for (int j = 0; j < a.poses.joints(); ++j) {
      ASSERT_EQ(a.poses.rotations(i)[j].coeffs(), b.poses.rotations(i)[j].coeffs());
    }
  }
}

TEST(PlanWalk, RefusesRequestsThatCannotBeMeant) {
  EXPECT_THROW(planWalk({}), std::invalid_argument);
  PlanRequest request = requestIn(furnishedRoom());
  request.planner = "teleport";
  EXPECT_THROW(planWalk(request), std::invalid_argument);
  request = requestIn(furnishedRoom());
  request.limits.max_failures = 0;
  EXPECT_THROW(planWalk(request), std::invalid_argument);
  request = requestIn(furnishedRoom());
  request.limits.threads = 0;
  EXPECT_THROW(planWalk(request), std::invalid_argument);
  request = requestIn(furnishedRoom());
  request.comfort = -0.01;
  EXPECT_THROW(planWalk(request), std::invalid_argument);
}

// Nobody who is in a hurry stops at a corner: he slows down for it.
TEST(PlanWalk, WhoIsToldToHurrySlowsDownForCornersInPlaceOfStopping) {
  Scene scene;
  scene.objects = {boxObject("floor", {8, 6, 0.1}, {4, 3, -0.05}),
                   boxObject("wall left", {0.12, 2.55, 2.4}, {4, 1.275, 1.2}),
                   boxObject("wall right", {0.12, 2.55, 2.4}, {4, 4.725, 1.2}),
                   boxObject("low box", {0.4, 0.4, 0.4}, {2, 2, 0.2}),
                   boxObject("box", {0.5, 0.3, 0.9}, {3, 3.9, 0.45}),
                   boxObject("table", {0.8, 1.6, 0.75}, {6, 3, 0.375})};
  const auto walkAt = [&](double speed) {
    const FurnishedRoom room(scene, {.speed = speed});
    PlanRequest request = requestIn(room);
    request.bounds = {Eigen::Vector2d(0, 0), Eigen::Vector2d(8, 6)};
    request.start = {{0.8, 1, 0}, 0.0, true};
    request.goal = {{7.3, 5, 0}, 90 * kDegree, true};
    request.limits.max_failures = 500;
    request.refine = {};
    const PlanOutcome outcome = planWalk(request);
    EXPECT_EQ(outcome.status, PlanStatus::kSolved) << speed;
    return outcome.walk.buffer;
  };
  const AnimationBuffer usual = walkAt(1.2), hurried = walkAt(2.0);
  EXPECT_LT(hurried.size(), 1.1 * usual.size());
}

TEST(PlanWalk, WalkEndsAtTheGoalAndTouchesNothing) {
  const FurnishedRoom& room = furnishedRoom();
  const CollisionScratchPtr scratch = room.world.makeScratch();
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    PlanRequest request = requestIn(room);
    request.limits.seed = seed;
    const PlanOutcome outcome = planWalk(request);
    ASSERT_EQ(outcome.status, PlanStatus::kSolved);
    const AnimationBuffer& walk = outcome.walk.buffer;
    EXPECT_FALSE(room.world.check(walk.poses, walk.soles, false, *scratch).has_value());
    AnimationBuffer asked;
    Stance goal;
    goal.position = request.goal.position;
    goal.heading = *request.goal.heading;
    room.synthesizer.stand(goal, asked);
    const int last = walk.size() - 1;
    EXPECT_LT((walk.poses.p_WR(last) - asked.poses.p_WR(0)).norm(), 1e-3);
    EXPECT_LT(walk.poses.rotations(last)[0].angularDistance(asked.poses.rotations(0)[0]),
              0.5 * kDegree);
  }
}

TEST(PlanWalk, WithComfortWalksKeepAwayFromThings) {
  const FurnishedRoom& room = furnishedRoom();
  const CollisionScratchPtr scratch = room.world.makeScratch();
  double with = 0.0, without = 0.0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    PlanRequest request = requestIn(room);
    request.limits.seed = seed;
    for (const auto& [comfort, nearness] : {std::pair{0.15, &with}, std::pair{0.0, &without}}) {
      request.comfort = comfort;
      const PlanOutcome outcome = planWalk(request);
      ASSERT_EQ(outcome.status, PlanStatus::kSolved);
      *nearness += room.world.nearness(outcome.walk.buffer.poses, 0.15, *scratch);
    }
  }
  EXPECT_GT(without, 0.0);
  EXPECT_LT(with, 0.7 * without);
}

TEST(PlanWalk, SameSeedGivesTheSameFramesAtAnyNumberOfThreads) {
  PlanRequest request = requestIn(furnishedRoom());
  const PlanOutcome one = planWalk(request);
  const PlanOutcome again = planWalk(request);
  request.limits.threads = 2;
  const PlanOutcome two = planWalk(request);
  ASSERT_EQ(one.status, PlanStatus::kSolved);
  expectSameFrames(one.walk.buffer, again.walk.buffer);
  expectSameFrames(one.walk.buffer, two.walk.buffer);
  EXPECT_EQ(one.refusals, two.refusals);
  EXPECT_EQ(one.poses_checked, two.poses_checked);
  EXPECT_EQ(one.samples, two.samples);
}

TEST(PlanWalk, BlockedEndsAreNamed) {
  PlanRequest request = requestIn(furnishedRoom());
  request.start.position = {4.5, 1.2, 0};
  const PlanOutcome start = planWalk(request);
  EXPECT_EQ(start.status, PlanStatus::kStartBlocked);
  ASSERT_TRUE(start.why.has_value());
  EXPECT_EQ(start.why->object, "table");
  request = requestIn(furnishedRoom());
  request.goal.position = {3.0, 1.0, 0};
  const PlanOutcome goal = planWalk(request);
  EXPECT_EQ(goal.status, PlanStatus::kGoalBlocked);
  EXPECT_EQ(goal.why->object, "wall");
}

TEST(PlanWalk, ABlockedViaPointIsNamedByItsNumber) {
  PlanRequest request = requestIn(furnishedRoom());
  request.via = {{1.2, 2.8, 0}, {4.5, 1.2, 0}};
  const PlanOutcome outcome = planWalk(request);
  EXPECT_EQ(outcome.status, PlanStatus::kNoWalk);
  EXPECT_TRUE(outcome.proved);
  ASSERT_TRUE(outcome.why.has_value());
  EXPECT_EQ(outcome.why->object, "table");
  EXPECT_EQ(outcome.why->via, 1);
  EXPECT_EQ(describe(*outcome.why).find("via[1]"), 0u) << describe(*outcome.why);
}

TEST(PlanWalk, ThatASealedPassageLeavesNoWalkIsProvedAndSaysByWhat) {
  Scene scene = furnishedScene();
  scene.objects.push_back(boxObject("door", {0.1, 0.9, 2.5}, {3, 3.55, 1.25}));
  const FurnishedRoom room(scene);
  const PlanOutcome outcome = planWalk(requestIn(room));
  EXPECT_EQ(outcome.status, PlanStatus::kNoWalk);
  EXPECT_TRUE(outcome.proved);
  EXPECT_EQ(outcome.samples, 0);
  ASSERT_TRUE(outcome.why.has_value());
  EXPECT_EQ(outcome.why->rule, WalkRule::kDisconnected);
  EXPECT_TRUE(outcome.why->object == "wall" || outcome.why->object == "door")
      << outcome.why->object;
}

// Want of width, of height or of a step, on level ground and beside a kerb.
TEST(PlanWalk, DrawnRoomsThatNobodyGetsThroughEndWithAProofBeforeAnySample) {
  SampleStream stream(9, 0);
  const double stature = furnishedRoom().synthesizer.stature();
  for (int i = 0; i < 20; ++i) {
    Scene scene = furnishedScene();
    scene.objects.resize(5);  // the floor and four walls
    const auto add = [&](const std::string& name, const Eigen::Vector3d& size,
                         const Eigen::Vector3d& at) {
      scene.objects.push_back(boxObject(name, size, at));
    };
    const double x = stream.uniform(3.2, 4.0), thick = stream.uniform(0.05, 0.3);
    double goal_height = 0.0;
    if (i % 4 == 0) {
      const double gap = stream.uniform(0.02, 0.08), south = stream.uniform(0.5, 3.0);
      add("south of it", {thick, south, 2.5}, {x, 0.5 * south, 1.25});
      add("north of it", {thick, 4 - south - gap, 2.5}, {x, 0.5 * (4 + south + gap), 1.25});
    } else if (i % 4 == 1) {
      const double under = stature - stream.uniform(0.04, 0.5);
      add("beam", {thick, 4, 1.2}, {x, 2, under + 0.6});
    } else if (i % 4 == 2) {
      const double height = stream.uniform(0.5, 0.9);
      add("log", {thick, 4, height}, {x, 2, 0.5 * height});
    } else {
      goal_height = stream.uniform(0.35, 0.9);
      add("platform", {6 - x, 4, goal_height}, {0.5 * (6 + x), 2, 0.5 * goal_height});
    }
    if (i % 8 >= 4 && i % 4 != 3) add("kerb", {0.4, 4, 0.12}, {1.55, 2, 0.06});
    const FurnishedRoom room(scene);
    PlanRequest request = requestIn(room);
    request.goal.position.z() = goal_height;
    request.limits.max_failures = 1;
    const PlanOutcome outcome = planWalk(request);
    EXPECT_EQ(outcome.status, PlanStatus::kNoWalk) << i;
    EXPECT_TRUE(outcome.proved) << i;
    EXPECT_EQ(outcome.samples, 0) << i;
    EXPECT_TRUE(outcome.why.has_value()) << i;
  }
}

// A gap that is open, but for nobody: samples say so.
TEST(PlanWalk, ThatNoWalkIsFoundThroughANarrowGapIsNoProof) {
  Scene scene = furnishedScene();
  scene.objects.push_back(boxObject("door", {0.1, 0.5, 2.5}, {3, 3.35, 1.25}));
  const FurnishedRoom room(scene);
  PlanRequest request = requestIn(room);
  request.limits.max_failures = 25;
  const PlanOutcome outcome = planWalk(request);
  EXPECT_EQ(outcome.status, PlanStatus::kNoWalk);
  EXPECT_FALSE(outcome.proved);
  EXPECT_FALSE(outcome.time_limit_hit);
  EXPECT_GT(outcome.samples, 0);
  EXPECT_LE(outcome.samples, 50);  // 25 of them uniform
  ASSERT_TRUE(outcome.why.has_value());
  EXPECT_EQ(outcome.why->rule, WalkRule::kContact);
}

TEST(PlanWalk, ViaPointsArePassed) {
  PlanRequest request = requestIn(furnishedRoom());
  request.via = {{1.2, 2.8, 0}, {5.2, 3.4, 0}};
  const PlanOutcome outcome = planWalk(request);
  ASSERT_EQ(outcome.status, PlanStatus::kSolved);
  for (const Eigen::Vector3d& via : request.via) {
    double nearest = HUGE_VAL;
    for (const Stance& stance : outcome.walk.stances) {
      nearest = std::min(nearest, (stance.position - via).head<2>().norm());
    }
    EXPECT_LT(nearest, 1e-3);
  }
}

TEST(PlanWalk, FreeHeadingsAreChosen) {
  PlanRequest request = requestIn(furnishedRoom());
  request.start.heading.reset();
  request.goal.heading.reset();
  EXPECT_EQ(planWalk(request).status, PlanStatus::kSolved);
}

TEST(PlanWalk, EveryPlannerByNameAnswers) {
  ASSERT_EQ(listPlanners().front().name, "visibility");
  for (const PlannerInfo& planner : listPlanners()) {
    PlanRequest request = requestIn(furnishedRoom());
    request.planner = planner.name;
    request.limits.max_failures = 200;  // with few luck decides
    const PlanOutcome outcome = planWalk(request);
    // The passage is narrower than the bounding cylinder of a walking body.
    const PlanStatus expected =
        planner.name == "cylinder" ? PlanStatus::kNoWalk : PlanStatus::kSolved;
    EXPECT_EQ(outcome.status, expected) << planner.name;
  }
}

TEST(PlanWalk, GoalAtTheStartIsAWalkThatStands) {
  PlanRequest request = requestIn(furnishedRoom());
  request.goal = request.start;
  const PlanOutcome outcome = planWalk(request);
  EXPECT_EQ(outcome.status, PlanStatus::kSolved);
  EXPECT_EQ(outcome.walk.buffer.size(), 1);
}

TEST(PlanWalk, WhoWalksWhereHeIsToWalkIsThereWithoutAStep) {
  PlanRequest request = requestIn(furnishedRoom());
  request.start.standing = request.goal.standing = false;
  request.goal.position = request.start.position;
  for (const bool any : {false, true}) {
    request.goal.heading = any ? std::optional<double>() : request.start.heading;
    const PlanOutcome outcome = planWalk(request);
    ASSERT_EQ(outcome.status, PlanStatus::kSolved);
    EXPECT_EQ(outcome.walk.buffer.size(), 1);
    EXPECT_EQ(outcome.walk.path.length(), 0.0);
    EXPECT_EQ(outcome.walk.buffer.states[0].standing, 0.0) << "in the middle of a step";
  }
}

TEST(PlanWalk, GoalsNearerThanAShortWalkAreTwoSmallSteps) {
  for (const Eigen::Vector3d& by : {Eigen::Vector3d(0, 0.1, 0), Eigen::Vector3d(0.15, 0, 0),
                                    Eigen::Vector3d(-0.05, -0.15, 0)}) {
    PlanRequest request = requestIn(furnishedRoom());
    request.goal = request.start;
    request.goal.position += by;
    const PlanOutcome outcome = planWalk(request);
    ASSERT_EQ(outcome.status, PlanStatus::kSolved);
    EXPECT_NEAR(outcome.walk.path.length(), by.norm(), 1e-9);
    const AnimationBuffer& walk = outcome.walk.buffer;
    EXPECT_LT(walk.size() * walk.frame_time, 1.5);
    int steps = 0;
    for (const Footprint& print : walk.footprints) steps += print.first_frame > 0;
    EXPECT_EQ(steps, 2);
    AnimationBuffer asked;
    furnishedRoom().synthesizer.stand({request.goal.position, *request.goal.heading}, asked);
    EXPECT_LT((walk.poses.p_WR(walk.size() - 1) - asked.poses.p_WR(0)).norm(), 1e-9);
  }
}

TEST(PlanWalk, WhereNoGroundLeadsItIsSaidAtOnceAndProved) {
  Scene scene;
  scene.objects = {boxObject("west", {3, 6, 0.1}, {1.5, 3, -0.05}),
                   boxObject("east", {3, 6, 0.1}, {6.5, 3, -0.05})};
  const FurnishedRoom room(scene);
  PlanRequest request = requestIn(room);
  request.start.position = {1.5, 1.5, 0};
  request.goal.position = {6.5, 4.5, 0};
  request.limits.max_failures = 1000000;  // no search would end
  const PlanOutcome outcome = planWalk(request);
  EXPECT_EQ(outcome.status, PlanStatus::kNoWalk);
  EXPECT_TRUE(outcome.proved);
  EXPECT_EQ(outcome.samples, 0);
  ASSERT_TRUE(outcome.why && outcome.why->width && outcome.why->needed);
  EXPECT_EQ(outcome.why->rule, WalkRule::kNoGround);
  EXPECT_NEAR(*outcome.why->width, 2.0, 0.25);
  EXPECT_LT(*outcome.why->needed, *outcome.why->width);
}

// A walker needs room for a step where it walks on; every heading is judged so, the first one too.
TEST(PlanWalk, WalkingEndsAreJudgedWalking) {
  const FurnishedRoom& room = furnishedRoom();
  PlanRequest request = requestIn(room);
  // Standing along the wall there is room, in mid-walk across it there is none.
  request.goal = {{5.3, 0.3, 0}, -90 * kDegree, false};
  const WalkSteering steering(room.synthesizer, room.world, room.ground);
  const SteeringScratchPtr scratch = steering.makeScratch();
  Stance stance;
  stance.position = request.goal.position;
  stance.heading = *request.goal.heading;
  stance.standing = false;
  ASSERT_TRUE(steering.stand(stance, *scratch).has_value());
  EXPECT_EQ(planWalk(request).status, PlanStatus::kGoalBlocked);
  request.goal.heading.reset();
  const PlanOutcome outcome = planWalk(request);
  if (outcome.status == PlanStatus::kSolved) {
    Stance last = outcome.walk.stances.back();
    EXPECT_FALSE(last.standing);
    EXPECT_FALSE(steering.stand(last, *scratch).has_value());
  }
}

TEST(PlanWalk, RoadmapsPictureHasTheCurvesThatWereWalked) {
  const PlanOutcome outcome = planWalk(requestIn(furnishedRoom()));
  ASSERT_FALSE(outcome.roadmap.edges.empty());
  for (const RoadmapPicture::Edge& edge : outcome.roadmap.edges) {
    if (edge.line.empty()) continue;
    const auto at = [&](int node) {
      return Eigen::Vector2d(outcome.roadmap.nodes[node].stance.position.head<2>());
    };
    EXPECT_LT((edge.line.front() - at(edge.from)).norm(), 1e-9);
    EXPECT_LT((edge.line.back() - at(edge.to)).norm(), 1e-9);
    for (size_t i = 1; i < edge.line.size(); ++i)
      EXPECT_LT((edge.line[i] - edge.line[i - 1]).norm(), 0.11);
  }
}

// A door that is no door: what is told of it is the same however many threads looked for a way.
TEST(PlanWalk, HowFarOneGetsAndWhatWasRefusedAreToldTheSameAtAnyNumberOfThreads) {
  Scene scene = furnishedScene();
  scene.objects.push_back(boxObject("post", {0.1, 0.4, 2.5}, {3, 3.8, 1.25}));
  const FurnishedRoom room(scene);  // 0.5 m are left between wall and post
  PlanRequest request = requestIn(room);
  request.limits.max_failures = 10;
  const PlanOutcome one = planWalk(request);
  request.limits.threads = 3;
  const PlanOutcome three = planWalk(request);
  ASSERT_EQ(one.status, PlanStatus::kNoWalk);
  ASSERT_TRUE(one.reached && three.reached);
  EXPECT_LT(one.reached->near.x(), 3.0);
  EXPECT_GT(one.reached->far.x(), 3.0);
  EXPECT_NEAR(one.reached->near.y(), 3.35, 0.2);  // the middle of what is left
  ASSERT_EQ(one.reached->strips.size(), three.reached->strips.size());
  for (size_t i = 0; i < one.reached->strips.size(); ++i) {
    EXPECT_EQ(one.reached->strips[i].from, three.reached->strips[i].from);
    EXPECT_EQ(one.reached->strips[i].to, three.reached->strips[i].to);
  }
  ASSERT_FALSE(one.roadmap.refused.empty());
  ASSERT_EQ(one.roadmap.refused.size(), three.roadmap.refused.size());
  for (size_t i = 0; i < one.roadmap.refused.size(); ++i) {
    const auto &a = one.roadmap.refused[i], &b = three.roadmap.refused[i];
    EXPECT_EQ(a.from.stance.position, b.from.stance.position);
    EXPECT_EQ(a.to.stance.position, b.to.stance.position);
    EXPECT_EQ(a.rule, b.rule);
    EXPECT_EQ(a.part, b.part);
    EXPECT_EQ(a.object, b.object);
    EXPECT_EQ(a.at, b.at);
  }
}

TEST(PlanWalk, WhereThereIsAWalkNothingIsToldOfHowFarOneGets) {
  const PlanOutcome outcome = planWalk(requestIn(furnishedRoom()));
  ASSERT_EQ(outcome.status, PlanStatus::kSolved);
  EXPECT_FALSE(outcome.reached.has_value());
  PlanRequest request = requestIn(furnishedRoom());
  request.start.position = {4.5, 1.2, 0};  // in the table
  EXPECT_FALSE(planWalk(request).reached.has_value());
}

TEST(PlanWalk, ToAGoalThatIsBlockedOneGetsAsFarAsThereIsRoom) {
  PlanRequest request = requestIn(furnishedRoom());
  request.goal.position = {4.5, 1.2, 0};
  const PlanOutcome outcome = planWalk(request);
  ASSERT_EQ(outcome.status, PlanStatus::kGoalBlocked);
  ASSERT_TRUE(outcome.reached.has_value());
  EXPECT_GT(outcome.reached->near.x(), 3.0);  // through the passage, to the table
  EXPECT_LT((outcome.reached->near - request.goal.position).norm(), 1.2);
}

TEST(PlanWalk, DeadlineOnlyStopsAndIsReported) {
  PlanRequest request = requestIn(furnishedRoom());
  request.limits.deadline = std::chrono::steady_clock::now();
  const PlanOutcome outcome = planWalk(request);
  EXPECT_EQ(outcome.status, PlanStatus::kNoWalk);
  EXPECT_TRUE(outcome.time_limit_hit);
}

// Small rooms, every planner of the table: what is found is free and the same on two threads.
TEST(PlanWalk, EveryPlannersWalkIsFreeAndTheSameOnTwoThreads) {
  const FurnishedRoom& room = furnishedRoom();
  const CollisionScratchPtr scratch = room.world.makeScratch();
  for (const PlannerInfo& planner : listPlanners()) {
    PlanRequest request = requestIn(room);
    request.planner = planner.name;
    request.limits.max_failures = 200;                   // with few luck decides
    request.goal = {{1.2, 2.8, 0}, 90 * kDegree, true};  // in the same half, for the cylinder
    request.limits.max_failures = 15;
    request.refine.tries = 5;
    const PlanOutcome one = planWalk(request);
    ASSERT_EQ(one.status, PlanStatus::kSolved) << planner.name;
    EXPECT_FALSE(one.why.has_value());
    const AnimationBuffer& walk = one.walk.buffer;
    EXPECT_FALSE(room.world.check(walk.poses, walk.soles, false, *scratch)) << planner.name;
    request.limits.threads = 2;
    const PlanOutcome two = planWalk(request);
    ASSERT_EQ(two.status, PlanStatus::kSolved) << planner.name;
    expectSameFrames(walk, two.walk.buffer);
    EXPECT_EQ(one.samples, two.samples) << planner.name;
    EXPECT_EQ(one.poses_checked, two.poses_checked) << planner.name;
  }
}

TEST(PlanWalk, WithTheBoundsTooSmallTheyAreWidenedToTheEnds) {
  PlanRequest request = requestIn(furnishedRoom());
  request.goal = {{1.0, 3.0, 0}, 90 * kDegree, true};
  request.bounds = {Eigen::Vector2d(0.9, 0.9), Eigen::Vector2d(1.1, 1.1)};
  EXPECT_EQ(planWalk(request).status, PlanStatus::kSolved);
}

TEST(PlanWalk, TheWalkIsAsLongAsItsPathAndAsItsFrames) {
  const PlanOutcome outcome = planWalk(requestIn(furnishedRoom()));
  ASSERT_EQ(outcome.status, PlanStatus::kSolved);
  const Walk& walk = outcome.walk;
  double shortest = (walk.stances.back().position - walk.stances.front().position).norm();
  EXPECT_GT(walk.path.length(), shortest);
  EXPECT_EQ(walk.buffer.states.size(), static_cast<size_t>(walk.buffer.size()));
  EXPECT_EQ(walk.buffer.soles.size(), static_cast<size_t>(walk.buffer.size()));
  EXPECT_NEAR(walk.buffer.states.back().arc, walk.path.length(), 1e-6);
  for (int i = 1; i < walk.buffer.size(); ++i) {
    EXPECT_GE(walk.buffer.states[i].arc, walk.buffer.states[i - 1].arc - 1e-12);
    EXPECT_LT((walk.buffer.poses.p_WR(i) - walk.buffer.poses.p_WR(i - 1)).norm(), 0.05);
  }
  EXPECT_EQ(walk.stances.front().position, requestIn(furnishedRoom()).start.position);
}

TEST(PlanWalk, AStopIsToldApartFromADeadline) {
  PlanRequest request = requestIn(furnishedRoom());
  const std::atomic<bool> stop{true};
  request.limits.stop = &stop;
  const PlanOutcome outcome = planWalk(request);
  EXPECT_EQ(outcome.status, PlanStatus::kNoWalk);
  EXPECT_TRUE(outcome.stopped);
  EXPECT_FALSE(outcome.time_limit_hit);
  EXPECT_EQ(outcome.samples, 0);
}

TEST(PlanWalk, RefusesBoundsAndTriesThatCannotBe) {
  PlanRequest request = requestIn(furnishedRoom());
  request.bounds = {};
  EXPECT_THROW(planWalk(request), std::invalid_argument);
  request = requestIn(furnishedRoom());
  request.bounds.max().x() = HUGE_VAL;
  EXPECT_THROW(planWalk(request), std::invalid_argument);
  request = requestIn(furnishedRoom());
  request.refine.tries = -1;
  EXPECT_THROW(planWalk(request), std::invalid_argument);
  request = requestIn(furnishedRoom());
  request.limits.threads = 65;
  EXPECT_THROW(planWalk(request), std::invalid_argument);
}

}  // namespace
}  // namespace amble

#include "planner/why/obstruction.h"

#include <gtest/gtest.h>

#include <set>

#include "base/rotation.h"
#include "planner/plan_walk.h"
#include "planner/steering/walk_steering.h"
#include "planner/why/ground_profile.h"
#include "planner/why/obstruction_text.h"
#include "tests/planner/furnished_room.h"

namespace amble {
namespace {

SteeringFailure contact(int part, int object, const Eigen::Vector3d& at, double gap = 0.0) {
  return {WalkRule::kContact, part, object, gap, at, {at.x(), at.y(), 0.0}, 0.0};
}

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(Obstruction, OfNothingIsNone) {
  const FurnishedRoom& room = furnishedRoom();
  EXPECT_FALSE(mostOften({}, room.scene, room.body).has_value());
}

TEST(Obstruction, IsTheRuleAndObjectThatRefusedMostOften) {
  const FurnishedRoom& room = furnishedRoom();
  const std::vector<SteeringFailure> refusals = {
      contact(1, 5, {3, 1, 1}, 0.02), contact(2, 5, {3, 2, 1}, 0.01), contact(2, 5, {3, 3, 1}),
      contact(3, 6, {4, 1, 0}),       {WalkRule::kTurnRate},          {WalkRule::kTurnRate}};
  const auto why = mostOften(refusals, room.scene, room.body);
  ASSERT_TRUE(why.has_value());
  EXPECT_EQ(why->rule, WalkRule::kContact);
  EXPECT_EQ(why->object, "wall");
  EXPECT_EQ(why->part, room.body.parts[2].name);
  EXPECT_EQ(why->count, 3);
  EXPECT_EQ(why->gap, 0.0);
  EXPECT_EQ(why->at, Eigen::Vector3d(3, 2, 1));  // the middle one
}

PlanRequest askedIn(const FurnishedRoom& room) {
  PlanRequest request;
  request.synthesizer = &room.synthesizer;
  request.world = &room.world;
  request.ground = &room.ground;
  request.bounds = room.bounds;
  request.start = {{1, 1, 0}, 90 * kDegree, true};
  request.goal = {{5.3, 2.5, 0}, -90 * kDegree, true};
  request.limits.max_failures = 20;
  return request;
}

// A door of the furnished room between its wall and a post.
PlanOutcome throughDoor(double width) {
  Scene scene = furnishedScene();
  const double post = 0.9 - width;
  scene.objects.push_back(boxObject("post", {0.1, post, 2.5}, {3, 4.0 - 0.5 * post, 1.25}));
  const FurnishedRoom room(scene);
  PlanRequest request = askedIn(room);
  const double middle = 3.1 + 0.5 * width;
  request.start = {{1.2, middle, 0}, 0.0, true};
  request.goal = {{4.8, middle, 0}, 0.0, true};  // straight through
  return planWalk(request);
}

TEST(Obstruction, ATooNarrowPassageIsMeasuredBetweenItsSides) {
  const PlanOutcome outcome = throughDoor(0.5);
  ASSERT_EQ(outcome.status, PlanStatus::kNoWalk);
  ASSERT_TRUE(outcome.why && outcome.why->width && outcome.why->needed && outcome.why->overlap);
  EXPECT_EQ(outcome.why->lack, Obstruction::Lack::kGap) << describe(*outcome.why);
  EXPECT_NEAR(*outcome.why->width, 0.5, 0.001);
  const std::set<std::string> sides = {outcome.why->object, outcome.why->other};
  EXPECT_EQ(sides, (std::set<std::string>{"wall", "post"}));
  EXPECT_FALSE(outcome.why->part.empty());
  EXPECT_GT(*outcome.why->overlap, 0.0);
  EXPECT_FALSE(outcome.proved);  // a search proves nothing
}

// What it says would do does, and 5 cm less do not; with 3 cm less there are walks that a search
// finds.
TEST(Obstruction, AGapAsWideAsWouldDoIsWalkedAndANarrowerOneIsNot) {
  const double needed = *throughDoor(0.5).why->needed;
  EXPECT_EQ(throughDoor(needed + 0.01).status, PlanStatus::kSolved) << needed;
  EXPECT_EQ(throughDoor(needed - 0.05).status, PlanStatus::kNoWalk) << needed;
}

// The thing that lies in the door, and not the wall that the door is in.
TEST(Obstruction, OfASillInADoorTheSillIsNamed) {
  Scene scene = furnishedScene();
  scene.objects.push_back(boxObject("sill", {0.1, 0.9, 0.35}, {3, 3.55, 0.175}));
  const FurnishedRoom room(scene);
  PlanRequest request = askedIn(room);
  request.start = {{1.5, 3.55, 0}, 0.0, true};
  request.goal = {{4.5, 3.55, 0}, 0.0, true};
  const PlanOutcome outcome = planWalk(request);
  ASSERT_EQ(outcome.status, PlanStatus::kNoWalk);
  EXPECT_EQ(outcome.why->lack, Obstruction::Lack::kStep) << describe(*outcome.why);
  EXPECT_EQ(outcome.why->object, "sill");
  EXPECT_NEAR(*outcome.why->width, 0.35, 0.001);
  EXPECT_EQ(*outcome.why->needed, 0.25);
}

TEST(Obstruction, WhatHangsTooLowSaysHowHigh) {
  Scene scene = furnishedScene();
  scene.objects.push_back(boxObject("lintel", {0.1, 0.9, 0.97}, {3, 3.55, 2.015}));  // at 1.53 m
  const FurnishedRoom room(scene);
  PlanRequest request = askedIn(room);
  request.start = {{1.5, 3.55, 0}, 0.0, true};
  request.goal = {{4.5, 3.55, 0}, 0.0, true};
  const PlanOutcome outcome = planWalk(request);
  ASSERT_EQ(outcome.status, PlanStatus::kNoWalk);
  EXPECT_EQ(outcome.why->lack, Obstruction::Lack::kHeadroom) << describe(*outcome.why);
  EXPECT_EQ(outcome.why->object, "lintel");
  EXPECT_NEAR(*outcome.why->width, 1.53, 0.001);
  EXPECT_NEAR(*outcome.why->needed, room.synthesizer.stature(), 1e-9);
}

TEST(Obstruction, OfRefusalsThoseAreTakenThatAreMostAlongAWay) {
  const std::vector<Eigen::Vector3d> way = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}};
  std::vector<SteeringFailure> refusals;
  const auto refuse = [&](int times, int object, const Eigen::Vector3d& at) {
    for (int i = 0; i < times; ++i) refusals.push_back(contact(1, object, at));
  };
  refuse(3, 1, {1.2, 0.1, 1});
  refuse(5, 2, {4.2, 2.3, 1});
  refuse(9, 3, {0, 3, 1});  // more, far from the way
  const auto most = whereMostWereRefused(refusals, way);
  ASSERT_EQ(most.size(), 5u);
  for (const SteeringFailure& refusal : most) EXPECT_EQ(refusal.object, 2);
  EXPECT_EQ(whereMostWereRefused(refusals, {}).size(), refusals.size());
}

// From one floor to another by what is between them.
Obstruction acrossFloors(const std::vector<SceneObject>& between, double rise, double length) {
  Scene scene;
  scene.objects = {boxObject("low", {3, 3, 0.1}, {1.5, 1.5, -0.05}),
                   boxObject("high", {3, 3, 0.1}, {4.5 + length, 1.5, rise - 0.05})};
  scene.objects.insert(scene.objects.end(), between.begin(), between.end());
  const FurnishedRoom room(scene);
  Obstruction why;
  measureGround({2, 1.5, 0}, {4 + length, 1.5, rise}, askedIn(room), why);
  return why;
}

TEST(Obstruction, ARampSaysHowSteepItIs) {
  const double slope = 30 * kDegree;
  SceneObject ramp = boxObject("ramp", {2, 2, 0.1}, {0, 0, 0});
  ramp.X_WO.linear() = Eigen::AngleAxisd(-slope, Eigen::Vector3d::UnitY()).toRotationMatrix();
  ramp.X_WO.translation() =
      Eigen::Vector3d(3, 1.5, 0) + ramp.X_WO.linear() * Eigen::Vector3d(1, 0, -0.05);
  const Obstruction why = acrossFloors({ramp}, 2 * std::sin(slope), 2 * std::cos(slope));
  EXPECT_EQ(why.lack, Obstruction::Lack::kSlope) << describe(why);
  EXPECT_EQ(why.object, "ramp");
  ASSERT_TRUE(why.slope && why.max_slope);
  EXPECT_NEAR(*why.slope, slope, 1e-6);
  EXPECT_NEAR(*why.max_slope, 20 * kDegree, 1e-9);
}

std::vector<SceneObject> stairs(int count, double riser, double tread) {
  std::vector<SceneObject> treads;
  for (int i = 1; i <= count; ++i)
    treads.push_back(
        boxObject("tread", {tread, 2, i * riser}, {3 + (i - 0.5) * tread, 1.5, 0.5 * i * riser}));
  return treads;
}

TEST(Obstruction, StairsSayHowHighOrHowShortTheirStepsAre) {
  const Obstruction high = acrossFloors(stairs(4, 0.3, 0.28), 1.5, 4 * 0.28);
  EXPECT_EQ(high.lack, Obstruction::Lack::kStep) << describe(high);
  EXPECT_NEAR(*high.width, 0.3, 1e-6);
  EXPECT_EQ(*high.needed, 0.25);
  const Obstruction brief = acrossFloors(stairs(5, 0.16, 0.1), 0.96, 5 * 0.1);
  EXPECT_EQ(brief.lack, Obstruction::Lack::kTread) << describe(brief);
  EXPECT_NEAR(*brief.width, 0.1, 0.011);
  EXPECT_GT(*brief.needed, 0.12);
  EXPECT_LT(*brief.needed, 0.25);
  EXPECT_EQ(acrossFloors(stairs(5, 0.16, 0.28), 0.96, 5 * 0.28).lack, Obstruction::Lack::kUnknown);
}

TEST(Obstruction, ABlockedEndSaysByWhatAndWhereItWouldDo) {
  const FurnishedRoom& room = furnishedRoom();
  PlanRequest request = askedIn(room);
  request.start = {{0.05, 2, 0}, {}, true};
  const PlanOutcome outcome = planWalk(request);
  ASSERT_EQ(outcome.status, PlanStatus::kStartBlocked);
  ASSERT_TRUE(outcome.why && outcome.why->free && outcome.why->width && outcome.why->needed);
  EXPECT_EQ(outcome.why->object, "west");
  EXPECT_NEAR(*outcome.why->width, 0.05, 0.03);
  EXPECT_GT(*outcome.why->needed, 0.15);
  EXPECT_LT(outcome.why->free->x(), 0.6);
  EXPECT_TRUE(outcome.proved);
  request.start.position = *outcome.why->free;
  EXPECT_NE(planWalk(request).status, PlanStatus::kStartBlocked);  // it does
}

TEST(Obstruction, ARuleOfTheGroundNamesThePlaceAndTheHeight) {
  Scene scene = furnishedScene();
  scene.objects.push_back(boxObject("sill", {0.3, 0.9, 0.4}, {3, 3.55, 0.2}));
  const FurnishedRoom room(scene);
  SteeringFailure refusal{WalkRule::kStepHeight};
  refusal.at = {1.5, 3.55, 0};
  refusal.body = {4.5, 3.55, 0};
  const auto why = whatStoodInTheWay({refusal}, askedIn(room));
  ASSERT_TRUE(why && why->width && why->needed);
  EXPECT_EQ(why->object, "sill");
  EXPECT_NEAR(why->at.x(), 2.85, 0.011);
  EXPECT_NEAR(*why->width, 0.4, 0.01);
  EXPECT_EQ(*why->needed, 0.25);
}

TEST(Obstruction, ALegThatIsTooShortSaysWhereTheStepIsAndHowHigh) {
  Scene scene = furnishedScene();
  scene.objects.push_back(boxObject("plinth", {2.4, 0.9, 0.2}, {4.2, 3.55, 0.1}));
  const FurnishedRoom room(scene);
  SteeringFailure refusal{WalkRule::kReach};
  refusal.at = {1.5, 3.55, 0};
  refusal.body = {4.5, 3.55, 0.2};
  const auto why = whatStoodInTheWay({refusal}, askedIn(room));
  ASSERT_TRUE(why && why->width);
  EXPECT_NEAR(why->at.x(), 3.0, 0.011);
  EXPECT_NEAR(*why->width, 0.2, 1e-6);
  const std::string line = describe(*why);
  EXPECT_TRUE(holds(line, "a step of 0.20 m is out of a leg's reach at (3.0")) << line;
}

TEST(Obstruction, WhatTheSceneRefusesSaysMoreThanEdgesThatHaveNoCurve) {
  const FurnishedRoom& room = furnishedRoom();
  std::vector<SteeringFailure> refusals(9, SteeringFailure{WalkRule::kStepLength});
  refusals.push_back(contact(1, 5, {3, 1, 1}));
  EXPECT_EQ(whatStoodInTheWay(refusals, askedIn(room))->rule, WalkRule::kContact);
  refusals.resize(30, SteeringFailure{WalkRule::kStepLength});  // next to nothing
  refusals.resize(31, SteeringFailure{WalkRule::kTurnRate});
  EXPECT_EQ(whatStoodInTheWay(refusals, askedIn(room))->rule, WalkRule::kStepLength);
}

TEST(Obstruction, WhatNothingTouchedSaysFromWhereToWhereAndHowFar) {
  SteeringFailure refusal{WalkRule::kNoCurve};
  refusal.at = {1.0, 1.0, 0};
  refusal.body = {1.3, 1.4, 0};
  const auto why = whatStoodInTheWay({refusal}, askedIn(furnishedRoom()));
  ASSERT_TRUE(why.has_value());
  const std::string line = describe(*why);
  EXPECT_TRUE(holds(line, "on the way to (1.30, 1.40, 0.00), 0.50 m")) << line;
}

TEST(Obstruction, InsideOfWhatIsWalkedOnIsNoPassage) {
  // Walks that lead into a bed with ground on it: its own sides are no two things to walk between.
  Scene scene;
  scene.objects = {boxObject("floor", {12, 8, 0.1}, {6, 4, -0.05}),
                   boxObject("bed", {2.5, 2.5, 0.5}, {6, 4, 0.25})};
  const FurnishedRoom room(scene);
  std::vector<SteeringFailure> refusals;
  for (const double heading : {20.0, 35.0, 50.0, 65.0}) {
    SteeringFailure refusal = contact(2, 1, {4.9, 3.1, 0.36});
    refusal.body.x() = 4.7;
    refusal.body.y() = 3.0;
    refusal.heading = heading * kDegree;
    refusals.push_back(refusal);
  }
  const auto why = whatStoodInTheWay(refusals, askedIn(room));
  ASSERT_TRUE(why.has_value());
  EXPECT_EQ(why->object, "bed");
  EXPECT_EQ(why->other, "") << describe(*why);
  EXPECT_EQ(why->lack, Obstruction::Lack::kStep) << "it is as high as it is";
}

TEST(Obstruction, WhereTheGroundEndsItsGapIsMeasured) {
  Scene scene;
  scene.objects = {boxObject("west", {3, 6, 0.1}, {1.5, 3, -0.05}),
                   boxObject("east", {3, 6, 0.1}, {6.5, 3, -0.05})};
  const FurnishedRoom room(scene);
  SteeringFailure refusal{WalkRule::kNoGround};
  refusal.at = {2, 3, 0};
  refusal.body = {6, 3, 0};
  const auto why = whatStoodInTheWay({refusal}, askedIn(room));
  ASSERT_TRUE(why && why->width && why->needed);
  EXPECT_NEAR(why->at.x(), 3.0, 0.02);
  EXPECT_NEAR(*why->width, 2.0, 0.001);
  EXPECT_LT(*why->needed, 1.5);
}

TEST(Obstruction, OfAsManyTheRuleOfTheOrderCounts) {
  const FurnishedRoom& room = furnishedRoom();
  const std::vector<SteeringFailure> one = {contact(1, 5, {3, 1, 1}), {WalkRule::kTurnRate}},
                                     other = {{WalkRule::kTurnRate}, contact(1, 5, {3, 1, 1})};
  const auto a = mostOften(one, room.scene, room.body), b = mostOften(other, room.scene, room.body);
  ASSERT_TRUE(a && b);
  EXPECT_EQ(a->rule, b->rule);  // whatever order threads find them in
  EXPECT_EQ(a->count, 1);
}

// Of a floor that is open at its edges a wall from edge to edge: it is told, and not the table on
// the way to it that refuses more.
TEST(Obstruction, AWallThatCutsTheGroundInTwoIsToldAndNotWhatStandsBeforeIt) {
  const auto cut = [](double length) {
    Scene scene;
    scene.objects = {boxObject("floor", {6, 4, 0.1}, {3, 2, -0.05}),
                     boxObject("table", {0.8, 1.6, 0.75}, {3, 2, 0.375}),
                     boxObject("wall", {0.1, length, 2.5}, {4.5, 0.5 * length, 1.25})};
    return FurnishedRoom(scene);
  };
  const FurnishedRoom room = cut(4.0);
  for (const char* planner : {"visibility", "prm", "cylinder", "rrt"}) {
    PlanRequest request = askedIn(room);
    request.planner = planner;
    request.start = {{1, 1, 0}, 0.0, true};
    request.goal = {{5.2, 2, 0}, 0.0, true};
    const PlanOutcome outcome = planWalk(request);
    ASSERT_EQ(outcome.status, PlanStatus::kNoWalk) << planner;
    ASSERT_TRUE(outcome.why.has_value()) << planner;
    EXPECT_EQ(outcome.why->rule, WalkRule::kDisconnected) << planner;
    EXPECT_EQ(outcome.why->object, "wall") << planner;
    EXPECT_NEAR(outcome.why->at.x(), 4.5, 0.1) << planner;
    EXPECT_TRUE(holds(describe(*outcome.why), "wall shuts the way off at (4.")) << planner;
    const bool proves = request.planner == "visibility" || request.planner == "prm";
    EXPECT_EQ(outcome.proved, proves) << planner;
  }
  const FurnishedRoom door = cut(2.8);
  PlanRequest request = askedIn(door);
  request.start = {{1, 1, 0}, 0.0, true};
  request.goal = {{5.2, 2, 0}, 0.0, true};
  EXPECT_EQ(planWalk(request).status, PlanStatus::kSolved);
}

TEST(Obstruction, LongestStepIsLongerThanAUsualOneAndShorterThanALeap) {
  const double step = longestStep(furnishedRoom().synthesizer);
  EXPECT_GT(step, furnishedRoom().synthesizer.stepLength());
  EXPECT_LT(step, 1.5);
}

// The place that is offered for an end that is blocked is the nearest that would do, and it does.
TEST(Obstruction, FreePlacesThatAreOfferedAreFreeAndNear) {
  const FurnishedRoom& room = furnishedRoom();
  const WalkSteering steering(room.synthesizer, room.world, room.ground);
  const SteeringScratchPtr scratch = steering.makeScratch();
  for (const Eigen::Vector3d& at : {Eigen::Vector3d(4.5, 1.2, 0), Eigen::Vector3d(3.0, 1.0, 0),
                                    Eigen::Vector3d(5.95, 3.9, 0)}) {
    Waypoint end;
    end.stance.position = at;
    end.any_heading = true;
    Stance blocked = end.stance;
    const auto failure = steering.stand(blocked, *scratch);
    ASSERT_TRUE(failure.has_value());
    const Obstruction why = whatBlocks(*failure, end, askedIn(room), steering);
    ASSERT_TRUE(why.free.has_value()) << at.transpose();
    EXPECT_LT((*why.free - at).norm(), 1.2);
    bool stands = false;
    for (int i = 0; i < 16; ++i) {
      Stance stance = end.stance;
      stance.position = *why.free;
      stance.heading = kPi * i / 8;
      stands = stands || !steering.stand(stance, *scratch);
    }
    EXPECT_TRUE(stands) << at.transpose();
  }
}

}  // namespace
}  // namespace amble

#include "planner/obstruction.h"

#include <gtest/gtest.h>

#include "base/rotation.h"
#include "planner/plan_walk.h"
#include "planner/steering/walk_steering.h"
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

TEST(Obstruction, LineSaysRulePartObjectPlaceAndHowMuch) {
  Obstruction why;
  why.rule = WalkRule::kContact;
  why.part = "left hand";
  why.object = "wall";
  why.other = "cupboard";
  why.at = {1, 2, 0.8};
  why.width = 0.5;
  why.needed = 0.62;
  const std::string line = describe(why);
  for (const char* part : {"contact", "left hand", "wall", "cupboard", "(1.00, 2.00, 0.80)",
                           "0.50 m", "0.62 m needed"}) {
    EXPECT_TRUE(holds(line, part) || holds(line, "needed 0.62 m")) << line;
  }
  EXPECT_EQ(line.find('\n'), std::string::npos);
}

PlanRequest requestIn(const FurnishedRoom& room) {
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

TEST(Obstruction, ATooNarrowPassageIsMeasuredBetweenItsSides) {
  Scene scene = furnishedScene();
  scene.objects.push_back(boxObject("post", {0.1, 0.4, 2.5}, {3, 3.8, 1.25}));
  const FurnishedRoom room(scene);  // 0.5 m are left between wall and post
  PlanRequest request = requestIn(room);
  request.start = {{1.5, 3.35, 0}, 0.0, true};
  request.goal = {{4.5, 3.35, 0}, 0.0, true};  // straight through
  const PlanOutcome outcome = planWalk(request);
  ASSERT_EQ(outcome.status, PlanStatus::kNoWalk);
  ASSERT_TRUE(outcome.why.has_value());
  ASSERT_TRUE(outcome.why->width.has_value()) << describe(*outcome.why);
  EXPECT_NEAR(*outcome.why->width, 0.5, 0.05);
  EXPECT_GT(*outcome.why->needed, 0.5);
  const std::string line = describe(*outcome.why);
  EXPECT_TRUE(holds(line, "wall") && holds(line, "post")) << line;
  EXPECT_FALSE(outcome.proved);  // a search proves nothing
}

TEST(Obstruction, ABlockedEndSaysByWhatAndWhereItWouldDo) {
  const FurnishedRoom& room = furnishedRoom();
  PlanRequest request = requestIn(room);
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
  const auto why = whatStoodInTheWay({refusal}, requestIn(room));
  ASSERT_TRUE(why && why->width && why->needed);
  EXPECT_EQ(why->object, "sill");
  EXPECT_NEAR(why->at.x(), 2.85, 0.06);
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
  const auto why = whatStoodInTheWay({refusal}, requestIn(room));
  ASSERT_TRUE(why && why->width);
  EXPECT_NEAR(why->at.x(), 3.0, 0.03);
  EXPECT_NEAR(*why->width, 0.2, 1e-6);
  const std::string line = describe(*why);
  EXPECT_TRUE(holds(line, "reach (a leg is too short) at (3.0") && holds(line, "0.20 m high"))
      << line;
}

TEST(Obstruction, WhatTheSceneRefusesSaysMoreThanEdgesThatHaveNoCurve) {
  const FurnishedRoom& room = furnishedRoom();
  std::vector<SteeringFailure> refusals(9, SteeringFailure{WalkRule::kStepLength});
  refusals.push_back(contact(1, 5, {3, 1, 1}));
  EXPECT_EQ(whatStoodInTheWay(refusals, requestIn(room))->rule, WalkRule::kContact);
  refusals.resize(30, SteeringFailure{WalkRule::kStepLength});  // next to nothing
  refusals.resize(31, SteeringFailure{WalkRule::kTurnRate});
  EXPECT_EQ(whatStoodInTheWay(refusals, requestIn(room))->rule, WalkRule::kStepLength);
}

TEST(Obstruction, WhatNothingTouchedSaysFromWhereToWhereAndHowFar) {
  SteeringFailure refusal{WalkRule::kNoCurve};
  refusal.at = {1.0, 1.0, 0};
  refusal.body = {1.3, 1.4, 0};
  const auto why = whatStoodInTheWay({refusal}, requestIn(furnishedRoom()));
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
  const auto why = whatStoodInTheWay(refusals, requestIn(room));
  ASSERT_TRUE(why.has_value());
  EXPECT_EQ(why->object, "bed");
  EXPECT_EQ(why->other, "") << describe(*why);
  EXPECT_FALSE(why->width.has_value());
}

TEST(Obstruction, WhereTheGroundEndsItsGapIsMeasured) {
  Scene scene;
  scene.objects = {boxObject("west", {3, 6, 0.1}, {1.5, 3, -0.05}),
                   boxObject("east", {3, 6, 0.1}, {6.5, 3, -0.05})};
  const FurnishedRoom room(scene);
  SteeringFailure refusal{WalkRule::kNoGround};
  refusal.at = {2, 3, 0};
  refusal.body = {6, 3, 0};
  const auto why = whatStoodInTheWay({refusal}, requestIn(room));
  ASSERT_TRUE(why && why->width && why->needed);
  EXPECT_NEAR(why->at.x(), 3.0, 0.05);
  EXPECT_NEAR(*why->width, 2.0, 0.05);
  EXPECT_LT(*why->needed, 1.5);
}

TEST(Obstruction, EveryRulesLineBeginsWithItsNameAndSaysWhere) {
  for (int i = 1; i < kWalkRules; ++i) {
    Obstruction why;
    why.rule = static_cast<WalkRule>(i);
    why.count = 3;
    why.at = {1.25, -2.5, 0};
    why.body = {1.25, -2.5, 0};
    const std::string line = describe(why);
    EXPECT_TRUE(holds(line, std::string(walkRuleName(why.rule)))) << line;
    EXPECT_TRUE(holds(line, "(1.25, -2.50, 0.00)")) << line;
    EXPECT_EQ(line.find('\n'), std::string::npos);
  }
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
    const Obstruction why = whatBlocks(*failure, end, requestIn(room), steering);
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

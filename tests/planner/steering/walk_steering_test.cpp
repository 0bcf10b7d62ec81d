#include "planner/steering/walk_steering.h"

#include <gtest/gtest.h>

#include "base/rotation.h"
#include "base/sample_stream.h"
#include "tests/planner/furnished_room.h"

namespace amble {
namespace {

class WalkSteeringTest : public testing::Test {
 protected:
  Waypoint standing(double x, double y, double heading_deg = 0.0) const {
    Waypoint at;
    at.stance.position = {x, y, 0.0};
    at.stance.heading = heading_deg * kDegree;
    return at;
  }
  Waypoint walking(double x, double y, double heading_deg) const {
    Waypoint at = standing(x, y, heading_deg);
    at.stance.standing = false;
    return at;
  }
  Waypoint anywhere(SampleStream& stream) const {
    return standing(stream.uniform(0.2, 5.8), stream.uniform(0.2, 3.8), stream.uniform(-180, 180));
  }

  const FurnishedRoom& room = furnishedRoom();
  const WalkSteering steering{room.synthesizer, room.world, room.ground};
  const SteeringScratchPtr scratch = steering.makeScratch();
};

TEST_F(WalkSteeringTest, RefusalNamesStageRuleAndObject) {
  const SteerResult through = steering.steer(standing(1.5, 1.5), standing(4.5, 2.5), *scratch);
  ASSERT_FALSE(through.edge.has_value());
  EXPECT_EQ(stageOf(through.failure.rule), SteeringStage::kValidation);
  EXPECT_EQ(through.failure.rule, WalkRule::kContact);
  EXPECT_EQ(room.scene.objects[through.failure.object].name, "wall");

  const SteerResult tight = steering.steer(walking(1, 1, 0), walking(1, 2, 180), *scratch);
  ASSERT_FALSE(tight.edge.has_value());
  EXPECT_NE(stageOf(tight.failure.rule), SteeringStage::kValidation);

  Stance outside = standing(9, 9).stance;
  EXPECT_EQ(steering.stand(outside, *scratch)->rule, WalkRule::kNoGround);
  Stance in_table = standing(4.5, 1.2).stance;
  const auto blocked = steering.stand(in_table, *scratch);
  ASSERT_TRUE(blocked.has_value());
  EXPECT_EQ(room.scene.objects[blocked->object].name, "table");
}

TEST_F(WalkSteeringTest, AnimatingAnEdgeAgainGivesWhatWasChecked) {
  SampleStream stream(1, 0);
  int edges = 0;
  for (int i = 0; i < 30; ++i) {
    const SteerResult result = steering.steer(anywhere(stream), anywhere(stream), *scratch);
    if (!result.edge) continue;
    ++edges;
    AnimationBuffer once, again;
    steering.animate(*result.edge, once);
    steering.animate(*result.edge, again);
    EXPECT_FALSE(steering.contact(once, *scratch).has_value());
    EXPECT_NEAR(result.edge->duration, (once.size() - 1) * once.frame_time, 1e-9);
    ASSERT_EQ(once.size(), again.size());
    for (int frame = 0; frame < once.size(); ++frame) {
      ASSERT_EQ(once.poses.p_WR(frame), again.poses.p_WR(frame));
      for (int joint = 0; joint < once.poses.joints(); ++joint) {
        ASSERT_EQ(once.poses.rotations(frame)[joint].coeffs(),
                  again.poses.rotations(frame)[joint].coeffs());
      }
    }
  }
  EXPECT_GT(edges, 3);
}

TEST_F(WalkSteeringTest, EdgesBeginAndEndInTheirStances) {
  SampleStream stream(2, 0);
  for (int i = 0; i < 20; ++i) {
    const Waypoint from = anywhere(stream), to = anywhere(stream);
    const SteerResult result = steering.steer(from, to, *scratch);
    if (!result.edge) continue;
    AnimationBuffer walk, first, last;
    steering.animate(*result.edge, walk);
    room.synthesizer.stand(from.stance, first);
    room.synthesizer.stand(to.stance, last);
    EXPECT_LT((walk.poses.p_WR(0) - first.poses.p_WR(0)).norm(), 1e-9);
    EXPECT_LT((walk.poses.p_WR(walk.size() - 1) - last.poses.p_WR(0)).norm(), 1e-9);
    const auto end = walk.poses.rotations(walk.size() - 1)[0];
    EXPECT_LT(end.angularDistance(last.poses.rotations(0)[0]), 1e-6);
  }
}

TEST_F(WalkSteeringTest, WhatTheCoreRefusesTheBodyRefuses) {
  const BodyCore core(straightWalk(room.synthesizer, room.ground, 3.0), room.synthesizer.skeleton(),
                      room.synthesizer.roles(), room.body, room.synthesizer.stature());
  const CollisionScratchPtr collision = room.world.makeScratch();
  SampleStream stream(3, 0);
  int refused = 0;
  AnimationBuffer buffer;
  for (int i = 0; i < 150; ++i) {
    const Waypoint a = anywhere(stream), b = anywhere(stream);
    Stance from = a.stance, to = b.stance;
    const Eigen::Vector3d way = to.position - from.position;
    from.heading = std::atan2(way.y(), way.x()) + stream.uniform(-0.6, 0.6);
    to.heading = std::atan2(way.y(), way.x()) + stream.uniform(-0.6, 0.6);
    const RootPath path({makeBezier(from.position.head<2>(), from.heading, to.position.head<2>(),
                                    to.heading, 0.4)});
    if (!core.touch({path, 0.0, true, true, room.ground}, room.world, *collision)) continue;
    if (room.synthesizer.walk(from, to, path, true, buffer).refused != WalkRule::kNone) continue;
    ++refused;
    EXPECT_TRUE(room.world.check(buffer.poses, buffer.soles, true, *collision).has_value());
  }
  EXPECT_GT(refused, 30);
}

TEST_F(WalkSteeringTest, TurningOnTheSpotIsAnEdge) {
  const SteerResult result = steering.steer(standing(1.5, 2, 0), standing(1.5, 2, 170), *scratch);
  ASSERT_TRUE(result.edge.has_value());
  EXPECT_TRUE(result.edge->path.empty());
  EXPECT_NEAR(result.edge->turn_first, 170 * kDegree, 1e-12);
  EXPECT_GT(result.edge->duration, 0.0);
}

TEST_F(WalkSteeringTest, FreeHeadingsNeedNoTurn) {
  Waypoint from = standing(1.0, 1.0, 180), to = standing(1.0, 3.0, -90);
  from.any_heading = to.any_heading = true;
  const SteerResult result = steering.steer(from, to, *scratch);
  ASSERT_TRUE(result.edge.has_value());
  EXPECT_EQ(result.edge->turn_first, 0.0);
  EXPECT_EQ(result.edge->turn_last, 0.0);
  EXPECT_NEAR(result.edge->from.heading, 90 * kDegree, 1e-12);
}

TEST_F(WalkSteeringTest, SameHeadingAtTheSamePlaceIsAnEdgeThatStays) {
  const SteerResult result = steering.steer(standing(1.5, 2, 30), standing(1.5, 2, 30), *scratch);
  ASSERT_TRUE(result.edge.has_value());
  EXPECT_EQ(result.edge->duration, 0.0);
  AnimationBuffer buffer;
  steering.animate(*result.edge, buffer);
  EXPECT_EQ(buffer.size(), 1);
}

TEST_F(WalkSteeringTest, PlacesNearerThanAWalkAreJoinedBySmallStepsInAnyDirection) {
  for (const double direction : {0.0, 90.0, 180.0, -120.0}) {
    const Waypoint from = standing(1.5, 2, 30);
    const Waypoint to = standing(1.5 + 0.15 * std::cos(direction * kDegree),
                                 2 + 0.15 * std::sin(direction * kDegree), 75);
    const SteerResult result = steering.smallSteps(from, to, *scratch);
    ASSERT_TRUE(result.edge.has_value());
    EXPECT_NEAR(result.edge->length, 0.15, 1e-12);
    AnimationBuffer walk, last;
    steering.animate(*result.edge, walk);
    EXPECT_NEAR(result.edge->duration, (walk.size() - 1) * walk.frame_time, 1e-9);
    EXPECT_FALSE(steering.contact(walk, *scratch).has_value());
    room.synthesizer.stand(to.stance, last);
    EXPECT_LT((walk.poses.p_WR(walk.size() - 1) - last.poses.p_WR(0)).norm(), 1e-9);
  }
}

TEST_F(WalkSteeringTest, SmallStepsLeadNoFartherThanTheyMay) {
  EXPECT_FALSE(steering.smallSteps(standing(1.5, 2), standing(1.8, 2), *scratch).edge.has_value());
  EXPECT_FALSE(
      steering.smallSteps(standing(1.5, 2), walking(1.6, 2, 0), *scratch).edge.has_value());
}

TEST_F(WalkSteeringTest, PartsOfAnEdgeAddUpToItsDuration) {
  // Turning before and after: three parts, whose joints are frames of both.
  const SteerResult result = steering.steer(standing(1, 1, 180), standing(1, 3.2, -90), *scratch);
  ASSERT_TRUE(result.edge.has_value());
  ASSERT_NE(result.edge->turn_first, 0.0);
  ASSERT_NE(result.edge->turn_last, 0.0);
  AnimationBuffer walk, first, last;
  steering.animate(*result.edge, walk);
  room.synthesizer.turnOnSpot(result.edge->from, result.edge->turn_first, first);
  for (int i = 0; i < first.size(); ++i) EXPECT_EQ(walk.poses.p_WR(i), first.poses.p_WR(i));
  Stance arrived = result.edge->to;
  arrived.heading -= result.edge->turn_last;
  room.synthesizer.turnOnSpot(arrived, result.edge->turn_last, last);
  for (int i = 1; i <= last.size(); ++i)
    EXPECT_EQ(walk.poses.p_WR(walk.size() - i), last.poses.p_WR(last.size() - i));
}

TEST_F(WalkSteeringTest, ContactsSayWhereThePartIs) {
  Stance in_table = standing(4.5, 1.2).stance;
  const auto blocked = steering.stand(in_table, *scratch);
  ASSERT_TRUE(blocked.has_value());
  EXPECT_LT((blocked->at.head<2>() - Eigen::Vector2d(4.5, 1.2)).norm(), 0.6);
  EXPECT_GT(blocked->at.z(), 0.0);
  EXPECT_LT(blocked->at.z(), 1.8);
}

TEST(SteeringRules, EachBelongsToAStageAndHasANameOfItsOwn) {
  std::vector<std::string_view> names;
  int stage = 0;
  for (int i = 0; i < kWalkRules; ++i) {
    const WalkRule rule = static_cast<WalkRule>(i);
    EXPECT_GE(static_cast<int>(stageOf(rule)), stage);  // in the order of the stages
    stage = static_cast<int>(stageOf(rule));
    EXPECT_EQ(std::count(names.begin(), names.end(), walkRuleName(rule)), 0);
    names.push_back(walkRuleName(rule));
  }
  EXPECT_EQ(stageOf(WalkRule::kContact), SteeringStage::kValidation);
}

}  // namespace
}  // namespace amble

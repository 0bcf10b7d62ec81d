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

}  // namespace
}  // namespace amble

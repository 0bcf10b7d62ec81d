#include "planner/roadmap/replay_edge.h"

#include <gtest/gtest.h>

#include "base/rotation.h"
#include "base/sample_stream.h"
#include "tests/planner/furnished_room.h"

namespace amble {
namespace {

class ReplayEdgeTest : public testing::Test {
 protected:
  Waypoint standing(double x, double y, double heading_deg = 0.0) const {
    Waypoint at;
    at.stance.position = {x, y, 0.0};
    at.stance.heading = heading_deg * kDegree;
    return at;
  }
  Waypoint anywhere(SampleStream& stream) const {
    return standing(stream.uniform(0.4, 5.6), stream.uniform(0.4, 3.6), stream.uniform(-180, 180));
  }
  // Of the frames up to one, between them too.
  bool touches(const AnimationBuffer& buffer, int last) const {
    PoseArray poses(buffer.poses.joints());
    poses.append(buffer.poses, 0, last + 1);
    const std::vector<SolePhases> soles(buffer.soles.begin(), buffer.soles.begin() + last + 1);
    return room.world.check(poses, soles, true, *room.world.makeScratch()).has_value();
  }

  const FurnishedRoom& room = furnishedRoom();
  const WalkSteering steering{room.synthesizer, room.world, room.ground};
  const SteeringScratchPtr scratch = steering.makeScratch();
};

TEST_F(ReplayEdgeTest, OfAWalkGivesTheFramesThatWereChecked) {
  SampleStream stream(11, 0);
  int walks = 0;
  for (int i = 0; i < 20; ++i) {
    const Waypoint from = anywhere(stream), to = anywhere(stream);
    const SteerResult result = steering.steer(from, to, *scratch);
    const EdgeReplay replay = replayEdge(steering, from, to);
    ASSERT_EQ(replay.stop.has_value(), !result.edge.has_value());
    if (!result.edge) continue;
    ++walks;
    AnimationBuffer checked;
    steering.animate(*result.edge, checked);
    ASSERT_EQ(replay.buffer.size(), checked.size());
    for (int frame = 0; frame < checked.size(); ++frame)
      ASSERT_EQ(replay.buffer.poses.p_WR(frame), checked.poses.p_WR(frame));
  }
  EXPECT_GT(walks, 3);
}

TEST_F(ReplayEdgeTest, OfARefusedOneStopsAtItsFirstContact) {
  SampleStream stream(12, 0);
  int stopped = 0;
  for (int i = 0; i < 40; ++i) {
    const Waypoint from = anywhere(stream), to = anywhere(stream);
    const EdgeReplay replay = replayEdge(steering, from, to);
    if (!replay.stop || replay.stop->rule != WalkRule::kContact) continue;
    ++stopped;
    const EdgeReplay::Stop& stop = *replay.stop;
    ASSERT_GE(stop.object, 0);
    ASSERT_GE(stop.part, 0);
    ASSERT_LT(stop.frame, replay.buffer.size());
    EXPECT_FALSE(stop.frame > 0 && touches(replay.buffer, stop.frame - 1));
    EXPECT_TRUE(touches(replay.buffer, std::min(stop.frame + 1, replay.buffer.size() - 1)));
    // The part that touches is about as near to where the body is as its limbs are long.
    const Eigen::Vector3d body = replay.buffer.states[stop.frame].position;
    EXPECT_LT((stop.at - body).head<2>().norm(), 1.0);
  }
  EXPECT_GT(stopped, 5);
}

TEST_F(ReplayEdgeTest, WhatHasNoRootPathStandsAtItsBegin) {
  Waypoint from = standing(2, 1), to = standing(1, 1);  // backwards
  from.stance.standing = to.stance.standing = false;
  const SteerResult result = steering.steer(from, to, *scratch);
  ASSERT_FALSE(result.edge.has_value());
  ASSERT_EQ(result.failure.rule, WalkRule::kNoCurve);
  const EdgeReplay replay = replayEdge(steering, from, to);
  ASSERT_TRUE(replay.stop.has_value());
  EXPECT_EQ(replay.stop->rule, WalkRule::kNoCurve);
  EXPECT_EQ(replay.stop->object, -1);
  ASSERT_EQ(replay.buffer.size(), 1);
  EXPECT_LT((replay.buffer.states[0].position - from.stance.position).norm(), 1e-12);
}

// What a picture says of a node is all that steering needs.
TEST_F(ReplayEdgeTest, APicturesEndIsTheWaypointThatWasAsked) {
  RoadmapPicture::Node node;
  node.stance = standing(2, 1, 40).stance;
  node.any_heading = true;
  node.any_leading = false;
  const Waypoint at = waypointOf(node);
  EXPECT_EQ(at.stance.position, node.stance.position);
  EXPECT_EQ(at.stance.heading, node.stance.heading);
  EXPECT_TRUE(at.any_heading);
  EXPECT_FALSE(at.any_leading);
}

}  // namespace
}  // namespace amble

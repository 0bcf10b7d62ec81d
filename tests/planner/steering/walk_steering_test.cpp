#include "planner/steering/walk_steering.h"

#include <gtest/gtest.h>

#include "base/rotation.h"
#include "base/sample_stream.h"
#include "planner/steering/walk_effort.h"
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

// Facing one another's way, so that there is one proposal.
TEST_F(WalkSteeringTest, WithinAPriceTheEdgeIsTheSameOrCostsMore) {
  SampleStream stream(11, 0);
  int dear = 0, same = 0, refused = 0;
  for (int i = 0; i < 120; ++i) {
    Waypoint from = anywhere(stream), to = anywhere(stream);
    const Eigen::Vector3d way = to.stance.position - from.stance.position;
    from.stance.heading = to.stance.heading = std::atan2(way.y(), way.x());
    const SteerResult exact = steering.steer(from, to, *scratch);
    const double usual = way.norm() / room.synthesizer.settings().speed;
    for (const double most : {HUGE_VAL, 2.0 * usual + 2.0, usual, 0.5 * usual}) {
      const SteerResult within = steering.steerWithin(from, to, most, *scratch);
      if (within.too_dear) {
        ++dear;
        EXPECT_EQ(within.poses, 0);
        EXPECT_FALSE(within.edge.has_value());
        EXPECT_TRUE(!exact.edge || exact.edge->duration + exact.edge->effort > most);
        continue;
      }
      ASSERT_EQ(within.edge.has_value(), exact.edge.has_value());
      if (exact.edge) {
        ++same;
        EXPECT_EQ(within.edge->cost(), exact.edge->cost());
        EXPECT_EQ(within.edge->steps, exact.edge->steps);
        EXPECT_LE(exact.edge->duration + exact.edge->effort, most);
      } else {
        ++refused;
        EXPECT_EQ(within.failure.rule, exact.failure.rule);
      }
    }
  }
  EXPECT_GT(dear, 20);
  EXPECT_GT(same, 20);
  EXPECT_GT(refused, 20);
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
  const BodyCore core(straightWalk(room.synthesizer, 3.0), room.synthesizer.skeleton(),
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

TEST_F(WalkSteeringTest, WhatLooksFreeIsFree) {
  SampleStream stream(9, 0);
  int free = 0;
  for (int i = 0; i < 400; ++i) {
    Waypoint from = anywhere(stream), to = anywhere(stream);
    if (steering.stand(from.stance, *scratch) || steering.stand(to.stance, *scratch) ||
        !steering.looksFree(from, to, *scratch))
      continue;
    ++free;
    EXPECT_TRUE(steering.steer(from, to, *scratch).edge.has_value());
  }
  EXPECT_GT(free, 30);
  EXPECT_FALSE(steering.looksFree(standing(1.5, 1.5), standing(4.5, 2.5), *scratch));
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

/// Whether a walk is free, by points of its capsules' axes at five moments a frame: apart from
/// FCL, trees, fields and bounds. Boxes that stand upright only, soles over the floor left out.
bool isFreeByPoints(const FurnishedRoom& room, const AnimationBuffer& walk, double slack) {
  constexpr int kMoments = 5, kPoints = 7;
  std::vector<JointFrame> joints(room.synthesizer.skeleton().size());
  Pose pose;
  pose.rotations.resize(joints.size());
  for (int i = 0; i < kMoments * (walk.size() - 1) + 1; ++i) {
    const int frame = i / kMoments, next = std::min(frame + 1, walk.size() - 1);
    interpolatePose(walk.poses[frame], walk.poses[next], i % kMoments / double{kMoments}, pose);
    forwardKinematics(room.synthesizer.skeleton(), pose, joints);
    for (const BodyPart& part : room.body.parts) {
      for (int k = 0; k < kPoints; ++k) {
        const Eigen::Vector3d p =
            joints[part.joint] * (part.from + (part.to - part.from) * k / (kPoints - 1.0));
        for (size_t object = 0; object < room.scene.objects.size(); ++object) {
          const Eigen::Vector3d half = std::get<Box>(room.scene.objects[object].shape).size / 2;
          const Eigen::Vector3d at = room.scene.objects[object].X_WO.translation();
          if (part.sole >= 0 && object == 0) continue;  // the floor
          if (Eigen::AlignedBox3d(at - half, at + half).exteriorDistance(p) < part.radius - slack)
            return false;
        }
      }
    }
  }
  return true;
}

TEST_F(WalkSteeringTest, AnEdgeThatIsValidIsFreeByAnotherReckoning) {
  SampleStream stream(21, 0);
  int edges = 0;
  for (int i = 0; i < 60 && edges < 12; ++i) {
    const SteerResult result = steering.steer(anywhere(stream), anywhere(stream), *scratch);
    if (!result.edge) continue;
    ++edges;
    AnimationBuffer walk;
    steering.animate(*result.edge, walk);
    EXPECT_TRUE(isFreeByPoints(room, walk, 1e-6)) << i;
  }
  EXPECT_EQ(edges, 12);
}

TEST_F(WalkSteeringTest, StandingIsRefusedWhereABoxIsInTheBodyAndNowhereElse) {
  SampleStream stream(22, 0);
  int blocked = 0;
  for (int i = 0; i < 300; ++i) {
    Stance stance = anywhere(stream).stance;
    AnimationBuffer pose;
    room.synthesizer.stand(stance, pose);
    const auto failure = steering.stand(stance, *scratch);
    if (failure && failure->rule != WalkRule::kContact) continue;  // no room for a foot
    blocked += failure.has_value();
    if (failure) {
      EXPECT_FALSE(isFreeByPoints(room, pose, -0.02)) << i;  // a point within 2 cm of its skin
    } else {
      EXPECT_TRUE(isFreeByPoints(room, pose, 1e-6)) << i;
    }
  }
  EXPECT_GT(blocked, 30);
  EXPECT_LT(blocked, 250);
}

TEST_F(WalkSteeringTest, TheContactThatIsNamedIsThere) {
  SampleStream stream(23, 0);
  int named = 0;
  for (int i = 0; i < 60; ++i) {
    const SteerResult result = steering.steer(anywhere(stream), anywhere(stream), *scratch);
    if (result.edge || result.failure.rule != WalkRule::kContact) continue;
    ++named;
    const SteeringFailure& failure = result.failure;
    ASSERT_TRUE(failure.part >= 0 && failure.object >= 0);
    const BodyPart& part = room.body.parts[failure.part];
    const SceneObject& object = room.scene.objects[failure.object];
    const Eigen::Vector3d half = std::get<Box>(object.shape).size / 2;
    const Eigen::AlignedBox3d box(object.X_WO.translation() - half,
                                  object.X_WO.translation() + half);
    // The middle of a part is its half length and its radius from what it touches, and may move so
    // far from frame to frame.
    EXPECT_LT(box.exteriorDistance(failure.at),
              part.radius + 0.5 * (part.to - part.from).norm() + 0.05)
        << part.name << " and " << object.name;
    EXPECT_TRUE(room.bounds.contains(failure.body.head<2>()));
  }
  EXPECT_GT(named, 15);
}

TEST_F(WalkSteeringTest, EdgesAreWholeFramesOfWholeStepsAlongTheirPaths) {
  SampleStream stream(24, 0);
  int edges = 0;
  for (int i = 0; i < 80; ++i) {
    const Waypoint from = anywhere(stream), to = anywhere(stream);
    const SteerResult result = steering.steer(from, to, *scratch);
    if (!result.edge) continue;
    ++edges;
    const WalkEdge& edge = *result.edge;
    const double frames = edge.duration / room.synthesizer.settings().frame_time;
    EXPECT_NEAR(frames, std::round(frames), 1e-6);
    EXPECT_EQ(edge.from.position, from.stance.position);
    EXPECT_EQ(edge.to.position, to.stance.position);
    EXPECT_EQ(edge.from.heading, from.stance.heading);
    EXPECT_EQ(edge.to.heading, to.stance.heading);
    if (edge.path.empty()) continue;
    EXPECT_GT(edge.steps, 0);
    EXPECT_EQ(edge.length, edge.path.length());
    const RootPath::Sample first = edge.path.at(0.0), last = edge.path.at(edge.length);
    EXPECT_LT((first.position - from.stance.position.head<2>()).norm(), 1e-9);
    EXPECT_LT((last.position - to.stance.position.head<2>()).norm(), 1e-9);
    EXPECT_NEAR(wrapAngle(first.heading - from.stance.heading - edge.turn_first), 0.0, 1e-6);
    EXPECT_NEAR(wrapAngle(to.stance.heading - edge.turn_last - last.heading), 0.0, 1e-6);
    EXPECT_LE(edge.length / edge.duration, steering.topSpeed());
    EXPECT_GE(edge.cost(), edge.duration);
  }
  EXPECT_GT(edges, 8);
}

TEST_F(WalkSteeringTest, AnswersDependOnNothingThatWasAskedBefore) {
  SampleStream stream(25, 0);
  std::vector<std::pair<Waypoint, Waypoint>> questions;
  for (int i = 0; i < 25; ++i) questions.emplace_back(anywhere(stream), anywhere(stream));
  std::vector<SteerResult> there;
  for (const auto& [from, to] : questions) there.push_back(steering.steer(from, to, *scratch));
  const SteeringScratchPtr fresh = steering.makeScratch();
  for (size_t i = questions.size(); i-- > 0;) {  // in the other order
    const SteerResult again = steering.steer(questions[i].first, questions[i].second, *fresh);
    ASSERT_EQ(again.edge.has_value(), there[i].edge.has_value());
    EXPECT_EQ(again.poses, there[i].poses);
    EXPECT_EQ(again.failure.rule, there[i].failure.rule);
    EXPECT_EQ(again.failure.object, there[i].failure.object);
    EXPECT_EQ(again.failure.at, there[i].failure.at);
    if (!again.edge) continue;
    EXPECT_EQ(again.edge->duration, there[i].edge->duration);
    EXPECT_EQ(again.edge->length, there[i].edge->length);
  }
}

// Through a stance that walks: what one edge ends with the next begins with, to the bit.
TEST_F(WalkSteeringTest, EdgesJoinAtAWalkingStanceWithoutAJump) {
  for (const double heading : {90.0, 80.0, 100.0}) {
    const Waypoint from = standing(1.5, 0.5, 90), through = walking(1.5, 2.0, heading),
                   to = standing(1.5, 3.5, 90);
    const SteerResult first = steering.steer(from, through, *scratch);
    ASSERT_TRUE(first.edge.has_value()) << heading;
    EXPECT_FALSE(first.edge->to.standing);
    const SteerResult second = steering.steer({first.edge->to}, to, *scratch);
    ASSERT_TRUE(second.edge.has_value()) << heading;
    AnimationBuffer a, b;
    steering.animate(*first.edge, a);
    steering.animate(*second.edge, b);
    EXPECT_EQ(a.poses.p_WR(a.size() - 1), b.poses.p_WR(0));
    for (int joint = 0; joint < a.poses.joints(); ++joint)
      EXPECT_EQ(a.poses.rotations(a.size() - 1)[joint].coeffs(),
                b.poses.rotations(0)[joint].coeffs());
    EXPECT_LT(first.edge->duration + second.edge->duration,
              steering.steer(from, standing(1.5, 2.0, 90), *scratch).edge->duration +
                  steering.steer(standing(1.5, 2.0, 90), to, *scratch).edge->duration);
  }
}

TEST_F(WalkSteeringTest, PlacingAStanceMovesItUpAndDownOnly) {
  Stance stance = standing(2, 1, 30).stance;
  stance.position.z() = 0.8;
  EXPECT_TRUE(steering.place(stance));
  EXPECT_EQ(stance.position, Eigen::Vector3d(2, 1, 0));
  stance.position.z() = 30.0;
  EXPECT_FALSE(steering.place(stance));
  EXPECT_EQ(steering.layers(), 0);
  EXPECT_TRUE(steering.passages().empty());
}

TEST(WalkSteeringUneven, PassagesOfAStairAreWalkedUpAndDown) {
  Scene scene;
  scene.objects = {boxObject("low", {3, 3, 0.2}, {-1.5, 0, -0.1}),
                   boxObject("high", {3, 3, 0.2}, {1.16 + 1.5, 0, 0.85 - 0.1})};
  for (int i = 0; i < 4; ++i)
    scene.objects.push_back(
        boxObject("tread", {0.29, 3, 0.17 * (i + 1)}, {0.29 * (i + 0.5), 0, 0.085 * (i + 1)}));
  const FurnishedRoom room(scene);
  const WalkSteering steering(room.synthesizer, room.world, room.ground);
  const SteeringScratchPtr scratch = steering.makeScratch();
  EXPECT_GE(steering.layers(), 1);
  const auto passages = steering.passages();
  ASSERT_FALSE(passages.empty());
  int up = 0, down = 0, foretold = 0;
  for (const StancePair& pair : passages) {
    Stance low = pair.first, high = pair.second;
    EXPECT_FALSE(steering.stand(low, *scratch));
    EXPECT_FALSE(steering.stand(high, *scratch));
    const SteerResult rising = steering.steer({low}, {high}, *scratch);
    up += rising.edge.has_value();
    down += steering.steer({high}, {low}, *scratch).edge.has_value();
    if (!rising.edge) continue;
    const WalkEdge& edge = *rising.edge;
    EXPECT_GT(edge.effort, 0.0);  // 0.85 m are won
    if (edge.turn_first != 0.0 || edge.turn_last != 0.0) continue;
    // Planned it costs what it does when it has been made, and before that it is told no more.
    const CharacterSettings& settings = room.synthesizer.settings();
    std::vector<std::pair<double, double>> told;  // duration, effort; the first without steps
    AnimationBuffer buffer;
    const auto plan = [&](size_t most) {
      told.clear();
      return room.synthesizer.walk(
          edge.from, edge.to, edge.path, edge.any_leading, buffer, {},
          [&](int intervals, Side, std::span<const GaitParameters> gait) {
            told.emplace_back(intervals * settings.frame_time,
                              effortOf(gait, room.synthesizer.capturedLift(), settings.speed));
            return told.size() < most;
          });
    };
    EXPECT_FALSE(plan(100).unwanted);
    ASSERT_GE(told.size(), 2u);
    EXPECT_NEAR(told.back().first, edge.duration, 1e-9);
    EXPECT_EQ(told.back().second, edge.effort);
    for (const auto& [duration, effort] : told) {
      EXPECT_LE(duration, edge.duration + 1e-9);
      EXPECT_LE(effort, edge.effort + 1e-9);
    }
    EXPECT_EQ(told.front().second, 0.0);
    for (size_t i = 1; i < told.size(); ++i) EXPECT_GT(told[i].second, 0.0);
    // Nothing is planned further that is not wanted.
    for (size_t most = 1; most <= 2; ++most) {
      EXPECT_TRUE(plan(most).unwanted);
      EXPECT_EQ(told.size(), most);
    }
    ++foretold;
  }
  EXPECT_GT(up, 0);
  EXPECT_GT(down, 0);
  EXPECT_GT(foretold, 0);
}

}  // namespace
}  // namespace amble

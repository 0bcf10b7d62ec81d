#include "planner/steering/body_reach.h"

#include <gtest/gtest.h>

#include <memory>

#include "animation/steps/step_placer.h"
#include "base/rotation.h"
#include "base/sample_stream.h"
#include "planner/steering/ground_range.h"
#include "planner/steering/walk_steering.h"
#include "tests/planner/furnished_room.h"

namespace amble {
namespace {

constexpr double kLongestStep = 1.0;  // no step is longer [m]
const Eigen::Vector3d kWest(0.8, 2, 0), kEast(5.2, 2, 0);
bool never() { return false; }

// A room of 6 x 4 m with walls around, and more in it.
Scene roomWith(const std::vector<SceneObject>& things) {
  Scene scene = furnishedScene();
  scene.objects.resize(5);  // the floor and four walls
  scene.objects.insert(scene.objects.end(), things.begin(), things.end());
  return scene;
}

// In that room, standing or walking, by any heading.
Waypoint anywhere(SampleStream& stream) {
  Waypoint at;
  at.stance.position << stream.uniform(0.3, 5.7), stream.uniform(0.3, 3.7), 0.0;
  at.stance.heading = stream.uniform(-kPi, kPi);
  at.stance.standing = stream.uniform() < 0.6;
  return at;
}

std::optional<SteeringFailure> shutOff(const FurnishedRoom& room, const Eigen::Vector3d& from,
                                       const Eigen::Vector3d& to) {
  const WalkSteering steering(room.synthesizer, room.world, room.ground);
  const auto scratch = steering.makeScratch();
  return steering.shutOff(from, to, never, {&scratch, 1});
}

struct Named {
  std::string part, object;
  Eigen::Vector3d at;
};
std::optional<Named> shutOffBy(const std::vector<SceneObject>& things) {
  const FurnishedRoom room(roomWith(things));
  const auto failure = shutOff(room, kWest, kEast);
  if (!failure) return std::nullopt;
  EXPECT_EQ(failure->rule, WalkRule::kDisconnected);
  return Named{room.body.parts.at(failure->part).name, room.scene.objects.at(failure->object).name,
               failure->at};
}

TEST(BodyReach, AWallFromSideToSideShutsOffAndOneWithADoorDoesNot) {
  const auto named = shutOffBy({boxObject("wall", {0.1, 4.0, 2.5}, {3, 2, 1.25})});
  ASSERT_TRUE(named.has_value());
  EXPECT_EQ(named->object, "wall");
  EXPECT_NEAR(named->at.x(), 3.0, 0.1);
  EXPECT_NEAR(named->at.y(), 2.0, 0.3);  // where it is least out of the way
  EXPECT_FALSE(shutOffBy({boxObject("wall", {0.1, 3.1, 2.5}, {3, 1.55, 1.25})}).has_value());
}

TEST(BodyReach, ABeamShutsOffWhoIsTaller) {
  const double stature = furnishedRoom().synthesizer.stature();
  const auto beam = [](double under) {
    return std::vector{boxObject("beam", {0.2, 4.0, 0.2}, {3, 2, under + 0.1})};
  };
  const auto named = shutOffBy(beam(stature - 0.05));
  ASSERT_TRUE(named.has_value());
  EXPECT_EQ(named->part, "head");
  EXPECT_FALSE(shutOffBy(beam(stature + 0.01)).has_value());
}

TEST(BodyReach, ALogShutsOffWhoDoesNotLiftTheLegSoHigh) {
  const auto log = [](double height) {
    return std::vector{boxObject("log", {0.4, 4.0, height}, {3, 2, 0.5 * height})};
  };
  const auto named = shutOffBy(log(0.6));
  ASSERT_TRUE(named.has_value());
  EXPECT_TRUE(named->part == "left shank" || named->part == "right shank") << named->part;
  EXPECT_FALSE(shutOffBy(log(0.24)).has_value());
}

TEST(BodyReach, OfTwoBeamsOneAfterTheOtherOneIsNamedAndNotTheRoomBetween) {
  const double stature = furnishedRoom().synthesizer.stature();
  const auto beam = [&](const char* name, double x) {
    return boxObject(name, {0.2, 4.0, 0.2}, {x, 2, stature + 0.05});
  };
  const FurnishedRoom room(roomWith({beam("first", 2.0), beam("second", 4.0)}));
  const auto failure = shutOff(room, kWest, kEast);
  ASSERT_TRUE(failure.has_value());
  ASSERT_GE(failure->object, 0);
  const Eigen::Vector3d middle = room.scene.objects.at(failure->object).X_WO.translation();
  EXPECT_NEAR(failure->at.x(), middle.x(), 0.2);
  EXPECT_NEAR(failure->body.x(), middle.x(), 0.2);
}

// The theorem: what is walked is not shut off, whatever stands in the room.
TEST(BodyReach, NoWalkThatIsFoundWasShutOff) {
  SampleStream stream(3, 0);
  int walked = 0;
  for (int i = 0; i < 12; ++i) {
    std::vector<SceneObject> things;
    for (int k = 0; k < 7; ++k) {
      const Eigen::Vector3d size(stream.uniform(0.1, 1.5), stream.uniform(0.1, 1.5),
                                 stream.uniform(0.1, 2.0));
      const double under = stream.uniform() < 0.3 ? stream.uniform(0.5, 1.9) : 0.0;
      things.push_back(
          boxObject("thing", size,
                    {stream.uniform(0.5, 5.5), stream.uniform(0.3, 3.7), under + 0.5 * size.z()}));
    }
    const FurnishedRoom room(roomWith(things));
    const WalkSteering steering(room.synthesizer, room.world, room.ground);
    const auto scratch = steering.makeScratch();
    for (int k = 0; k < 40; ++k) {
      const Waypoint from = anywhere(stream), to = anywhere(stream);
      if (!steering.steer(from, to, *scratch).edge) continue;
      ++walked;
      EXPECT_FALSE(steering.shutOff(from.stance.position, to.stance.position, never, {&scratch, 1})
                       .has_value());
    }
  }
  EXPECT_GE(walked, 20);
}

// On top of which somebody could stand and walk: it is no ground that leads there.
TEST(BodyReach, WallsThatAreThickShutOffAsThinOnesDo) {
  for (const double thick : {0.1, 0.4, 0.5, 1.0, 2.0}) {
    const auto named = shutOffBy({boxObject("wall", {thick, 12.0, 2.5}, {3, 2, 1.25})});
    ASSERT_TRUE(named.has_value()) << thick;
    EXPECT_EQ(named->object, "wall") << thick;
  }
}

// Walks of all kinds, over things as high as may be stepped over: all balls are in the body.
// From where nothing is stepped over to where heads are at least, and where they may not be.
TEST(BodyReach, ABarFromSideToSideShutsOffAtAnyHeight) {
  SampleStream stream(12, 0);
  const double stature = furnishedRoom().synthesizer.stature();
  for (int i = 0; i < 20; ++i) {
    const double under = stream.uniform(0.25, 0.95) * stature, thick = stream.uniform(0.15, 0.3);
    const double deep = stream.uniform(0.03, 0.4);
    const auto named =
        shutOffBy({boxObject("bar", {deep, 4.0, thick}, {3, 2, under + 0.5 * thick})});
    ASSERT_TRUE(named.has_value()) << under << ' ' << thick;
    EXPECT_EQ(named->object, "bar");
  }
  EXPECT_FALSE(shutOffBy({boxObject("bar", {0.1, 4.0, 0.2}, {3, 2, stature + 0.2})}));
}

// Ends of the axes of the body's parts, in a pose.
struct Pose {
  const std::vector<Eigen::Vector3d>&from, &to;
  Eigen::Vector3d middle(int part) const { return 0.5 * (from[part] + to[part]); }
  double fromAxis(size_t part, const Eigen::Vector3d& p) const {
    const Eigen::Vector3d axis = to[part] - from[part];
    const double along = (p - from[part]).dot(axis) / std::max(axis.squaredNorm(), 1e-12);
    return (p - from[part] - std::clamp(along, 0.0, 1.0) * axis).norm();
  }
};

bool isInBody(const Eigen::Vector3d& p, const Pose& pose, const Body& body) {
  for (size_t i = 0; i < body.parts.size(); ++i) {
    if (pose.fromAxis(i, p) <= body.parts[i].radius) return true;
  }
  return false;
}

// All of a ball round the place where each leg, from the ankle by the knee and the hip to the
// middle of the pelvis, crosses its height: there is one such place.
void expectHeld(const BodyReach::Ball& ball, const Pose& pose, const Body& body,
                const JointRoles& roles) {
  const auto partOf = [&](int joint) {
    return std::ranges::find(body.parts, joint, &BodyPart::joint) - body.parts.begin();
  };
  for (const LegJoints& leg : roles.legs) {
    const auto shank = partOf(leg.leg), thigh = partOf(leg.up_leg), pelvis = partOf(roles.hips);
    const Eigen::Vector3d chain[] = {pose.to[shank], pose.from[shank], pose.from[thigh],
                                     pose.middle(static_cast<int>(pelvis))};
    int crossings = 0;
    for (int i = 0; i < 3; ++i) {
      const Eigen::Vector3d &low = chain[i], &high = chain[i + 1];
      if ((low.z() > ball.height) == (high.z() > ball.height)) continue;
      ++crossings;
      const double share = (ball.height - low.z()) / (high.z() - low.z());
      const Eigen::Vector3d at = low + share * (high - low);
      for (int k = 0; k < 64; ++k) {  // a spiral over the ball
        const double z = -1.0 + (2.0 * k + 1.0) / 64.0, turned = 2.4 * k;
        const double out = std::sqrt(1.0 - z * z);
        const Eigen::Vector3d way(out * std::cos(turned), out * std::sin(turned), z);
        ASSERT_TRUE(isInBody(at + 0.999 * ball.radius * way, pose, body)) << ball.height;
      }
    }
    ASSERT_EQ(crossings, 1) << ball.height;
  }
}

// All balls of a stack, as low or high as its middle part is.
void expectHeld(const TrunkStack& stack, const Pose& pose, const Body& body) {
  const auto is_middle = [&](const StackedBall& own) {
    return body.parts[own.part].name == "abdomen" || body.parts[own.part].name == "neck";
  };
  // About what the others are seen from is more of its part than elsewhere.
  const auto middle = std::ranges::max_element(
      stack.balls, {}, [&](const StackedBall& own) { return is_middle(own) ? own.radius : 0.0; });
  ASSERT_TRUE(is_middle(*middle));
  const Eigen::Vector3d at =
      body.parts[middle->part].name == "neck" ? pose.from[middle->part] : pose.middle(middle->part);
  const double lifted = at.z() - middle->height;
  ASSERT_GT(lifted, -(stack.sway + BodyReach::kDip));
  ASSERT_LT(lifted, stack.sway + BodyReach::kRise);
  for (const StackedBall& own : stack.balls) {
    const Eigen::Vector3d ball(at.x(), at.y(), own.height + lifted);
    const BodyPart& part = body.parts[own.part];
    ASSERT_LE(pose.fromAxis(own.part, ball) + own.radius, part.radius) << part.name;
  }
}

// visit(joints, pose) for each frame of walks between stances that are drawn in the room. @return
// of how many walks
template <typename Visit>
int visitDrawnPoses(const FurnishedRoom& room, std::uint64_t seed, Visit visit) {
  const WalkSteering steering(room.synthesizer, room.world, room.ground);
  const auto scratch = steering.makeScratch();
  SampleStream stream(seed, 0);
  AnimationBuffer buffer;
  std::vector<JointFrame> joints(room.synthesizer.skeleton().size());
  std::vector<Eigen::Vector3d> from(room.body.parts.size()), to(room.body.parts.size());
  int walks = 0;
  for (int i = 0; i < 150; ++i) {
    const Waypoint begin = anywhere(stream), end = anywhere(stream);
    const auto result = steering.steer(begin, end, *scratch);
    if (!result.edge) continue;
    ++walks;
    steering.animate(*result.edge, buffer);
    for (int frame = 0; frame < buffer.size(); ++frame) {
      forwardKinematics(room.synthesizer.skeleton(), buffer.poses[frame], joints);
      placeBody(room.body, joints, from, to);
      visit(joints, Pose{from, to});
    }
  }
  return walks;
}

TEST(BodyReach, EveryPoseHoldsTheBalls) {
  const double highest = furnishedRoom().ground.settings().limits.highestStep();
  std::vector<SceneObject> logs;
  for (const double x : {2.0, 4.0})
    logs.push_back(boxObject("log", {0.12, 4.0, highest - 0.01}, {x, 2, 0.5 * (highest - 0.01)}));
  const FurnishedRoom room(roomWith(logs));
  const BodyReach reach(straightWalk(room.synthesizer), room.synthesizer.skeleton(),
                        room.synthesizer.roles(), room.body, room.synthesizer.stature(),
                        {highest, kLongestStep, StepPlacer::kHighestLift});
  Body who_stoops = room.body;
  who_stoops.upright = 0.0;
  const BodyReach stooping(straightWalk(room.synthesizer), room.synthesizer.skeleton(),
                           room.synthesizer.roles(), who_stoops, room.synthesizer.stature(),
                           {highest, kLongestStep, StepPlacer::kHighestLift});
  const auto head = std::ranges::find(stooping.balls(), room.body.head, &BodyReach::Ball::part);
  ASSERT_NE(head, stooping.balls().end());
  EXPECT_TRUE(std::ranges::all_of(
      stooping.balls(), [](const BodyReach::Ball& ball) { return ball.stack.balls.empty(); }));
  double lifted = 0.0;
  visitDrawnPoses(room, 4, [&](const std::vector<JointFrame>& joints, const Pose& pose) {
    for (const BodyReach::Ball& ball : reach.balls()) {
      if (ball.isFoot() || ball.post) continue;  // LiftedFeet, WallEnds
      if (!ball.stack.balls.empty()) {
        expectHeld(ball.stack, pose, room.body);
        continue;
      }
      if (ball.isOverLevelOnly()) {
        expectHeld(ball, pose, room.body, room.synthesizer.roles());
        continue;
      }
      const BodyPart& part = room.body.parts[ball.part];
      const double middle = pose.middle(ball.part).z();
      if (ball.part == room.body.head) {
        ASSERT_LT(middle, ball.height);  // it begins in the head, or in what is over it
        ASSERT_LT(head->height, middle);
        ASSERT_LT(middle, head->highest);
      } else if (part.name == "pelvis" || part.name == "chest") {
        ASSERT_EQ(ball.radius, part.radius) << part.name;
        ASSERT_LT(ball.height, middle) << part.name;
        ASSERT_LT(middle, ball.highest) << part.name;
      } else {
        for (const LegJoints& leg : room.synthesizer.roles().legs) {
          ASSERT_LT(joints[leg.foot].p_WJ.z(), ball.height);
          ASSERT_GT(joints[leg.up_leg].p_WJ.z(), ball.height);
          lifted = std::max(lifted, joints[leg.foot].p_WJ.z());
        }
      }
    }
  });
  EXPECT_GE(reach.balls().size(), 10u);
  EXPECT_GT(lifted, highest);  // somebody stepped over a log
}

// Who turns on the spot bends otherwise than who walks straight on, and hips of tall people who
// walk fast give way the most.
TEST(BodyReach, PosesOfTallAndShortSlowAndFastHoldTheStacks) {
  for (const double height : {1.2, 2.0}) {
    for (const double speed : {0.4, 1.8}) {
      CharacterSettings settings;
      settings.height = height, settings.speed = speed;
      std::vector<SceneObject> logs;
      for (const double x : {2.0, 4.0})
        logs.push_back(boxObject("log", {0.1, 4.0, 0.2}, {x, 2, 0.1}));
      const FurnishedRoom room(roomWith(logs), settings);
      const std::vector<TrunkStack> stacks =
          trunkStacks(straightWalk(room.synthesizer), room.synthesizer.skeleton(),
                      room.synthesizer.roles(), room.body, 0.01);
      ASSERT_EQ(stacks.size(), 2u);
      const int walks = visitDrawnPoses(room, 7, [&](const auto&, const Pose& pose) {
        for (const TrunkStack& stack : stacks) expectHeld(stack, pose, room.body);
      });
      EXPECT_GT(walks, 10) << height << " " << speed;
    }
  }
}

// Of a floor without walls: a wall that leaves a strip along its edge is walked by, leaning out.
TEST(BodyReach, NoWalkAlongAnOpenEdgeWasShutOff) {
  SampleStream stream(6, 0);
  int walked = 0;
  double narrowest = HUGE_VAL;
  for (int i = 0; i < 10; ++i) {
    Scene scene = furnishedScene();
    scene.objects.resize(1);
    const Eigen::AlignedBox2d floor = FurnishedRoom(scene).ground.extent();
    const double strip = stream.uniform(0.1, 0.8), south = floor.min().y() - 0.5;
    const double breadth = floor.max().y() - strip - south;
    scene.objects.push_back(
        boxObject("wall", {0.1, breadth, 2.5}, {3, south + 0.5 * breadth, 1.25}));
    const FurnishedRoom room(std::move(scene));
    const WalkSteering steering(room.synthesizer, room.world, room.ground);
    const auto scratch = steering.makeScratch();
    for (int k = 0; k < 30; ++k) {
      Waypoint from = anywhere(stream), to = anywhere(stream);
      from.stance.position.x() = stream.uniform(0.5, 2.2);
      to.stance.position.x() = stream.uniform(3.8, 5.5);
      for (Waypoint* end : {&from, &to}) {
        end->stance.position.y() = floor.max().y() - stream.uniform(0.0, 0.5);
        end->stance.heading = stream.uniform(-0.3, 0.3);
      }
      if (!steering.steer(from, to, *scratch).edge) continue;
      ++walked;
      narrowest = std::min(narrowest, strip);
      EXPECT_FALSE(steering.shutOff(from.stance.position, to.stance.position, never, {&scratch, 1})
                       .has_value());
    }
  }
  EXPECT_GE(walked, 15);
  EXPECT_LT(narrowest, 0.5) << "narrower than anybody is";
}

// A room of 6 x 4 m with a step up to a platform.
std::vector<SceneObject> platform(double height) {
  return {boxObject("platform", {2.0, 4.0, height}, {5, 2, 0.5 * height}),
          boxObject("step", {0.4, 4.0, 0.5 * height}, {3.8, 2, 0.25 * height})};
}

TEST(BodyReach, WhatShutsOffDoesWhereTheGroundIsUneven) {
  const auto shuts = [](double height, const SceneObject& thing) {
    std::vector<SceneObject> things = platform(height);
    things.push_back(thing);
    const FurnishedRoom room(roomWith(things));
    EXPECT_FALSE(room.ground.isLevel());
    return shutOff(room, kWest, kEast + Eigen::Vector3d(0, 0, height)).has_value();
  };
  for (const double x : {2.5, 3.6, 4.2}) {  // far from the steps, before them and over them
    EXPECT_TRUE(shuts(0.3, boxObject("wall", {0.1, 4.0, 2.5}, {x, 2, 1.25}))) << x;
  }
  EXPECT_FALSE(shuts(0.3, boxObject("wall", {0.1, 3.1, 2.5}, {3.6, 1.55, 1.25})));
  EXPECT_TRUE(shuts(0.3, boxObject("log", {0.2, 4.0, 0.6}, {1.8, 2, 0.3})));
  EXPECT_TRUE(shuts(0.3, boxObject("beam", {0.2, 4.0, 0.3}, {1.8, 2, 1.7})));
  EXPECT_FALSE(shuts(0.3, boxObject("beam", {0.2, 4.0, 0.3}, {1.8, 2, 1.9})));
}

// What is walked over steps is not shut off, and pelvis and chest are carried between what would be
// over the lowest ground and over the highest.
TEST(BodyReach, NoWalkOverStepsWasShutOffAndTheirPosesHoldTheBalls) {
  SampleStream stream(5, 0);
  int walked = 0;
  double least = HUGE_VAL;
  for (const double height : {0.3, 0.45}) {
    std::vector<SceneObject> things = platform(height);
    things.push_back(boxObject("post", {0.3, 0.3, 2.0}, {stream.uniform(1.5, 4.5), 2.0, 1.0}));
    const FurnishedRoom room(roomWith(things));
    const WalkSteering steering(room.synthesizer, room.world, room.ground);
    const double highest = room.ground.settings().limits.highestStep();
    const double stature = room.synthesizer.stature();
    const BodyReach reach(straightWalk(room.synthesizer), room.synthesizer.skeleton(),
                          room.synthesizer.roles(), room.body, stature,
                          {highest, kLongestStep, StepPlacer::kHighestLift});
    const GroundRange range(room.ground, ReachedGround(room.ground, {0.0, 0.0, 50.0}, kLongestStep),
                            0.5 * stature);
    const auto scratch = steering.makeScratch();
    AnimationBuffer buffer;
    std::vector<JointFrame> joints(room.synthesizer.skeleton().size());
    std::vector<Eigen::Vector3d> a(room.body.parts.size()), b(room.body.parts.size());
    for (int i = 0; i < 60; ++i) {
      Waypoint from = anywhere(stream), to = anywhere(stream);
      if (!steering.place(from.stance) || !steering.place(to.stance)) continue;
      const auto result = steering.steer(from, to, *scratch);
      if (!result.edge || from.stance.position.z() == to.stance.position.z()) continue;
      ++walked;
      EXPECT_FALSE(steering.shutOff(from.stance.position, to.stance.position, never, {&scratch, 1})
                       .has_value());
      steering.animate(*result.edge, buffer);
      for (int frame = 0; frame < buffer.size(); ++frame) {
        forwardKinematics(room.synthesizer.skeleton(), buffer.poses[frame], joints);
        placeBody(room.body, joints, a, b);
        for (const BodyReach::Ball& ball : reach.balls()) {
          const BodyPart& part = room.body.parts[ball.part];
          if (ball.isLeg()) continue;
          if (part.name != "pelvis" && part.name != "chest") continue;
          const Eigen::Vector3d middle = 0.5 * (a[ball.part] + b[ball.part]);
          const auto ground = range.around(middle.head<2>());
          ASSERT_FALSE(ground.isEmpty());
          const double low = middle.z() - (ground.min()[0] + ball.height);
          const double high = ground.max()[0] + ball.highest - middle.z();
          least = std::min({least, low, high});
          ASSERT_GT(low, 0.0) << part.name;
          ASSERT_GT(high, 0.0) << part.name;
        }
      }
    }
  }
  EXPECT_GE(walked, 10);
  EXPECT_LT(least, 0.1);  // somebody uses what is allowed for
}

TEST(BodyReach, WhoIsStoppedKnowsNothing) {
  const FurnishedRoom room(roomWith({boxObject("wall", {0.1, 4.0, 2.5}, {3, 2, 1.25})}));
  const WalkSteering steering(room.synthesizer, room.world, room.ground);
  const auto scratch = steering.makeScratch();
  EXPECT_FALSE(steering.shutOff(kWest, kEast, [] { return true; }, {&scratch, 1}).has_value());
}

}  // namespace
}  // namespace amble

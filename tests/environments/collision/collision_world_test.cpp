#include "environments/collision/collision_world.h"

#include <gtest/gtest.h>

#include <memory>
#include <random>

#include "animation/captures/bvh.h"
#include "tests/environments/test_scenes.h"
#include "tests/environments/test_walker.h"

namespace amble {
namespace {

// A world with somebody in it.
struct TestWorld {
  explicit TestWorld(std::vector<SceneObject> objects) : scene(sceneOf(std::move(objects))) {}

  std::optional<Contact> check(const PoseArray& poses, bool planted, bool any = false) {
    return world.check(poses, solesOf(poses.size(), planted), any, *scratch);
  }
  std::optional<Contact> checkPose(const Pose& pose) { return world.checkPose(pose, *scratch); }
  std::string partOf(const std::optional<Contact>& contact) const {
    return contact ? walker.body.parts[contact->part].name : "nothing";
  }

  TestWalker walker;
  Scene scene;
  SceneGround ground{scene, 0.0};
  CollisionWorld world{scene, ground, walker.skeleton, walker.body};
  CollisionScratchPtr scratch = world.makeScratch();
};

PoseArray motionOf(const TestWalker& walker, const std::vector<Pose>& poses) {
  PoseArray array(walker.skeleton.size());
  for (const Pose& pose : poses) array.append(pose);
  return array;
}

// Standing, moved by a vector.
Pose standingAt(const TestWalker& walker, const Eigen::Vector3d& by) {
  Pose pose = walker.standing(by.x(), by.y());
  pose.p_WR.z() += by.z();
  return pose;
}

TEST(CollisionWorld, AnEmptyMotionHasNoContact) {
  TestWorld world({floorSlab()});
  EXPECT_FALSE(world.check(PoseArray(world.walker.skeleton.size()), true));
  EXPECT_FALSE(world.check(PoseArray(world.walker.skeleton.size()), true, true));
}

TEST(CollisionWorld, StandingOnTheFloorIsFreeAndSixMillimetresDeepIsNot) {
  TestWorld world({floorSlab()});
  EXPECT_FALSE(world.checkPose(standingAt(world.walker, {0, 0, 0})));
  EXPECT_FALSE(world.checkPose(standingAt(world.walker, {0, 0, -0.0049})));
  const auto deep = world.checkPose(standingAt(world.walker, {0, 0, -0.006}));
  ASSERT_TRUE(deep);
  EXPECT_GE(world.walker.body.parts[deep->part].sole, 0);
  EXPECT_EQ(deep->object, 0);
}

TEST(CollisionWorld, AnUprightBodyIsAsTallAsItSaysWhateverItsHeadDoes) {
  TestWorld world({floorSlab()});
  const Pose standing = standingAt(world.walker, {0, 0, 0});
  std::vector<JointFrame> joints(world.walker.skeleton.size());
  std::vector<Eigen::Vector3d> from(world.walker.body.parts.size()), to(from.size());
  forwardKinematics(world.walker.skeleton, {standing.p_WR, standing.rotations}, joints);
  placeBody(world.walker.body, joints, from, to);
  const int head = world.walker.body.head;
  ASSERT_EQ(world.walker.body.parts[head].name, "head");
  const double top = std::max(from[head].z(), to[head].z()) + world.walker.body.parts[head].radius;
  // A slab that begins 3 cm over the head of who says to be 5 cm taller than it is.
  const Scene low =
      sceneOf({floorSlab(), makeObject("lintel", Box{{2, 0.2, 0.4}}, {0, 0, top + 0.03 + 0.2})});
  const SceneGround ground(low, 0.0);
  for (const double taller : {0.0, 0.02, 0.05}) {
    Body body = world.walker.body;
    body.upright = taller > 0.0 ? top + taller : 0.0;
    const CollisionWorld under(low, ground, world.walker.skeleton, body);
    const CollisionScratchPtr scratch = under.makeScratch();
    const PoseArray poses = motionOf(world.walker, {standing, standing});
    for (const bool any : {false, true}) {
      const auto contact = under.check(poses, solesOf(2, true), any, *scratch);
      EXPECT_EQ(contact.has_value(), taller > 0.03) << taller;
      EXPECT_TRUE(!contact || contact->part == head);
    }
    EXPECT_EQ(under.checkPose(poses[0], *scratch).has_value(), taller > 0.03) << taller;
  }
}

TEST(CollisionWorld, ASwingingSoleMayNotBeInTheGround) {
  TestWorld world({floorSlab()});
  const auto at = [&](double z) {
    return motionOf(world.walker, {standingAt(world.walker, {0, 0, z})});
  };
  EXPECT_FALSE(world.check(at(-0.0009), false));
  EXPECT_TRUE(world.check(at(-0.003), false));
  EXPECT_FALSE(world.check(at(-0.003), true));
  EXPECT_FALSE(world.check(at(0.001), false));
}

TEST(CollisionWorld, AHandInTheFloorIsAContact) {
  TestWorld world({floorSlab()});
  // Sitting in the air with legs stretched forwards; the hands hang 0.3 m below the hips.
  Pose pose = world.walker.standing(0, 0);
  for (const LegJoints& leg : world.walker.roles.legs)
    pose.rotations[leg.up_leg] = expRotation({-0.5 * kPi, 0, 0});
  pose.p_WR.z() = 0.5;
  EXPECT_FALSE(world.checkPose(pose)) << world.partOf(world.checkPose(pose));
  pose.p_WR.z() = 0.25;
  const auto contact = world.checkPose(pose);
  EXPECT_NE(world.partOf(contact).find("hand"), std::string::npos) << world.partOf(contact);
}

TEST(CollisionWorld, WhatIsUnderTheGroundIsAContact) {
  // A floor that is one sheet, and somebody a storey below it.
  TestWorld world({makeObject(
      "sheet",
      TriangleMesh{{{-9, -9, 0}, {9, -9, 0}, {9, 9, 0}, {-9, 9, 0}}, {{0, 1, 2}, {0, 2, 3}}},
      {0, 0, 0})});
  EXPECT_FALSE(world.checkPose(standingAt(world.walker, {0, 0, 0})));
  EXPECT_TRUE(world.checkPose(standingAt(world.walker, {0, 0, -3})));
}

TEST(CollisionWorld, FeetMayStandOnARugAndNotInIt) {
  TestWorld world({floorSlab(), makeObject("rug", Box{{2, 2, 0.01}}, {0, 0, 0.005})});
  EXPECT_FALSE(world.checkPose(standingAt(world.walker, {0, 0, 0.01})));
  EXPECT_TRUE(world.checkPose(standingAt(world.walker, {0, 0, 0.0})));
  EXPECT_FALSE(world.checkPose(standingAt(world.walker, {4, 0, 0.0})));
  // Half on the rug, at its height.
  EXPECT_FALSE(world.checkPose(standingAt(world.walker, {1, 0, 0.01})));
}

TEST(CollisionWorld, AHouseOfOneMeshHasWallsToHitAndAFloorToStandOn) {
  TriangleMesh house = makeBox({10, 10, 0.1});
  for (Eigen::Vector3d& v : house.vertices) v.z() -= 0.05;
  TriangleMesh wall = makeBox({0.2, 10, 2.5});
  for (Eigen::Vector3d& v : wall.vertices) v += Eigen::Vector3d(2, 0, 1.25);
  TestWorld world({makeObject("house", joined(house, wall), {0, 0, 0})});
  EXPECT_FALSE(world.checkPose(standingAt(world.walker, {0, 0, 0})));
  EXPECT_TRUE(world.checkPose(standingAt(world.walker, {1.9, 0, 0})));
  EXPECT_TRUE(world.checkPose(standingAt(world.walker, {0, 0, -0.01})));
  EXPECT_FALSE(world.checkPose(standingAt(world.walker, {3.0, 0, 0})));
}

TEST(CollisionWorld, TheInsideOfAClosedCupboardIsAContactAndOfAHollowRoomIsNot) {
  const auto shell = [](double inner) {
    TriangleMesh walls = joined(makeBox({8, 8, 4}), makeBox({inner, inner, inner}));
    for (Eigen::Vector3d& v : walls.vertices) v.z() += 0.5 * inner;
    return walls;
  };
  TriangleMesh cupboard = makeBox({4, 4, 4});
  for (const bool flipped : {false, true}) {
    TestWorld solid(
        {floorSlab(), makeObject("cupboard", flipped ? turned(cupboard) : cupboard, {0, 0, 2.2})});
    EXPECT_TRUE(solid.checkPose(standingAt(solid.walker, {0, 0, 0.3})));
    // Nothing of the body is near the room's surface: its inner box is 3.9 m wide.
    TriangleMesh room = shell(3.9);
    TestWorld hollow({makeObject("room", flipped ? turned(room) : room, {0, 0, 0})});
    EXPECT_FALSE(hollow.checkPose(standingAt(hollow.walker, {0, 0, 1.0})));
    EXPECT_TRUE(hollow.checkPose(standingAt(hollow.walker, {3.0, 0, 1.0})));
  }
}

TEST(CollisionWorld, AThinWallBetweenTwoFramesIsFound) {
  TestWorld world({floorSlab(), makeObject("wall", makeBox({0.001, 5, 2}), {0, 0, 1.1})});
  const PoseArray through = motionOf(world.walker, {standingAt(world.walker, {-1, 0, 0.01}),
                                                    standingAt(world.walker, {1, 0, 0.01})});
  EXPECT_FALSE(world.checkPose(standingAt(world.walker, {-1, 0, 0})));
  EXPECT_FALSE(world.checkPose(standingAt(world.walker, {1, 0, 0})));
  for (const bool any : {false, true}) {
    const auto contact = world.check(through, false, any);
    ASSERT_TRUE(contact);
    EXPECT_EQ(contact->frame, 0);
    EXPECT_EQ(contact->object, 1);
    EXPECT_GT(contact->between, 0.2);
    EXPECT_LT(contact->between, 0.6);
  }
}

TEST(CollisionWorld, AnArmThatSwingsThroughAPoleBetweenTwoFramesIsFound) {
  // The left hand swings from hanging down to stretched out forwards, past a bar at 45 degrees.
  TestWorld world({floorSlab(), makeObject("bar", Box{{0.01, 1.0, 0.01}}, {0.42, 0.4, 0.95})});
  Pose down = world.walker.standing(0, 0), out = down;
  const int arm = world.walker.roles.arms[kLeft].arm;
  out.rotations[arm] = expRotation({-0.5 * kPi, 0, 0}) * down.rotations[arm];
  EXPECT_FALSE(world.checkPose(down));
  EXPECT_FALSE(world.checkPose(out)) << world.partOf(world.checkPose(out));
  const auto contact = world.check(motionOf(world.walker, {down, out}), true);
  ASSERT_TRUE(contact);
  EXPECT_EQ(contact->object, 1);
  EXPECT_GT(contact->between, 0.0);
}

TEST(CollisionWorld, AGapWiderThanTheProofIsPassedAtAnyFrameRate) {
  // Two walls, 1 cm beside the widest parts of somebody who walks straight between them without
  // moving a limb.
  const TestWalker walker;
  std::vector<JointFrame> frames(walker.skeleton.size());
  const Pose pose = walker.standing(0, 0);
  forwardKinematics(walker.skeleton, pose, frames);
  double widest = 0.0;
  for (const BodyPart& part : walker.body.parts)
    for (const Eigen::Vector3d& end : {part.from, part.to})
      widest = std::max(widest, std::abs((frames[part.joint] * end).y()) + part.radius);
  const auto walled = [&](double gap) {
    return TestWorld({floorSlab(),
                      makeObject("left", makeBox({4, 0.1, 2.5}), {2, widest + gap + 0.05, 1.3}),
                      makeObject("right", Box{{4, 0.1, 2.5}}, {2, -widest - gap - 0.05, 1.3})});
  };
  TestWorld wide = walled(0.01), narrow = walled(-0.001);
  for (const int steps : {1, 3, 60}) {
    PoseArray poses(walker.skeleton.size());
    for (int i = 0; i <= steps; ++i) poses.append(walker.standing(-1.0 + 3.0 * i / steps, 0));
    EXPECT_FALSE(wide.check(poses, true)) << steps << " " << wide.partOf(wide.check(poses, true));
    EXPECT_TRUE(narrow.check(poses, true)) << steps;
  }
}

TEST(CollisionWorld, FirstIsInOrderOfTimeAndAnyAgreesOnYesAndNo) {
  std::vector<SceneObject> objects = {
      floorSlab(), makeObject("table", makeBox({1.2, 0.8, 0.05}), {0, 0, 0.72}),
      makeObject("pole", Cylinder{0.05, 2.5}, {1.5, 0.5, 1.3}),
      makeObject("cupboard", makeBox({0.5, 1.2, 1.9}), {-1.5, -1, 1.0}),
      makeObject("lamp", Sphere{0.2}, {0.5, 1.5, 1.6})};
  TestWorld world(objects);
  std::mt19937_64 generator(11);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  int contacts = 0;
  for (int n = 0; n < 150; ++n) {
    PoseArray poses(world.walker.skeleton.size());
    const Eigen::Vector2d from(3 * number(generator), 3 * number(generator)),
        way(number(generator), number(generator));
    const double heading = kPi * number(generator), turn = number(generator);
    for (int i = 0; i <= 40; ++i) {
      const double t = i / 40.0;
      poses.append(world.walker.standing(from.x() + t * way.x(), from.y() + t * way.y(),
                                         heading + t * turn));
    }
    const auto first = world.check(poses, true), any = world.check(poses, true, true);
    ASSERT_EQ(first.has_value(), any.has_value());
    if (!first) continue;
    ++contacts;
    EXPECT_LE(first->frame + first->between, any->frame + any->between + 1.0);
    for (int i = 0; i < first->frame; ++i)
      EXPECT_FALSE(world.world.checkPose(poses[i], *world.scratch));
  }
  EXPECT_GT(contacts, 20);
  EXPECT_LT(contacts, 130);
}

TEST(CollisionWorld, WhatItCallsFreeIsFreeAtAThousandMomentsBetween) {
  TestWorld world({floorSlab(), makeObject("table", makeBox({1.2, 0.8, 0.05}), {0, 0, 0.72}),
                   makeObject("pole", Cylinder{0.05, 2.5}, {0.9, 0.3, 1.3})});
  std::mt19937_64 generator(12);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  int free = 0;
  for (int n = 0; n < 60; ++n) {
    Pose a = world.walker.standing(1.2 * number(generator), 1.2 * number(generator),
                                   kPi * number(generator));
    a.p_WR.z() += 0.15;
    Pose b = a;
    b.p_WR += Eigen::Vector3d(0.1 * number(generator), 0.1 * number(generator), 0);
    for (Eigen::Quaterniond& q : b.rotations)
      q = q * expRotation(0.15 *
                          Eigen::Vector3d(number(generator), number(generator), number(generator)));
    const PoseArray poses = motionOf(world.walker, {a, b});
    if (world.check(poses, false)) continue;
    ++free;
    Pose between;
    between.rotations.resize(a.rotations.size());
    for (int i = 0; i <= 1000; ++i) {
      interpolatePose(a, b, i / 1000.0, between);
      EXPECT_FALSE(world.checkPose(between)) << world.partOf(world.checkPose(between));
    }
  }
  EXPECT_GT(free, 5);
}

TEST(CollisionWorld, AnswersDoNotChangeWhenSceneAndBodyAreMovedTogether) {
  std::vector<SceneObject> objects = {
      makeObject("table", makeBox({1.2, 0.8, 0.05}), {0, 0, 0.72}),
      makeObject("pole", Cylinder{0.05, 2.5}, {0.9, 0.3, 1.3}),
      makeObject("cupboard", makeBox({0.5, 1.2, 1.9}), {-1.2, -1, 1.0})};
  SceneObject floor = floorSlab();
  objects.push_back(floor);
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  X.linear() = aboutZ(2.1).toRotationMatrix();
  X.translation() = Eigen::Vector3d(4, -3, 0);
  std::vector<SceneObject> moved = objects;
  for (SceneObject& object : moved) object.X_WO = X * object.X_WO;
  TestWorld here(objects), there(moved);
  std::mt19937_64 generator(13);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  for (int n = 0; n < 300; ++n) {
    const Pose pose =
        here.walker.standing(2 * number(generator), 2 * number(generator), kPi * number(generator));
    Pose other = pose;
    other.p_WR = X * pose.p_WR;
    other.rotations[0] = Eigen::Quaterniond(X.linear()) * pose.rotations[0];
    EXPECT_EQ(here.checkPose(pose).has_value(), there.checkPose(other).has_value());
  }
}

TEST(CollisionWorld, ClearanceIsTheDistanceOfTheNearestPart) {
  TestWorld world({floorSlab(), makeObject("wall", Box{{0.1, 9, 2.5}}, {1.05, 0, 1.25})});
  const PoseArray poses = motionOf(
      world.walker, {standingAt(world.walker, {0.2, 0, 0}), standingAt(world.walker, {0.0, 0, 0}),
                     standingAt(world.walker, {0.3, 0, 0})});
  // The toes are farthest ahead: toe tip 0.19 m before the root.
  const Clearance nearest = world.world.clearance(poses, 2.0, *world.scratch);
  EXPECT_EQ(nearest.frame, 2);
  EXPECT_EQ(nearest.object, 1);
  EXPECT_NE(world.walker.body.parts[nearest.part].name.find("toes"), std::string::npos);
  EXPECT_NEAR(nearest.distance, 1.0 - 0.3 - 0.19, 1e-4);
  const Clearance none = world.world.clearance(poses, 0.4, *world.scratch);
  EXPECT_EQ(none.object, -1);
  EXPECT_EQ(none.distance, 0.4);
}

// Of three frames that are looked at, of nine, the parts that are nearest to the wall are 0.41,
// 0.31 and 0.21 m away, soles apart.
TEST(CollisionWorld, NearnessIsWhatIsMissingOfTheLimitFrameByFrame) {
  TestWorld world({floorSlab(), makeObject("wall", Box{{0.1, 9, 2.5}}, {1.05, 0, 1.25})});
  const auto clearanceAt = [&](double x) {
    double least = HUGE_VAL;
    const PoseArray poses = motionOf(world.walker, {standingAt(world.walker, {x, 0, 0})});
    std::vector<JointFrame> joints(world.walker.skeleton.size());
    const size_t parts = world.walker.body.parts.size();
    std::vector<Eigen::Vector3d> from(parts), to(parts);
    forwardKinematics(world.walker.skeleton, poses[0], joints);
    placeBody(world.walker.body, joints, from, to);
    for (size_t i = 0; i < parts; ++i) {
      const BodyPart& part = world.walker.body.parts[i];
      if (part.sole < 0)
        least = std::min(least, 1.0 - std::max(from[i].x(), to[i].x()) - part.radius);
    }
    return least;
  };
  std::vector<Pose> frames;
  double expected = 0.0;
  constexpr double kLimit = 0.7;
  for (int i = 0; i < 9; ++i) {
    const double x = 0.05 * i;
    frames.push_back(standingAt(world.walker, {x, 0, 0}));
    if (i % 4 == 0) expected += 4.0 * std::max(0.0, 1.0 - clearanceAt(x) / kLimit);
  }
  const PoseArray poses = motionOf(world.walker, frames);
  EXPECT_GT(expected, 1.0);
  EXPECT_NEAR(world.world.nearness(poses, kLimit, *world.scratch), expected, 1e-6);
  EXPECT_EQ(world.world.nearness(poses, 0.1, *world.scratch), 0.0);
}

TEST(CollisionWorld, ClearanceLeavesOutTheGround) {
  TestWorld world({floorSlab()});
  const PoseArray poses = motionOf(world.walker, {standingAt(world.walker, {0, 0, 0})});
  EXPECT_EQ(world.world.clearance(poses, 1.0, *world.scratch).object, -1);
}

TEST(CollisionWorld, IgnoredThingsAreNotThere) {
  TestWorld world(
      {floorSlab(), makeObject("door", makeBox({1, 1, 2}), {0, 0, 1.1}, Role::kIgnore)});
  EXPECT_FALSE(world.checkPose(standingAt(world.walker, {0, 0, 0})));
}

TEST(CollisionWorld, ThreadsWithTheirOwnScratchAgree) {
  TestWorld world({floorSlab(), makeObject("table", makeBox({1.2, 0.8, 0.05}), {0, 0, 0.72})});
  const CollisionScratchPtr other = world.world.makeScratch();
  // One scratch is used before, the other is not: what was asked before does not matter.
  for (double x = -1.0; x <= 1.0; x += 0.1) {
    const Pose pose = standingAt(world.walker, {x, 0.2, 0});
    world.world.checkPose(standingAt(world.walker, {0, 0, 0}), *other);
    const auto a = world.world.checkPose(pose, *world.scratch),
               b = world.world.checkPose(pose, *other);
    ASSERT_EQ(a.has_value(), b.has_value());
    if (a) {
      EXPECT_EQ(a->part, b->part);
      EXPECT_EQ(a->object, b->object);
    }
  }
}

TEST(CollisionWorld, EveryPartThatTouchesIsListedOnceAndTheFirstIsTheVerdict) {
  TestWorld world({floorSlab(), makeObject("table", makeBox({1.2, 0.8, 0.05}), {0, 0, 0.72}),
                   makeObject("cupboard", makeBox({0.5, 1.2, 1.9}), {-1.0, -1, 1.0})});
  std::mt19937_64 generator(31);
  std::uniform_real_distribution<double> place(-1.5, 1.5), turn(-3.0, 3.0);
  int touching = 0;
  for (int n = 0; n < 150; ++n) {
    const Pose pose = world.walker.standing(place(generator), place(generator), turn(generator));
    const auto all = world.world.contacts(pose, *world.scratch);
    const auto one = world.checkPose(pose);
    ASSERT_EQ(one.has_value(), !all.empty());
    touching += !all.empty();
    for (size_t i = 0; i < all.size(); ++i) {
      if (i > 0) {
        EXPECT_GT(all[i].part, all[i - 1].part);
      }
      const BodyPart& part = world.walker.body.parts[all[i].part];
      std::vector<JointFrame> joints(world.walker.skeleton.size());
      forwardKinematics(world.walker.skeleton, pose, joints);
      const int object =
          world.world.touched(joints[part.joint] * part.from, joints[part.joint] * part.to,
                              part.radius, *world.scratch);
      if (all[i].object > 0) {
        EXPECT_EQ(object, all[i].object);
      }
    }
  }
  EXPECT_GT(touching, 20);
}

TEST(CollisionWorld, ClearanceIsCutAtItsLimit) {
  TestWorld world({floorSlab(), makeObject("wall", makeBox({0.1, 5, 2}), {2, 0, 1.1})});
  const PoseArray poses = motionOf(
      world.walker, {standingAt(world.walker, {0, 0, 0}), standingAt(world.walker, {0.5, 0, 0})});
  const Clearance all = world.world.clearance(poses, 5.0, *world.scratch);
  EXPECT_EQ(all.frame, 1);
  EXPECT_EQ(all.object, 1);
  const Clearance near = world.world.clearance(poses, 0.5 * all.distance, *world.scratch);
  EXPECT_EQ(near.object, -1);
  EXPECT_EQ(near.distance, 0.5 * all.distance);
}

}  // namespace
}  // namespace amble

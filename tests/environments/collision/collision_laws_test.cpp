// What holds of bodies in any scene: both checkers agree, nothing depends on order, thread or what
// was asked before, distances change no faster than bodies move.
#include <gtest/gtest.h>

#include <cmath>

#include "base/parallel.h"
#include "environments/collision/collision_world.h"
#include "tests/environments/random_scenes.h"
#include "tests/environments/test_walker.h"

namespace amble {
namespace {

// Somebody among things that are drawn.
struct DrawnWorld {
  explicit DrawnWorld(std::vector<SceneObject> objects, Checker checker = Checker::kFast)
      : scene(sceneOf(std::move(objects))),
        world(scene, ground, walker.skeleton, walker.body, {}, checker) {}

  PoseArray motion(const std::vector<Pose>& poses) const {
    PoseArray array(walker.skeleton.size());
    for (const Pose& pose : poses) array.append(pose);
    return array;
  }
  std::optional<Contact> check(const std::vector<Pose>& poses, bool any = false) {
    return world.check(motion(poses), solesOf(static_cast<int>(poses.size()), false), any,
                       *scratch);
  }
  double clearance(const Pose& pose, double limit) {
    return world.clearance(motion({pose}), limit, *scratch).distance;
  }

  TestWalker walker;
  Scene scene;
  SceneGround ground{scene, 0.0};
  CollisionWorld world;
  CollisionScratchPtr scratch = world.makeScratch();
};

Pose drawnPose(const TestWalker& walker, SampleStream& random, double bent = 0.2) {
  Pose pose = walker.standing(random.uniform(-4, 4), random.uniform(-4, 4), random.uniform(-3, 3));
  pose.p_WR.z() += 0.1;
  for (size_t i = 1; i < pose.rotations.size(); ++i)
    pose.rotations[i] = pose.rotations[i] * expRotation(drawnVector(random, bent));
  return pose;
}

Pose driftedPose(const Pose& pose, SampleStream& random, double way, double turn) {
  Pose next = pose;
  next.p_WR += drawnVector(random, way);
  for (Eigen::Quaterniond& q : next.rotations) q = q * expRotation(drawnVector(random, turn));
  return next;
}

std::vector<Pose> drawnFlight(const TestWalker& walker, SampleStream& random, int frames) {
  std::vector<Pose> poses = {drawnPose(walker, random)};
  while (static_cast<int>(poses.size()) < frames)
    poses.push_back(driftedPose(poses.back(), random, 0.06, 0.05));
  return poses;
}

Pose movedPose(Pose pose, const Eigen::Isometry3d& X) {
  pose.p_WR = X * pose.p_WR;
  pose.rotations[0] = Eigen::Quaterniond(X.linear()) * pose.rotations[0];
  return pose;
}

TEST(CollisionLaws, BothCheckersSayWhetherAPoseTouches) {
  for (const std::uint64_t seed : {1, 2}) {
    DrawnWorld fast(drawnThings(seed, 30)), fcl(drawnThings(seed, 30), Checker::kFcl);
    SampleStream random(seed, 1);
    int touching = 0, free = 0;
    for (int n = 0; n < 90; ++n) {
      const Pose pose = drawnPose(fast.walker, random);
      const bool touches = fast.world.checkPose(pose, *fast.scratch).has_value();
      (touches ? touching : free) += 1;
      ASSERT_EQ(fcl.world.checkPose(pose, *fcl.scratch).has_value(), touches) << n;
    }
    EXPECT_GT(touching, 10);
    EXPECT_GT(free, 10);
  }
}

TEST(CollisionLaws, BothCheckersHaveTheSameDistances) {
  DrawnWorld fast(drawnThings(3, 15)), fcl(drawnThings(3, 15), Checker::kFcl);
  SampleStream random(3, 1);
  for (int n = 0; n < 60; ++n) {
    const Pose pose = drawnPose(fast.walker, random);
    EXPECT_NEAR(fast.clearance(pose, 0.6), fcl.clearance(pose, 0.6), 1e-4) << n;
  }
}

TEST(CollisionLaws, BothCheckersRefuseTheSameMotions) {
  DrawnWorld fast(drawnThings(4, 20)), fcl(drawnThings(4, 20), Checker::kFcl);
  SampleStream random(4, 1);
  int refused = 0;
  for (int n = 0; n < 25; ++n) {
    const auto poses = drawnFlight(fast.walker, random, 12);
    const auto a = fast.check(poses), b = fcl.check(poses);
    ASSERT_EQ(a.has_value(), b.has_value()) << n;
    refused += a.has_value();
    if (!a) continue;
    EXPECT_EQ(a->frame, b->frame) << n;
  }
  EXPECT_GT(refused, 3);
  EXPECT_LT(refused, 25);
}

// A body that only moves, moves every point as far.
TEST(CollisionLaws, ClearanceChangesNoFasterThanABodyMoves) {
  DrawnWorld here(drawnThings(5, 15));
  SampleStream random(5, 1);
  int near = 0;
  for (int n = 0; n < 300; ++n) {
    const Pose pose = drawnPose(here.walker, random);
    Pose beside = pose;
    const Eigen::Vector3d by = drawnVector(random, 0.3);
    beside.p_WR += by;
    const double a = here.clearance(pose, 0.8), b = here.clearance(beside, 0.8);
    near += a < 0.8 && b < 0.8 && a > 0.0;
    EXPECT_LE(std::abs(a - b), by.norm() + 1e-6) << n;
  }
  EXPECT_GT(near, 100);
}

TEST(CollisionLaws, ABodyWithClearanceTouchesNothingAndOneWithoutDoes) {
  DrawnWorld here(drawnThings(6, 20));
  SampleStream random(6, 1);
  for (int n = 0; n < 200; ++n) {
    const Pose pose = drawnPose(here.walker, random);
    const double clearance = here.clearance(pose, 0.5);
    const auto contact = here.world.checkPose(pose, *here.scratch);
    EXPECT_EQ(contact.has_value(), clearance <= 0.0) << n << " " << clearance;
  }
}

TEST(CollisionLaws, AHigherLimitChangesNoDistanceBelowTheLower) {
  DrawnWorld here(drawnThings(7, 20));
  SampleStream random(7, 1);
  for (int n = 0; n < 150; ++n) {
    const PoseArray pose = here.motion({drawnPose(here.walker, random)});
    const Clearance low = here.world.clearance(pose, 0.2, *here.scratch),
                    high = here.world.clearance(pose, 0.7, *here.scratch);
    EXPECT_NEAR(low.distance, std::min(0.2, high.distance), 1e-12);
    if (low.object >= 0 && low.distance > 0.0) {
      EXPECT_EQ(low.part, high.part);
      EXPECT_EQ(low.object, high.object);
    }
  }
}

TEST(CollisionLaws, ClearanceIsTheLeastOfThatOfEveryPart) {
  DrawnWorld here(drawnThings(8, 20));
  SampleStream random(8, 1);
  const int parts = static_cast<int>(here.walker.body.parts.size());
  for (int n = 0; n < 25; ++n) {
    const PoseArray poses = here.motion(drawnFlight(here.walker, random, 6));
    const Clearance least = here.world.clearance(poses, 0.5, *here.scratch);
    const PartClearances all = here.world.clearances(poses, 0.5, *here.scratch);
    ASSERT_EQ(static_cast<int>(all.distance.size()), 6 * parts);
    const double at_frames = *std::min_element(all.distance.begin(), all.distance.end());
    EXPECT_LE(least.distance, at_frames + 1e-9);
    for (size_t i = 0; i < all.distance.size(); ++i)
      EXPECT_EQ(all.object[i] < 0, all.distance[i] >= 0.5) << i;
    if (least.object >= 0 && least.between == 0.0) {
      EXPECT_NEAR(least.distance, at_frames, 1e-9);
      EXPECT_NEAR(all.distance[least.frame * parts + least.part], least.distance, 1e-9);
    }
  }
}

// Something may be passed between two frames more closely than at either.
TEST(CollisionLaws, ClearanceIsThatOfTheMotionBetweenItsFramesToo) {
  constexpr int kPieces = 32;
  DrawnWorld here(drawnThings(8, 20));
  SampleStream random(8, 2);
  int between = 0;
  for (int n = 0; n < 60; ++n) {
    const Pose first = drawnPose(here.walker, random);
    const PoseArray poses = here.motion({first, driftedPose(first, random, 0.02, 0.8)});
    PoseArray fine(here.walker.skeleton.size());
    Pose pose;
    pose.rotations.resize(static_cast<size_t>(here.walker.skeleton.size()));
    for (int i = 0; i < kPieces * (poses.size() - 1); ++i) {
      interpolatePose(poses[i / kPieces], poses[i / kPieces + 1],
                      static_cast<double>(i % kPieces) / kPieces, pose);
      fine.append(pose);
    }
    const PartClearances all = here.world.clearances(fine, 0.5, *here.scratch);
    const Clearance least = here.world.clearance(poses, 0.5, *here.scratch);
    const double finest = *std::min_element(all.distance.begin(), all.distance.end());
    EXPECT_LE(least.distance, finest + kClearanceGap) << n;
    if (least.object < 0) continue;
    between += least.between > 0.0;
    interpolatePose(poses[least.frame], poses[std::min(least.frame + 1, poses.size() - 1)],
                    least.between, pose);
    EXPECT_NEAR(here.clearance(pose, 0.5), least.distance, 1e-9) << n;
  }
  EXPECT_GT(between, 3);
}

TEST(CollisionLaws, OneMoreThingBringsNothingFartherAwayAndFreesNoMotion) {
  auto objects = drawnThings(9, 20);
  DrawnWorld all(objects);
  objects.resize(12);
  DrawnWorld fewer(objects);
  SampleStream random(9, 1);
  int only_more = 0;
  for (int n = 0; n < 60; ++n) {
    const auto poses = drawnFlight(all.walker, random, 8);
    const bool touches_all = all.check(poses).has_value();
    const bool touches_fewer = fewer.check(poses).has_value();
    EXPECT_LE(touches_fewer, touches_all) << n;
    only_more += touches_all && !touches_fewer;
    EXPECT_LE(all.clearance(poses[0], 0.5), fewer.clearance(poses[0], 0.5) + 1e-9);
    EXPECT_GE(all.world.nearness(all.motion(poses), 0.5, *all.scratch),
              fewer.world.nearness(fewer.motion(poses), 0.5, *fewer.scratch) - 1e-6);
  }
  EXPECT_GT(only_more, 0);
}

TEST(CollisionLaws, TheOrderOfThingsChangesNoDistance) {
  auto objects = drawnThings(10, 20);
  DrawnWorld usual(objects);
  std::reverse(objects.begin() + 1, objects.end());
  DrawnWorld other(objects);
  const int last = static_cast<int>(objects.size()) - 1;
  SampleStream random(10, 1);
  for (int n = 0; n < 120; ++n) {
    const PoseArray pose = usual.motion({drawnPose(usual.walker, random)});
    const Clearance a = usual.world.clearance(pose, 0.6, *usual.scratch),
                    b = other.world.clearance(pose, 0.6, *other.scratch);
    EXPECT_EQ(a.distance, b.distance);
    if (a.object > 0 && a.distance > 0.0) {
      EXPECT_EQ(a.object, last + 1 - b.object);
    }
  }
}

// The farther of the two from the origin loses digits.
TEST(CollisionLaws, DistancesGoAlongWithSceneAndBody) {
  const auto objects = drawnThings(11, 20);
  DrawnWorld here(objects);
  for (const double angle : {0.7, 2.9}) {
    const Eigen::Isometry3d X = turnedAndMoved(angle, {120.0, -75.0, 0.0});
    DrawnWorld there(movedObjects(objects, X));
    SampleStream random(11, 1);
    for (int n = 0; n < 80; ++n) {
      const Pose pose = drawnPose(here.walker, random);
      EXPECT_NEAR(here.clearance(pose, 0.6), there.clearance(movedPose(pose, X), 0.6), 1e-5);
    }
  }
}

TEST(CollisionLaws, AMotionBackIsRefusedWhereTheMotionIs) {
  DrawnWorld here(drawnThings(12, 25));
  SampleStream random(12, 1);
  int refused = 0;
  for (int n = 0; n < 60; ++n) {
    auto poses = drawnFlight(here.walker, random, 8);
    const bool there = here.check(poses).has_value();
    std::reverse(poses.begin(), poses.end());
    EXPECT_EQ(here.check(poses).has_value(), there) << n;
    refused += there;
  }
  EXPECT_GT(refused, 5);
}

TEST(CollisionLaws, AMotionIsFreeWhereEachOfItsStepsIs) {
  DrawnWorld here(drawnThings(13, 25));
  SampleStream random(13, 1);
  int free = 0, refused = 0;
  for (int n = 0; n < 60; ++n) {
    const auto poses = drawnFlight(here.walker, random, 7);
    std::optional<int> first;
    for (int i = 0; i + 1 < 7 && !first; ++i)
      if (here.check({poses[i], poses[i + 1]})) first = i;
    const auto whole = here.check(poses);
    ASSERT_EQ(whole.has_value(), first.has_value()) << n;
    (whole ? refused : free) += 1;
    if (whole) {
      EXPECT_LE(std::abs(whole->frame - *first), 1) << n;
    }
  }
  EXPECT_GT(free, 5);
  EXPECT_GT(refused, 5);
}

TEST(CollisionLaws, AContactIsToldWhereItIs) {
  DrawnWorld here(drawnThings(14, 25));
  SampleStream random(14, 1);
  int told = 0;
  for (int n = 0; n < 80; ++n) {
    const auto poses = drawnFlight(here.walker, random, 8);
    const auto contact = here.check(poses);
    if (!contact || contact->object == 0) continue;
    ++told;
    ASSERT_GE(contact->frame, 0);
    ASSERT_LT(contact->frame, 8);
    ASSERT_GE(contact->between, 0.0);
    ASSERT_LT(contact->between, 1.0);
    Pose moment = poses[contact->frame];
    if (contact->between > 0.0)
      interpolatePose(poses[contact->frame], poses[contact->frame + 1], contact->between, moment);
    const PartClearances at = here.world.clearances(here.motion({moment}), 0.1, *here.scratch);
    EXPECT_LE(at.distance[contact->part], kProofGap + 1e-6) << n;
    EXPECT_LE(contact->gap, kProofGap + 1e-6);
  }
  EXPECT_GT(told, 10);
}

TEST(CollisionLaws, ThreadsAndUsedScratchMemoryChangeNothing) {
  DrawnWorld here(drawnThings(15, 25));
  SampleStream random(15, 1);
  std::vector<PoseArray> motions;
  for (int n = 0; n < 40; ++n)
    motions.push_back(here.motion(drawnFlight(here.walker, random, 3 + n % 30)));
  struct Answer {
    std::optional<Contact> contact;
    Clearance clearance;
    double nearness = 0.0;
  };
  const auto ask = [&](int i, CollisionScratch& scratch) {
    const PoseArray& poses = motions[i];
    return Answer{here.world.check(poses, solesOf(poses.size(), false), i % 2 == 0, scratch),
                  here.world.clearance(poses, 0.4, scratch),
                  here.world.nearness(poses, 0.4, scratch)};
  };
  std::vector<Answer> threaded(motions.size());
  std::vector<CollisionScratchPtr> scratches;
  for (int i = 0; i < 3; ++i) scratches.push_back(here.world.makeScratch());
  parallelFor(static_cast<int>(motions.size()), 3,
              [&](int i, int thread) { threaded[i] = ask(i, *scratches[thread]); });
  for (int i = 0; i < static_cast<int>(motions.size()); ++i) {
    const CollisionScratchPtr fresh = here.world.makeScratch();
    const Answer alone = ask(i, *fresh);
    ASSERT_EQ(threaded[i].contact.has_value(), alone.contact.has_value());
    if (alone.contact) {
      EXPECT_EQ(threaded[i].contact->frame, alone.contact->frame);
      EXPECT_EQ(threaded[i].contact->between, alone.contact->between);
      EXPECT_EQ(threaded[i].contact->part, alone.contact->part);
      EXPECT_EQ(threaded[i].contact->object, alone.contact->object);
    }
    EXPECT_EQ(threaded[i].clearance.distance, alone.clearance.distance);
    EXPECT_EQ(threaded[i].clearance.part, alone.clearance.part);
    EXPECT_EQ(threaded[i].nearness, alone.nearness);
  }
}

TEST(CollisionLaws, WhatIsInTheWayOfAThinnerCapsuleIsInTheWayOfAThicker) {
  DrawnWorld here(drawnThings(16, 25));
  SampleStream random(16, 1);
  const Eigen::AlignedBox3d region(Eigen::Vector3d(-4, -4, 0.1), Eigen::Vector3d(4, 4, 2));
  int touched = 0;
  for (int n = 0; n < 1500; ++n) {
    const Eigen::Vector3d from = drawnPoint(random, region), to = from + drawnVector(random, 0.6);
    bool before = false;
    for (const double radius : {0.01, 0.05, 0.12, 0.3}) {
      const bool now = here.world.touched(from, to, radius, *here.scratch) >= 0;
      EXPECT_LE(before, now);
      EXPECT_EQ(here.world.touched(to, from, radius, *here.scratch) >= 0, now);
      before = now;
    }
    touched += before;
  }
  EXPECT_GT(touched, 150);
}

}  // namespace
}  // namespace amble

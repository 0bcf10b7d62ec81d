#include "environments/collision/clearance_field.h"

#include <gtest/gtest.h>

#include <atomic>
#include <limits>

#include "base/rotation.h"
#include "tests/environments/test_scenes.h"

namespace amble {
namespace {

// Furniture as meshes and primitives, turned, with solids and an open surface.
std::vector<SceneObject> furniture() {
  std::vector<SceneObject> objects = {
      makeObject("table", makeBox({1.2, 0.8, 0.04}), {0, 0, 0.75}),
      makeObject("cupboard", makeBox({0.6, 1.0, 1.9}), {1.5, 1.0, 0.95}),
      makeObject("shell", joined(makeBox({1.5, 1.5, 1.5}), makeBox({1.3, 1.3, 1.3})),
                 {-1.5, -1.5, 0.8}),
      makeObject("ball", makeSphere(0.35), {-1, 1, 0.5}),
      makeObject("wall", makeBox({6, 0.1, 2.5}), {0, 2.4, 1.25}),
      makeObject("pole", Cylinder{0.1, 1.8}, {1.2, -1.2, 0.9}),
      makeObject("box", Box{{0.5, 0.7, 0.3}}, {0.3, -1.9, 0.3}),
      makeObject("bolster", CapsuleShape{0.15, 0.9}, {-0.4, 1.7, 0.6}),
      makeObject("globe", Sphere{0.3}, {1.9, -0.3, 1.4})};
  for (size_t i = 0; i < objects.size(); ++i)
    objects[i].X_WO.linear() =
        (aboutZ(0.3 * i) * expRotation({0.2 * (i % 3), 0.1 * (i % 4), 0})).toRotationMatrix();
  TriangleMesh scan = makeBox({0.8, 0.8, 0.8});
  scan.triangles.pop_back();
  objects.push_back(makeObject("scan", scan, {0.2, 0.9, 1.7}));
  return objects;
}

std::vector<Obstacle> obstaclesOf(const std::vector<SceneObject>& objects) {
  std::vector<Obstacle> obstacles;
  for (size_t i = 0; i < objects.size(); ++i)
    obstacles.push_back(obstacleOf(objects[i], static_cast<int>(i)));
  return obstacles;
}

const Eigen::AlignedBox3d kRoom(Eigen::Vector3d(-3, -3, -0.2), Eigen::Vector3d(3, 3, 2.2));

TEST(ClearanceField, AnswersNothingOutsideItsRegion) {
  const ClearanceField field(obstaclesOf(furniture()), kRoom);
  EXPECT_EQ(field.lowerBound({9, 0, 1}), 0.0);
  EXPECT_EQ(field.lowerBound({0, 0, 1e300}), 0.0);
  EXPECT_EQ(field.lowerBound({0, std::numeric_limits<double>::quiet_NaN(), 1}), 0.0);
  const ClearanceField none({}, {});
  EXPECT_EQ(none.lowerBound({0, 0, 0}), 0.0);
}

TEST(ClearanceField, IsNeverAboveTheTrueDistance) {
  const std::vector<Obstacle> obstacles = obstaclesOf(furniture());
  const ClearanceField field(obstacles, kRoom);
  const ObstacleSet exact(obstacles);
  const auto scratch = ObstacleSet::makeScratch();
  std::mt19937_64 generator(9);
  int inside = 0, useful = 0;
  for (int n = 0; n < 20000; ++n) {
    Capsule point = randomCapsule(generator, kRoom, 0.0);
    point.radius = 1e-4;
    const double bound = field.lowerBound(point.from);
    if (bound == 0.0) continue;
    // As a yes or no, which is exact to 1e-6 m, and which knows insides.
    Capsule ball = point;
    ball.radius = bound - 1e-5;
    EXPECT_EQ(exact.touched(ball, *scratch), -1) << point.from.transpose() << " bound " << bound;
    inside += exact.touched(point, *scratch) >= 0;
    useful += bound > 0.1;
  }
  EXPECT_EQ(inside, 0);
  EXPECT_GT(useful, 5000);
}

TEST(ClearanceField, IsNoMoreThanTwoVoxelsShort) {
  const std::vector<Obstacle> obstacles =
      obstaclesOf({makeObject("box", makeBox({1, 1, 1}), {0, 0, 1})});
  const ClearanceField field(obstacles, kRoom);
  // Above a face, where the distance is the difference of heights.
  for (double z = 1.55; z < 2.0; z += 0.01) {
    const double bound = field.lowerBound({0.1, 0.2, z});
    EXPECT_LE(bound, z - 1.5);
    EXPECT_GE(bound, z - 1.5 - 2.0 * field.voxel() - 0.003);
  }
}

// In all directions and at all distances that are told apart: along each axis two voxels are known
// to within one each, and a thing's own voxel is a little larger than it.
TEST(ClearanceField, IsFewVoxelsShortOfASmallBallInAnyDirection) {
  const Eigen::Vector3d middle(0.31, -0.47, 1.02);
  const double radius = 0.03;
  const ClearanceField field(obstaclesOf({makeObject("ball", Sphere{radius}, middle)}), kRoom);
  const double short_of = 3.5 * std::sqrt(3.0) * field.voxel();
  std::mt19937_64 generator(13);
  int far = 0;
  for (int n = 0; n < 20000; ++n) {
    const Eigen::Vector3d p = randomCapsule(generator, kRoom, 0.0).from;
    const double distance = (p - middle).norm() - radius, bound = field.lowerBound(p);
    if (bound == 0.0) continue;  // beyond the voxels that fill the region
    EXPECT_LE(bound, distance);
    EXPECT_GE(bound, std::min(distance, ClearanceField::kFarthest) - short_of);
    far += bound > 0.9 * ClearanceField::kFarthest;
  }
  EXPECT_GT(far, 5000);
}

TEST(ClearanceField, NeverCallsATouchingCapsuleFree) {
  const std::vector<Obstacle> obstacles = obstaclesOf(furniture());
  const ClearanceField field(obstacles, kRoom);
  const ObstacleSet exact(obstacles);
  const auto scratch = ObstacleSet::makeScratch();
  std::mt19937_64 generator(10);
  int both = 0;
  for (int n = 0; n < 20000; ++n) {
    const Capsule capsule = randomCapsule(generator, kRoom);
    if (!field.isFree(capsule)) continue;
    ++both;
    EXPECT_EQ(exact.touched(capsule, *scratch), -1);
  }
  EXPECT_GT(both, 2000);
}

TEST(ClearanceField, KnowsWhatLiesOutsideItsRegion) {
  // A ceiling above the region and a wall beside it.
  const std::vector<Obstacle> obstacles =
      obstaclesOf({makeObject("ceiling", makeBox({9, 9, 0.1}), {0, 0, 2.35}),
                   makeObject("wall", makeBox({0.1, 9, 3}), {3.2, 0, 1})});
  const ClearanceField field(obstacles, kRoom);
  for (double z = 0.0; z < 2.2; z += 0.01) EXPECT_LE(field.lowerBound({0, 0, z}), 2.3 - z);
  for (double x = 0.0; x < 3.0; x += 0.01) EXPECT_LE(field.lowerBound({x, 0, 1}), 3.15 - x);
}

TEST(ClearanceField, LargeRegionsGetCoarserVoxels) {
  const Eigen::AlignedBox3d large(Eigen::Vector3d(-100, -100, 0), Eigen::Vector3d(100, 100, 2));
  const ClearanceField field(obstaclesOf({makeObject("box", makeBox({1, 1, 1}), {0, 0, 1})}),
                             large);
  EXPECT_GT(field.voxel(), 0.2);
  EXPECT_EQ(field.lowerBound({0, 0, 1}), 0.0);
  EXPECT_GT(field.lowerBound({50, 50, 1}), 0.6);
}

TEST(ClearanceField, WhatIsAddedOnlyLowersIt) {
  std::vector<SceneObject> objects = furniture();
  const ClearanceField all(obstaclesOf(objects), kRoom);
  objects.resize(objects.size() / 2);
  const ClearanceField some(obstaclesOf(objects), kRoom);
  std::mt19937_64 generator(12);
  int lower = 0;
  for (int n = 0; n < 5000; ++n) {
    const Eigen::Vector3d p = randomCapsule(generator, kRoom, 0.0).from;
    EXPECT_LE(all.lowerBound(p), some.lowerBound(p));
    lower += all.lowerBound(p) < some.lowerBound(p);
  }
  EXPECT_GT(lower, 500);
}

TEST(ClearanceField, StoppedInTheMiddleThrows) {
  const std::atomic<bool> stop{true};
  EXPECT_THROW(ClearanceField(obstaclesOf(furniture()), kRoom, {&stop, {}}), Stopped);
}

}  // namespace
}  // namespace amble

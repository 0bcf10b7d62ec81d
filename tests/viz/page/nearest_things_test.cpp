#include "viz/page/nearest_things.h"

#include <gtest/gtest.h>

#include "tests/animation/random_clip.h"
#include "tests/environments/test_scenes.h"
#include "tests/environments/test_walker.h"

namespace amble {
namespace {

using Eigen::Vector3d;

// Somebody who stands in several places of a room, one a frame.
struct Standing {
  explicit Standing(std::vector<SceneObject> objects) : scene(sceneOf(std::move(objects))) {}

  void at(double x, double y, double heading = 0.0) {
    poses.append(walker.standing(x, y, heading));
  }
  PageClearance nearest() const { return nearestThings(world, walker.skeleton, poses); }

  /// Distance of a point to the axis of a part, less its radius.
  double toPart(int frame, int part, const Vector3d& p) const {
    std::vector<JointFrame> joints(walker.skeleton.size());
    forwardKinematics(walker.skeleton, poses[frame], joints);
    const BodyPart& one = walker.body.parts[part];
    const Vector3d a = joints[one.joint] * one.from, b = joints[one.joint] * one.to;
    const Vector3d axis = b - a;
    const double share =
        axis.squaredNorm() > 0.0 ? std::clamp((p - a).dot(axis) / axis.squaredNorm(), 0.0, 1.0) : 0;
    return (p - a - share * axis).norm() - one.radius;
  }

  TestWalker walker;
  Scene scene;
  SceneGround ground{scene, 0.0};
  CollisionWorld world{scene, ground, walker.skeleton, walker.body};
  PoseArray poses{walker.skeleton.size()};
};

SceneObject boxAt(const char* name, const Vector3d& size, const Vector3d& at) {
  return makeObject(name, Box{size}, at);
}

// How far a point is from an upright box.
double toBox(const Vector3d& p, const Vector3d& size, const Vector3d& at) {
  return ((p - at).cwiseAbs() - 0.5 * size).cwiseMax(0.0).norm();
}

TEST(NearestThings, PointsAreOnTheBodyAndOnTheThingAndAsFarApartAsItSays) {
  const Vector3d size(0.5, 0.6, 1.1), place(1.0, 0.2, 0.55);
  Standing somebody({floorSlab(), boxAt("chest", size, place)});
  Generator random(1);
  for (int i = 0; i < 40; ++i)
    somebody.at(uniform(random, -0.6, 0.3), uniform(random, -1, 1), uniform(random, -3, 3));
  const PageClearance nearest = somebody.nearest();
  int seen = 0;
  for (int i = 0; i < somebody.poses.size(); ++i) {
    if (nearest.distance[i] < 0.0F) continue;
    ++seen;
    EXPECT_EQ(nearest.object[i], 1);
    const Vector3d on_body = nearest.on_body[i].cast<double>(),
                   on_it = nearest.on_it[i].cast<double>();
    EXPECT_NEAR((on_body - on_it).norm(), nearest.distance[i], 1e-4) << i;
    EXPECT_NEAR(toBox(on_it, size, place), 0.0, 1e-5) << i;
    EXPECT_NEAR(somebody.toPart(i, nearest.part[i], on_body), 0.0, 1e-5) << i;
  }
  EXPECT_GE(seen, 20);
}

// No point of the thing is nearer to any part: tried over its surface.
TEST(NearestThings, NothingIsNearer) {
  const Vector3d size(0.4, 0.4, 0.9), place(0.9, 0.0, 0.45);
  Standing somebody({floorSlab(), boxAt("stool", size, place)});
  for (int i = 0; i < 6; ++i) somebody.at(0.2 - 0.04 * i, 0.1 * i, 0.5 * i);
  const PageClearance nearest = somebody.nearest();
  Generator random(2);
  for (int i = 0; i < somebody.poses.size(); ++i) {
    ASSERT_GE(nearest.distance[i], 0.0F);
    for (int k = 0; k < 300; ++k) {
      Vector3d p = randomVector(random, 0.5);
      p[k % 3] = p[k % 3] < 0 ? -0.5 : 0.5;  // onto a side
      p = place + size.cwiseProduct(p);
      for (size_t part = 0; part < somebody.walker.body.parts.size(); ++part)
        EXPECT_GE(somebody.toPart(i, static_cast<int>(part), p), nearest.distance[i] - 1e-4);
    }
  }
}

TEST(NearestThings, OfTwoThingsTheNearerIsTold) {
  Standing somebody({floorSlab(), boxAt("left", {0.2, 0.2, 1.0}, {0, 1.0, 0.5}),
                     boxAt("right", {0.2, 0.2, 1.0}, {0, -1.0, 0.5})});
  somebody.at(0, 0.2);
  somebody.at(0, -0.2);
  EXPECT_EQ(somebody.nearest().object, (std::vector<int>{1, 2}));
}

TEST(NearestThings, MovedAndTurnedTogetherNothingChanges) {
  const auto distances = [](double heading, const Vector3d& shift) {
    const Eigen::AngleAxisd turn(heading, Vector3d::UnitZ());
    SceneObject box = boxAt("box", {0.3, 0.8, 1.2}, {0, 0, 0});
    box.X_WO = Eigen::Translation3d(shift + turn * Vector3d(0.8, 0.1, 0.6)) * turn;
    Standing somebody({floorSlab(), box});
    for (int i = 0; i < 5; ++i) {
      const Vector3d at = shift + turn * Vector3d(-0.05 * i, 0.2 * i - 0.4, 0);
      somebody.at(at.x(), at.y(), heading + 0.3 * i);
    }
    return somebody.nearest();
  };
  const PageClearance a = distances(0.0, {0, 0, 0}), b = distances(1.1, {1.0, -0.7, 0});
  for (size_t i = 0; i < a.distance.size(); ++i) {
    EXPECT_NEAR(a.distance[i], b.distance[i], 1e-4);
    EXPECT_EQ(a.part[i], b.part[i]);
  }
}

TEST(NearestThings, WhereNothingIsWithinAMetreNothingIsTold) {
  Standing somebody({floorSlab(), boxAt("far", {0.2, 0.2, 1.0}, {0, 2.5, 0.5})});
  somebody.at(0, 0);
  const PageClearance nearest = somebody.nearest();
  EXPECT_LT(nearest.distance[0], 0.0F);
  EXPECT_EQ(nearest.object[0], -1);
}

TEST(NearestThings, HasAnEntryForEveryFrameAndForNoneNone) {
  Standing somebody({floorSlab(), boxAt("box", {0.2, 0.2, 1.0}, {0, 0.9, 0.5})});
  EXPECT_TRUE(somebody.nearest().distance.empty());
  for (int i = 0; i < 7; ++i) somebody.at(0.0, 0.01 * i);
  const PageClearance nearest = somebody.nearest();
  for (const size_t size : {nearest.distance.size(), nearest.on_body.size(), nearest.on_it.size(),
                            nearest.part.size(), nearest.object.size()})
    EXPECT_EQ(size, 7u);
  for (int i = 1; i < 7; ++i) EXPECT_LE(nearest.distance[i], nearest.distance[i - 1] + 1e-6F);
}

}  // namespace
}  // namespace amble

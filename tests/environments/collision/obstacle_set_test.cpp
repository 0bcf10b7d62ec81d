#include "environments/collision/obstacle_set.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/rotation.h"
#include "tests/environments/test_scenes.h"

namespace amble {
namespace {

// Distance of a segment to a box about the origin, by bisection of a convex function along the
// segment.
double segmentToBox(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                    const Eigen::Vector3d& half) {
  const auto at = [&](double t) {
    return ((a + t * (b - a)).cwiseAbs() - half).cwiseMax(0.0).norm();
  };
  double low = 0.0, high = 1.0;
  for (int n = 0; n < 200; ++n) {
    const double u = low + (high - low) / 3.0, v = high - (high - low) / 3.0;
    (at(u) < at(v) ? high : low) = at(u) < at(v) ? v : u;
  }
  return at(0.5 * (low + high));
}

ObstacleSet setOf(const std::vector<SceneObject>& objects) {
  std::vector<Obstacle> obstacles;
  for (size_t i = 0; i < objects.size(); ++i)
    obstacles.push_back(obstacleOf(objects[i], static_cast<int>(i)));
  return ObstacleSet(std::move(obstacles));
}

TEST(ObstacleSet, OfNothingTouchesNothing) {
  const ObstacleSet none({});
  const auto scratch = ObstacleSet::makeScratch();
  EXPECT_EQ(none.touched({{0, 0, 0}, {1, 0, 0}, 1.0}, *scratch), -1);
  const auto nearest = none.nearest({{0, 0, 0}, {1, 0, 0}, 1.0}, 2.0, *scratch);
  EXPECT_EQ(nearest.object, -1);
  EXPECT_EQ(nearest.distance, 2.0);
}

TEST(ObstacleSet, DistancesToABoxAreThoseOfTheFormulaAsPrimitiveAndAsMesh) {
  const Eigen::Vector3d size(1.0, 0.6, 2.0);
  const ObstacleSet primitive = setOf({makeObject("box", Box{size}, {0, 0, 0})});
  const ObstacleSet mesh = setOf({makeObject("box", makeBox(size), {0, 0, 0})});
  const auto scratch = ObstacleSet::makeScratch();
  std::mt19937_64 generator(6);
  const Eigen::AlignedBox3d around(Eigen::Vector3d(-2, -2, -2), Eigen::Vector3d(2, 2, 2));
  for (int n = 0; n < 3000; ++n) {
    const Capsule capsule = randomCapsule(generator, around);
    const double gap = segmentToBox(capsule.from, capsule.to, 0.5 * size) - capsule.radius;
    for (const ObstacleSet* set : {&primitive, &mesh}) {
      if (std::abs(gap) > 1e-5) {
        EXPECT_EQ(set->touched(capsule, *scratch) >= 0, gap < 0.0) << gap;
      }
      const double distance = set->nearest(capsule, 10.0, *scratch).distance;
      EXPECT_NEAR(distance, std::max(0.0, gap), 2e-4) << (set == &mesh);
    }
  }
}

TEST(ObstacleSet, DistancesToRoundThingsAreThoseOfTheFormula) {
  const ObstacleSet set = setOf({makeObject("sphere", Sphere{0.5}, {0, 0, 0})});
  const ObstacleSet post = setOf({makeObject("capsule", CapsuleShape{0.2, 20.4}, {0, 0, 0})});
  const ObstacleSet pole = setOf({makeObject("cylinder", Cylinder{0.2, 20.0}, {0, 0, 0})});
  const auto scratch = ObstacleSet::makeScratch();
  std::mt19937_64 generator(7);
  const Eigen::AlignedBox3d around(Eigen::Vector3d(-2, -2, -2), Eigen::Vector3d(2, 2, 2));
  for (int n = 0; n < 2000; ++n) {
    const Capsule capsule = randomCapsule(generator, around);
    const double to_sphere =
        segmentToBox(capsule.from, capsule.to, Eigen::Vector3d::Zero()) - 0.5 - capsule.radius;
    EXPECT_NEAR(set.nearest(capsule, 10.0, *scratch).distance, std::max(0.0, to_sphere), 2e-4);
    // To a vertical axis only the plane's two coordinates count.
    const Eigen::Vector3d flat_from(capsule.from.x(), capsule.from.y(), 0),
        flat_to(capsule.to.x(), capsule.to.y(), 0);
    const double to_axis =
        segmentToBox(flat_from, flat_to, Eigen::Vector3d::Zero()) - 0.2 - capsule.radius;
    EXPECT_NEAR(post.nearest(capsule, 10.0, *scratch).distance, std::max(0.0, to_axis), 2e-4);
    EXPECT_NEAR(pole.nearest(capsule, 10.0, *scratch).distance, std::max(0.0, to_axis), 2e-4);
  }
}

TEST(ObstacleSet, WithinAClosedMeshIsAContactAndWithinAHollowOneIsNot) {
  const auto scratch = ObstacleSet::makeScratch();
  const Capsule small{{0, 0, 0}, {0, 0, 0.2}, 0.05};
  for (const bool flipped : {false, true}) {
    const TriangleMesh outer = flipped ? turned(makeBox({4, 4, 4})) : makeBox({4, 4, 4});
    const ObstacleSet solid = setOf({makeObject("cupboard", outer, {0, 0, 0})});
    EXPECT_EQ(solid.touched(small, *scratch), 0);
    EXPECT_EQ(solid.nearest(small, 1.0, *scratch).distance, 0.0);
    const ObstacleSet hollow =
        setOf({makeObject("room", joined(outer, makeBox({3, 3, 3})), {0, 0, 0})});
    EXPECT_EQ(hollow.touched(small, *scratch), -1);
    EXPECT_NEAR(hollow.nearest(small, 2.0, *scratch).distance, 1.5 - 0.25, 1e-4);
  }
  TriangleMesh open = makeBox({4, 4, 4});
  open.triangles.pop_back();
  EXPECT_EQ(setOf({makeObject("scan", open, {0, 0, 0})}).touched(small, *scratch), -1);
}

TEST(ObstacleSet, NamesTheFirstObjectThatItTouches) {
  const ObstacleSet set =
      setOf({makeObject("a", Box{{1, 1, 1}}, {5, 0, 0}), makeObject("b", Box{{1, 1, 1}}, {0, 0, 0}),
             makeObject("c", makeBox({1, 1, 1}), {0, 0, 0})});
  const auto scratch = ObstacleSet::makeScratch();
  EXPECT_EQ(set.touched({{0, 0, 0}, {0, 0, 0.1}, 0.1}, *scratch), 1);
  EXPECT_EQ(set.touched({{0, 0, 0}, {5, 0, 0}, 0.1}, *scratch), 0);
}

TEST(ObstacleSet, AnswersDoNotDependOnWhereInTheWorldTheSceneIs) {
  std::vector<SceneObject> objects = {makeObject("table", makeBox({1, 2, 0.05}), {0, 0, 0.7}),
                                      makeObject("pole", Cylinder{0.1, 2}, {1, 1, 1}),
                                      makeObject("ball", makeSphere(0.4), {-1, 0, 0.4})};
  const ObstacleSet here = setOf(objects);
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  X.linear() = aboutZ(0.7).toRotationMatrix();
  X.translation() = Eigen::Vector3d(20, -30, 4);
  for (SceneObject& object : objects) object.X_WO = X * object.X_WO;
  const ObstacleSet there = setOf(objects);
  const auto scratch = ObstacleSet::makeScratch();
  std::mt19937_64 generator(8);
  const Eigen::AlignedBox3d around(Eigen::Vector3d(-2, -2, 0), Eigen::Vector3d(2, 2, 2));
  for (int n = 0; n < 2000; ++n) {
    const Capsule capsule = randomCapsule(generator, around);
    const Capsule moved{X * capsule.from, X * capsule.to, capsule.radius};
    const auto a = here.nearest(capsule, 5.0, *scratch), b = there.nearest(moved, 5.0, *scratch);
    EXPECT_NEAR(a.distance, b.distance, 1e-4);
    if (a.distance > 1e-5) {
      EXPECT_EQ(there.touched(moved, *scratch), -1);
    }
  }
}

TEST(ObstacleSet, ACapsuleWithoutLengthIsASphere) {
  const ObstacleSet set = setOf({makeObject("mesh", makeBox({1, 1, 1}), {0, 0, 0})});
  const auto scratch = ObstacleSet::makeScratch();
  EXPECT_EQ(set.touched({{0.7, 0, 0}, {0.7, 0, 0}, 0.19}, *scratch), -1);
  EXPECT_EQ(set.touched({{0.7, 0, 0}, {0.7, 0, 0}, 0.21}, *scratch), 0);
}

}  // namespace
}  // namespace amble

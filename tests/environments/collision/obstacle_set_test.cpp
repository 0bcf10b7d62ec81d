#include "environments/collision/obstacle_set.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/rotation.h"
#include "environments/scene/triangle_grid.h"
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

TEST(ObstacleSet, WithinTwoOverlappingSolidsOfOneMeshIsAContactToo) {
  const auto scratch = ObstacleSet::makeScratch();
  const TriangleMesh block = makeBox({4, 4, 4});
  const ObstacleSet sofa =
      setOf({makeObject("sofa", joined(block, moved(block, {1.5, 1, 0.5})), {0, 0, 0})});
  for (const Eigen::Vector3d& at : {Eigen::Vector3d(-1, -1, 0), {0.8, 0.5, 0.2}, {2.8, 2, 1}}) {
    const Capsule small{at, at + Eigen::Vector3d(0, 0, 0.2), 0.05};
    EXPECT_EQ(sofa.touched(small, *scratch), 0) << at.transpose();
    EXPECT_EQ(sofa.nearest(small, 1.0, *scratch).distance, 0.0) << at.transpose();
  }
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

/// Of a point to a triangle, by the regions of its corners, edges and face (Ericson, Real-Time
/// Collision Detection, 5.1.5).
double pointToTriangle(const Eigen::Vector3d& p, const Triangle3& t) {
  const Eigen::Vector3d ab = t[1] - t[0], ac = t[2] - t[0], normal = ab.cross(ac);
  double least = HUGE_VAL;
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector3d &a = t[k], &b = t[(k + 1) % 3];
    const double along = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
    least = std::min(least, (p - a - along * (b - a)).norm());
  }
  bool above = true;  // over the face, not beside it
  for (int k = 0; k < 3; ++k)
    above = above && normal.cross(t[(k + 1) % 3] - t[k]).dot(p - t[k]) >= 0.0;
  return above ? std::min(least, std::abs(normal.normalized().dot(p - t[0]))) : least;
}

double capsuleToMesh(const Capsule& capsule, const TriangleMesh& mesh) {
  double least = HUGE_VAL;
  for (const auto& t : mesh.triangles) {
    const Triangle3 corners = {mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]};
    const auto at = [&](double u) {
      return pointToTriangle(capsule.from + u * (capsule.to - capsule.from), corners);
    };
    double low = 0.0, high = 1.0;  // convex along the axis
    for (int n = 0; n < 60; ++n) {
      const double u = low + (high - low) / 3.0, v = high - (high - low) / 3.0;
      (at(u) < at(v) ? high : low) = at(u) < at(v) ? v : u;
    }
    least = std::min(least, at(0.5 * (low + high)));
  }
  return least - capsule.radius;
}

/// Triangles anywhere in a box: a surface without an inside.
TriangleMesh crumpled(std::mt19937_64& generator, int triangles) {
  std::uniform_real_distribution<double> number(-1.0, 1.0), side(-0.4, 0.4);
  TriangleMesh mesh;
  for (int i = 0; i < triangles; ++i) {
    const Eigen::Vector3d at(number(generator), number(generator), number(generator));
    for (int k = 0; k < 3; ++k)
      mesh.vertices.push_back(at +
                              Eigen::Vector3d(side(generator), side(generator), side(generator)));
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return mesh;
}

TEST(ObstacleSet, ARandomSurfaceIsAsNearAsItsNearestTriangle) {
  const auto scratch = ObstacleSet::makeScratch();
  std::mt19937_64 generator(21);
  const Eigen::AlignedBox3d around(Eigen::Vector3d(-2, -2, -2), Eigen::Vector3d(2, 2, 2));
  int touching = 0;
  for (int mesh = 0; mesh < 5; ++mesh) {
    const TriangleMesh surface = crumpled(generator, 20);
    const ObstacleSet set = setOf({makeObject("scan", surface, {0, 0, 0})});
    for (int n = 0; n < 150; ++n) {
      const Capsule capsule = randomCapsule(generator, around);
      const double gap = capsuleToMesh(capsule, surface);
      touching += gap < 0.0;
      if (std::abs(gap) > 1e-5) {
        EXPECT_EQ(set.touched(capsule, *scratch) >= 0, gap < 0.0) << gap;
      }
      EXPECT_NEAR(set.nearest(capsule, 10.0, *scratch).distance, std::max(0.0, gap), 2e-4);
    }
  }
  EXPECT_GT(touching, 10);
}

// The tree of boxes leaves nothing out: many things together answer as a loop over each alone.
TEST(ObstacleSet, ManyTogetherAnswerAsEachAlone) {
  const auto scratch = ObstacleSet::makeScratch();
  std::mt19937_64 generator(22);
  std::uniform_real_distribution<double> place(-2.0, 2.0), size(0.05, 0.5), turn(-3.0, 3.0);
  std::vector<SceneObject> objects;
  std::vector<ObstacleSet> alone;
  for (int i = 0; i < 40; ++i) {
    const double s = size(generator);
    const Eigen::Vector3d at(place(generator), place(generator), place(generator));
    const Shape shapes[] = {Box{{s, 2 * s, s}}, Sphere{s}, Cylinder{s, 3 * s},
                            makeBox({s, s, 2 * s})};
    objects.push_back(makeObject("thing", shapes[i % 4], at));
    objects.back().X_WO.linear() =
        expRotation({turn(generator), turn(generator), 0}).toRotationMatrix();
    alone.push_back(setOf({objects.back()}));
  }
  const ObstacleSet all = setOf(objects);
  const Eigen::AlignedBox3d around(Eigen::Vector3d(-2.5, -2.5, -2.5),
                                   Eigen::Vector3d(2.5, 2.5, 2.5));
  int touching = 0;
  for (int n = 0; n < 300; ++n) {
    const Capsule capsule = randomCapsule(generator, around);
    int first = -1;
    double nearest = 1.0;
    for (size_t i = 0; i < alone.size(); ++i) {
      if (first < 0 && alone[i].touched(capsule, *scratch) >= 0) first = static_cast<int>(i);
      nearest = std::min(nearest, alone[i].nearest(capsule, 1.0, *scratch).distance);
    }
    touching += first >= 0;
    EXPECT_EQ(all.touched(capsule, *scratch), first);
    EXPECT_DOUBLE_EQ(all.nearest(capsule, 1.0, *scratch).distance, nearest);
  }
  EXPECT_GT(touching, 15);
}

}  // namespace
}  // namespace amble

#include "planner/steering/cylinder_steering.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/sample_stream.h"
#include "planner/steering/straight_walk.h"
#include "tests/planner/furnished_room.h"

namespace amble {
namespace {

class CylinderSteeringTest : public testing::Test {
 protected:
  static Waypoint standing(double x, double y) {
    Waypoint at;
    at.stance.position = {x, y, 0.0};
    return at;
  }
  const FurnishedRoom& room = furnishedRoom();
  const CylinderSteering steering{room.scene, room.ground, {0.3, 1.7, 1.2}};
  const SteeringScratchPtr scratch = steering.makeScratch();
};

TEST_F(CylinderSteeringTest, StandsWhereItsCircleIsFree) {
  Stance free = standing(0.31, 1.0).stance, at_wall = standing(0.29, 1.0).stance;
  EXPECT_FALSE(steering.stand(free, *scratch).has_value());
  const auto blocked = steering.stand(at_wall, *scratch);
  ASSERT_TRUE(blocked.has_value());
  EXPECT_EQ(blocked->rule, WalkRule::kContact);
  EXPECT_EQ(room.scene.objects[blocked->object].name, "west");
}

TEST_F(CylinderSteeringTest, EdgesAreStraightAndAsLongAsTheWay) {
  const SteerResult result = steering.steer(standing(1, 1), standing(2, 3), *scratch);
  ASSERT_TRUE(result.edge.has_value());
  EXPECT_NEAR(result.edge->length, std::sqrt(5.0), 1e-12);
  EXPECT_NEAR(result.edge->duration, std::sqrt(5.0) / 1.2, 1e-12);
  EXPECT_NEAR(result.edge->path.at(1.0).curvature, 0.0, 1e-9);
}

TEST_F(CylinderSteeringTest, WhatIsBetweenTwoPlacesIsMet) {
  const SteerResult result = steering.steer(standing(1.5, 1.5), standing(5.5, 3.3), *scratch);
  ASSERT_FALSE(result.edge.has_value());
  EXPECT_EQ(room.scene.objects[result.failure.object].name, "wall");
  EXPECT_NEAR(result.failure.at.x(), 3.0, 0.4);
}

TEST_F(CylinderSteeringTest, HoldsTheWholeBodyOfAWalk) {
  const StraightWalk walk = straightWalk(room.synthesizer, 3.0);
  const double radius = boundingRadius(walk, room.synthesizer.skeleton(), room.body);
  EXPECT_GT(radius, 0.3);  // arms swing and feet step beyond the shoulders
  EXPECT_LT(radius, 0.8);
  EXPECT_EQ(boundingRadius({}, room.synthesizer.skeleton(), room.body), 0.0);
}

TEST_F(CylinderSteeringTest, OutOfTheFloorThereIsNoGround) {
  Stance outside = standing(9, 9).stance;
  EXPECT_EQ(steering.stand(outside, *scratch)->rule, WalkRule::kNoGround);
}

/// Distance of a place in the plan to what stands there, and is higher than the cylinder's foot.
double clearanceAt(const FurnishedRoom& room, const Eigen::Vector2d& p) {
  double least = HUGE_VAL;
  for (size_t i = 1; i < room.scene.objects.size(); ++i) {
    const Eigen::Vector2d half = std::get<Box>(room.scene.objects[i].shape).size.head<2>() / 2;
    const Eigen::Vector2d at = room.scene.objects[i].X_WO.translation().head<2>();
    least = std::min(least, Eigen::AlignedBox2d(at - half, at + half).exteriorDistance(p));
  }
  return least;
}

TEST_F(CylinderSteeringTest, StandsWhereItsCircleIsFreeAnywhereInTheRoom) {
  SampleStream stream(31, 0);
  int blocked = 0;
  for (int i = 0; i < 500; ++i) {
    Stance stance = standing(stream.uniform(0, 6), stream.uniform(0, 4)).stance;
    const double gap = clearanceAt(room, stance.position.head<2>()) - 0.3;
    if (std::abs(gap) < 1e-4) continue;
    EXPECT_EQ(steering.stand(stance, *scratch).has_value(), gap < 0.0) << gap;
    blocked += gap < 0.0;
  }
  EXPECT_GT(blocked, 100);
  EXPECT_LT(blocked, 400);
}

TEST_F(CylinderSteeringTest, AnEdgeIsFreeWhereEveryPlaceOfItIsBothWays) {
  SampleStream stream(32, 0);
  int free = 0, met = 0;
  for (int i = 0; i < 300; ++i) {
    const Waypoint a = standing(stream.uniform(0, 6), stream.uniform(0, 4)),
                   b = standing(stream.uniform(0, 6), stream.uniform(0, 4));
    double gap = HUGE_VAL;
    for (int k = 0; k <= 1000; ++k) {
      const Eigen::Vector3d p =
          a.stance.position + (b.stance.position - a.stance.position) * k / 1000.0;
      gap = std::min(gap, clearanceAt(room, p.head<2>()) - 0.3);
    }
    if (std::abs(gap) < 0.003) continue;
    const SteerResult there = steering.steer(a, b, *scratch), back = steering.steer(b, a, *scratch);
    EXPECT_EQ(there.edge.has_value(), gap > 0.0) << gap;
    EXPECT_EQ(back.edge.has_value(), gap > 0.0) << gap;
    ++(gap > 0.0 ? free : met);
    if (!there.edge) continue;
    EXPECT_NEAR(there.edge->length / there.edge->duration, steering.topSpeed(), 1e-9);
    EXPECT_EQ(there.edge->from.position, a.stance.position);
    EXPECT_EQ(there.edge->to.position, b.stance.position);
  }
  EXPECT_GT(free, 20);
  EXPECT_GT(met, 50);
}

TEST_F(CylinderSteeringTest, AThinnerOneStandsWhereverAThickerDoes) {
  const CylinderSteering thick(room.scene, room.ground, {0.45, 1.7, 1.2});
  const SteeringScratchPtr own = thick.makeScratch();
  SampleStream stream(33, 0);
  for (int i = 0; i < 200; ++i) {
    Stance stance = standing(stream.uniform(0, 6), stream.uniform(0, 4)).stance;
    if (!thick.stand(stance, *own)) {
      EXPECT_FALSE(steering.stand(stance, *scratch));
    }
  }
}

TEST_F(CylinderSteeringTest, WhatLiesFlatOnTheFloorPassesBelow) {
  Scene scene = furnishedScene();
  scene.objects.push_back(boxObject("rug", {1, 1, 0.01}, {1.5, 2, 0.005}));
  scene.objects.push_back(boxObject("sill", {1, 0.2, 0.15}, {1.5, 3.3, 0.075}));
  const FurnishedRoom with(scene);
  const CylinderSteering over(with.scene, with.ground, {0.3, 1.7, 1.2});
  const SteeringScratchPtr own = over.makeScratch();
  EXPECT_TRUE(over.steer(standing(0.5, 2), standing(2.5, 2), *own).edge.has_value());
  EXPECT_FALSE(over.steer(standing(1.5, 2.5), standing(1.5, 3.6), *own).edge.has_value());
}

}  // namespace
}  // namespace amble

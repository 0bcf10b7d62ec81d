#include "planner/steering/cylinder_steering.h"

#include <gtest/gtest.h>

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
  const StraightWalk walk = straightWalk(room.synthesizer, room.ground, 3.0);
  const double radius = boundingRadius(walk, room.synthesizer.skeleton(), room.body);
  EXPECT_GT(radius, 0.3);  // arms swing and feet step beyond the shoulders
  EXPECT_LT(radius, 0.8);
  EXPECT_EQ(boundingRadius({}, room.synthesizer.skeleton(), room.body), 0.0);
}

TEST_F(CylinderSteeringTest, OutOfTheFloorThereIsNoGround) {
  Stance outside = standing(9, 9).stance;
  EXPECT_EQ(steering.stand(outside, *scratch)->rule, WalkRule::kNoGround);
}

}  // namespace
}  // namespace amble

#include "planner/steering/straight_walk.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/rotation.h"
#include "tests/planner/furnished_room.h"

namespace amble {
namespace {

StraightWalk walkIn(const FurnishedRoom& room, double length) {
  return straightWalk(room.synthesizer, room.ground, length);
}

Scene platformOf(double side, double top = 0.0) {
  Scene scene;
  scene.objects = {boxObject("platform", {side, side, 0.2}, {0, 0, top - 0.1})};
  return scene;
}

TEST(StraightWalk, IsStraightAndAsLongAsAsked) {
  for (const double length : {2.0, 3.0, 3.5}) {
    const StraightWalk walk = walkIn(furnishedRoom(), length);
    ASSERT_GT(walk.buffer.size(), 0);
    EXPECT_NEAR(walk.path.length(), length, 1e-9);
    for (double s = 0.0; s <= length; s += 0.1) EXPECT_NEAR(walk.path.at(s).curvature, 0.0, 1e-9);
    EXPECT_NEAR(walk.buffer.states.back().arc, length, 1e-9);
    EXPECT_EQ(walk.buffer.states.front().standing, 1.0);
    EXPECT_EQ(walk.buffer.states.back().standing, 1.0);
  }
}

TEST(StraightWalk, EveryFootprintLiesOnTheGround) {
  const FurnishedRoom& room = furnishedRoom();
  const StraightWalk walk = walkIn(room, 3.0);
  EXPECT_GE(walk.buffer.footprints.size(), 4u);
  for (const Footprint& print : walk.buffer.footprints) {
    const auto under = room.ground.height(print.position.x(), print.position.y(), 0.0, 0.1);
    ASSERT_TRUE(under.has_value());
    EXPECT_NEAR(print.position.z(), *under, 1e-9);
  }
}

TEST(StraightWalk, IsLevelAtWhateverHeightTheFloorIs) {
  for (const double top : {-3.0, 0.0, 7.5}) {
    const FurnishedRoom room(platformOf(8.0, top));
    const StraightWalk walk = walkIn(room, 3.0);
    ASSERT_GT(walk.buffer.size(), 0);
    for (const FrameState& state : walk.buffer.states) EXPECT_NEAR(state.position.z(), top, 1e-9);
  }
}

TEST(StraightWalk, WhereThereIsNoRoomForItThereIsNone) {
  EXPECT_EQ(walkIn(FurnishedRoom(platformOf(1.2)), 3.0).buffer.size(), 0);
  EXPECT_EQ(walkIn(FurnishedRoom(platformOf(5.0)), 30.0).buffer.size(), 0);
}

TEST(StraightWalk, IsFoundOnTheLevelPartOfASlope) {
  Scene scene = platformOf(4.5);
  SceneObject ramp = boxObject("ramp", {8, 4, 0.1}, {0, 0, 0});
  ramp.X_WO.linear() = expRotation({0, -12 * kDegree, 0}).toRotationMatrix();
  ramp.X_WO.translation() =
      Eigen::Vector3d(2.2 + 4 * std::cos(12 * kDegree), 0, 4 * std::sin(12 * kDegree) - 0.05);
  scene.objects.push_back(ramp);
  const StraightWalk walk = walkIn(FurnishedRoom(scene), 2.5);
  ASSERT_GT(walk.buffer.size(), 0);
  for (const FrameState& state : walk.buffer.states) EXPECT_LT(std::abs(state.position.z()), 0.05);
}

TEST(StraightWalk, IsTheSameTwice) {
  const StraightWalk once = walkIn(furnishedRoom(), 3.0), again = walkIn(furnishedRoom(), 3.0);
  ASSERT_EQ(once.buffer.size(), again.buffer.size());
  for (int i = 0; i < once.buffer.size(); ++i)
    EXPECT_EQ(once.buffer.poses.p_WR(i), again.buffer.poses.p_WR(i));
}

// Arms swing one after the other: a short gap needs less than the whole walk's breadth, and a
// longer one no less than a shorter.
TEST(StraightWalk, PassesAShortGapThatIsNarrowerThanItsWholeBreadth) {
  const FurnishedRoom& room = furnishedRoom();
  const StraightWalk walk = walkIn(room, 3.0);
  const Skeleton& skeleton = room.synthesizer.skeleton();
  const double all = walkingBreadth(walk, skeleton, room.body).sizes()[0];
  double last = 0.0;
  for (const double depth : {0.0, 0.1, 0.2, 0.4, 0.8, 1.5, 5.0}) {
    const double breadth = passableBreadth(walk, skeleton, room.body, depth);
    EXPECT_GE(breadth, last) << depth;
    EXPECT_LE(breadth, all) << depth;
    last = breadth;
  }
  EXPECT_LT(passableBreadth(walk, skeleton, room.body, 0.1), all - 0.02);
  EXPECT_NEAR(last, all, 1e-9);
  EXPECT_EQ(passableBreadth({}, skeleton, room.body, 0.1), 0.0);
}

}  // namespace
}  // namespace amble

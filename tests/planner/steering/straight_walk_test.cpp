#include "planner/steering/straight_walk.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/rotation.h"
#include "tests/planner/furnished_room.h"

namespace amble {
namespace {

StraightWalk walkIn(const FurnishedRoom& room, double length) {
  return straightWalk(room.synthesizer, length);
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

TEST(StraightWalk, EveryFootprintLiesOnTheLevel) {
  const StraightWalk walk = walkIn(furnishedRoom(), 3.0);
  EXPECT_GE(walk.buffer.footprints.size(), 4u);
  for (const Footprint& print : walk.buffer.footprints) EXPECT_NEAR(print.position.z(), 0.0, 1e-9);
  for (const FrameState& state : walk.buffer.states) EXPECT_NEAR(state.position.z(), 0.0, 1e-9);
}

TEST(StraightWalk, IsTheSameWhateverTheSceneIsLike) {
  const StraightWalk at_home = walkIn(furnishedRoom(), 3.0);
  SceneObject ramp = boxObject("ramp", {2, 1, 0.1}, {0, 0, 0});
  ramp.X_WO.linear() = expRotation({0, -12 * kDegree, 0}).toRotationMatrix();
  Scene scene;
  scene.objects = {ramp};
  for (const Scene& other : {platformOf(1.2), platformOf(8.0, 7.5), scene}) {
    const StraightWalk walk = walkIn(FurnishedRoom(other), 3.0);
    ASSERT_EQ(walk.buffer.size(), at_home.buffer.size());
    for (int i = 0; i < walk.buffer.size(); ++i)
      EXPECT_EQ(walk.buffer.poses.p_WR(i), at_home.buffer.poses.p_WR(i));
    ASSERT_EQ(walk.turns.size(), 4u);
  }
}

TEST(StraightWalk, TurnsOnTheSpotByQuartersAndHalvesEachWay) {
  double sum = 0.0, largest = 0.0;
  for (const AnimationBuffer& turn : walkIn(furnishedRoom(), 3.0).turns) {
    const double by = turn.states.back().heading - turn.states.front().heading;
    sum += by;
    largest = std::max(largest, std::abs(by));
    EXPECT_GE(std::abs(by), 0.5 * kPi - 1e-6);
  }
  EXPECT_NEAR(sum, 0.0, 1e-9);
  EXPECT_NEAR(largest, kPi, 1e-6);
}

TEST(StraightWalk, ShorterThanAStepThereIsNone) {
  EXPECT_EQ(walkIn(furnishedRoom(), 0.05).buffer.size(), 0);
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

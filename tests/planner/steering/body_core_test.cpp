#include "planner/steering/body_core.h"

#include <gtest/gtest.h>

#include "base/rotation.h"
#include "base/sample_stream.h"
#include "planner/steering/walk_steering.h"
#include "tests/planner/furnished_room.h"

namespace amble {
namespace {

class BodyCoreTest : public testing::Test {
 protected:
  static BodyCore coreOf(const FurnishedRoom& room) {
    return {straightWalk(room.synthesizer, 3.0), room.synthesizer.skeleton(),
            room.synthesizer.roles(), room.body, room.synthesizer.stature()};
  }
  static RootPath line(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    const double heading = std::atan2((b - a).y(), (b - a).x());
    return RootPath({makeBezier(a, heading, b, heading, 1.0 / 3.0)});
  }
  const FurnishedRoom& room = furnishedRoom();
  const CollisionScratchPtr scratch = room.world.makeScratch();
};

TEST_F(BodyCoreTest, NeverRefusesAFreeWalk) {
  const BodyCore core = coreOf(room);
  SampleStream stream(11, 0);
  AnimationBuffer buffer;
  int free = 0;
  for (int i = 0; i < 250; ++i) {
    Stance from, to;
    from.position << stream.uniform(0.3, 5.7), stream.uniform(0.3, 3.7), 0.0;
    to.position << stream.uniform(0.3, 5.7), stream.uniform(0.3, 3.7), 0.0;
    const Eigen::Vector3d way = to.position - from.position;
    from.heading = std::atan2(way.y(), way.x()) + stream.uniform(-0.8, 0.8);
    to.heading = std::atan2(way.y(), way.x()) + stream.uniform(-0.8, 0.8);
    from.standing = stream.uniform() < 0.5;
    to.standing = stream.uniform() < 0.5;
    const RootPath path({makeBezier(from.position.head<2>(), from.heading, to.position.head<2>(),
                                    to.heading, 0.4)});
    if (room.synthesizer.walk(from, to, path, true, buffer).refused != WalkRule::kNone) continue;
    if (room.world.check(buffer.poses, buffer.soles, true, *scratch)) continue;
    ++free;
    EXPECT_FALSE(
        core.touch({path, 0.0, from.standing, to.standing, room.ground}, room.world, *scratch));
  }
  EXPECT_GT(free, 10);
}

TEST_F(BodyCoreTest, RefusesAWayThroughAWallAndSaysWhere) {
  const RootPath path = line({1.5, 1.5}, {5.0, 1.5});
  const auto touch = coreOf(room).touch({path, 0.0, true, true, room.ground}, room.world, *scratch);
  ASSERT_TRUE(touch.has_value());
  EXPECT_EQ(room.scene.objects[touch->object].name, "wall");
  EXPECT_NEAR(touch->at.x(), 3.0, 0.25);
  EXPECT_NEAR(touch->at.y(), 1.5, 0.2);
  EXPECT_NEAR(touch->heading, 0.0, 1e-9);
}

// The passage from y = 3.1 to 4: past its middle by more than half of what it is wider than the
// body.
TEST_F(BodyCoreTest, KnowsHowWideTheBodyIs) {
  const BodyCore core = coreOf(room);
  const auto passes = [&](double y) {
    const RootPath path = line({1.5, y}, {4.5, y});
    return !core.touch({path, 0.0, true, true, room.ground}, room.world, *scratch);
  };
  EXPECT_TRUE(passes(3.55));
  EXPECT_FALSE(passes(3.28));  // an upper arm's middle is 0.2 m beside the path
  EXPECT_FALSE(passes(3.82));
}

TEST_F(BodyCoreTest, KnowsHowTallTheBodyIs) {
  Scene scene = furnishedScene();
  scene.objects.push_back(boxObject("beam", {0.1, 4.0, 0.3}, {1.5, 2.0, 1.6}));
  const FurnishedRoom low(scene);
  const CollisionScratchPtr own = low.world.makeScratch();
  const RootPath path = line({0.6, 2.0}, {2.4, 2.0});
  const auto touch = coreOf(low).touch({path, 0.0, true, true, low.ground}, low.world, *own);
  ASSERT_TRUE(touch.has_value());
  EXPECT_EQ(low.scene.objects[touch->object].name, "beam");
  EXPECT_EQ(low.body.parts[touch->part].name, "head");
}

TEST_F(BodyCoreTest, WithoutAWalkItRefusesNothing) {
  const BodyCore nothing({}, room.synthesizer.skeleton(), room.synthesizer.roles(), room.body, 1.7);
  const RootPath path = line({1.5, 1.5}, {5.0, 1.5});
  EXPECT_FALSE(
      nothing.touch({path, 0.0, true, true, room.ground}, room.world, *scratch).has_value());
}

// Slats all over the floor but for its east end: most straight walks step over them.
Scene slattedScene() {
  Scene scene;
  scene.objects = {boxObject("floor", {12, 12, 0.1}, {0, 0, -0.05})};
  for (double x = -5.5; x < 2.0; x += 0.5)
    scene.objects.push_back(boxObject("slat", {0.04, 12, 0.2}, {x, 0, 0.1}));
  return scene;
}

TEST_F(BodyCoreTest, IsMeasuredWhereNothingIsSteppedOver) {
  const FurnishedRoom slatted(slattedScene());
  const StraightWalk walk = straightWalk(slatted.synthesizer, 3.0);
  ASSERT_GT(walk.buffer.size(), 0);
  for (const Footprint& print : walk.buffer.footprints)
    EXPECT_LE(print.gait.lift, slatted.synthesizer.capturedLift() + 0.011);
}

TEST_F(BodyCoreTest, FurnitureDoesNotMakeItThinner) {
  const FurnishedRoom slatted(slattedScene());
  const RootPath path = line({2.5, -1}, {2.5, 3});
  Scene scene = slattedScene();
  scene.objects.push_back(boxObject("post", {0.1, 0.1, 2.0}, {2.5, 1, 1.0}));
  const FurnishedRoom with_post(scene);
  const CollisionScratchPtr own = with_post.world.makeScratch();
  EXPECT_TRUE(
      coreOf(slatted).touch({path, 0.0, true, true, with_post.ground}, with_post.world, *own));
}

/// The room without its wall and table, and six boxes anywhere in it.
Scene randomRoom(std::uint64_t seed) {
  SampleStream stream(seed, 0);
  Scene scene = furnishedScene();
  scene.objects.resize(5);
  for (int i = 0; i < 6; ++i) {
    const Eigen::Vector3d size(stream.uniform(0.1, 0.9), stream.uniform(0.1, 0.9),
                               stream.uniform(0.2, 1.8));
    const double below = stream.uniform() < 0.3 ? 0.8 : 0.0;  // some hang
    scene.objects.push_back(boxObject(
        "box", size, {stream.uniform(0.5, 5.5), stream.uniform(0.5, 3.5), below + size.z() / 2}));
  }
  return scene;
}

TEST_F(BodyCoreTest, NeverRefusesAFreeWalkInAnyRoom) {
  int free = 0, refused = 0;
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const FurnishedRoom random(randomRoom(seed));
    const BodyCore core = coreOf(random);
    const CollisionScratchPtr own = random.world.makeScratch();
    SampleStream stream(seed, 1);
    AnimationBuffer buffer;
    for (int i = 0; i < 80; ++i) {
      Stance from, to;
      from.position << stream.uniform(0.3, 5.7), stream.uniform(0.3, 3.7), 0.0;
      to.position << stream.uniform(0.3, 5.7), stream.uniform(0.3, 3.7), 0.0;
      const Eigen::Vector3d way = to.position - from.position;
      from.heading = std::atan2(way.y(), way.x()) + stream.uniform(-0.5, 0.5);
      to.heading = std::atan2(way.y(), way.x()) + stream.uniform(-0.5, 0.5);
      const RootPath path({makeBezier(from.position.head<2>(), from.heading, to.position.head<2>(),
                                      to.heading, 0.4)});
      const auto touch = core.touch({path, 0.0, true, true, random.ground}, random.world, *own);
      if (random.synthesizer.walk(from, to, path, true, buffer).refused != WalkRule::kNone)
        continue;
      const bool is_free = !random.world.check(buffer.poses, buffer.soles, true, *own);
      EXPECT_FALSE(is_free && touch) << seed << " " << i;
      free += is_free;
      refused += touch.has_value();
    }
  }
  EXPECT_GT(free, 10);
  EXPECT_GT(refused, 20);
}

}  // namespace
}  // namespace amble

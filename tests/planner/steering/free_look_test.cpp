#include "planner/steering/free_look.h"

#include <gtest/gtest.h>

#include "base/sample_stream.h"
#include "planner/steering/walk_steering.h"
#include "tests/planner/furnished_room.h"

namespace amble {
namespace {

// 8 x 5 m with a log across, too high to climb, and a step before a part of it.
Scene logAcross() {
  Scene scene;
  scene.objects = {boxObject("floor", {8, 5, 0.1}, {4, 2.5, -0.05}),
                   boxObject("log", {0.3, 5, 0.45}, {4, 2.5, 0.225}),
                   boxObject("step", {0.4, 1, 0.12}, {3.65, 1.5, 0.06})};
  return scene;
}

class FreeLookTest : public testing::Test {
 protected:
  Waypoint standing(double x, double y, double heading = 0.0) const {
    Waypoint at;
    at.stance.position = {x, y, 0.0};
    at.stance.heading = heading;
    return at;
  }

  const FurnishedRoom room{logAcross()};
  const WalkSteering steering{room.synthesizer, room.world, room.ground};
  const SteeringScratchPtr scratch = steering.makeScratch();
};

TEST_F(FreeLookTest, BesideStepsAndLogsWhatLooksFreeIsFree) {
  ASSERT_FALSE(room.ground.isLevel());
  SampleStream stream(4, 0);
  int free = 0;
  for (int i = 0; i < 600; ++i) {
    const auto anywhere = [&] {
      return standing(stream.uniform(0.3, 7.7), stream.uniform(0.3, 4.7), stream.uniform(-3, 3));
    };
    Waypoint from = anywhere(), to = anywhere();
    if (steering.stand(from.stance, *scratch) || steering.stand(to.stance, *scratch) ||
        !steering.looksFree(from, to, *scratch))
      continue;
    ++free;
    EXPECT_TRUE(steering.steer(from, to, *scratch).edge.has_value());
  }
  EXPECT_GT(free, 30);
}

TEST_F(FreeLookTest, NothingLooksFreeOverAStepOrOffTheGround) {
  EXPECT_TRUE(steering.looksFree(standing(1, 1), standing(3, 4), *scratch));
  EXPECT_FALSE(steering.looksFree(standing(1, 1), standing(7, 1), *scratch));
  EXPECT_FALSE(steering.looksFree(standing(3.1, 0.3), standing(3.1, 2.5), *scratch));
  EXPECT_FALSE(steering.looksFree(standing(1, 0.1), standing(3, 0.1), *scratch));
}

}  // namespace
}  // namespace amble

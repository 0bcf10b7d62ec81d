// How high feet come over things, and what is too high for them.
#include <gtest/gtest.h>

#include "animation/steps/step_placer.h"
#include "base/rotation.h"
#include "base/sample_stream.h"
#include "planner/steering/body_reach.h"
#include "planner/steering/straight_walk.h"
#include "planner/steering/walk_steering.h"
#include "tests/planner/furnished_room.h"

namespace amble {
namespace {

const Eigen::Vector3d kBeforeLog(1, 2, 0), kBehindLog(5, 2, 0);

// Across a floor of 6 by 4 m.
SceneObject logAcross(double thick, double high, double south, double north) {
  return boxObject("log", {thick, north - south, high}, {3, 0.5 * (south + north), 0.5 * high});
}

struct LogFloor {
  explicit LogFloor(const std::vector<SceneObject>& things, double speed = 1.2)
      : room(withFloor(things), ofSpeed(speed)),
        steering(room.synthesizer, room.world, room.ground) {}
  static Scene withFloor(const std::vector<SceneObject>& things) {
    Scene scene;
    scene.objects = things;
    scene.objects.push_back(boxObject("floor", {6, 4, 0.1}, {3, 2, -0.05}));
    return scene;
  }
  static CharacterSettings ofSpeed(double speed) {
    CharacterSettings settings;
    settings.speed = speed;
    return settings;
  }
  std::optional<SteeringFailure> shutOff(const Eigen::Vector3d& from,
                                         const Eigen::Vector3d& to) const {
    return steering.shutOff(from, to, [] { return false; }, {&scratch, 1});
  }

  const FurnishedRoom room;
  const WalkSteering steering;
  const SteeringScratchPtr scratch = steering.makeScratch();
};

std::vector<SceneObject> betweenWalls(const SceneObject& log) {
  return {log, boxObject("south", {6, 0.1, 2.5}, {3, -0.05, 1.25}),
          boxObject("north", {6, 0.1, 2.5}, {3, 4.05, 1.25})};
}

TEST(LiftedFeet, ALogHigherThanFeetAreLiftedShutsOffBeyondTheEdgesAndBetweenWalls) {
  for (const double high : {0.35, 0.4, 0.45}) {
    for (const double thick : {0.05, 0.3}) {
      const LogFloor beyond({logAcross(thick, high, -1, 5)});
      const LogFloor between(betweenWalls(logAcross(thick, high, 0, 4)));
      for (const LogFloor* floor : {&beyond, &between}) {
        const auto failure = floor->shutOff(kBeforeLog, kBehindLog);
        ASSERT_TRUE(failure.has_value()) << high << ", " << thick << " m thick";
        ASSERT_GE(failure->object, 0) << high;
        EXPECT_EQ(floor->room.scene.objects[failure->object].name, "log") << high;
      }
    }
  }
  for (const double high : {0.1, 0.25})
    EXPECT_FALSE(LogFloor({logAcross(0.1, high, -1, 5)}).shutOff(kBeforeLog, kBehindLog)) << high;
}

// Lower than that, as no foot of a walk swings over it.
TEST(LiftedFeet, ALogThatEndsHigherThanAnySwingLeadsShutsOff) {
  const LogFloor open({logAcross(0.1, 0.2, 1, 3)});
  const Eigen::AlignedBox1d too_high = open.room.synthesizer.tooHighToSwingOver();
  ASSERT_LT(too_high.min()[0], 0.29);
  ASSERT_GT(too_high.max()[0], 0.34);
  for (const double thick : {0.03, 0.4}) {
    for (double high = too_high.min()[0] + 0.01; high < too_high.max()[0]; high += 0.03) {
      for (const LogFloor& floor : {LogFloor({logAcross(thick, high, -1, 5)}),
                                    LogFloor(betweenWalls(logAcross(thick, high, 0, 4)))}) {
        const auto failure = floor.shutOff(kBeforeLog, kBehindLog);
        ASSERT_TRUE(failure.has_value()) << high << ", " << thick << " m thick";
        ASSERT_GE(failure->object, 0) << high;
        EXPECT_EQ(floor.room.scene.objects[failure->object].name, "log") << high;
      }
    }
    const double low = too_high.min()[0] - 0.005;
    EXPECT_FALSE(LogFloor({logAcross(thick, low, -1, 5)}).shutOff(kBeforeLog, kBehindLog));
  }
  EXPECT_FALSE(open.shutOff(kBeforeLog, kBehindLog));
}

// Feet go under what hangs as high.
TEST(LiftedFeet, ABarAtTheHeightOfALogDoesNotShutFeetOff) {
  SceneObject bar = logAcross(0.1, 0.05, -1, 5);
  bar.X_WO.translation().z() = 0.28;
  const auto failure = LogFloor({bar}).shutOff(kBeforeLog, kBehindLog);
  EXPECT_FALSE(failure.has_value());
}

// The front ends of soles and insteps in all poses of a walk, between the heights of their balls.
void expectBallsHeld(const LogFloor& floor, const BodyReach& reach, const WalkEdge& walk) {
  const Body& body = floor.room.body;
  std::vector<JointFrame> joints(floor.room.synthesizer.skeleton().size());
  AnimationBuffer buffer;
  floor.steering.animate(walk, buffer);
  for (int frame = 0; frame < buffer.size(); ++frame) {
    forwardKinematics(floor.room.synthesizer.skeleton(), buffer.poses[frame], joints);
    for (const BodyReach::Ball& ball : reach.balls()) {
      if (!ball.isFoot()) continue;
      const BodyPart& sole = body.parts[ball.part];
      const double z = (joints[sole.joint] * sole.to).z();
      ASSERT_GT(z, ball.height) << sole.name;
      ASSERT_LT(z, ball.highest) << sole.name;
    }
  }
}

Waypoint besideLog(SampleStream& stream, double low, double high) {
  Waypoint at;
  at.stance.position << stream.uniform(low, high), stream.uniform(0.15, 3.85), 0.0;
  at.stance.heading = stream.uniform(-0.7, 0.7);
  at.stance.standing = stream.uniform() < 0.6;
  return at;
}

// The theorem: logs from edge to edge, beyond it, or with room beside them; the one walk over them,
// about them, or with a turn on the spot.
TEST(LiftedFeet, NoLogThatIsSteppedOverIsSaidToShutOff) {
  SampleStream stream(41, 0);
  int over = 0, shut = 0;
  double highest = 0.0;
  for (int i = 0; i < 24; ++i) {
    const double high = stream.uniform(0.15, 0.45);
    const double south = stream.uniform() < 0.7 ? stream.uniform(-0.3, 0.0) : 0.5;
    const SceneObject log = logAcross(stream.uniform(0.03, 0.4), high, south, 4 - south);
    const bool walled = south <= 0.0 && stream.uniform() < 0.3;
    const LogFloor floor(walled ? betweenWalls(log) : std::vector{log}, stream.uniform(0.5, 1.6));
    const WalkSynthesizer& walker = floor.room.synthesizer;
    const BodyReach reach(straightWalk(walker), walker.skeleton(), walker.roles(), floor.room.body,
                          walker.stature(),
                          {0.25, 1.0, StepPlacer::kHighestLift, walker.tooHighToSwingOver(),
                           walker.feet()[kLeft].half_width});
    shut += floor.shutOff(kBeforeLog, kBehindLog).has_value();
    for (int k = 0; k < 8; ++k) {
      Waypoint from = besideLog(stream, 1.0, 2.6), to = besideLog(stream, 3.4, 5.0);
      if (k % 3 == 0) {
        std::swap(from, to);
        from.stance.heading += kPi;
        to.stance.heading += kPi;
      } else if (k % 3 == 1 && from.stance.standing) {
        from.stance.heading += stream.uniform(-kPi, kPi);
      }
      const auto walk = floor.steering.steer(from, to, *floor.scratch).edge;
      if (!walk) continue;
      ++over;
      // Logs that are low and broad are ground themselves.
      if (floor.room.ground.isLevel()) expectBallsHeld(floor, reach, *walk);
      highest = std::max(highest, high);
      EXPECT_FALSE(floor.shutOff(from.stance.position, to.stance.position))
          << i << ": a log " << high << " m high, of " << south << " to " << 4 - south;
    }
  }
  EXPECT_GE(over, 30);
  EXPECT_GE(shut, 3);
  EXPECT_GT(highest, 0.24);
}

}  // namespace
}  // namespace amble

// How high bodies are carried over stairs, slopes and slabs: the lines from ground to ground, and
// what holds of every walk.
#include "planner/steering/ground_chords.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "animation/steps/step_placer.h"
#include "animation/steps/stride_law.h"
#include "base/data_directory.h"
#include "base/rotation.h"
#include "base/sample_stream.h"
#include "planner/steering/ground_range.h"
#include "planner/steering/walk_steering.h"
#include "tests/planner/furnished_room.h"

namespace amble {
namespace {

constexpr double kFeetAside = 0.5;  // of stature: feet are no farther from a part of the body

enum class RiseKind { kStairs, kStep, kRamp, kSlabs, kHills };
constexpr int kRiseKinds = 5;

// From a floor, up to x = 0, to another that begins at `length`, `height` higher.
struct GroundRise {
  Scene scene;
  double length = 0.0, height = 0.0;  // [m]
};

GroundRise riseOfSteps(SampleStream& stream, int count) {
  const double riser = stream.uniform(0.05, 0.25), tread = stream.uniform(0.25, 0.5);
  GroundRise rise{{}, count * tread, (count + 1) * riser};
  for (int k = 1; k <= count; ++k)
    rise.scene.objects.push_back(boxObject("step", {tread, stream.uniform(1.0, 3.0), k * riser},
                                           {tread * (k - 0.5), 0, 0.5 * k * riser}));
  return rise;
}

GroundRise riseOfRamp(SampleStream& stream) {
  const double slope = stream.uniform(0.03, 0.25), length = stream.uniform(0.5, 4.0);
  GroundRise rise{{}, length, slope * length};
  SceneObject board = boxObject("ramp", {std::hypot(length, rise.height), 3, 0.04}, {0, 0, 0});
  board.X_WO.linear() = Eigen::AngleAxisd(-std::atan(slope), Eigen::Vector3d::UnitY()).matrix();
  board.X_WO.translation() = Eigen::Vector3d(0.5 * length, 0, 0.5 * rise.height) -
                             0.02 * board.X_WO.linear() * Eigen::Vector3d::UnitZ();
  rise.scene.objects.push_back(board);
  return rise;
}

GroundRise riseOfSlabs(SampleStream& stream) {
  GroundRise rise{{}, 3.0, 0.0};
  for (int i = 0; i < 12; ++i) {
    const double high = stream.uniform(0.04, 0.25);
    rise.scene.objects.push_back(
        boxObject("slab", {stream.uniform(0.3, 2.0), stream.uniform(0.3, 2.0), high},
                  {stream.uniform(-2, 5), stream.uniform(-2, 2), 0.5 * high}));
  }
  rise.scene.objects.push_back(boxObject("between", {3, 5, 0.1}, {1.5, 0, -0.05}));
  return rise;
}

// The middle of the hills that are shipped, which are level nowhere.
GroundRise riseOfHills() {
  return {readScene(dataDirectory() / "environments/scenes/rolling-terrain/scene.yaml"), 5.0, 0.0};
}

GroundRise drawnRise(RiseKind kind, SampleStream& stream) {
  if (kind == RiseKind::kHills) return riseOfHills();
  GroundRise rise = kind == RiseKind::kRamp ? riseOfRamp(stream)
                    : kind == RiseKind::kSlabs
                        ? riseOfSlabs(stream)
                        : riseOfSteps(stream, kind == RiseKind::kStep ? 1 : 5);
  const double off = stream.uniform(0.0, 0.1);  // of the ground's squares
  rise.scene.objects.push_back(boxObject("low", {6 + off, 5, 0.1}, {-3 - 0.5 * off, 0, -0.05}));
  rise.scene.objects.push_back(
      boxObject("high", {6, 5, 0.2}, {rise.length + 3, 0, rise.height - 0.1}));
  return rise;
}

Waypoint anywhereOnRise(const GroundRise& rise, double heading, SampleStream& stream) {
  Waypoint at;
  at.stance.position << stream.uniform(-1.5, rise.length + 1.5), stream.uniform(-1.0, 1.0),
      0.5 * rise.height;
  at.stance.heading = heading + stream.uniform(-0.5, 0.5);
  at.stance.standing = stream.uniform() < 0.6;
  return at;
}

TEST(GroundChords, OnAFlightTheyKeepToItsSlopeAndNotToItsLowestAndHighestTreads) {
  const double riser = 0.17, tread = 0.3;  // squares of 0.1 m
  Scene scene;
  for (int k = 1; k <= 12; ++k)
    scene.objects.push_back(
        boxObject("step", {tread, 2, k * riser}, {tread * (k - 0.5), 0, 0.5 * k * riser}));
  scene.objects.push_back(boxObject("floor", {4, 4, 0.1}, {-2, 0, -0.05}));
  const SceneGround ground(scene);
  const ReachedGround all(ground, {-1, 0, 0}, 1.0);
  const GroundChords chords(ground, all, 1.0);
  const GroundRange range(ground, all, 0.8);
  for (double x = 1.3; x < 2.3; x += 0.03) {
    const double slope = riser / tread * x;  // of what is lowest of the treads
    const Eigen::AlignedBox1d around = chords.through({x, 0.1});
    EXPECT_GT(around.min()[0], slope - 0.5 * riser) << x;
    EXPECT_LT(around.max()[0], slope + 1.5 * riser) << x;
    EXPECT_LT(range.around({x, 0.1}).min()[0], slope - 2.0 * riser) << x;
  }
}

// The theorem, for bodies and speeds of all kinds.
TEST(GroundChords, EveryPoseOverUnevenGroundIsCarriedBetweenThem) {
  SampleStream stream(9, 0);
  int walked = 0;
  double least = HUGE_VAL;
  for (int i = 0; i < 2 * kRiseKinds; ++i) {
    CharacterSettings settings;
    settings.height = stream.uniform(1.2, 2.0);
    settings.speed = stream.uniform(0.6, 1.5);
    GroundRise rise = drawnRise(static_cast<RiseKind>(i % kRiseKinds), stream);
    const FurnishedRoom room(rise.scene, settings);
    ASSERT_FALSE(room.ground.isLevel());
    const WalkSteering steering(room.synthesizer, room.world, room.ground);
    const double stature = room.synthesizer.stature();
    const double longest = StrideLaw::kLongestStep * room.synthesizer.capturedStep();
    const BodyReach reach(
        straightWalk(room.synthesizer), room.synthesizer.skeleton(), room.synthesizer.roles(),
        room.body, stature,
        {room.ground.settings().limits.highestStep(), longest, StepPlacer::kHighestLift});
    const ReachedGround all(room.ground, {0.0, 0.0, 50.0}, longest);
    const GroundChords chords(room.ground, all, longest);
    const GroundRange range(room.ground, all, kFeetAside * stature);
    const auto scratch = steering.makeScratch();
    AnimationBuffer buffer;
    std::vector<JointFrame> joints(room.synthesizer.skeleton().size());
    std::vector<Eigen::Vector3d> a(room.body.parts.size()), b(room.body.parts.size());
    for (int k = 0; k < 60; ++k) {
      const double heading = stream.uniform() < 0.5 ? 0.0 : kPi;
      Waypoint from = anywhereOnRise(rise, heading, stream),
               to = anywhereOnRise(rise, heading, stream);
      if (!steering.place(from.stance) || !steering.place(to.stance)) continue;
      const auto result = steering.steer(from, to, *scratch);
      if (!result.edge) continue;
      ++walked;
      steering.animate(*result.edge, buffer);
      for (int frame = 0; frame < buffer.size(); frame += 3) {
        forwardKinematics(room.synthesizer.skeleton(), buffer.poses[frame], joints);
        placeBody(room.body, joints, a, b);
        for (const BodyReach::Ball& ball : reach.balls()) {
          if (ball.isLeg()) continue;
          Eigen::Vector3d at = 0.5 * (a[ball.part] + b[ball.part]);
          if (ball.part == room.body.head) at.z() = std::max(a[ball.part].z(), b[ball.part].z());
          const Eigen::AlignedBox1d ground =
              chords.through(at.head<2>()).intersection(range.around(at.head<2>()));
          ASSERT_FALSE(ground.isEmpty());
          const double low = at.z() - (ground.min()[0] + ball.carried.min()[0]);
          const double high = ground.max()[0] + ball.carried.max()[0] - at.z();
          least = std::min({least, low, high});
          EXPECT_GE(low, 0.0) << i << ' ' << room.body.parts[ball.part].name;
          EXPECT_GE(high, 0.0) << i << ' ' << room.body.parts[ball.part].name;
        }
      }
    }
  }
  EXPECT_GE(walked, 100);
  EXPECT_LT(least, 0.06);  // somebody uses what is allowed for
}

}  // namespace
}  // namespace amble

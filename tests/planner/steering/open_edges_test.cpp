// Floors that end in the open, and walls that go on beyond their edges or do not.
#include <gtest/gtest.h>

#include "animation/steps/stride_law.h"
#include "base/rotation.h"
#include "base/sample_stream.h"
#include "planner/steering/ground_reach.h"
#include "planner/steering/walk_steering.h"
#include "planner/why/obstruction.h"
#include "tests/planner/furnished_room.h"

namespace amble {
namespace {

const Eigen::Vector3d kWestOfWall(1, 2, 0), kEastOfWall(7, 2, 0);

SceneObject floorBetween(double low, double high, double top = 0.0) {
  return boxObject("floor", {high - low, 4, 0.1 + top}, {0.5 * (low + high), 2, 0.5 * (top - 0.1)});
}

struct OpenFloor {
  explicit OpenFloor(const std::vector<SceneObject>& objects,
                     const CharacterSettings& settings = {})
      : room(sceneWith(objects), settings), steering(room.synthesizer, room.world, room.ground) {}
  static Scene sceneWith(const std::vector<SceneObject>& objects) {
    Scene scene;
    scene.objects = objects;
    return scene;
  }
  std::optional<SteeringFailure> shutOff(const Eigen::Vector3d& from,
                                         const Eigen::Vector3d& to) const {
    return steering.shutOff(from, to, [] { return false; }, {&scratch, 1});
  }
  // Before any search, by the ground or by what stands on it.
  bool isProved(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const {
    const double step = StrideLaw::kLongestStep * room.synthesizer.capturedStep();
    return findGap(room.ground, from, to, step) || shutOff(from, to);
  }

  const FurnishedRoom room;
  const WalkSteering steering;
  const SteeringScratchPtr scratch = steering.makeScratch();
};

void expectTheWall(const OpenFloor& open, const Eigen::Vector3d& to, const std::string& what) {
  const auto failure = open.shutOff(kWestOfWall, to);
  ASSERT_TRUE(failure.has_value()) << what;
  ASSERT_GE(failure->object, 0) << what;
  EXPECT_EQ(open.room.scene.objects[failure->object].name, "wall") << what;
  EXPECT_GT(failure->at.y(), -0.4) << what << ": named where there is no floor";
  EXPECT_LT(failure->at.y(), 4.4) << what << ": named where there is no floor";
}

TEST(OpenEdges, WallsThatGoOnBeyondTheFloorShutOffHoweverThick) {
  for (const double thick : {0.1, 1.0, 2.0}) {
    for (const double length : {4.3, 5.0, 8.0}) {
      const SceneObject wall = boxObject("wall", {thick, length, 2.5}, {4, 2, 1.25});
      const std::string what = std::to_string(thick) + " by " + std::to_string(length);
      expectTheWall(OpenFloor({floorBetween(0, 8), wall}), kEastOfWall, what);
      expectTheWall(OpenFloor({floorBetween(0, 4), floorBetween(4, 8), wall}), kEastOfWall,
                    "two, " + what);
      if (length < 5.0) continue;  // beside so high a step nothing is known of legs
      expectTheWall(OpenFloor({floorBetween(0, 4), floorBetween(4, 8, 0.2), wall}),
                    kEastOfWall + Eigen::Vector3d(0, 0, 0.2), "two heights, " + what);
    }
  }
}

TEST(OpenEdges, AWallWithGroundBesideItsEndDoesNot) {
  for (const double thick : {0.1, 1.0}) {
    const OpenFloor open({floorBetween(0, 8), boxObject("wall", {thick, 6, 2.5}, {4, 0, 1.25})});
    EXPECT_FALSE(open.shutOff(kWestOfWall, kEastOfWall).has_value()) << thick;
  }
}

// What lacks width, height or a step, each drawn, of people small and tall.
TEST(OpenEdges, WhatLacksWidthHeightOrAStepIsProvedBeforeAnySearch) {
  SampleStream stream(12, 0);
  for (int i = 0; i < 20; ++i) {
    CharacterSettings settings;
    settings.height = stream.uniform(1.3, 1.95);
    const double thick =
        stream.uniform() < 0.5 ? stream.uniform(0.05, 0.2) : stream.uniform(0.5, 1.5);
    std::vector<SceneObject> things;
    Eigen::Vector3d to = kEastOfWall;
    const int kind = i % 4;
    if (kind == 0) {
      const double gap = stream.uniform(0.06, 0.11) * settings.height;
      const double south = stream.uniform(1.0, 3.0), north = 5.0 - south - gap;
      things = {floorBetween(0, 8),
                boxObject("south", {thick, south + 1, 2.5}, {4, 0.5 * (south - 1), 1.25}),
                boxObject("north", {thick, north, 2.5}, {4, 5 - 0.5 * north, 1.25})};
    } else if (kind == 1) {
      const double under = stream.uniform(0.6, 0.9) * settings.height;
      things = {floorBetween(0, 8), boxObject("beam", {thick, 6, 0.4}, {4, 2, under + 0.2})};
    } else if (kind == 2) {
      to.z() = stream.uniform(0.3, 0.8);
      things = {floorBetween(0, 4), floorBetween(4, 8, to.z())};
    } else {
      const double apart = stream.uniform(1.8, 2.5);
      things = {floorBetween(0, 4 - 0.5 * apart), floorBetween(4 + 0.5 * apart, 8)};
    }
    EXPECT_TRUE(OpenFloor(things, settings).isProved(kWestOfWall, to))
        << i << ": " << settings.height << " m tall, " << thick << " m thick";
  }
}

Waypoint besideWall(SampleStream& stream, double x, double y) {
  Waypoint at;
  at.stance.position << x, std::clamp(y + stream.uniform(-0.4, 0.4), 0.0, 4.0), 0.0;
  at.stance.heading = stream.uniform(-0.4, 0.4);
  at.stance.standing = stream.uniform() < 0.6;
  return at;
}

// Heads dip on stairs: by how much at most is by trial. A beam that hangs 1.35 m over the treads is
// too low for all that, for somebody of 1.63 m; one that he may walk under is not.
TEST(OpenEdges, ALowBeamOverAFlightThatGoesOnBeyondItsSidesShutsItOff) {
  for (const auto& [high, shut] : {std::pair(1.2, true), {1.35, true}, {1.9, false}}) {
    std::vector<SceneObject> objects = {floorBetween(-4, 0)};
    for (int i = 1; i <= 10; ++i) {
      const double top = 0.17 * i, go = 0.29;
      objects.push_back(boxObject("tread", {go, 1.4, top}, {go * (i - 0.5), 2, 0.5 * top}));
    }
    objects.push_back(boxObject("landing", {2, 1.4, 1.7}, {3.9, 2, 0.85}));
    const double under = 0.85 + high;  // over the fifth tread
    objects.push_back(boxObject("beam", {0.2, 3, 0.6}, {1.4, 2, under + 0.3}));
    const OpenFloor open(objects);
    const auto failure = open.shutOff({-2, 2, 0}, {4.2, 2, 1.7});
    ASSERT_EQ(failure.has_value(), shut) << high;
    if (!failure) continue;
    ASSERT_GE(failure->object, 0) << high;
    PlanRequest request;
    request.synthesizer = &open.room.synthesizer;
    request.world = &open.room.world;
    request.ground = &open.room.ground;
    EXPECT_EQ(whatShutsOff(*failure, request).object, "beam") << high;
  }
}

// Behind walls that stand along an edge nobody leans out, near as the ground is.
TEST(OpenEdges, WhatGoesFromWallToWallWhereTheFloorEndsShutsOff) {
  for (const double thick : {0.06, 0.1, 0.15}) {
    std::vector<SceneObject> things = {floorBetween(0, 8)};
    for (const double y : {-0.5 * thick, 4 + 0.5 * thick})
      things.push_back(boxObject("side", {8, thick, 2.5}, {4, y, 1.25}));
    things.push_back(boxObject("wall", {0.2, 4, 0.4}, {4, 2, 1.7}));
    expectTheWall(OpenFloor(things), kEastOfWall, std::to_string(thick));
  }
}

// The theorem: past walls and beams that end near the edge, within it or beyond it, and past kerbs
// and breaks of the ground there.
TEST(OpenEdges, NothingThatIsWalkedIsProvedToBeShutOff) {
  SampleStream stream(13, 0);
  int walked = 0, shut = 0;
  for (int i = 0; i < 40; ++i) {
    CharacterSettings settings;
    settings.height = stream.uniform(1.3, 1.95);
    const double thick = stream.uniform(0.05, 1.2), end = stream.uniform(2.6, 4.3);
    const double under = stream.uniform() < 0.3 ? stream.uniform(0.8, 1.02) * settings.height : 0.0;
    const double apart = stream.uniform() < 0.3 ? stream.uniform(0.1, 0.5) : 0.0;
    const double top = apart == 0.0 && stream.uniform() < 0.4 ? stream.uniform(0.05, 0.2) : 0.0;
    std::vector<SceneObject> things = {
        floorBetween(0, 4 - 0.5 * apart), floorBetween(4 + 0.5 * apart, 8, top),
        boxObject("wall", {thick, end + 1, 2.5}, {4, 0.5 * (end - 1), under + 1.25})};
    if (stream.uniform() < 0.5) {  // along the edge, or a little beyond it
      const double west = stream.uniform(0, 4), east = stream.uniform(4, 8);
      things.push_back(boxObject("along", {east - west, 0.1, 2.5},
                                 {0.5 * (west + east), 4.05 + stream.uniform(0, 0.15), 1.25}));
    }
    const OpenFloor open(things, settings);
    shut += open.shutOff(kWestOfWall, kEastOfWall + Eigen::Vector3d(0, 0, top)).has_value();
    for (int k = 0; k < 25; ++k) {
      Waypoint from = besideWall(stream, stream.uniform(2.2, 3.6 - 0.5 * thick), 0.5 * (end + 4.0));
      Waypoint to = besideWall(stream, stream.uniform(4.4 + 0.5 * thick, 5.8), 0.5 * (end + 4.0));
      if (!open.steering.place(from.stance) || !open.steering.place(to.stance)) continue;
      if (!open.steering.steer(from, to, *open.scratch).edge) continue;
      ++walked;
      EXPECT_FALSE(open.shutOff(from.stance.position, to.stance.position).has_value())
          << i << ": a wall " << thick << " m thick to " << end << ", " << under << " m up";
    }
  }
  EXPECT_GE(walked, 100);
  EXPECT_GE(shut, 3);
}

}  // namespace
}  // namespace amble

// Gaps in walls, as narrow as bodies of all heights are: what is proved to shut off is not walked.
#include <gtest/gtest.h>

#include "base/rotation.h"
#include "base/sample_stream.h"
#include "planner/steering/walk_steering.h"
#include "tests/planner/furnished_room.h"

namespace amble {
namespace {

const Eigen::Vector3d kMiddle(3, 2, 0), kNear(1.0, 2, 0), kFar(5.0, 2, 0);
bool goOn() { return false; }

struct Gap {
  double width = 0.5;                // [m]
  double thickness = 0.1;            // of the wall [m]
  double turned = 0.0;               // of the wall, from across the room [rad]
  std::optional<double> after = {};  // a second wall so far behind it, open at the north [m]
};

// The room of 6 x 4 m with a wall across it that has a gap in its middle.
Scene roomWith(const Gap& gap) {
  Scene scene = furnishedScene();
  scene.objects.resize(5);
  constexpr double kLong = 4.0;
  const Eigen::Matrix3d turn = aboutZ(gap.turned).toRotationMatrix();
  for (const double side : {-1.0, 1.0}) {
    SceneObject wall = boxObject(side < 0.0 ? "south" : "north", {gap.thickness, kLong, 2.5},
                                 {0, side * 0.5 * (gap.width + kLong), 1.25});
    wall.X_WO.linear() = turn;
    wall.X_WO.translation() = kMiddle + turn * wall.X_WO.translation();
    scene.objects.push_back(wall);
  }
  if (gap.after) {
    const double x = 3.0 + 0.5 * gap.thickness + *gap.after + 0.05;
    scene.objects.push_back(boxObject("screen", {0.1, 2.9, 2.5}, {x, 1.45, 1.25}));
  }
  return scene;
}

struct Walker {
  Walker(const Gap& gap, double height)
      : room(roomWith(gap), settings(height)),
        steering(room.synthesizer, room.world, room.ground) {}
  static CharacterSettings settings(double height) {
    CharacterSettings settings;
    settings.height = height;
    return settings;
  }
  bool isShutOff(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const {
    return steering.shutOff(from, to, goOn, {&scratch, 1}).has_value();
  }

  const FurnishedRoom room;
  const WalkSteering steering;
  const SteeringScratchPtr scratch = steering.makeScratch();
};

// From somewhere before the gap, or behind it, by a heading towards it, or nearly.
Waypoint beside(SampleStream& stream, double side) {
  Waypoint at;
  at.stance.position =
      kMiddle + Eigen::Vector3d(side * stream.uniform(0.3, 1.5), stream.uniform(-0.4, 0.4), 0.0);
  at.stance.heading = stream.uniform(-0.5, 0.5);
  at.stance.standing = stream.uniform() < 0.6;
  return at;
}

TEST(NarrowGaps, NoneThatIsWalkedThroughShutsOff) {
  SampleStream stream(7, 0);
  int walked = 0, shut = 0;
  for (int i = 0; i < 24; ++i) {
    const double height = stream.uniform(1.2, 2.0);
    const double of_height = i % 2 == 0 ? stream.uniform(0.04, 0.2) : stream.uniform(0.3, 0.55);
    Gap gap{of_height * height, stream.uniform(0.02, 0.5)};
    if (i % 3 == 1) gap.turned = stream.uniform(-0.6, 0.6);
    if (i % 3 == 2) gap.after = stream.uniform(0.15, 0.9) * height;
    const Walker walker(gap, height);
    shut += walker.isShutOff(kNear, kFar);
    for (int k = 0; k < 110; ++k) {
      const Waypoint from = beside(stream, -1.0), to = beside(stream, 1.0);
      if (!walker.steering.steer(from, to, *walker.scratch).edge) continue;
      ++walked;
      EXPECT_FALSE(walker.isShutOff(from.stance.position, to.stance.position))
          << i << ": " << gap.width << " m at " << height;
    }
  }
  EXPECT_GE(walked, 30);
  EXPECT_GE(shut, 4);
}

// Arms hang as one sets off, and the body leans aside over the foot that stands: more get through
// than of those who come along walking.
TEST(NarrowGaps, NoneThatIsWalkedThroughFromAStopBeforeItShutsOff) {
  SampleStream stream(3, 0);
  int from_stops = 0, from_afar = 0;
  for (int i = 0; i < 8; ++i) {
    const double height = stream.uniform(1.2, 2.0);
    const Walker walker({0.38 * height}, height);
    const auto at = [&](double low, double high, double aside, double turned) {
      Waypoint place;
      place.stance.position =
          kMiddle +
          height * Eigen::Vector3d(stream.uniform(low, high), stream.uniform(-aside, aside), 0.0);
      place.stance.heading = stream.uniform(-turned, turned);
      return place;
    };
    const auto passes = [&](const Waypoint& from, const Waypoint& to) {
      if (!walker.steering.steer(from, to, *walker.scratch).edge) return false;
      EXPECT_FALSE(walker.isShutOff(from.stance.position, to.stance.position)) << height;
      return true;
    };
    for (int k = 0; k < 25; ++k) {
      const Waypoint to = at(0.5, 1.0, 0.2, 0.5);
      from_stops += passes(at(-0.2, -0.1, 0.06, 1.0), to);
      from_afar += passes(at(-1.0, -0.3, 0.2, 0.3), to);
    }
  }
  EXPECT_GE(from_stops, 10);
  EXPECT_GT(from_stops, from_afar);
}

TEST(NarrowGaps, ThoseThatThePelvisIsTooThickForShutOffAndNoOthers) {
  for (const double height : {1.2, 1.5, 2.0}) {
    double thick = 0.0;  // front to back
    for (const BodyPart& part : Walker({}, height).room.body.parts)
      if (part.name == "pelvis") thick = 2.0 * part.radius;
    for (const double turned : {0.0, 0.4}) {
      EXPECT_TRUE(Walker({0.85 * thick, 0.1, turned}, height).isShutOff(kNear, kFar)) << height;
      EXPECT_FALSE(Walker({1.01 * thick, 0.1, turned}, height).isShutOff(kNear, kFar)) << height;
    }
  }
}

}  // namespace
}  // namespace amble

// Which steps the ground is said to lead over, beside those that are taken.
#include <gtest/gtest.h>

#include "animation/steps/stride_law.h"
#include "base/rotation.h"
#include "base/sample_stream.h"
#include "planner/steering/ground_reach.h"
#include "planner/steering/walk_steering.h"
#include "tests/planner/furnished_room.h"

namespace amble {
namespace {

// Two floors, beside one another along x = 0.
struct TwoFloors {
  TwoFloors(const std::vector<SceneObject>& objects, const CharacterSettings& settings)
      : scene(sceneWith(objects)),
        ground(scene, ofGround(settings)),
        synthesizer(furnishedRoom().library, ground, settings),
        world(scene, ground, synthesizer.skeleton(), body),
        steering(synthesizer, world, ground) {}
  static Scene sceneWith(const std::vector<SceneObject>& objects) {
    Scene scene;
    scene.objects = objects;
    return scene;
  }
  static GroundSettings ofGround(const CharacterSettings& settings) {
    GroundSettings ground;
    ground.limits = settings.limits;
    return ground;
  }
  bool leads(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const {
    return !findGap(ground, from, to, StrideLaw::kLongestStep * synthesizer.capturedStep());
  }

  const Scene scene;
  const SceneGround ground;
  const WalkSynthesizer synthesizer;
  const Body body = uprightBody(synthesizer);
  const CollisionWorld world;
  const WalkSteering steering;
  const SteeringScratchPtr scratch = steering.makeScratch();
};

CharacterSettings drawnWalker(SampleStream& stream) {
  CharacterSettings settings;
  settings.height = stream.uniform(1.4, 2.0);
  settings.speed = stream.uniform(0.6, 1.4);
  settings.limits.max_climb = stream.uniform() < 0.2 ? 0.0 : stream.uniform(0.05, 0.3);
  settings.limits.max_drop = stream.uniform(0.0, settings.limits.max_climb);
  return settings;
}

std::vector<SceneObject> floorsWithRise(double rise) {
  return {boxObject("low", {5, 4, 0.1}, {-2.5, 0, -0.05}),
          boxObject("high", {5, 4, 0.1 + rise}, {2.5, 0, 0.5 * (rise - 0.1)})};
}

// A rug, a strip, or a slab that is tilted, on either floor beside the edge.
SceneObject drawnThing(SampleStream& stream, double rise) {
  const bool on_high = stream.uniform() < 0.3, tilted = stream.uniform() < 0.4;
  const double length = stream.uniform(0.05, 0.7), thick = stream.uniform(0.003, 0.06);
  const double from_edge = stream.uniform() < 0.5 ? 0.0 : stream.uniform(0.0, 0.3);
  const double x = (on_high ? 1.0 : -1.0) * (from_edge + 0.5 * length);
  SceneObject thing =
      boxObject("thing", {length, 4, thick}, {x, 0, (on_high ? rise : 0.0) + 0.5 * thick});
  if (tilted) {
    const double tilt = stream.uniform(-12.0, 12.0) * kDegree;
    thing.X_WO.linear() = expRotation({0, tilt, 0}).toRotationMatrix();
  }
  return thing;
}

// The theorem: whatever lies about, and however high the step.
TEST(StepLimits, NoStepThatIsTakenIsSaidToBeTooHigh) {
  constexpr int kScenes = 60;
  SampleStream stream(21, 0);
  int taken = 0, apart = 0;
  for (int i = 0; i < kScenes; ++i) {
    const CharacterSettings settings = drawnWalker(stream);
    const double rise = std::max(0.04, settings.limits.max_climb + stream.uniform(-0.03, 0.07));
    std::vector<SceneObject> objects = floorsWithRise(rise);
    for (int k = static_cast<int>(stream.uniform(0.0, 4.0)); k > 0; --k)
      objects.push_back(drawnThing(stream, rise));
    const TwoFloors floors(objects, settings);
    const bool leads = floors.leads({-2, 0, 0}, {2, 0, rise});
    apart += !leads;
    for (int k = 0; k < 12; ++k) {
      Waypoint low, high;
      low.stance.position << stream.uniform(-2.5, -0.3), stream.uniform(-0.5, 0.5), 0.0;
      high.stance.position << stream.uniform(0.3, 2.5), stream.uniform(-0.5, 0.5), rise;
      low.stance.standing = stream.uniform() < 0.6;
      high.stance.standing = stream.uniform() < 0.6;
      if (!floors.steering.place(low.stance) || !floors.steering.place(high.stance)) continue;
      if (k % 2 == 1) {
        std::swap(low, high);
        low.stance.heading = high.stance.heading = kPi;
      }
      if (!floors.steering.steer(low, high, *floors.scratch).edge) continue;
      ++taken;
      EXPECT_TRUE(leads) << i << ": " << rise << " m, where " << settings.limits.max_climb
                         << " is climbed";
    }
  }
  EXPECT_GE(taken, 30);
  EXPECT_GE(apart, 10);
}

TEST(StepLimits, OfTwoLevelFloorsAStepThatIsTooHighByAMillimetreIsProved) {
  SampleStream stream(22, 0);
  for (int i = 0; i < 12; ++i) {
    CharacterSettings settings = drawnWalker(stream);
    settings.limits.max_climb = settings.limits.max_drop = stream.uniform(0.06, 0.3);
    for (const double off : {-1e-3, 1e-3}) {
      const double rise = settings.limits.max_climb + off;
      const TwoFloors floors(floorsWithRise(rise), settings);
      EXPECT_EQ(floors.leads({-2, 0, 0}, {2, 0, rise}), off < 0.0) << rise;
      EXPECT_EQ(floors.leads({2, 0, rise}, {-2, 0, 0}), off < 0.0) << rise;
    }
  }
}

}  // namespace
}  // namespace amble

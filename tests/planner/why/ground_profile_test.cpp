#include "planner/why/ground_profile.h"

#include <gtest/gtest.h>

#include <cmath>

#include "animation/steps/unevenness.h"
#include "base/rotation.h"
#include "base/sample_stream.h"
#include "tests/planner/furnished_room.h"

namespace amble {
namespace {

using Lack = Obstruction::Lack;

// A way of 3 m along a heading from the origin, over two floors 2 m wide that meet in its middle:
// the second so much higher, and so far behind the first's end.
struct Ground {
  Ground(double heading, double rise, double apart)
      : way(std::cos(heading), std::sin(heading), 0.0), room([&] {
          Scene scene;
          const auto floor = [&](const char* name, double middle, double top) {
            SceneObject object = boxObject(name, {2.0, 2.0, 0.1}, {0, 0, 0});
            object.X_WO.linear() =
                Eigen::AngleAxisd(heading, Eigen::Vector3d::UnitZ()).toRotationMatrix();
            object.X_WO.translation() = middle * way + Eigen::Vector3d(0, 0, top - 0.05);
            scene.objects.push_back(object);
          };
          floor("first", 0.5, 0.0);
          floor("second", 2.5 + apart, rise);
          return scene;
        }()) {
    request.synthesizer = &room.synthesizer;
    request.world = &room.world;
    request.ground = &room.ground;
  }
  Obstruction measure(double rise, bool back = false) const {
    Obstruction why;
    const Eigen::Vector3d from(0, 0, 0), to = 3.0 * way + Eigen::Vector3d(0, 0, rise);
    found = back ? measureGround(to, from, request, why) : measureGround(from, to, request, why);
    return why;
  }

  Eigen::Vector3d way;
  const FurnishedRoom room;
  PlanRequest request;
  mutable bool found = false;
};

TEST(GroundProfile, AStepIsAsHighAsItIsFromBelowAndFromAboveByAnyHeading) {
  SampleStream stream(21, 0);
  for (int i = 0; i < 8; ++i) {
    const double rise = stream.uniform(0.27, 0.6), heading = stream.uniform(-kPi, kPi);
    const Ground ground(heading, rise, 0.0);
    for (const bool back : {false, true}) {
      const Obstruction why = ground.measure(rise, back);
      ASSERT_TRUE(ground.found);
      EXPECT_EQ(why.lack, back ? Lack::kDrop : Lack::kStep);
      EXPECT_EQ(why.object, "second");  // whose edge it is, from both sides
      EXPECT_EQ(why.rule, WalkRule::kStepHeight);
      EXPECT_NEAR(*why.width, rise, 1e-3);
      EXPECT_EQ(*why.needed, 0.25);
      EXPECT_NEAR(why.at.head<2>().dot(ground.way.head<2>()), 1.5, 0.02);
    }
  }
}

TEST(GroundProfile, AStepThatIsClimbedIsNoneButTheHighestOfTheWay) {
  for (const double rise : {0.05, 0.15, 0.24}) {
    const Ground ground(0.4, rise, 0.0);
    ground.measure(rise);
    EXPECT_FALSE(ground.found) << rise;
    Obstruction why;
    const Eigen::Vector3d to = 3.0 * ground.way + Eigen::Vector3d(0, 0, rise);
    ASSERT_TRUE(measureRise({0, 0, 0}, to, ground.request, why));
    EXPECT_NEAR(*why.width, rise, 1e-3);
  }
  Obstruction none;
  const Ground level(0.4, 0.0, 0.0);
  EXPECT_FALSE(measureRise({0, 0, 0}, 3.0 * level.way, level.request, none));
}

TEST(GroundProfile, ABreakIsAsWideAsItIsAndOneThatIsSteppedOverIsNone) {
  const double longest = longestBreak(furnishedRoom().synthesizer);
  for (const double beyond : {0.05, 0.2, 0.4}) {
    const Ground ground(1.1, 0.0, longest + beyond);
    const Obstruction why = ground.measure(0.0);
    ASSERT_TRUE(ground.found);
    EXPECT_EQ(why.lack, Lack::kGround);
    EXPECT_EQ(why.rule, WalkRule::kNoGround);
    EXPECT_NEAR(*why.width, longest + beyond, 1e-3);
    EXPECT_NEAR(*why.needed, longest, 1e-9);
  }
  const Ground narrow(1.1, 0.0, longest - 0.02);
  narrow.measure(0.0);
  EXPECT_FALSE(narrow.found);
}

TEST(GroundProfile, ABreakIsShorterThanTheLongestStep) {
  const WalkSynthesizer& synthesizer = furnishedRoom().synthesizer;
  EXPECT_LT(longestBreak(synthesizer), longestStep(synthesizer));
  EXPECT_GT(longestBreak(synthesizer), 0.3);
}

TEST(GroundProfile, WhoMayNotClimbTakesWhatIsNaturalAllTheSame) {
  GroundSettings settings;
  settings.limits.max_climb = settings.limits.max_drop = 0.02;
  for (const double rise : {0.05, 0.08}) {
    Ground ground(0.4, rise, 0.0);
    const SceneGround strict(ground.room.scene, settings);
    ground.request.ground = &strict;
    for (const bool back : {false, true}) {
      const Obstruction why = ground.measure(rise, back);
      ASSERT_EQ(ground.found, rise > Unevenness::kNatural) << rise;
      if (ground.found) {
        EXPECT_EQ(*why.needed, Unevenness::kNatural);
      }
    }
  }
}

TEST(GroundProfile, WhoGoesNowhereLacksNothing) {
  const Ground ground(0.0, 0.5, 0.0);
  Obstruction why;
  EXPECT_FALSE(measureGround({0, 0, 0}, {0, 0, 0}, ground.request, why));
  EXPECT_FALSE(measureRise({0, 0, 0}, {0, 0, 0}, ground.request, why));
}

}  // namespace
}  // namespace amble

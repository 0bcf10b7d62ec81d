#include "planner/why/passage.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "base/rotation.h"
#include "base/sample_stream.h"
#include "tests/planner/furnished_room.h"

namespace amble {
namespace {

constexpr double kFelt = 1e-3;  // of what is felt, at most off [m]

SceneObject turnedBox(const std::string& name, const Eigen::Vector3d& size,
                      const Eigen::Vector3d& at, double angle) {
  SceneObject object = boxObject(name, size, at);
  object.X_WO.linear() = Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  return object;
}

// A floor of 12 x 12 m about the origin with things on it, and what is asked of them.
struct Felt {
  explicit Felt(const std::vector<SceneObject>& things)
      : room([&] {
          Scene scene;
          scene.objects = {boxObject("floor", {12, 12, 0.1}, {0, 0, -0.05})};
          scene.objects.insert(scene.objects.end(), things.begin(), things.end());
          return scene;
        }()) {
    request.synthesizer = &room.synthesizer;
    request.world = &room.world;
    request.ground = &room.ground;
    request.bounds = {Eigen::Vector2d(-6, -6), Eigen::Vector2d(6, 6)};
  }
  std::optional<Obstruction> measure(const Eigen::Vector2d& at, double heading) const {
    Obstruction why;
    const bool found = PassageProbe(request).measure({at.x(), at.y(), 0}, heading, why);
    return found ? std::optional(why) : std::nullopt;
  }

  const FurnishedRoom room;
  PlanRequest request;
};

// Two walls with a gap of a width between them about the origin, which leads by an angle.
std::vector<SceneObject> gapOf(double width, double angle, double thick = 0.1) {
  const Eigen::Vector2d aside(-std::sin(angle), std::cos(angle));
  std::vector<SceneObject> walls;
  for (const double side : {1.0, -1.0}) {
    const Eigen::Vector2d middle = side * (0.5 * width + 1.0) * aside;
    walls.push_back(turnedBox(side > 0 ? "left" : "right", {thick, 2.0, 2.5},
                              {middle.x(), middle.y(), 1.25}, angle));
  }
  return walls;
}

TEST(PassageProbe, OfAnOpenFloorThereIsNothing) {
  const Felt open({});
  EXPECT_FALSE(PassageProbe(open.request).nearest({0, 0, 0}).has_value());
  EXPECT_FALSE(PassageProbe(open.request).topOver({0, 0, 0}).has_value());
  EXPECT_FALSE(open.measure({0, 0}, 0.3).has_value());
}

TEST(PassageProbe, AGapIsAsWideAsItIsByWhateverAngleItLeads) {
  SampleStream stream(11, 0);
  for (int i = 0; i < 8; ++i) {
    const double width = stream.uniform(0.25, 0.5), angle = stream.uniform(-kPi, kPi);
    const Felt felt(gapOf(width, angle));
    const auto why = felt.measure({0, 0}, angle);
    ASSERT_TRUE(why && why->width && why->needed) << width;
    EXPECT_EQ(why->lack, Obstruction::Lack::kGap);
    EXPECT_NEAR(*why->width, width, kFelt);
    EXPECT_GT(*why->needed, width);
    EXPECT_LT(why->at.head<2>().norm(), 0.06) << "in its middle";
    EXPECT_EQ((std::set<std::string>{why->object, why->other}),
              (std::set<std::string>{"left", "right"}));
  }
}

// Aslant a gap looks wider than it is: it is measured straight across. Of walls so thick that they
// are to both sides of who comes aslant, too.
TEST(PassageProbe, WhoComesAslantFindsTheSameGap) {
  const Felt felt(gapOf(0.4, 0.0, 0.3));
  for (const double aslant : {-25.0, -10.0, 10.0, 25.0}) {
    const auto why = felt.measure({0, 0}, aslant * kDegree);
    ASSERT_TRUE(why && why->width) << aslant;
    EXPECT_NEAR(*why->width, 0.4, 3 * kFelt) << aslant;
  }
}

// Places that are looked at may lie in the plane of a wall's face: aslant there are no two sides.
TEST(PassageProbe, AGapIsFoundFromWhereverOnItsWayItIsLookedAt) {
  for (const double thick : {0.05, 0.1, 0.3}) {
    const Felt felt(gapOf(0.4, 0.0, thick));
    for (const double x : {-0.4, -0.3, -0.15, -0.03, 0.0, 0.013, 0.05, 0.15, 0.3}) {
      const auto why = felt.measure({x, 0}, 0.0);
      ASSERT_TRUE(why && why->width) << thick << " from " << x;
      EXPECT_NEAR(*why->width, 0.4, 2 * kFelt) << thick << " from " << x;
    }
  }
}

TEST(PassageProbe, WhatWouldDoDoesNotDependOnHowNarrowItIsNorOnItsAngle) {
  const double needed = *Felt(gapOf(0.3, 0.0)).measure({0, 0}, 0.0)->needed;
  EXPECT_NEAR(*Felt(gapOf(0.45, 0.0)).measure({0, 0}, 0.0)->needed, needed, 0.01);
  EXPECT_NEAR(*Felt(gapOf(0.3, 1.0)).measure({0, 0}, 1.0)->needed, needed, 0.01);
  EXPECT_FALSE(Felt(gapOf(needed + 0.005, 0.0)).measure({0, 0}, 0.0).has_value());
  EXPECT_TRUE(Felt(gapOf(needed - 0.005, 0.0)).measure({0, 0}, 0.0).has_value());
}

TEST(PassageProbe, ALongGapNeedsNoLessThanAShortOne) {
  const auto neededFor = [](double thick) {
    return *Felt(gapOf(0.3, 0.0, thick)).measure({0, 0}, 0.0)->needed;
  };
  EXPECT_LE(neededFor(0.05), neededFor(0.3) + 0.005);
  EXPECT_LE(neededFor(0.3), neededFor(1.2) + 0.005);
}

TEST(PassageProbe, ABeamHangsAsHighAsItDoes) {
  SampleStream stream(12, 0);
  const double stature = furnishedRoom().synthesizer.stature();
  for (int i = 0; i < 6; ++i) {
    const double under = stream.uniform(0.8 * stature, stature - 0.01);
    const Felt felt({boxObject("beam", {0.2, 4.0, 0.2}, {0, 0, under + 0.1})});
    const auto why = felt.measure({0, 0}, 0.0);
    ASSERT_TRUE(why && why->width && why->needed);
    EXPECT_EQ(why->lack, Obstruction::Lack::kHeadroom);
    EXPECT_EQ(why->object, "beam");
    EXPECT_NEAR(*why->width, under, kFelt);
    EXPECT_NEAR(*why->needed, stature, 1e-9);
  }
  EXPECT_FALSE(Felt({boxObject("beam", {0.2, 4.0, 0.2}, {0, 0, stature + 0.12})})
                   .measure({0, 0}, 0.0)
                   .has_value());
}

TEST(PassageProbe, OfTwoBeamsTheLowerIsTold) {
  const double stature = furnishedRoom().synthesizer.stature();
  const Felt felt({boxObject("high", {0.1, 4.0, 0.2}, {-0.2, 0, stature - 0.05 + 0.1}),
                   boxObject("low", {0.1, 4.0, 0.2}, {0.2, 0, stature - 0.15 + 0.1})});
  const auto why = felt.measure({0, 0}, 0.0);
  ASSERT_TRUE(why.has_value());
  EXPECT_EQ(why->object, "low");
  EXPECT_NEAR(*why->width, stature - 0.15, kFelt);
}

TEST(PassageProbe, AThingInTheWayIsAsHighAsItIsAndWhatIsSteppedOverIsNone) {
  for (const double height : {0.3, 0.45, 0.7, 1.0}) {
    const Felt felt({boxObject("log", {0.3, 4.0, height}, {0.3, 0, 0.5 * height})});
    const auto why = felt.measure({0.1, 0}, 0.0);
    ASSERT_TRUE(why && why->width && why->needed) << height;
    EXPECT_EQ(why->lack, Obstruction::Lack::kStep);
    EXPECT_EQ(why->object, "log");
    EXPECT_NEAR(*why->width, height, kFelt);
    EXPECT_EQ(*why->needed, 0.25);
  }
  EXPECT_FALSE(
      Felt({boxObject("log", {0.3, 4.0, 0.2}, {0.3, 0, 0.1})}).measure({0.1, 0}, 0.0).has_value());
}

// From a place beside a post: the distance to its face, and the post that is nearer.
TEST(PassageProbe, TheNearestOfTwoIsAsFarAsItsFace) {
  SampleStream stream(13, 0);
  for (int i = 0; i < 6; ++i) {
    const double a = stream.uniform(0.2, 0.5), b = stream.uniform(0.6, 0.9);
    const Felt felt({boxObject("near", {0.2, 6, 2}, {a + 0.1, 0, 1}),
                     boxObject("far", {0.2, 6, 2}, {-b - 0.1, 0, 1})});
    const auto side = PassageProbe(felt.request).nearest({0, 0, 0});
    ASSERT_TRUE(side.has_value());
    EXPECT_EQ(felt.room.scene.objects.at(static_cast<size_t>(side->object)).name, "near");
    EXPECT_NEAR(side->distance, a - 0.02, 0.021) << "of a post of 2 cm";
  }
}

}  // namespace
}  // namespace amble

#include "environments/ground/ground_warnings.h"

#include <gtest/gtest.h>

#include "tests/environments/test_scenes.h"

namespace amble {
namespace {

const TriangleMesh kSheet{{{0, 0, 0}, {6, 0, 0}, {6, 4, 0}, {0, 4, 0}}, {{0, 1, 2}, {0, 2, 3}}};

std::vector<std::string> warningsOf(std::vector<SceneObject> objects) {
  const Scene scene = sceneOf(std::move(objects));
  return groundWarnings(scene, SceneGround(scene));
}

TEST(GroundWarnings, AFloorThatFacesDownIsNamed) {
  const auto warnings = warningsOf({makeObject("floor", turned(kSheet), {0, 0, 0})});
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_TRUE(warnings[0].starts_with("floor: faces down")) << warnings[0];
}

TEST(GroundWarnings, AFloorThatFacesUpIsNot) {
  EXPECT_TRUE(warningsOf({makeObject("floor", kSheet, {0, 0, 0})}).empty());
}

TEST(GroundWarnings, ACeilingOverAFloorIsNot) {
  EXPECT_TRUE(warningsOf({makeObject("floor", kSheet, {0, 0, 0}),
                          makeObject("ceiling", turned(kSheet), {0, 0, 2.5})})
                  .empty());
}

TEST(GroundWarnings, WhatHasARoleIsMeantSo) {
  EXPECT_TRUE(warningsOf({makeObject("floor", turned(kSheet), {0, 0, 0}, Role::kGround)}).empty());
  EXPECT_TRUE(
      warningsOf({makeObject("floor", turned(kSheet), {0, 0, 0}, Role::kObstacle)}).empty());
}

TEST(GroundWarnings, SolidsAreNot) {
  EXPECT_TRUE(warningsOf({makeObject("roof", turned(makeBox({6, 4, 0.2})), {0, 0, 3})}).empty());
}

std::vector<std::string> flightWarnings(double rise, double max_climb, int treads = 6) {
  std::vector<SceneObject> objects = stairs(treads, rise, 0.37);
  objects.push_back(floorSlab());
  const Scene scene = sceneOf(objects);
  GroundSettings settings;
  settings.limits.max_climb = max_climb;
  return groundWarnings(scene, SceneGround(scene, settings));
}

TEST(GroundWarnings, AFlightOfStepsTooHighForFlightsIsToldWithItsRise) {
  const auto warnings = flightWarnings(0.33, 0.4);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(warnings[0].find("rise by 0.33 m"), std::string::npos) << warnings[0];
}

TEST(GroundWarnings, LowFlightsAndSingleStepsAreNot) {
  EXPECT_TRUE(flightWarnings(0.28, 0.4).empty());
  EXPECT_TRUE(flightWarnings(0.17, 0.4).empty());
  EXPECT_TRUE(flightWarnings(0.33, 0.4, 1).empty());
  EXPECT_TRUE(flightWarnings(0.33, 0.3).empty());  // nobody asks to climb it
}

}  // namespace
}  // namespace amble

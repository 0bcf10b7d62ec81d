#include "environments/ground/ground_warnings.h"

#include <gtest/gtest.h>

#include <array>

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

std::vector<std::string> flightWarnings(double rise, double going, double max_climb = 0.4,
                                        int treads = 6, double turn = 0.0) {
  std::vector<SceneObject> objects = stairs(treads, rise, going);
  for (SceneObject& object : objects)
    object.X_WO = Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitZ()) * object.X_WO;
  objects.push_back(floorSlab());
  const Scene scene = sceneOf(objects);
  GroundSettings settings;
  settings.limits.max_climb = max_climb;
  return groundWarnings(scene, SceneGround(scene, settings));
}

TEST(GroundWarnings, AFlightTooSteepToBeClimbedIsToldWithItsRiseAndGoing) {
  const auto warnings = flightWarnings(0.33, 0.37);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(warnings[0].find("rise by 0.33 m over 0.37 m"), std::string::npos) << warnings[0];
}

TEST(GroundWarnings, FlightsAreToldJustWhereNoWalkIsFound) {
  // As flights of four steps were walked, or not, by the default walker.
  const std::vector<std::array<double, 2>> climbed = {
      {0.17, 0.29}, {0.23, 0.25}, {0.23, 0.28}, {0.27, 0.31}, {0.28, 0.34},
      {0.30, 0.37}, {0.28, 0.45}, {0.33, 0.45}, {0.33, 0.60}, {0.38, 0.60}};
  const std::vector<std::array<double, 2>> refused = {{0.25, 0.25}, {0.25, 0.28}, {0.28, 0.28},
                                                      {0.28, 0.31}, {0.30, 0.34}, {0.33, 0.37},
                                                      {0.38, 0.45}};
  // However they lie.
  for (const double turn : {0.0, 0.4, 0.785}) {
    for (const auto& [rise, going] : climbed)
      EXPECT_TRUE(flightWarnings(rise, going, 0.4, 4, turn).empty()) << rise << " over " << going;
    for (const auto& [rise, going] : refused)
      EXPECT_EQ(flightWarnings(rise, going, 0.4, 4, turn).size(), 1u) << rise << " over " << going;
  }
}

TEST(GroundWarnings, SingleStepsAndThoseThatNobodyAsksToClimbAreNot) {
  EXPECT_TRUE(flightWarnings(0.33, 0.37, 0.4, 1).empty());
  EXPECT_TRUE(flightWarnings(0.33, 0.37, 0.3).empty());
}

}  // namespace
}  // namespace amble

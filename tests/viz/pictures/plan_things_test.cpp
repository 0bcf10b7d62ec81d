#include "viz/pictures/plan_things.h"

#include <gtest/gtest.h>

#include "tests/environments/test_meshes.h"
#include "tests/viz/test_walk.h"

namespace amble {
namespace {

const PlanThing& named(const std::vector<PlanThing>& things, const std::string& name) {
  return *std::find_if(things.begin(), things.end(),
                       [&](const PlanThing& thing) { return thing.name == name; });
}

TEST(PlanThings, OfAnEmptySceneAreNone) { EXPECT_TRUE(cutScene(Scene{}, 0.0).empty()); }

TEST(PlanThings, AreCutAtTheirHeightsOverTheFloor) {
  Scene scene = testRoom();
  scene.objects.push_back(testBox("shelf", {1, 0.5, 0.1}, {2, 2, 1.5}));  // over the hips
  for (const double floor : {0.0, 3.0}) {
    Scene moved = scene;
    for (SceneObject& object : moved.objects) object.X_WO.translation().z() += floor;
    const auto things = cutScene(moved, floor);
    ASSERT_EQ(things.size(), moved.objects.size());
    EXPECT_TRUE(named(things, "shelf").hips.empty());
    EXPECT_NEAR(coveredArea(named(things, "shelf").body), 0.5, 1e-9);
    EXPECT_NEAR(coveredArea(named(things, "chest").hips), 0.3, 1e-9);
    EXPECT_NEAR(coveredArea(named(things, "floor").floor), 24.0, 1e-9);
    EXPECT_TRUE(named(things, "floor").body.empty());
    EXPECT_NEAR(named(things, "chest").top, 0.7, 1e-9);
  }
}

TEST(PlanThings, ObjectsOfOneNameAreOneThingUnlessTheyFillAFlat) {
  Scene scene;
  scene.objects = {testBox("pair", {0.4, 0.4, 1}, {0, 0, 0.5}),
                   testBox("pair", {0.4, 0.4, 1}, {1, 0, 0.5})};
  EXPECT_EQ(cutScene(scene, 0.0).size(), 1u);
  scene.objects[1].X_WO.translation().x() = 9.0;
  EXPECT_EQ(cutScene(scene, 0.0).size(), 2u);
}

// A table's top is over its legs: what a body can touch is the top, at hip height too.
TEST(PlanThings, OfAMeshAreTheOutlinesOfItsSlices) {
  TriangleMesh table = moved(makeBox({1.2, 0.8, 0.04}), {0, 0, 0.72});
  for (const double x : {-0.5, 0.5})
    for (const double y : {-0.3, 0.3})
      table = joined(table, moved(makeBox({0.06, 0.06, 0.7}), {x, y, 0.35}));
  SceneObject object;
  object.name = "table";
  object.shape = table;
  object.X_WO.translation() = Eigen::Vector3d(2, 1, 0);
  Scene scene;
  scene.objects = {object};
  const auto things = cutScene(scene, 0.0);
  ASSERT_EQ(things.size(), 1u);
  EXPECT_NEAR(coveredArea(things[0].body), 1.2 * 0.8, 0.03);
  EXPECT_NEAR(coveredArea(things[0].hips), 1.2 * 0.8, 0.03);
  EXPECT_NEAR(coveredArea(things[0].floor), 4 * 0.06 * 0.06, 0.01);
  EXPECT_NEAR(things[0].top, 0.74, 1e-9);
  EXPECT_LT((things[0].box.center() - Eigen::Vector2d(2, 1)).norm(), 0.01);
}

TEST(PlanThings, WhatHangsOverEveryHeadIsNotDrawn) {
  Scene scene;
  scene.objects = {testBox("lamp", {0.4, 0.4, 0.3}, {1, 1, 2.2})};
  const auto things = cutScene(scene, 0.0);
  EXPECT_TRUE(things[0].body.empty() && things[0].hips.empty() && things[0].floor.empty());
  EXPECT_TRUE(things[0].box.isEmpty());
}

}  // namespace
}  // namespace amble

#include "viz/plan_things.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace amble

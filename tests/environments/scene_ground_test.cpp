#include "environments/scene_ground.h"

#include <gtest/gtest.h>

#include <cmath>

#include "animation/rotation.h"
#include "tests/environments/test_scenes.h"

namespace amble {
namespace {

TEST(SceneGround, IsTheFloorAndWhatLiesOnItButNoFurniture) {
  const Scene scene = sceneOf({floorSlab(), makeObject("rug", Box{{2, 2, 0.01}}, {3, 0, 0.005}),
                               makeObject("table", makeBox({1, 1, 0.05}), {-3, 0, 0.725}),
                               makeObject("step", Box{{1, 1, 0.15}}, {0, 5, 0.075})});
  const SceneGround ground(scene, 0.0);
  EXPECT_TRUE(ground.isGround(0));
  EXPECT_TRUE(ground.isGround(1));
  EXPECT_FALSE(ground.isGround(2));
  EXPECT_FALSE(ground.isGround(3));
  EXPECT_NEAR(ground.height(0, 0, 0, 0.3).value(), 0.0, 1e-12);
  EXPECT_NEAR(ground.height(3, 0, 0, 0.3).value(), 0.01, 1e-12);
  EXPECT_NEAR(ground.height(-3, 0, 0, 1.0).value(), 0.0, 1e-12);
  EXPECT_EQ(ground.extent().min(), Eigen::Vector2d(-10, -10));
  EXPECT_EQ(ground.extent().max(), Eigen::Vector2d(10, 10));
}

TEST(SceneGround, EndsWhereTheFloorEnds) {
  const SceneGround ground(sceneOf({floorSlab()}), 0.0);
  EXPECT_TRUE(ground.height(10, 10, 0, 0.3).has_value());
  EXPECT_FALSE(ground.height(10.01, 0, 0, 0.3).has_value());
  EXPECT_FALSE(ground.height(1e9, 0, 0, 0.3).has_value());
  EXPECT_FALSE(ground.height(0, 0, 0.5, 0.3).has_value());
  EXPECT_FALSE(ground.height(0, 0, -0.5, 0.3).has_value());
}

TEST(SceneGround, OfASceneWithoutFloorIsNowhere) {
  const SceneGround ground(sceneOf({}), 0.0);
  EXPECT_FALSE(ground.height(0, 0, 0, 1).has_value());
  EXPECT_TRUE(ground.extent().isEmpty());
}

TEST(SceneGround, RolesDecide) {
  const auto slab = [](Role role) {
    SceneObject object = floorSlab();
    object.role = role;
    return SceneGround(sceneOf({object}), 0.0).height(0, 0, 0, 0.1).has_value();
  };
  EXPECT_TRUE(slab(Role::kAuto));
  EXPECT_TRUE(slab(Role::kGround));
  EXPECT_FALSE(slab(Role::kObstacle));
  EXPECT_FALSE(slab(Role::kIgnore));
}

TEST(SceneGround, SteepAndDownFacingSurfacesAreNoGround) {
  SceneObject ramp = makeObject("ramp", Box{{4, 4, 0.01}}, {0, 0, 0});
  ramp.X_WO.linear() = expRotation({0.4, 0, 0}).toRotationMatrix();
  EXPECT_FALSE(SceneGround(sceneOf({ramp}), 0.0).isGround(0));
  const TriangleMesh up{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, {{0, 1, 2}}};
  EXPECT_TRUE(SceneGround(sceneOf({makeObject("sheet", up, {0, 0, 0})}), 0.0).isGround(0));
  EXPECT_FALSE(SceneGround(sceneOf({makeObject("sheet", turned(up), {0, 0, 0})}), 0.0).isGround(0));
  EXPECT_TRUE(SceneGround(sceneOf({makeObject("sheet", turned(up), {0, 0, 0}, Role::kGround)}), 0.0)
                  .isGround(0));
}

TEST(SceneGround, AClosedMeshFacesOutHoweverItIsWound) {
  const TriangleMesh slab = makeBox({20, 20, 0.1});
  for (const TriangleMesh& mesh : {slab, turned(slab)}) {
    const SceneGround ground(sceneOf({makeObject("floor", mesh, {0, 0, -0.05})}), 0.0);
    EXPECT_NEAR(ground.height(1, 2, 0, 0.3).value(), 0.0, 1e-12);
  }
}

TEST(SceneGround, HasNoSeamsBetweenTiles) {
  std::vector<SceneObject> tiles;
  for (int i = 0; i < 4; ++i)
    tiles.push_back(makeObject("tile", makeBox({0.3, 3, 0.02}), {0.3 * i, 0, -0.01}));
  const SceneGround ground(sceneOf(tiles), 0.0);
  for (double x = -0.15; x <= 1.05; x += 0.01)
    EXPECT_TRUE(ground.height(x, 0.7, 0, 0.1).has_value()) << x;
}

TEST(Floors, ListsStoreysAndNoTables) {
  const Scene scene = sceneOf({floorSlab(), makeObject("upstairs", Box{{10, 10, 0.2}}, {0, 0, 2.6}),
                               makeObject("table", Box{{2, 1, 0.05}}, {0, 0, 0.725}),
                               makeObject("rug", Box{{2, 2, 0.01}}, {0, 0, 0.005})});
  const std::vector<double> two = floors(scene, 0, 0);
  ASSERT_EQ(two.size(), 2u);
  EXPECT_NEAR(two[0], 0.0, 1e-12);
  EXPECT_NEAR(two[1], 2.7, 1e-12);
  EXPECT_EQ(floors(scene, 8, 8).size(), 1u);
  EXPECT_TRUE(floors(scene, 30, 0).empty());
}

TEST(Floors, ASmallPlatformCountsWhereItIsSaidToBeGround) {
  const SceneObject stage = makeObject("stage", Box{{1, 1, 0.4}}, {0, 0, 0.2}, Role::kGround);
  EXPECT_EQ(floors(sceneOf({floorSlab(), stage}), 0, 0).size(), 2u);
}

TEST(Floors, WhereOnlySmallThingsAreTheyAreFloors) {
  const SceneObject stool = makeObject("stool", Box{{0.5, 0.5, 0.4}}, {0, 0, 0.2});
  EXPECT_EQ(floors(sceneOf({stool}), 0, 0), std::vector<double>{0.4});
}

}  // namespace
}  // namespace amble

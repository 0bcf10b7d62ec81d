#include "environments/ground_layer.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/environments/test_scenes.h"

namespace amble {
namespace {

// A slab and a rug of 1 cm on a part of it.
struct Rug {
  Scene scene = sceneOf({floorSlab(), makeObject("rug", Box{{2, 2, 0.01}}, {0, 0, 0.005})});
  SceneGround ground{scene, 0.0};
  GroundLayer layer{{surface(0), surface(1)}, ground};
  ObstacleSet::ScratchPtr scratch = ObstacleSet::makeScratch();

  Obstacle surface(int object) const {
    return {object, worldMesh(scene.objects[object]), Eigen::Isometry3d::Identity(), {}};
  }
  int touched(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double depth) const {
    return layer.touched({from, to, 0.02}, depth, *scratch);
  }
  double ceiling(const Eigen::Vector2d& min, const Eigen::Vector2d& max) const {
    return layer.ceiling(
        {Eigen::Vector3d(min.x(), min.y(), 0), Eigen::Vector3d(max.x(), max.y(), 1)});
  }
};

TEST(GroundLayer, OfNothingIsNowhere) {
  const Scene scene = sceneOf({});
  const SceneGround ground(scene, 0.0);
  const GroundLayer layer({}, ground);
  const auto scratch = ObstacleSet::makeScratch();
  EXPECT_EQ(layer.touched({{0, 0, -1}, {1, 0, -1}, 0.1}, 0.0, *scratch), -1);
  EXPECT_TRUE(std::isinf(layer.ceiling({Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 1, 1)})));
}

TEST(GroundLayer, ItsCeilingIsTheHighestSurfaceThere) {
  const Rug rug;
  EXPECT_EQ(rug.layer.highest(), 0.01);
  EXPECT_EQ(rug.ceiling({-0.1, -0.1}, {0.1, 0.1}), 0.01);
  EXPECT_EQ(rug.ceiling({3, 3}, {4, 4}), 0.0);
  EXPECT_EQ(rug.ceiling({0.9, 0}, {3, 0}), 0.01);
  EXPECT_TRUE(std::isinf(rug.ceiling({30, 30}, {31, 31})));
}

TEST(GroundLayer, DepthIsAllowedToTheMillimetre) {
  const Rug rug;
  for (const auto& [x, top] : {std::pair(0.0, 0.01), std::pair(5.0, 0.0)}) {
    const auto sole = [&](double z) {
      return rug.touched({x, 0, top + z + 0.02}, {x + 0.2, 0, top + z + 0.02}, 0.005);
    };
    EXPECT_EQ(sole(0.001), -1);
    EXPECT_EQ(sole(-0.0049), -1);
    EXPECT_GE(sole(-0.0051), 0);
  }
}

TEST(GroundLayer, WhatLiesUnderTheGroundIsTouchedThoughItTouchesNoSurface) {
  const Rug rug;
  EXPECT_GE(rug.touched({5, 0, -0.05}, {5.1, 0, -0.05}, 0.0), 0);   // within the slab
  EXPECT_GE(rug.touched({5, 0, -3.0}, {5.1, 0, -3.0}, 0.005), 0);   // a storey below
  EXPECT_EQ(rug.touched({15, 0, -3.0}, {15.1, 0, -3.0}, 0.0), -1);  // beside the floor
}

TEST(GroundLayer, TheEdgeOfARugIsTouchedFromTheSideOnly) {
  const Rug rug;
  // A sole on the floor that comes nearer to the rug's edge at x = 1.
  EXPECT_EQ(rug.touched({1.2, 0, 0.02}, {1.03, 0, 0.02}, 0.001), -1);
  EXPECT_EQ(rug.touched({1.2, 0, 0.02}, {1.01, 0, 0.02}, 0.001), 1);
  EXPECT_EQ(rug.touched({1.2, 0, 0.031}, {0.8, 0, 0.031}, 0.001), -1);
}

}  // namespace
}  // namespace amble

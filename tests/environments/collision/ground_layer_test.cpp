#include "environments/collision/ground_layer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "tests/environments/test_scenes.h"

namespace amble {
namespace {

// A slab and a rug of 1 cm on a part of it.
struct Rug {
  Scene scene = sceneOf({floorSlab(), makeObject("rug", Box{{2, 2, 0.01}}, {0, 0, 0.005})});
  GroundLayer layer{{surface(0), surface(1)}};
  ObstacleSet::ScratchPtr scratch = ObstacleSet::makeScratch();

  Obstacle surface(int object) const {
    const TriangleMesh mesh = worldMesh(scene.objects[object]);
    return {object, mesh, Eigen::Isometry3d::Identity(), SolidMesh(mesh)};
  }
  int touched(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double depth) const {
    return layer.touched({from, to, 0.02}, depth, *scratch);
  }
};

TEST(GroundLayer, OfNothingIsNowhere) {
  const GroundLayer layer({});
  const auto scratch = ObstacleSet::makeScratch();
  const Capsule capsule{{0, 0, -1}, {1, 0, -1}, 0.1};
  EXPECT_EQ(layer.touched(capsule, 0.0, *scratch), -1);
  EXPECT_TRUE(layer.isClearBetween(capsule, capsule, 0.0, 0.0));
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

// The layer takes triangles that the solid shares with the surface once, whatever comes between.
TEST(GroundLayer, ASolidThatIsTheSurfaceInAnotherOrderIsTheSame) {
  const TriangleMesh slab = makeBox({6, 5, 0.4});
  TriangleMesh shuffled = slab, top = slab;
  std::swap(shuffled.triangles[1], shuffled.triangles[7]);
  std::reverse(shuffled.triangles.begin() + 3, shuffled.triangles.end());
  std::erase_if(top.triangles, [&](const std::array<int, 3>& t) {
    return slab.vertices[t[0]].z() + slab.vertices[t[1]].z() + slab.vertices[t[2]].z() < 0.5;
  });
  ASSERT_EQ(top.triangles.size(), 2u);
  const auto here = Eigen::Isometry3d::Identity();
  const GroundLayer same({{0, slab, here, SolidMesh(slab)}}),
      other({{0, slab, here, SolidMesh(shuffled)}}), covered({{0, top, here, SolidMesh(slab)}});
  const auto scratch = ObstacleSet::makeScratch();
  std::mt19937_64 generator(21);
  const Eigen::AlignedBox3d box(Eigen::Vector3d(-3.5, -3, -0.5), Eigen::Vector3d(3.5, 3, 0.6));
  int touching = 0;
  for (int n = 0; n < 5000; ++n) {
    const Capsule capsule = randomCapsule(generator, box, 0.3);
    const int object = same.touched(capsule, 0.0, *scratch);
    EXPECT_EQ(other.touched(capsule, 0.0, *scratch), object);
    EXPECT_EQ(same.isAbove(capsule, 0.0), covered.isAbove(capsule, 0.0));
    touching += object >= 0;
  }
  EXPECT_GT(touching, 1000);
}

TEST(GroundLayer, TheEdgeOfARugIsTouchedFromTheSideOnly) {
  const Rug rug;
  // A sole on the floor that comes nearer to the rug's edge at x = 1.
  EXPECT_EQ(rug.touched({1.2, 0, 0.02}, {1.03, 0, 0.02}, 0.001), -1);
  EXPECT_EQ(rug.touched({1.2, 0, 0.02}, {1.01, 0, 0.02}, 0.001), 1);
  EXPECT_EQ(rug.touched({1.2, 0, 0.031}, {0.8, 0, 0.031}, 0.001), -1);
}

// Ten steps up from a slab, whole, as the layer and as FCL sees them.
struct Stair {
  Scene scene = [] {
    std::vector<SceneObject> objects = stairs(10, 0.17, 0.29);
    objects.push_back(floorSlab());
    return sceneOf(objects);
  }();
  std::vector<Obstacle> surfaces = [this] {
    std::vector<Obstacle> all;
    for (size_t i = 0; i < scene.objects.size(); ++i) {
      const TriangleMesh mesh = worldMesh(scene.objects[i]);
      all.push_back({static_cast<int>(i), mesh, Eigen::Isometry3d::Identity(), SolidMesh(mesh)});
    }
    return all;
  }();
  GroundLayer layer{surfaces};
  ObstacleSet::ScratchPtr scratch = ObstacleSet::makeScratch();
};

TEST(GroundLayer, ASoleMaySinkIntoATreadAndOverItsEdgeButNotIntoARiser) {
  const Stair stair;
  const auto sole = [&](double heel, double tip, double z) {
    return stair.layer.touched({{heel, 0, z + 0.02}, {tip, 0, z + 0.02}, 0.02}, 0.005,
                               *stair.scratch);
  };
  EXPECT_EQ(sole(0.33, 0.55, 0.34), -1);
  EXPECT_EQ(sole(0.33, 0.55, 0.34 - 0.004), -1);
  EXPECT_GE(sole(0.33, 0.55, 0.34 - 0.006), 0);
  EXPECT_EQ(sole(0.20, 0.50, 0.34 - 0.004), -1);  // the heel over the edge
  EXPECT_GE(sole(0.33, 0.57, 0.34), 0);           // the toes in the next riser
  EXPECT_GE(sole(-0.3, -0.01, 0.0), 0);
  EXPECT_EQ(sole(-0.3, -0.021, 0.0), -1);
}

TEST(GroundLayer, GivesTheAnswersOfFclOnStairs) {
  const Stair stair;
  const ObstacleSet exact(stair.surfaces);
  std::mt19937_64 generator(3);
  int touching = 0, clear = 0;
  const Eigen::AlignedBox3d box(Eigen::Vector3d(-1, -1.3, 0), Eigen::Vector3d(3.2, 1.3, 2.2));
  for (int n = 0; n < 20000; ++n) {
    const Capsule capsule = randomCapsule(generator, box, 0.3);
    const bool touches = exact.touched(capsule, *stair.scratch) >= 0;
    EXPECT_EQ(stair.layer.touched(capsule, 0.0, *stair.scratch) >= 0, touches)
        << capsule.from.transpose() << " to " << capsule.to.transpose() << " radius "
        << capsule.radius;
    touching += touches;
    clear += stair.layer.isClearBetween(capsule, capsule, 0.0, 0.0);
  }
  EXPECT_GT(touching, 4000);
  EXPECT_GT(clear, 4000);
}

TEST(GroundLayer, WhatIsClearBetweenTwoPlacesTouchesNothingOnTheWay) {
  const Stair stair;
  std::mt19937_64 generator(4);
  int clear = 0;
  const Eigen::AlignedBox3d box(Eigen::Vector3d(-1, -1.3, 0), Eigen::Vector3d(3.2, 1.3, 2.2));
  for (int n = 0; n < 4000; ++n) {
    const Capsule a = randomCapsule(generator, box, 0.3);
    const Eigen::Vector3d way = 0.3 * Eigen::Vector3d::Random();
    const Capsule b{a.from + way, a.to + way, a.radius};
    if (stair.layer.touched(a, 0.0, *stair.scratch) >= 0) continue;
    if (!stair.layer.isClearBetween(a, b, 0.0, 0.0)) continue;
    ++clear;
    for (double t = 0.1; t < 1.05; t += 0.1) {
      const Capsule between{a.from + t * way, a.to + t * way, a.radius};
      EXPECT_EQ(stair.layer.touched(between, 0.0, *stair.scratch), -1);
    }
  }
  EXPECT_GT(clear, 400);
}

// On the stair, beside it and beyond the slab's border.
TEST(GroundLayer, WhatIsAboveTheGroundTouchesNothing) {
  const Stair stair;
  std::mt19937_64 generator(5);
  for (const Eigen::Vector2d& middle : {Eigen::Vector2d(1, 0), {10, 0}, {0, -10}}) {
    int above = 0, free = 0;
    const Eigen::Vector3d low(middle.x() - 1.5, middle.y() - 1.5, -0.1);
    const Eigen::AlignedBox3d box(low, low + Eigen::Vector3d(3, 3, 2.2));
    for (int n = 0; n < 20000; ++n) {
      const Capsule capsule = randomCapsule(generator, box, 0.3);
      const bool is_free = stair.layer.touched(capsule, 0.002, *stair.scratch) < 0;
      free += is_free;
      const bool is_above = stair.layer.isAbove(capsule, 0.002);
      if (is_above) {
        EXPECT_TRUE(stair.layer.isFree(capsule, 0.002));
      }
      if (!stair.layer.isFree(capsule, 0.002)) continue;
      above += is_above;
      EXPECT_TRUE(is_free) << capsule.from.transpose() << " to " << capsule.to.transpose()
                           << " radius " << capsule.radius;
    }
    EXPECT_GT(above, free / 2);
  }
}

TEST(GroundLayer, BelowABridgeIsFreeWhereTheGroundGoesOnBelow) {
  const TriangleMesh deck{{{-1, -1, 2}, {1, -1, 2}, {1, 1, 2}, {-1, 1, 2}}, {{0, 1, 2}, {0, 2, 3}}};
  const Scene scene = sceneOf({floorSlab()});
  const TriangleMesh slab = worldMesh(scene.objects[0]);
  const Eigen::Isometry3d here = Eigen::Isometry3d::Identity();
  const GroundLayer layer({{0, slab, here, SolidMesh(slab)}, {1, deck, here, {}}});
  const auto scratch = ObstacleSet::makeScratch();
  const auto touched = [&](double z) {
    return layer.touched({{0, 0, z}, {0.2, 0.1, z}, 0.1}, 0.0, *scratch);
  };
  EXPECT_EQ(touched(1.0), -1);
  EXPECT_EQ(touched(1.95), 1);
  EXPECT_EQ(touched(2.2), -1);
  EXPECT_EQ(touched(-0.2), 0);
}

// Boxes in one another, all of them one object or each its own: solid and free in turn.
TEST(GroundLayer, ManyShellsInOneAnotherAreSolidAndFreeInTurn) {
  constexpr int kShells = 20;
  constexpr double kThick = 0.1;
  TriangleMesh mesh;
  for (int k = 0; k < kShells; ++k)
    mesh = joined(mesh, makeBox(Eigen::Vector3d::Constant(2.0 * kThick * (kShells - k))));
  const TriangleMesh other = moved(makeBox({1, 1, 1}), {5, 0, 0});
  const Eigen::Isometry3d here = Eigen::Isometry3d::Identity();
  const GroundLayer layer({{3, other, here, solidOf(other)}, {4, mesh, here, solidOf(mesh)}});
  const auto scratch = ObstacleSet::makeScratch();
  for (int k = 0; k < 2 * kShells; ++k) {
    const double z = kThick * (k - kShells + 0.5);
    const Capsule capsule{{-0.03, 0.02, z}, {0.04, -0.03, z}, 0.02};
    const bool solid = (k < kShells ? k : 2 * kShells - 1 - k) % 2 == 0;
    EXPECT_EQ(layer.touched(capsule, 0.0, *scratch), solid ? 4 : -1) << z;
    EXPECT_EQ(layer.isClearBetween(capsule, capsule, 0.0, 0.0), true) << z;
  }
}

}  // namespace
}  // namespace amble

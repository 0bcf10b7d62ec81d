#include "environments/ground/scene_ground.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "base/rotation.h"
#include "environments/ground/ground_cells.h"
#include "environments/scene/triangle_grid.h"
#include "tests/environments/test_scenes.h"

namespace amble {
namespace {

TEST(SceneGround, IsTheFloorWhatLiesOnItAndStepsButNoFurniture) {
  const Scene scene = sceneOf({floorSlab(), makeObject("rug", Box{{2, 2, 0.01}}, {3, 0, 0.005}),
                               makeObject("table", makeBox({1, 1, 0.05}), {-3, 0, 0.725}),
                               makeObject("step", Box{{1, 1, 0.15}}, {0, 5, 0.075}),
                               makeObject("high step", Box{{1, 1, 0.3}}, {5, 5, 0.15})});
  const SceneGround ground(scene, 0.0);
  EXPECT_TRUE(ground.isGround(0));
  EXPECT_TRUE(ground.isGround(1));
  EXPECT_FALSE(ground.isGround(2));
  EXPECT_TRUE(ground.isGround(3));
  EXPECT_FALSE(ground.isGround(4));
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

// A floor, ten steps and an upper floor that they lead to.
Scene storeys(double rise) {
  std::vector<SceneObject> objects = stairs(10, rise, 0.29);
  objects.push_back(floorSlab());
  objects.push_back(makeObject("upstairs", Box{{4, 4, 0.2}}, {4.9, 0, 10 * rise - 0.1}));
  return sceneOf(objects);
}

TEST(SceneGround, TreadsAreGroundToTheirEdges) {
  const Scene scene = storeys(0.17);
  const SceneGround ground(scene);
  EXPECT_FALSE(ground.isLevel());
  for (int i = 0; i < 10; ++i) {
    EXPECT_TRUE(ground.isGround(i));
    for (const double inset : {0.001, 0.1, 0.289}) {
      const auto point = ground.surface(0.29 * i + inset, 0.3, 0.17 * i + 0.1, 0.1);
      ASSERT_TRUE(point.has_value()) << i << " " << inset;
      EXPECT_NEAR(point->height, 0.17 * (i + 1), 1e-12);
      EXPECT_EQ(point->normal, Eigen::Vector3d::UnitZ());
    }
  }
  EXPECT_NEAR(ground.height(5, 0, 1.7, 0.1).value(), 1.7, 1e-12);
  EXPECT_NEAR(ground.height(5, 0, 0, 0.1).value(), 0.0, 1e-12);
}

TEST(SceneGround, StepsHigherThanTheCharacterTakesAreNone) {
  const Scene scene = storeys(0.27);
  const SceneGround ground(scene);
  for (int i = 0; i < 9; ++i) EXPECT_FALSE(ground.isGround(i)) << i;
  EXPECT_TRUE(ground.isGround(11));  // the upper floor is a floor
}

TEST(SceneGround, ARampIsGroundUpToTheSteepestSlope) {
  for (const double slope : {10.0, 19.9, 20.1, 30.0}) {
    SceneObject ramp = makeObject("ramp", Box{{4, 2, 0.02}}, {0, 0, 0.8});
    ramp.X_WO.linear() = expRotation({0, -slope * kDegree, 0}).toRotationMatrix();
    const Scene scene = sceneOf({floorSlab(), ramp});
    const SceneGround ground(scene);
    EXPECT_EQ(ground.isGround(1), slope < 20.0) << slope;
    if (slope > 20.0) continue;
    const auto point = ground.surface(0.3, 0.1, 0.9, 0.3);
    ASSERT_TRUE(point.has_value());
    const double tangent = std::tan(slope * kDegree);
    EXPECT_NEAR(point->height, 0.8 + 0.3 * tangent + 0.01 / std::cos(slope * kDegree), 1e-9);
    EXPECT_NEAR(std::acos(point->normal.z()), slope * kDegree, 1e-6);
    EXPECT_LT(point->normal.x(), 0.0);
  }
}

TEST(SceneGround, StonesAndLogsHaveNoRoomForAFoot) {
  const Scene scene =
      sceneOf({floorSlab(), makeObject("stone", Box{{0.08, 0.1, 0.06}}, {0, 0, 0.03}),
               makeObject("log", Box{{0.1, 3, 0.15}}, {2, 0, 0.075}),
               makeObject("plank", Box{{0.3, 3, 0.15}}, {4, 0, 0.075})});
  GroundSettings settings;
  settings.foot_breadth = 0.12;
  const SceneGround ground(scene, settings);
  EXPECT_FALSE(ground.isGround(1));
  EXPECT_FALSE(ground.isGround(2));
  EXPECT_TRUE(ground.isGround(3));
}

TEST(SceneGround, OfSliversAndATriangleIsTheSame) {
  TriangleMesh slivers;
  for (int i = 0; i < 400; ++i) {
    const double x = -2 + 0.01 * i, next = -2 + 0.01 * (i + 1);
    slivers = joined(
        slivers, {{{x, -2, 0}, {next, -2, 0}, {next, 2, 0}, {x, 2, 0}}, {{0, 1, 2}, {0, 2, 3}}});
  }
  const TriangleMesh one{{{-10, -10, 0}, {10, -10, 0}, {0, 20, 0}}, {{0, 1, 2}}};
  for (const TriangleMesh& mesh : {slivers, one}) {
    const Scene scene = sceneOf({makeObject("floor", mesh, {0, 0, 0})});
    const SceneGround ground(scene);
    for (double x = -1.987; x < 2.0; x += 0.0137) {
      const auto point = ground.surface(x, 0.3 * x, 0.05, 0.1);
      ASSERT_TRUE(point.has_value()) << x;
      EXPECT_NEAR(point->height, 0.0, 1e-12);
      EXPECT_NEAR(point->normal.z(), 1.0, 1e-12);
    }
  }
}

TEST(SceneGround, TheCrestIsTheHighestOfWhatCanBeSteppedOver) {
  const Scene scene = sceneOf({floorSlab(), makeObject("log", Box{{0.1, 3, 0.15}}, {2, 0, 0.075}),
                               makeObject("wall", Box{{0.1, 3, 2}}, {4, 0, 1})});
  const SceneGround ground(scene);
  const auto crest = [&](double from, double to) {
    return ground.crest({from, 0.2}, {to, 0.2}, 0.05, -0.2, 0.4);
  };
  EXPECT_NEAR(crest(0, 1.94), 0.0, 1e-12);
  EXPECT_NEAR(crest(0, 1.96), 0.15, 1e-12);
  EXPECT_NEAR(crest(3, 5), 0.0, 1e-12);  // a wall is not to step over
  EXPECT_LT(ground.crest({30, 0}, {31, 0}, 0.1, -1, 1), -1e9);
}

TEST(Floors, ListsStoreysAndNoTables) {
  const Scene scene = sceneOf({floorSlab(), makeObject("upstairs", Box{{10, 10, 0.2}}, {0, 0, 2.6}),
                               makeObject("table", Box{{2, 1, 0.05}}, {0, 0, 0.725}),
                               makeObject("rug", Box{{2, 2, 0.01}}, {0, 0, 0.005})});
  const std::vector<double> two = SceneGround(scene).floors(0, 0);
  ASSERT_EQ(two.size(), 2u);
  EXPECT_NEAR(two[0], 0.0, 1e-12);
  EXPECT_NEAR(two[1], 2.7, 1e-12);
  EXPECT_EQ(SceneGround(scene).floors(8, 8).size(), 1u);
  EXPECT_TRUE(SceneGround(scene).floors(30, 0).empty());
}

TEST(Floors, ASmallPlatformIsOneWhereItIsSaidToBeGround) {
  const SceneObject stage = makeObject("stage", Box{{1, 1, 0.4}}, {0, 0, 0.2}, Role::kGround);
  EXPECT_EQ(SceneGround(sceneOf({floorSlab(), stage})).floors(0, 0), std::vector<double>{0.4});
}

TEST(Floors, WhatLiesUnderALowStepIsNone) {
  const Scene scene = storeys(0.17);
  const SceneGround ground(scene);
  EXPECT_EQ(ground.floors(0.4, 0).size(), 1u);
  EXPECT_EQ(ground.floors(5, 0).size(), 2u);
}

TEST(Floors, WhereOnlySmallThingsAreTheyAreFloors) {
  const SceneObject stool = makeObject("stool", Box{{0.5, 0.5, 0.4}}, {0, 0, 0.2});
  EXPECT_EQ(SceneGround(sceneOf({stool})).floors(0, 0), std::vector<double>{0.4});
}

// What a place without a height stands on.

TEST(MainFloors, AreOfWhatCanBeWalkedToNotOfACupboardsTop) {
  const Scene scene =
      sceneOf({floorSlab(), makeObject("cupboard", Box{{1, 0.6, 2.3}}, {2, 2, 1.15}),
               makeObject("table", Box{{1.2, 0.8, 0.75}}, {-2, 0, 0.375}),
               makeObject("bed", Box{{2, 1.6, 0.45}}, {5, 5, 0.225})});
  GroundSettings settings;
  for (const Eigen::Vector2d& at : {Eigen::Vector2d(2, 2), {-2, 0}, {5, 5}}) {
    settings.places.push_back({at, {}});
  }
  const SceneGround ground(scene, settings);
  for (const GroundPlace& place : settings.places)
    EXPECT_EQ(ground.mainFloors(place.at.x(), place.at.y()), std::vector<double>{0.0});
}

TEST(MainFloors, BelowABedAsLargeAsAFloorAreOfTheRoomHoweverLargeItIs) {
  for (const double side : {1.6, 2.0, 2.5, 4.0}) {
    const SceneGround ground(
        sceneOf({floorSlab(), makeObject("bed", Box{{side, side, 0.5}}, {0, 0, 0.25})}));
    EXPECT_EQ(ground.mainFloors(0, 0), std::vector<double>{0.0}) << side;
  }
  // Who can climb it stands on it.
  const SceneGround low(sceneOf({floorSlab(), makeObject("stage", Box{{4, 4, 0.2}}, {0, 0, 0.1})}));
  EXPECT_EQ(low.mainFloors(0, 0), std::vector<double>{0.2});
}

TEST(MainFloors, OfStoreysThatStepsJoinAreListed) {
  std::vector<SceneObject> objects = stairs(15, 0.2, 0.3);
  objects.push_back(floorSlab());
  objects.push_back(makeObject("upper", Box{{6, 8, 0.1}}, {4.5 + 3.0, 0, 2.95}));
  const SceneGround ground(sceneOf(objects));
  const std::vector<double> floors = ground.mainFloors(7, 0);
  ASSERT_EQ(floors.size(), 2u);
  EXPECT_NEAR(floors[0], 0.0, 1e-9);
  EXPECT_NEAR(floors[1], 3.0, 1e-9);
}

TEST(MainFloors, OfStoreysThatNothingJoinsAreOfTheLarger) {
  const SceneGround ground(
      sceneOf({floorSlab(), makeObject("attic", Box{{6, 6, 0.1}}, {0, 0, 2.95})}));
  EXPECT_EQ(ground.floors(0, 0).size(), 2u);
  EXPECT_EQ(ground.mainFloors(0, 0), std::vector<double>{0.0});
}

TEST(MainFloors, WithoutGroundAreWhateverThereIs) {
  const SceneGround ground(sceneOf({makeObject("stool", Box{{0.4, 0.4, 0.4}}, {0, 0, 0.2})}));
  EXPECT_EQ(ground.mainFloors(0, 0), ground.floors(0, 0));
}

/// Hills over 8 x 8 m, a corner every half metre, no steeper than one in five.
struct Hills {
  static constexpr int kSide = 17;
  static constexpr double kStep = 0.5;

  explicit Hills(std::uint64_t seed) {
    std::mt19937_64 generator(seed);
    std::uniform_real_distribution<double> up(-0.05, 0.05);
    for (int i = 0; i < kSide * kSide; ++i) {
      mesh.vertices.emplace_back(kStep * (i % kSide), kStep * (i / kSide), up(generator));
    }
    for (int j = 0; j + 1 < kSide; ++j) {
      for (int i = 0; i + 1 < kSide; ++i) {
        const int a = j * kSide + i, b = a + 1, c = a + kSide, d = c + 1;
        mesh.triangles.push_back({a, b, d});
        mesh.triangles.push_back({a, d, c});
      }
    }
  }
  /// By the two triangles of a square, which meet in its diagonal.
  double at(double x, double y) const {
    const int i = std::min(kSide - 2, static_cast<int>(x / kStep));
    const int j = std::min(kSide - 2, static_cast<int>(y / kStep));
    const double u = x / kStep - i, v = y / kStep - j;
    const auto z = [&](int di, int dj) { return mesh.vertices[(j + dj) * kSide + i + di].z(); };
    return u >= v ? z(0, 0) + u * (z(1, 0) - z(0, 0)) + v * (z(1, 1) - z(1, 0))
                  : z(0, 0) + v * (z(0, 1) - z(0, 0)) + u * (z(1, 1) - z(0, 1));
  }
  TriangleMesh mesh;
};

TEST(SceneGround, HeightsAndNormalsOfRandomHillsAreThoseOfTheirTriangles) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    const Hills hills(seed);
    const SceneGround ground(sceneOf({makeObject("hills", hills.mesh, {0, 0, 0})}));
    EXPECT_FALSE(ground.isLevel());
    std::mt19937_64 generator(seed + 10);
    std::uniform_real_distribution<double> place(0.01, 7.99);
    for (int n = 0; n < 500; ++n) {
      const double x = place(generator), y = place(generator);
      const double u = std::fmod(x, 0.5), v = std::fmod(y, 0.5);
      const double to_edge = std::min({u, 0.5 - u, v, 0.5 - v, std::abs(u - v)});
      if (to_edge < 2.0 * kSeam) continue;  // where two triangles are both over a point
      const auto point = ground.surface(x, y, 0.0, 0.3);
      ASSERT_TRUE(point.has_value()) << x << " " << y;
      EXPECT_NEAR(point->height, hills.at(x, y), 1e-9);
      EXPECT_EQ(ground.floors(x, y).size(), 1u);
      EXPECT_EQ(ground.stand(x, y, 0.2, 0.5)->height, point->height);
      // The plane of its normal goes on as the hill does.
      constexpr double kBeside = 1e-6;
      const double slope_x = (hills.at(x + kBeside, y) - hills.at(x, y)) / kBeside;
      EXPECT_NEAR(-point->normal.x() / point->normal.z(), slope_x, 1e-6);
      EXPECT_NEAR(point->normal.norm(), 1.0, 1e-12);
    }
  }
}

TEST(SceneGround, AHillOfSolidBoxesIsItsHighestTop) {
  std::mt19937_64 generator(5);
  std::uniform_real_distribution<double> place(-4.0, 4.0), size(1.0, 4.0), rise(0.05, 0.2);
  std::vector<SceneObject> objects = {floorSlab()};
  std::vector<std::pair<Eigen::AlignedBox2d, double>> tops;
  for (int i = 0; i < 8; ++i) {
    const Eigen::Vector2d at(place(generator), place(generator)), wide(size(generator), 3.0);
    const double top = rise(generator);
    objects.push_back(makeObject("box", Box{{wide.x(), wide.y(), top}}, {at.x(), at.y(), top / 2},
                                 Role::kGround));
    tops.push_back({{at - wide / 2, at + wide / 2}, top});
  }
  const SceneGround ground(sceneOf(objects));
  for (int n = 0; n < 1000; ++n) {
    const Eigen::Vector2d p(place(generator), place(generator));
    double highest = 0.0;
    for (const auto& [box, top] : tops)
      if (box.contains(p)) highest = std::max(highest, top);
    EXPECT_NEAR(ground.height(p.x(), p.y(), 0.1, 0.3).value(), highest, 1e-9);
  }
}

TEST(SceneGround, ASlopeIsGroundByItsSteepnessWhateverItsDirection) {
  std::mt19937_64 generator(6);
  std::uniform_real_distribution<double> heading(-kPi, kPi), limit(8.0, 30.0);
  for (int n = 0; n < 12; ++n) {
    GroundSettings settings;
    settings.limits.max_slope = limit(generator) * kDegree;
    for (const double share : {0.95, 1.05}) {
      SceneObject ramp = makeObject("ramp", Box{{4, 3, 0.02}}, {0, 0, 0.5});
      ramp.X_WO.linear() =
          (aboutZ(heading(generator)) * expRotation({0, share * settings.limits.max_slope, 0}))
              .toRotationMatrix();
      EXPECT_EQ(SceneGround(sceneOf({ramp}), settings).isGround(0), share < 1.0) << share;
    }
  }
}

// By points of the strip, close together: boxes that surely are under it, and that surely are not.
TEST(SceneGround, TheCrestIsTheHighestBoxUnderTheStrip) {
  std::mt19937_64 generator(7);
  std::uniform_real_distribution<double> place(-3.0, 3.0), size(0.1, 0.8), rise(0.05, 0.6);
  constexpr double kHalf = 0.1, kHigh = 0.4, kSlack = 0.012;
  std::vector<SceneObject> objects = {floorSlab()};
  std::vector<std::pair<Eigen::AlignedBox2d, double>> tops;
  for (int i = 0; i < 25; ++i) {
    const Eigen::Vector2d at(place(generator), place(generator));
    const Eigen::Vector2d wide(size(generator), size(generator));
    const double top = rise(generator);
    objects.push_back(makeObject("box", Box{{wide.x(), wide.y(), top}}, {at.x(), at.y(), top / 2}));
    tops.push_back({{at - wide / 2, at + wide / 2}, top});
  }
  const SceneGround ground(sceneOf(objects));
  for (int n = 0; n < 100; ++n) {
    const Eigen::Vector2d a(place(generator), place(generator)),
        b(place(generator), place(generator));
    const Eigen::Vector2d along = (b - a).normalized(), aside(-along.y(), along.x());
    double sure = 0.0, perhaps = 0.0;
    for (double s = 0.0; s <= (b - a).norm(); s += 0.01) {
      for (double t = -kHalf; t <= kHalf; t += 0.01) {
        const Eigen::Vector2d p = a + s * along + t * aside;
        for (const auto& [box, top] : tops) {
          if (top > kHigh) continue;
          const double off = box.exteriorDistance(p);
          if (off <= 0.0) sure = std::max(sure, top);
          if (off <= kSlack) perhaps = std::max(perhaps, top);
        }
      }
    }
    const double crest = ground.crest(a, b, kHalf, -0.1, kHigh);
    EXPECT_GE(crest, sure - 1e-9);
    EXPECT_LE(crest, perhaps + 1e-9);
  }
}

TEST(SceneGround, AskedTogetherPiecesOfALineAndPointsOfASoleAreAsEachAlone) {
  const Hills hills(4);
  const SceneGround ground(sceneOf({makeObject("hills", hills.mesh, {0, 0, 0}),
                                    makeObject("kerb", Box{{8, 0.3, 0.4}}, {4, 4, 0.1}),
                                    makeObject("wall", Box{{0.1, 3, 2}}, {2, 6, 1})}));
  std::mt19937_64 generator(8);
  std::uniform_real_distribution<double> place(-0.2, 8.2), off(-0.15, 0.15);
  for (int n = 0; n < 200; ++n) {
    const Eigen::Vector2d a(place(generator), place(generator)),
        unit = Eigen::Rotation2Dd(n) * Eigen::Vector2d::UnitX();
    std::vector<PlanSegment> pieces(100);
    for (size_t i = 0; i < pieces.size(); ++i)
      pieces[i] = {a + 0.01 * static_cast<double>(i) * unit,
                   a + 0.01 * static_cast<double>(i + 1) * unit};
    const std::vector<double> crests = ground.crests(pieces, 0.05, -0.2, 0.35);
    for (size_t i = 0; i < pieces.size(); ++i)
      EXPECT_EQ(crests[i], ground.crest(pieces[i].from, pieces[i].to, 0.05, -0.2, 0.35));
    std::vector<Eigen::Vector2d> points(20);
    for (Eigen::Vector2d& p : points) p = a + Eigen::Vector2d(off(generator), off(generator));
    std::vector<std::optional<SurfacePoint>> surfaces(points.size());
    ground.surfaces(points, 0.0, 0.03, surfaces);
    for (size_t i = 0; i < points.size(); ++i) {
      const auto alone = ground.surface(points[i].x(), points[i].y(), 0.0, 0.03);
      ASSERT_EQ(surfaces[i].has_value(), alone.has_value());
      if (!alone) continue;
      EXPECT_EQ(surfaces[i]->height, alone->height);
      EXPECT_EQ(surfaces[i]->normal, alone->normal);
    }
  }
}

}  // namespace
}  // namespace amble

#include "environments/ground/ground_cells.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "base/rotation.h"
#include "environments/ground/scene_ground.h"
#include "tests/environments/test_scenes.h"

namespace amble {
namespace {

SceneObject slab(double side, double top) {
  return makeObject("floor", Box{{side, side, 0.1}}, {0, 0, top - 0.05});
}

std::vector<double> groundAt(const GroundCells& cells, double x, double y) {
  const Eigen::Vector2i at = cells.squareAt({x, y});
  std::vector<double> heights;
  for (const GroundCells::Span& span : cells.spans(at.x(), at.y()))
    if (span.ground && span.standable) heights.push_back(span.height);
  return heights;
}

TEST(GroundCells, SquaresHaveOneSizeWhateverTheSceneHas) {
  for (const double side : {5.0, 50.0, 400.0})
    EXPECT_DOUBLE_EQ(SceneGround(sceneOf({slab(side, 0.0)})).cells().cell(), 0.1) << side;
}

// A hundred sheets over one another, each a little uneven, so that no tile of them is plain: nine
// million surfaces over squares of 0.1 m.
TEST(GroundCells, ManySheetsOverOneAnotherMakeSquaresLargerNotMore) {
  std::vector<SceneObject> objects;
  for (int k = 0; k < 100; ++k) {
    const double z = 0.3 * k;
    objects.push_back(
        makeObject("sheet" + std::to_string(k),
                   TriangleMesh{{{0, 0, z}, {30, 0, z}, {30, 30, z + 0.1}, {0, 30, z}},
                                {{0, 1, 2}, {0, 2, 3}}},
                   {0, 0, 0}));
  }
  const SceneGround ground(sceneOf(objects));
  EXPECT_GT(ground.cells().cell(), 0.1);
  EXPECT_LE(ground.cells().columns() * ground.cells().rows() * 100, 8e6);
  // Who stands on all but the topmost has his head in others.
  ASSERT_EQ(groundAt(ground.cells(), 10.0, 20.0).size(), 1u);
  EXPECT_NEAR(groundAt(ground.cells(), 10.0, 20.0)[0], 29.7, 0.1);
}

TEST(GroundCells, TreadsOfAStairOnASiteOf400MetresAreGround) {
  std::vector<SceneObject> objects = stairs(8, 0.17, 0.29);
  objects.push_back(makeObject("top", Box{{3, 2, 0.1}}, {8 * 0.29 + 1.5, 0, 8 * 0.17 - 0.05}));
  objects.push_back(slab(400.0, 0.0));
  const SceneGround ground(sceneOf(objects));
  for (int i = 0; i < 8; ++i) {
    const auto tread = groundAt(ground.cells(), (i + 0.5) * 0.29, 0.0);
    ASSERT_EQ(tread.size(), 1u) << i;
    EXPECT_NEAR(tread[0], (i + 1) * 0.17, 1e-9);
  }
  EXPECT_EQ(groundAt(ground.cells(), -150.0, 120.0), std::vector<double>{0.0});
}

// A plain tile is one square that stands for all of its squares: a slab and the same slab in tiles
// that are each cut by a hair's width must say the same.
TEST(GroundCells, APlainTileSaysWhatItsSquaresWould) {
  const std::vector<SceneObject> things = {makeObject("box", Box{{1, 1, 1}}, {3, 2, 0.5}),
                                           makeObject("shelf", Box{{2, 2, 0.1}}, {-4, -4, 0.9}),
                                           makeObject("upper", Box{{9, 9, 0.2}}, {-3, 3, 2.5})};
  std::vector<SceneObject> plain = things, ruffled = things;
  plain.push_back(slab(20, 0.0));
  ruffled.push_back(slab(20, 0.0));
  // Crumbs on the floor, a tenth of a millimetre high, so that no tile is plain.
  TriangleMesh crumbs;
  for (double x = -10.0; x < 10.0; x += 0.4) {
    for (double y = -10.0; y < 10.0; y += 0.4) {
      const int base = static_cast<int>(crumbs.vertices.size());
      for (const Eigen::Vector3d& v : {Eigen::Vector3d(0, 0, 0), {0.001, 0, 0}, {0, 0.001, 1e-4}})
        crumbs.vertices.push_back(Eigen::Vector3d(x, y, 0.0) + v);
      crumbs.triangles.push_back({base, base + 1, base + 2});
    }
  }
  ruffled.push_back(makeObject("crumbs", crumbs, {0, 0, 0}, Role::kObstacle));
  const SceneGround a(sceneOf(plain)), b(sceneOf(ruffled));
  int compared = 0;
  for (double x = -9.95; x < 10.0; x += 0.1) {
    for (double y = -9.95; y < 10.0; y += 0.1, ++compared)
      EXPECT_EQ(groundAt(a.cells(), x, y), groundAt(b.cells(), x, y)) << x << " " << y;
  }
  EXPECT_GT(compared, 30000);
}

TEST(GroundCells, GroundGoesOnLevelUnderFurnitureAcrossPlainTiles) {
  // A bed that hides more than a tile of the floor.
  const SceneGround ground(
      sceneOf({slab(30, 0.0), makeObject("bed", Box{{5, 5, 0.1}}, {0, 0, 0.4})}));
  const Eigen::Vector2i at = ground.cells().squareAt({0, 0});
  const auto here = ground.cells().spans(at.x(), at.y());
  ASSERT_FALSE(here.empty());
  EXPECT_TRUE(here[0].ground);
  EXPECT_FALSE(here[0].standable);
  EXPECT_GE(here[0].floor, 0);
}

TEST(GroundCells, TheFloorOfAHollowRoomIsGround) {
  // An outer and an inner shell, in one mesh, as solidified cubes are, or as two objects; wound
  // alike or not.
  const TriangleMesh inner = makeBox({6, 4, 2.5}), outer = makeBox({6.2, 4.2, 2.7});
  const auto of = [](const TriangleMesh& mesh) { return makeObject("shell", mesh, {0, 0, 0}); };
  for (const Scene& scene :
       {sceneOf({of(joined(outer, inner))}), sceneOf({of(joined(outer, turned(inner)))}),
        sceneOf({of(outer), of(inner)}), sceneOf({of(turned(inner)), of(outer)})}) {
    const SceneGround ground(scene);
    const std::vector<double> heights = groundAt(ground.cells(), 1.0, 1.0);
    ASSERT_EQ(heights.size(), 2u);  // and the roof
    EXPECT_NEAR(heights[0], -1.25, 1e-9);
    EXPECT_EQ(ground.mainFloors(1.0, 1.0), std::vector<double>{heights[0]});
  }
}

TEST(GroundCells, WithinASolidNothingIsStoodOnThoughItIsHollowElsewhere) {
  // A solid in the hollow of the room: its inside is no floor.
  TriangleMesh block = makeBox({2, 2, 2});
  for (Eigen::Vector3d& v : block.vertices) v.x() += 1.5;
  TriangleMesh room = joined(joined(makeBox({8.2, 6.2, 2.9}), makeBox({8, 6, 2.7})), block);
  const SceneGround ground(sceneOf({makeObject("room", room, {0, 0, 0})}));
  EXPECT_TRUE(groundAt(ground.cells(), 1.5, 0.0).empty() ||
              groundAt(ground.cells(), 1.5, 0.0)[0] > 1.0);
  EXPECT_NEAR(groundAt(ground.cells(), -2.0, 0.0).at(0), -1.35, 1e-9);
}

TEST(GroundCells, OfFloorsOverOneAnotherTheLowestCounts) {
  const SceneGround ground(sceneOf({slab(10, 0.0), slab(12, 3.0)}));
  const GroundCells& cells = ground.cells();
  const Eigen::Vector2i at = cells.squareAt({0, 0});
  const auto here = cells.spans(at.x(), at.y());
  ASSERT_EQ(here.size(), 2u);
  EXPECT_NEAR(cells.area(here[0].floor), 100.0, 3.0);
  EXPECT_NEAR(cells.area(here[1].floor), 44.0, 6.0);
}

TEST(GroundCells, APlaceChoosesNothingWhereThereIsGround) {
  GroundSettings settings;
  settings.places = {{{0, 0}, {}}};
  // A table with a solid foot: the floor goes on below it, so that its top is none.
  const Scene scene =
      sceneOf({slab(10, 0.0), makeObject("table", Box{{1, 1, 0.75}}, {0, 0, 0.375})});
  EXPECT_EQ(SceneGround(scene, settings).floors(0, 0), std::vector<double>{0.0});
  settings.places = {{{0, 0}, 0.75}};
  EXPECT_EQ(SceneGround(scene, settings).floors(0, 0).back(), 0.75);
}

TEST(GroundCells, APlaceWithoutGroundHasWhatCanBeStoodOn) {
  GroundSettings settings;
  settings.places = {{{0, 0}, {}}};
  const Scene scene = sceneOf({makeObject("stage", Box{{1, 1, 0.4}}, {0, 0, 0.2})});
  EXPECT_TRUE(SceneGround(scene).extent().isEmpty());
  EXPECT_EQ(SceneGround(scene, settings).surfaces().triangles().size(), 2u);
}

TEST(GroundCells, StoppedInTheMiddleThrows) {
  std::atomic<bool> stop = true;
  EXPECT_THROW(SceneGround(sceneOf({slab(10, 0.0)}), {}, {&stop, {}}), Stopped);
}

TEST(GroundCells, OfNothingAreNone) {
  const SceneGround ground(sceneOf({}));
  EXPECT_EQ(ground.cells().columns(), 0);
  EXPECT_TRUE(ground.cells().spans(0, 0).empty());
}

TEST(GroundCells, TheSquareOfAMiddleIsItsOwn) {
  const SceneGround ground(sceneOf({slab(7.3, 0.0)}));
  const GroundCells& cells = ground.cells();
  for (int row = 0; row < cells.rows(); ++row)
    for (int column = 0; column < cells.columns(); ++column)
      EXPECT_EQ(cells.squareAt(cells.middle(column, row)), Eigen::Vector2i(column, row));
  // Beyond the edges there is nothing.
  EXPECT_TRUE(cells.spans(-1, 0).empty());
  EXPECT_TRUE(cells.spans(0, cells.rows()).empty());
}

TEST(GroundCells, AreasAreThoseOfTheFloors) {
  for (const double side : {3.0, 6.5, 40.0}) {
    const SceneGround ground(sceneOf({slab(side, 0.0)}));
    const Eigen::Vector2i at = ground.cells().squareAt({0.05, 0.05});
    const auto here = ground.cells().spans(at.x(), at.y());
    ASSERT_EQ(here.size(), 1u);
    // Where a foot stands, a border of half a foot's breadth to half its length left out.
    EXPECT_LE(ground.cells().area(here[0].part), (side + 0.2) * (side + 0.2));
    EXPECT_GE(ground.cells().area(here[0].part), (side - 0.3) * (side - 0.3));
  }
}

// Terraces side by side at random heights: one walks from one to another where no step between
// them is higher than the limit, and nowhere else.
TEST(GroundCells, TerracesAreOnePartWhereEveryStepBetweenThemIsWithinTheLimit) {
  std::mt19937_64 generator(8);
  std::uniform_real_distribution<double> rise(-0.35, 0.35), limit(0.1, 0.3);
  constexpr double kWide = 2.5, kTerraces = 8;
  for (int n = 0; n < 10; ++n) {
    GroundSettings settings;
    settings.limits.max_climb = settings.limits.max_drop = limit(generator);
    std::vector<double> heights = {0.0};
    std::vector<SceneObject> objects;
    for (int i = 0; i < kTerraces; ++i) {
      objects.push_back(
          makeObject("terrace", Box{{kWide, 3, 4}}, {i * kWide, 0, heights.back() - 2.0}));
      double step = rise(generator);
      if (std::abs(std::abs(step) - settings.limits.max_climb) < 0.01) step *= 1.3;
      heights.push_back(heights.back() + step);
    }
    const SceneGround ground(sceneOf(objects), settings);
    std::vector<int> part;
    for (int i = 0; i < kTerraces; ++i) {
      const Eigen::Vector2i at = ground.cells().squareAt({i * kWide, 0.0});
      const auto here = ground.cells().spans(at.x(), at.y());
      ASSERT_EQ(here.size(), 1u);
      EXPECT_TRUE(here[0].ground);
      EXPECT_NEAR(here[0].height, heights[i], 1e-9);
      part.push_back(here[0].part);
    }
    for (int i = 0; i < kTerraces; ++i) {
      bool joined = true;
      for (int k = i + 1; k < kTerraces; ++k) {
        joined = joined && std::abs(heights[k] - heights[k - 1]) <= settings.limits.max_climb;
        EXPECT_EQ(part[i] == part[k], joined) << n << ": " << i << " to " << k;
      }
    }
  }
}

TEST(GroundCells, WhatIsSmallerThanAFloorIsFurnitureUnlessStepsLeadToIt) {
  const SceneObject low = makeObject("podium", Box{{1.5, 1.5, 0.2}}, {2, 2, 0.1});
  const SceneObject high = makeObject("bed", Box{{1.5, 1.5, 0.5}}, {-2, -2, 0.25});
  const SceneGround ground(sceneOf({slab(10, 0.0), low, high}));
  EXPECT_EQ(groundAt(ground.cells(), 2, 2), std::vector<double>{0.2});
  EXPECT_TRUE(groundAt(ground.cells(), -2, -2).empty());
}

TEST(GroundCells, WithoutHeadroomNobodyStands) {
  for (const double gap : {0.8, 0.95, 1.05, 2.0}) {
    const SceneGround ground(
        sceneOf({slab(10, 0.0), makeObject("ceiling", Box{{4, 4, 0.1}}, {0, 0, gap + 0.05})}));
    const Eigen::Vector2i at = ground.cells().squareAt({0.0, 0.0});
    EXPECT_EQ(ground.cells().spans(at.x(), at.y())[0].standable, gap > 1.0) << gap;
  }
}

}  // namespace
}  // namespace amble

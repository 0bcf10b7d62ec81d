#include "environments/scene/scene_pieces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>

#include "base/rotation.h"
#include "tests/environments/test_scenes.h"

namespace amble {
namespace {

// How many of the scene's triangles face up at a height.
int facingUpAt(const ScenePieces& pieces, double z) {
  int count = 0;
  for (const Triangle3& t : pieces.triangles())
    count += upwardness(t) > 0.9 && std::abs(t[0].z() - z) < 1e-9 ? 1 : 0;
  return count;
}

TEST(ScenePieces, OfNothingAndOfWhatIsIgnoredAreNone) {
  EXPECT_TRUE(splitScene(sceneOf({})).pieces.empty());
  EXPECT_TRUE(splitScene(sceneOf({makeObject("sky", Box{{1, 1, 1}}, {0, 0, 0}, Role::kIgnore)}))
                  .pieces.empty());
}

TEST(ScenePieces, NumberTheirTrianglesInOrder) {
  const ScenePieces all =
      splitScene(sceneOf({floorSlab(), makeObject("ball", Sphere{1}, {0, 0, 1})}));
  ASSERT_EQ(all.pieces.size(), 2u);
  EXPECT_EQ(all.pieces[1].first, 12);
  EXPECT_EQ(all.pieceOf(11).object, 0);
  EXPECT_EQ(all.pieceOf(12).object, 1);
  EXPECT_EQ(all.triangles().size(), 12 + all.pieces[1].mesh.triangles.size());
}

TEST(ScenePieces, ClosedOnesFaceOutHoweverTheyAreWound) {
  const TriangleMesh box = makeBox({2, 2, 2});
  for (const TriangleMesh& mesh : {box, turned(box)}) {
    const ScenePieces all = splitScene(sceneOf({makeObject("box", mesh, {0, 0, 0})}));
    EXPECT_EQ(facingUpAt(all, 1.0), 2);
    EXPECT_EQ(facingUpAt(all, -1.0), 0);
  }
}

TEST(ScenePieces, TheHollowOfAShellFacesIn) {
  for (const bool wound_out : {false, true}) {
    const TriangleMesh inner = makeBox({2, 2, 2});
    const TriangleMesh shell = joined(makeBox({3, 3, 3}), wound_out ? inner : turned(inner));
    const ScenePieces all = splitScene(sceneOf({makeObject("room", shell, {0, 0, 0})}));
    EXPECT_EQ(facingUpAt(all, -1.0), 2);  // its floor
    EXPECT_EQ(facingUpAt(all, 1.5), 2);   // its roof
    EXPECT_EQ(facingUpAt(all, 1.0), 0);
  }
}

TEST(ScenePieces, AShellInAShellIsAHollowAndWhatIsInThatIsNone) {
  TriangleMesh nest = makeBox({4, 4, 4});
  for (const double side : {3.0, 2.0, 1.0}) nest = joined(nest, makeBox({side, side, side}));
  const ScenePieces all = splitScene(sceneOf({makeObject("nest", nest, {0, 0, 0})}));
  ASSERT_EQ(all.pieces.size(), 4u);
  for (size_t i = 0; i < 4; ++i) EXPECT_EQ(all.pieces[i].hollow, i % 2 == 1) << i;
}

TEST(ScenePieces, OfAnObjectAreFoundByItsNumber) {
  Scene scene =
      sceneOf({floorSlab(), makeObject("nothing", makeBox({1, 1, 1}), {0, 0, 0}, Role::kIgnore),
               makeObject("two", joined(makeBox({1, 1, 1}), makeBox({3, 3, 3})), {0, 0, 5})});
  const ScenePieces all = splitScene(scene);
  EXPECT_EQ(all.ofObject(0).size(), 1u);
  EXPECT_TRUE(all.ofObject(1).empty());
  ASSERT_EQ(all.ofObject(2).size(), 2u);
  for (const ScenePiece& piece : all.ofObject(2)) EXPECT_EQ(piece.object, 2);
}

// What a scene is made of does not matter, only its surface: boxes as primitives, as meshes, placed
// or moved beforehand, as one object or as many, are the same solids.
TEST(ScenePieces, PrimitivesMeshesAndOneMeshOfAllMeanTheSame) {
  std::mt19937_64 generator(61);
  std::uniform_real_distribution<double> place(-4, 4), size(0.3, 1.5), turn(-3, 3);
  std::vector<SceneObject> primitives, meshes;
  TriangleMesh all;
  for (int i = 0; i < 8; ++i) {
    const Eigen::Vector3d wide(size(generator), size(generator), size(generator));
    const Shape shape = i % 2 == 0 ? Shape(Box{wide}) : Shape(Cylinder{wide.x(), wide.y()});
    SceneObject object =
        makeObject("thing", shape, {place(generator), place(generator), place(generator)});
    object.X_WO.linear() =
        expRotation({turn(generator), turn(generator), turn(generator)}).toRotationMatrix();
    primitives.push_back(object);
    meshes.push_back(makeObject("mesh", worldMesh(object), {0, 0, 0}));
    all = joined(all, worldMesh(object));
  }
  const auto cornersOf = [](const ScenePieces& pieces) {
    std::vector<std::array<double, 3>> corners;
    for (const Triangle3& t : pieces.triangles())
      for (const Eigen::Vector3d& p : t) corners.push_back({p.x(), p.y(), p.z()});
    std::sort(corners.begin(), corners.end());
    return corners;
  };
  const auto expected = cornersOf(splitScene(sceneOf(primitives)));
  EXPECT_EQ(cornersOf(splitScene(sceneOf(meshes))), expected);
  EXPECT_EQ(cornersOf(splitScene(sceneOf({makeObject("all", all, {0, 0, 0})}))), expected);
  for (const ScenePiece& piece : splitScene(sceneOf(primitives)).pieces) {
    EXPECT_TRUE(piece.closed);
    EXPECT_GT(volumeOf(piece.mesh), 0.0);
  }
}

TEST(ScenePieces, UpwardnessIsTheCosineOfTheSlope) {
  for (const double slope : {0.0, 0.3, 1.0, 1.5, 2.0, 3.1}) {
    const Eigen::Quaterniond q = aboutZ(0.7) * expRotation({slope, 0, 0});
    const Triangle3 t = {q * Eigen::Vector3d(0, 0, 0), q * Eigen::Vector3d(2, 0, 0),
                         q * Eigen::Vector3d(0, 3, 0)};
    EXPECT_NEAR(upwardness(t), std::cos(slope), 1e-12);
  }
}

TEST(ScenePieces, StoppedInTheMiddleThrows) {
  const std::atomic<bool> stop{true};
  EXPECT_THROW(splitScene(sceneOf({floorSlab()}), {&stop, {}}), Stopped);
}

}  // namespace
}  // namespace amble

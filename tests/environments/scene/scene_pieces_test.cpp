#include "environments/scene/scene_pieces.h"

#include <gtest/gtest.h>

#include "tests/environments/test_scenes.h"

namespace amble {
namespace {

// How many of the scene's triangles face up at a height.
int facingUpAt(const ScenePieces& pieces, double z) {
  int count = 0;
  for (const Triangle3& t : pieces.triangles)
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
  EXPECT_EQ(all.triangles.size(), 12 + all.pieces[1].mesh.triangles.size());
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

TEST(ScenePieces, ShellsOfDifferentObjectsAreNoHollows) {
  const ScenePieces all = splitScene(sceneOf({makeObject("outer", makeBox({4, 4, 4}), {0, 0, 0}),
                                              makeObject("inner", makeBox({3, 3, 3}), {0, 0, 0})}));
  for (const ScenePiece& piece : all.pieces) EXPECT_FALSE(piece.hollow);
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

}  // namespace
}  // namespace amble

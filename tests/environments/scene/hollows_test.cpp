#include "environments/scene/hollows.h"

#include <gtest/gtest.h>

#include <atomic>
#include <string>

#include "tests/environments/test_scenes.h"

namespace amble {
namespace {

SceneObject shell(const std::string& name, const Eigen::Vector3d& size, bool is_turned = false,
                  const Eigen::Vector3d& at = {0, 0, 0}) {
  return makeObject(name, is_turned ? turned(makeBox(size)) : makeBox(size), at);
}

// Of scenes of one piece an object: the object in whose solid each is, where it is a hollow; else
// -1.
std::vector<int> hollowsOf(const std::vector<SceneObject>& objects) {
  std::vector<int> found;
  for (const ScenePiece& piece : splitScene(sceneOf(objects)).pieces) {
    EXPECT_TRUE(piece.closed);
    EXPECT_TRUE(piece.hollow || piece.solid_of == piece.object);
    found.push_back(piece.hollow ? piece.solid_of : -1);
  }
  return found;
}

using Found = std::vector<int>;

TEST(Hollows, TwoShellsOfARoomAsObjectsAreOneHollowHoweverTheyAreWound) {
  for (const bool outer : {false, true}) {
    for (const bool inner : {false, true}) {
      EXPECT_EQ(
          hollowsOf({shell("outer", {6.4, 6.4, 3.4}, outer), shell("inner", {6, 6, 3}, inner)}),
          (Found{-1, 0}));
      EXPECT_EQ(
          hollowsOf({shell("inner", {6, 6, 3}, inner), shell("outer", {6.4, 6.4, 3.4}, outer)}),
          (Found{1, -1}));
    }
  }
}

TEST(Hollows, OfShellsInOneAnotherEverySecondIsTheHollowOfTheOneAroundIt) {
  std::vector<SceneObject> objects;
  for (int k = 0; k < 6; ++k) {
    const double side = 20.0 - 2.0 * k;
    objects.push_back(shell("shell" + std::to_string(k), {side, side, side}));
  }
  EXPECT_EQ(hollowsOf(objects), (Found{-1, 0, -1, 2, -1, 4}));
}

TEST(Hollows, AThingInSuchARoomIsSolid) {
  EXPECT_EQ(hollowsOf({shell("outer", {9.4, 9.4, 3.4}), shell("inner", {9, 9, 3}),
                       shell("stage", {3, 3, 1.2}, false, {0, 0, -0.8})}),
            (Found{-1, 0, -1}));
}

TEST(Hollows, ATableInAHouseThatIsOneBlockStaysSolid) {
  const SceneObject house = shell("house", {9, 9, 3});
  EXPECT_EQ(hollowsOf({house, shell("table", {1.6, 0.9, 0.75})}), (Found{-1, -1}));
  EXPECT_EQ(hollowsOf({house, shell("low", {4, 4, 0.9})}), (Found{-1, -1}));
  EXPECT_EQ(hollowsOf({house, shell("cupboard", {1.5, 0.6, 2})}), (Found{-1, -1}));
}

TEST(Hollows, PrimitivesAreSolidWhateverIsAroundThemAndWithinThem) {
  const SceneObject block = makeObject("block", Box{{9, 9, 3}}, {0, 0, 0});
  EXPECT_EQ(hollowsOf({block, shell("inner", {6, 6, 2})}), (Found{-1, -1}));
  EXPECT_EQ(hollowsOf({shell("outer", {9, 9, 4}), block}), (Found{-1, -1}));
}

TEST(Hollows, WhatReachesOutOfAShellOrTouchesItIsNone) {
  const SceneObject outer = shell("outer", {9, 9, 4});
  EXPECT_EQ(hollowsOf({outer, shell("across", {6, 6, 3}, false, {3, 0, 0})}), (Found{-1, -1}));
  EXPECT_EQ(hollowsOf({outer, shell("flush", {6, 6, 3}, false, {0, 0, -0.5})}), (Found{-1, -1}));
  EXPECT_EQ(hollowsOf({outer, shell("same", {9, 9, 4})}), (Found{-1, -1}));
}

TEST(Hollows, AHouseWithAHollowOfItsOwnInABlockIsNone) {
  const ScenePieces pieces = splitScene(
      sceneOf({shell("earth", {30, 30, 12}),
               makeObject("house", joined(makeBox({9, 9, 4}), makeBox({8, 8, 3})), {0, 0, 0})}));
  ASSERT_EQ(pieces.pieces.size(), 3u);
  EXPECT_FALSE(pieces.pieces[1].hollow);
  EXPECT_TRUE(pieces.pieces[2].hollow);
  EXPECT_EQ(pieces.pieces[2].solid_of, 1);
}

TEST(Hollows, AreListedByTheObjectsThatTheyAreIn) {
  const ScenePieces pieces =
      splitScene(sceneOf({shell("inner", {6, 6, 3}), shell("outer", {6.4, 6.4, 3.4})}));
  ASSERT_EQ(pieces.hollows.size(), 1u);
  EXPECT_EQ(pieces.hollows.begin()->first, 1);
  EXPECT_EQ(pieces.hollows.begin()->second, 0);
}

}  // namespace
}  // namespace amble

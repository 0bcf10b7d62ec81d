#include <cmath>

#include "tests/environments/furniture/pieces.h"

namespace amble {
namespace {

using Eigen::AlignedBox3d;
using Eigen::Vector3d;

TEST(Lamp, StandsUprightOnABroadFoot) {
  const Furniture lamp = makeLamp();
  const AlignedBox3d foot = boxOf(lamp, "foot"), shade = boxOf(lamp, "shade");
  EXPECT_NEAR(foot.sizes().x(), 0.30, 0.005);
  EXPECT_LT(foot.max().z(), 0.06);
  EXPECT_LT(boxOf(lamp, "pole").min().z(), foot.max().z());
  for (const AlignedBox3d& box : {foot, shade}) EXPECT_LT(box.center().head<2>().norm(), 0.002);
}

TEST(Lamp, ItsBulbIsInsideItsShadeAndNotInItsSkin) {
  const Furniture lamp = makeLamp();
  const Surface shade = groupOf(lamp, "shade");
  const AlignedBox3d bulb = boxOf(lamp, "bulb");
  EXPECT_GT(bulb.min().z(), boxOf(shade).min().z());
  EXPECT_LT(bulb.max().z(), boxOf(shade).max().z());
  for (const Vector3d& p : shade.vertices) EXPECT_GT(p.head<2>().norm(), bulb.max().x() + 0.05);
  EXPECT_LT(volumeOf(shade), 0.2 * boxOf(shade).sizes().prod());  // open above and below
}

TEST(Lamp, TheShadeNarrowsUpwards) {
  const Surface shade = groupOf(makeLamp(), "shade");
  const AlignedBox3d box = boxOf(shade);
  double low = 0.0, high = 0.0;
  for (const Vector3d& p : shade.vertices) {
    if (p.z() < box.min().z() + 1e-9) low = std::max(low, p.head<2>().norm());
    if (p.z() > box.max().z() - 1e-9) high = std::max(high, p.head<2>().norm());
  }
  EXPECT_NEAR(low, 0.21, 1e-9);
  EXPECT_LT(high, 0.75 * low);
}

TEST(Plant, GrowsOutOfItsPot) {
  const Furniture plant = makePlant();
  const AlignedBox3d pot = boxOf(plant, "pot");
  const auto stems = componentsOf(groupOf(plant, "stems"));
  EXPECT_EQ(stems.size(), 11u);
  for (const Surface& stem : stems) {
    AlignedBox3d begin;
    for (const Vector3d& p : stem.vertices)
      if (p.z() < boxOf(stem).min().z() + 0.01) begin.extend(p);
    EXPECT_TRUE(pot.contains(begin.center()));
    EXPECT_GT(boxOf(stem).max().z(), pot.max().z() + 0.2);
  }
}

TEST(Plant, EveryLeafBeginsAtAStemAndNoneLiesOnTheFloor) {
  const Furniture plant = makePlant();
  const auto stems = componentsOf(groupOf(plant, "stems"));
  const auto leaves = componentsOf(groupOf(plant, "leaves"));
  EXPECT_EQ(leaves.size(), 5 * stems.size());
  for (const Surface& leaf : leaves) {
    double nearest = 1.0;
    for (const Surface& stem : stems)
      nearest = std::min(nearest, boxOf(stem).exteriorDistance(boxOf(leaf)));
    EXPECT_LT(nearest, 0.01);
    EXPECT_GT(boxOf(leaf).min().z(), 0.1);
  }
}

// The golden angle: no two leaves of a stem hang over one another.
TEST(Plant, LeavesGoOutAllRound) {
  const AlignedBox3d box = boxOf(makePlant(), "leaves");
  EXPECT_GT(-box.min().x(), 0.25);
  EXPECT_GT(box.max().x(), 0.25);
  EXPECT_GT(-box.min().y(), 0.25);
  EXPECT_GT(box.max().y(), 0.25);
}

TEST(LivingRoomFurniture, IsAllThatTheHeaderLists) {
  std::vector<std::string> names;
  for (const Furniture& piece : makeLivingRoomFurniture()) names.push_back(piece.name);
  const std::vector<std::string> listed = {"piano",     "piano-stool",  "sofa",  "armchair",
                                           "low-table", "dining-table", "chair", "lamp",
                                           "bookshelf", "plant",        "door",  "picture"};
  EXPECT_EQ(names, listed);
}

}  // namespace
}  // namespace amble

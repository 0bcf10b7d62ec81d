#include <algorithm>
#include <cmath>

#include "tests/environments/furniture/pieces.h"

namespace amble {
namespace {

using Eigen::AlignedBox3d;
using Eigen::Vector3d;

TEST(Tables, HaveFourLegsUnderTheirTops) {
  for (const Furniture& table : {makeLowTable(), makeDiningTable()}) {
    const AlignedBox3d top = boxOf(table, "top");
    const auto legs = componentsOf(groupOf(table, "legs"));
    ASSERT_EQ(legs.size(), 4u) << table.name;
    for (const Surface& leg : legs) {
      EXPECT_NEAR(boxOf(leg).max().z(), top.min().z(), 0.002);
      EXPECT_GT(boxOf(leg).min().x(), top.min().x());
      EXPECT_LT(boxOf(leg).max().x(), top.max().x());
      EXPECT_GT(boxOf(leg).min().y(), top.min().y());
      EXPECT_LT(boxOf(leg).max().y(), top.max().y());
    }
    EXPECT_TRUE(isSymmetric(groupOf(table, "legs")));
    EXPECT_TRUE(isSymmetric(groupOf(table, "top")));
    EXPECT_TRUE(isSymmetric(groupOf(table, "apron")));
  }
}

TEST(Tables, TheDiningTableHasRoomForKneesAllRound) {
  const Furniture table = makeDiningTable();
  EXPECT_GT(boxOf(table, "apron").min().z(), 0.60);
  const AlignedBox3d knees(Vector3d(-0.5, -0.6, 0.1), Vector3d(0.5, 0.6, 0.6));
  for (const auto& [name, surface] : table.groups) {
    if (name == "legs") continue;
    EXPECT_FALSE(boxOf(surface).intersects(knees)) << name;
  }
}

TEST(Tables, WhatStandsOnThemStandsOnTheTop) {
  const Furniture low = makeLowTable(), dining = makeDiningTable();
  EXPECT_NEAR(boxOf(low, "bowl").min().z(), boxOf(low, "top").max().z(), 0.002);
  EXPECT_NEAR(boxOf(low, "magazines").min().z(), boxOf(low, "shelf").max().z(), 0.002);
  EXPECT_NEAR(boxOf(dining, "bowl").min().z(), boxOf(dining, "top").max().z(), 0.002);
  EXPECT_NEAR(boxOf(dining, "vase").min().z(), boxOf(dining, "top").max().z(), 0.007);
  for (const char* thing : {"bowl", "vase"}) {
    const AlignedBox3d box = boxOf(dining, thing), top = boxOf(dining, "top");
    EXPECT_TRUE(box.min().x() > top.min().x() && box.max().x() < top.max().x()) << thing;
    EXPECT_TRUE(box.min().y() > top.min().y() && box.max().y() < top.max().y()) << thing;
  }
  EXPECT_FALSE(boxOf(dining, "bowl").intersects(boxOf(dining, "vase")));
}

// A bowl holds something: its skin is thin, and its middle far below its rim.
TEST(Tables, BowlsAreHollow) {
  for (const Furniture& table : {makeLowTable(), makeDiningTable()}) {
    const Surface bowl = groupOf(table, "bowl");
    const AlignedBox3d box = boxOf(bowl);
    const double cylinder = box.sizes().prod() * 3.14159265 / 4.0;
    EXPECT_LT(volumeOf(bowl), 0.4 * cylinder);
    double bottom = 0.0;
    for (const Vector3d& p : bowl.vertices)
      if ((p - box.center()).head<2>().norm() < 0.02) bottom = std::max(bottom, p.z());
    EXPECT_LT(bottom, box.min().z() + 0.3 * box.sizes().z());
  }
}

class BookshelfTest : public testing::Test {
 protected:
  const Furniture shelf = makeBookshelf();
};

TEST_F(BookshelfTest, EveryBookStandsOnABoardWithinTheShelf) {
  std::vector<double> boards;
  for (const Surface& board : componentsOf(groupOf(shelf, "shelves")))
    boards.push_back(boxOf(board).max().z());
  const AlignedBox3d all = boxOf(shelf, "sides");
  const auto books = componentsOf(groupOf(shelf, "books"));
  EXPECT_GT(books.size(), 100u);
  for (const Surface& book : books) {
    const AlignedBox3d box = boxOf(book);
    const double on = *std::min_element(boards.begin(), boards.end(), [&](double a, double b) {
      return std::abs(a - box.min().z()) < std::abs(b - box.min().z());
    });
    EXPECT_NEAR(box.min().z(), on, 0.002);
    EXPECT_GE(box.min().z(), on);
    EXPECT_TRUE(all.contains(box));
  }
}

TEST_F(BookshelfTest, NoBookIsInAnotherNorInABoard) {
  std::vector<AlignedBox3d> solid;
  for (const char* group : {"books", "shelves", "sides"})
    for (const Surface& part : componentsOf(groupOf(shelf, group))) {
      solid.push_back(boxOf(part));
      solid.back().min().array() += 1e-5;
      solid.back().max().array() -= 1e-5;
    }
  const size_t books = componentsOf(groupOf(shelf, "books")).size();
  for (size_t i = 0; i < books; ++i)
    for (size_t k = i + 1; k < solid.size(); ++k)
      EXPECT_FALSE(solid[i].intersects(solid[k])) << solid[i].center().transpose();
}

TEST_F(BookshelfTest, HasSixShelvesInEachOfTwoBays) {
  std::map<long, int> at_height;
  for (const Surface& board : componentsOf(groupOf(shelf, "shelves")))
    ++at_height[std::lround(1000 * boxOf(board).min().z())];
  EXPECT_EQ(at_height.size(), 6u);
  for (const auto& [height, boards] : at_height) EXPECT_EQ(boards, 2) << height;
  EXPECT_GT(boxOf(shelf, "back").min().y(), 0.1);  // open to the front, -y
}

TEST(Door, ItsLeafFillsItsFrameAndItsHandleIsOnTheRoomsSide) {
  const Furniture door = makeDoor();
  const AlignedBox3d leaf = boxOf(door, "leaf"), frame = boxOf(door, "frame");
  EXPECT_TRUE(frame.min().x() < leaf.min().x() && frame.max().x() > leaf.max().x());
  EXPECT_GT(frame.max().z(), leaf.max().z());
  for (const Surface& bar : componentsOf(groupOf(door, "frame"))) {
    const AlignedBox3d box = boxOf(bar);
    const bool beside = box.max().x() < leaf.min().x() + 0.01 ||
                        box.min().x() > leaf.max().x() - 0.01 ||
                        box.min().z() > leaf.max().z() - 0.01;
    EXPECT_TRUE(beside);
  }
  EXPECT_LT(boxOf(door, "handle").min().y(), leaf.min().y() - 0.03);
  EXPECT_NEAR(boxOf(door, "handle").center().z(), 1.03, 0.05);
  EXPECT_LE(boxOf(door).max().y(), 1e-9);  // its back is at y = 0
}

TEST(Picture, ItsFrameIsRoundItsCanvas) {
  const Furniture picture = makePicture();
  const AlignedBox3d canvas = boxOf(picture, "canvas"), frame = boxOf(picture, "frame");
  EXPECT_TRUE((frame.min().array() <= canvas.min().array()).all());
  EXPECT_LE(boxOf(picture).max().y(), 1e-9);
  const auto bars = componentsOf(groupOf(picture, "frame"));
  ASSERT_EQ(bars.size(), 4u);
  const AlignedBox3d seen(Vector3d(-0.4, -1, -0.25), Vector3d(0.4, 0, 0.25));
  for (const Surface& bar : bars) EXPECT_FALSE(boxOf(bar).intersects(seen));
  EXPECT_LT(boxOf(picture).center().cwiseProduct(Vector3d(1, 0, 1)).norm(), 1e-9);
}

TEST(Cupboard, IsOneClosedBodyWithTwoDoorsSideBySide) {
  const Furniture cupboard = makeCupboard();
  EXPECT_EQ(componentsOf(groupOf(cupboard, "body")).size(), 1u);
  const auto doors = componentsOf(groupOf(cupboard, "doors"));
  ASSERT_EQ(doors.size(), 2u);
  EXPECT_LT(boxOf(doors[0]).max().x(), boxOf(doors[1]).min().x());
  EXPECT_TRUE(isSymmetric(groupOf(cupboard, "doors")));
  for (const Surface& handle : componentsOf(groupOf(cupboard, "handles")))
    EXPECT_LT(boxOf(handle).min().y(), boxOf(cupboard, "doors").min().y());
  EXPECT_NEAR(boxOf(cupboard).sizes().y(), 0.84, 0.03);
}

}  // namespace
}  // namespace amble

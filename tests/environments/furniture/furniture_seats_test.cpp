#include <cmath>

#include "tests/environments/furniture/pieces.h"

namespace amble {
namespace {

using Eigen::AlignedBox3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

/// Middles of the parts of a group that stand on the floor.
std::vector<Vector2d> feetOf(const Furniture& piece, const std::string& group) {
  std::vector<Vector2d> feet;
  for (const Surface& part : componentsOf(groupOf(piece, group))) {
    AlignedBox3d low;
    for (const Vector3d& p : part.vertices)
      if (p.z() < 0.004) low.extend(p);
    if (!low.isEmpty()) feet.emplace_back(low.center().head<2>());
  }
  return feet;
}

/// Height of the middle of a group's upper side: where somebody sits.
double seatHeight(const Surface& seat) {
  double nearest = 1e9, height = 0.0;
  const Vector2d middle = boxOf(seat).center().head<2>();
  for (const Vector3d& p : seat.vertices) {
    if (p.z() < boxOf(seat).center().z()) continue;
    const double off = (p.head<2>() - middle).norm();
    if (off > nearest + 1e-9 || (off > nearest - 1e-9 && p.z() < height)) continue;
    nearest = off;
    height = p.z();
  }
  return height;
}

TEST(Seats, AllStandOnFourFeetInARectangle) {
  for (const Furniture& piece : {makePianoStool(), makeChair(), makeSofa(), makeArmchair()}) {
    const auto feet = feetOf(piece, "legs");
    ASSERT_EQ(feet.size(), 4u) << piece.name;
    Eigen::AlignedBox2d box;
    for (const Vector2d& foot : feet) box.extend(foot);
    for (const Vector2d& foot : feet) {  // a corner of the box, but for a chair's splay
      EXPECT_LT((box.exteriorDistance(foot)), 1e-9);
      const Vector2d off = (foot - box.center()).cwiseAbs() - box.sizes() / 2;
      EXPECT_LT(off.cwiseAbs().maxCoeff(), 0.02) << piece.name;
    }
  }
}

TEST(Seats, LeftIsTheMirrorImageOfRight) {
  for (const Furniture& piece : {makePianoStool(), makeChair(), makeArmchair()})
    for (const auto& [name, surface] : piece.groups)
      EXPECT_TRUE(isSymmetric(surface)) << piece.name << ' ' << name;
  for (const char* group : {"frame", "arms", "legs", "cushions"})
    EXPECT_TRUE(isSymmetric(groupOf(makeSofa(), group))) << group;
}

TEST(Seats, OneSitsAtTheStatedHeightsFacingTheFront) {
  EXPECT_NEAR(seatHeight(groupOf(makePianoStool(), "seat")), 0.50, 0.01);
  EXPECT_NEAR(seatHeight(groupOf(makeChair(), "seat")), 0.45, 0.015);
  for (const auto& [piece, seats, height] :
       {std::tuple{makeSofa(), 3, 0.44}, std::tuple{makeArmchair(), 1, 0.43}}) {
    int found = 0;
    for (const Surface& part : componentsOf(groupOf(piece, "cushions"))) {
      if (boxOf(part).max().z() > height + 0.1) continue;  // a back's
      EXPECT_NEAR(seatHeight(part), height, 0.025);
      ++found;
    }
    EXPECT_EQ(found, seats) << piece.name;
  }
  EXPECT_GT(boxOf(makeChair(), "back").min().y(), 0.1);
  for (const Furniture& piece : {makeSofa(), makeArmchair()}) {
    Vector3d top = Vector3d::Zero();
    for (const Vector3d& p : groupOf(piece, "frame").vertices)
      if (p.z() > top.z()) top = p;
    EXPECT_GT(top.y(), 0.2) << piece.name;  // the back is behind
  }
}

TEST(Sofa, ArmsStandAtItsEndsAndAreLowerThanItsBack) {
  for (const Furniture& piece : {makeSofa(), makeArmchair()}) {
    const auto arms = componentsOf(groupOf(piece, "arms"));
    ASSERT_EQ(arms.size(), 2u);
    const AlignedBox3d all = boxOf(piece);
    EXPECT_NEAR(boxOf(arms[0]).min().x(), all.min().x(), 1e-9);
    EXPECT_NEAR(boxOf(arms[1]).max().x(), all.max().x(), 1e-9);
    EXPECT_LT(boxOf(piece, "arms").max().z(), all.max().z() - 0.1);
    for (const Surface& cushion : componentsOf(groupOf(piece, "cushions"))) {
      EXPECT_GT(boxOf(cushion).min().x(), boxOf(arms[0]).max().x() - 1e-9);
      EXPECT_LT(boxOf(cushion).max().x(), boxOf(arms[1]).min().x() + 1e-9);
    }
  }
}

TEST(Sofa, CushionsLieSideBySide) {
  std::vector<AlignedBox3d> seats;
  for (const Surface& part : componentsOf(groupOf(makeSofa(), "cushions")))
    if (boxOf(part).max().z() < 0.5) seats.push_back(boxOf(part));
  ASSERT_EQ(seats.size(), 3u);
  for (size_t i = 0; i + 1 < seats.size(); ++i) {
    EXPECT_GT(seats[i + 1].min().x(), seats[i].max().x());
    EXPECT_LT(seats[i + 1].min().x() - seats[i].max().x(), 0.02);
    EXPECT_NEAR(seats[i].sizes().x(), seats[i + 1].sizes().x(), 1e-9);
  }
}

TEST(Sofa, ItsPillowsLeanAgainstTheBackAboveTheSeat) {
  const Furniture sofa = makeSofa();
  for (const char* name : {"pillow-left", "pillow-right"}) {
    const AlignedBox3d box = boxOf(sofa, name);
    EXPECT_GT(box.min().z(), 0.40) << name;
    EXPECT_LT(box.max().z(), boxOf(sofa).max().z() + 0.05) << name;
    EXPECT_LT(std::abs(box.center().x()), 0.9);
  }
  EXPECT_LT(boxOf(sofa, "pillow-left").max().x(), 0.0);
  EXPECT_GT(boxOf(sofa, "pillow-right").min().x(), 0.0);
}

TEST(Stool, TheSeatIsPaddedByADomeWithinItsEdges) {
  const Surface seat = groupOf(makePianoStool(), "seat");
  const AlignedBox3d box = boxOf(seat);
  double edge = 0.0;
  for (const Vector3d& p : seat.vertices) {
    if (std::abs(std::abs(p.x()) - box.max().x()) < 1e-9) edge = std::max(edge, p.z());
  }
  EXPECT_GT(seatHeight(seat), edge + 0.005);
  EXPECT_LE(seatHeight(seat), 0.51);
}

TEST(Chair, HasFiveSlatsBetweenTwoRailsAndLegroomBelow) {
  const Furniture chair = makeChair();
  int slats = 0, rails = 0;
  for (const Surface& part : componentsOf(groupOf(chair, "back"))) {
    const Vector3d size = boxOf(part).sizes();
    ++(size.x() < size.z() ? slats : rails);
  }
  EXPECT_EQ(slats, 5);
  EXPECT_EQ(rails, 2);
  const AlignedBox3d feet(Vector3d(-0.15, -0.3, 0.0), Vector3d(0.15, -0.05, 0.38));
  for (const Surface& part : componentsOf(chair)) EXPECT_FALSE(boxOf(part).intersects(feet));
}

}  // namespace
}  // namespace amble

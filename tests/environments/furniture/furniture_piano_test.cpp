#include <algorithm>
#include <cmath>

#include "tests/environments/furniture/pieces.h"

namespace amble {
namespace {

using Eigen::AlignedBox3d;
using Eigen::Vector3d;

/// Boxes of a group's parts, from bass to treble.
std::vector<AlignedBox3d> inOrder(const Furniture& piece, const std::string& group) {
  std::vector<AlignedBox3d> boxes;
  for (const Surface& part : componentsOf(groupOf(piece, group))) boxes.push_back(boxOf(part));
  std::sort(boxes.begin(), boxes.end(),
            [](const auto& a, const auto& b) { return a.center().x() < b.center().x(); });
  return boxes;
}

class PianoTest : public testing::Test {
 protected:
  const Furniture piano = makePiano();
};

TEST_F(PianoTest, HasEightyEightKeys) {
  EXPECT_EQ(inOrder(piano, "white-keys").size(), 52u);
  EXPECT_EQ(inOrder(piano, "black-keys").size(), 36u);
}

// From A upwards: black keys stand after A, C, D, F and G.
TEST_F(PianoTest, BlackKeysStandInTwosAndThrees) {
  const auto white = inOrder(piano, "white-keys"), black = inOrder(piano, "black-keys");
  std::string pattern;
  size_t next = 0;
  for (size_t i = 0; i + 1 < white.size(); ++i) {
    const double seam = 0.5 * (white[i].max().x() + white[i + 1].min().x());
    const bool there = next < black.size() && std::abs(black[next].center().x() - seam) < 1e-6;
    pattern += there ? '#' : '.';
    next += there;
  }
  EXPECT_EQ(next, black.size());
  for (size_t i = 0; i < pattern.size(); ++i) EXPECT_EQ(pattern[i], "#.##.##"[i % 7]) << i;
}

TEST_F(PianoTest, WhiteKeysLieSideBySideAndBlackOnesOverThem) {
  const auto white = inOrder(piano, "white-keys"), black = inOrder(piano, "black-keys");
  for (size_t i = 0; i + 1 < white.size(); ++i) {
    EXPECT_GT(white[i + 1].min().x(), white[i].max().x());
    EXPECT_LT(white[i + 1].min().x() - white[i].max().x(), 0.002);
  }
  for (const AlignedBox3d& key : black) {
    EXPECT_GE(key.min().z(), white[0].max().z() - 1e-9);
    EXPECT_LT(key.sizes().x(), 0.6 * white[0].sizes().x());
    EXPECT_LT(key.sizes().y(), white[0].sizes().y());
  }
  EXPECT_LT(white[0].max().y(), -0.5);  // on the player's side
}

TEST_F(PianoTest, TheLidIsOpenAtThirtyThreeDegreesHingedAtTheBassSide) {
  const Surface lid = groupOf(piano, "lid");
  double highest = -1.0, slope = 0.0;
  for (const auto& t : lid.triangles) {
    const Vector3d normal =
        (lid.vertices[t[1]] - lid.vertices[t[0]]).cross(lid.vertices[t[2]] - lid.vertices[t[0]]);
    if (normal.norm() <= highest) continue;  // the largest faces are its broad sides
    highest = normal.norm();
    slope = std::acos(std::abs(normal.normalized().z()));
  }
  EXPECT_NEAR(slope, 33.0 * 3.14159265358979 / 180, 1e-6);
  const AlignedBox3d rim = boxOf(piano, "case"), box = boxOf(lid);
  for (const Vector3d& p : lid.vertices) {
    if (p.x() < box.min().x() + 0.02) {
      EXPECT_LT(p.z(), rim.max().z() + 0.04);
    }
  }
  EXPECT_GT(box.max().z(), rim.max().z() + 0.5);
}

TEST_F(PianoTest, ThePropReachesFromTheRimToTheLid) {
  const AlignedBox3d prop = boxOf(piano, "prop"), lid = boxOf(piano, "lid");
  EXPECT_LT(prop.min().z(), boxOf(piano, "case").max().z());
  EXPECT_TRUE(lid.intersects(prop));
  EXPECT_GT(prop.max().z(), 1.4);
}

TEST_F(PianoTest, StringsLieInTheCaseOverTheSoundBoard) {
  const auto strings = inOrder(piano, "strings");
  EXPECT_EQ(strings.size(), 36u);
  const AlignedBox3d plate = boxOf(piano, "plate"), rim = boxOf(piano, "case");
  for (const AlignedBox3d& string : strings) {
    EXPECT_GT(string.min().z(), plate.max().z());
    EXPECT_LT(string.max().z(), rim.max().z());
    EXPECT_TRUE(rim.contains(string));
  }
  // The bass is the longest, as in every grand piano.
  for (size_t i = 0; i + 1 < strings.size(); ++i)
    EXPECT_GT(strings[i].sizes().y(), strings[i + 1].sizes().y());
}

TEST_F(PianoTest, StandsOnThreeLegsWithWheelsAndHasThreePedals) {
  std::vector<AlignedBox3d> on_floor;
  for (const Surface& part : componentsOf(groupOf(piano, "legs")))
    if (boxOf(part).min().z() < 1e-9) on_floor.push_back(boxOf(part));
  EXPECT_EQ(on_floor.size(), 3u);
  const auto pedals = inOrder(piano, "pedals");
  ASSERT_EQ(pedals.size(), 3u);
  EXPECT_NEAR(pedals[0].center().x(), -pedals[2].center().x(), 1e-9);
  for (const AlignedBox3d& pedal : pedals) {
    EXPECT_GT(pedal.min().z(), 0.02);  // a foot goes on it, not under
    EXPECT_LT(pedal.max().z(), 0.15);
  }
}

// Where the stool's user sits: knees go under the keys.
TEST_F(PianoTest, NothingHangsBelowTheKeysWhereKneesAre) {
  const AlignedBox3d knees(Vector3d(-0.35, -0.78, 0.2), Vector3d(0.35, -0.5, 0.6));
  for (const Surface& part : componentsOf(piano)) EXPECT_FALSE(boxOf(part).intersects(knees));
}

}  // namespace
}  // namespace amble

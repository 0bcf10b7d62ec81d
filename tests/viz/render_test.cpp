#include "viz/render.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "test_walk.h"
#include "viz/color.h"
#include "viz/room.h"

namespace amble {
namespace {

constexpr RenderSettings kSmall{320, 200, 0.5};

// Pixels in which one colour channel leads the others clearly: none of wall and floor does.
int strongPixels(const Image& image, int channel) {
  int count = 0;
  for (size_t i = 0; i < image.rgb.size(); i += 3) {
    const int own = image.rgb[i + channel];
    const int other = std::max(image.rgb[i + (channel + 1) % 3], image.rgb[i + (channel + 2) % 3]);
    count += own > other + 50;
  }
  return count;
}

TEST(RenderWalk, HasTheSizeThatIsAskedForAndIsNotBlank) {
  const Image image = renderWalk(makeTestWalk()->view, kSmall);
  ASSERT_EQ(image.width, 320);
  ASSERT_EQ(image.height, 200);
  EXPECT_GT(strongPixels(image, 0), 50);  // late bodies are red
  EXPECT_GT(strongPixels(image, 2), 50);  // early ones blue
}

TEST(RenderWalk, GivesTheSamePictureTwice) {
  EXPECT_EQ(renderWalk(makeTestWalk()->view, kSmall).rgb,
            renderWalk(makeTestWalk()->view, kSmall).rgb);
}

TEST(RenderWalk, ThreadsChangeNoByte) {
  RenderSettings two = kSmall;
  two.threads = 2;
  EXPECT_EQ(renderWalk(makeTestWalk()->view, kSmall).rgb,
            renderWalk(makeTestWalk()->view, two).rgb);
}

TEST(RenderWalk, ShowsTheRoomWhereThereIsNoWalk) {
  const Scene room = testRoom();
  WalkView view;
  view.scene = &room;
  const Image image = renderWalk(view, kSmall);
  const auto [low, high] = std::minmax_element(image.rgb.begin(), image.rgb.end());
  EXPECT_GT(*high - *low, 60);
}

TEST(RenderWalk, SeesAWalkBehindAWall) {
  const auto walk = makeTestWalk();
  const int before = strongPixels(renderWalk(walk->view, kSmall), 0);
  walk->scene.objects.push_back(testBox("divider", {4, 0.1, 2.5}, {3, 1.2, 1.25}));
  walk->scene.objects.push_back(testBox("divider-2", {4, 0.1, 2.5}, {3, 2.8, 1.25}));
  EXPECT_GT(strongPixels(renderWalk(walk->view, kSmall), 0), before / 3);
}

TEST(Room, LeavesOutTheCeilingAndCutsTheWallsTowardsTheEye) {
  Scene scene = testRoom();
  scene.objects.push_back(testBox("ceiling", {6, 4, 0.2}, {3, 2, 2.6}));
  scene.objects.push_back(
      testBox("picture", {0.8, 0.03, 0.5}, {3, 0.02, 1.5}));  // hangs on the south wall
  const auto room = sortRoom(scene, 0);
  const RoomSight sight{{3, -8, 6}, {{3, 2, 1}}, 0};  // the eye is south of the room
  std::vector<DrawTriangle> triangles;
  addRoom(room, sight, triangles);
  float highest = 0, south = 0, north = 0;
  for (const DrawTriangle& t : triangles) {
    for (const auto& p : t.p) {
      highest = std::max(highest, p.z());
      if (p.y() < -0.01f) south = std::max(south, p.z());  // the side walls end at 0 and at 4
      if (p.y() > 4.01f) north = std::max(north, p.z());
    }
  }
  EXPECT_NEAR(highest, 2.5, 1e-5);
  EXPECT_NEAR(north, 2.5, 1e-5);
  EXPECT_GT(south, 0.01f);
  EXPECT_LT(south, 0.3f);
  const auto on_south = [](const DrawTriangle& t) {
    return t.p[0].z() > 1 && t.p[0].y() < 0.05f && t.p[0].y() > 0.001f;
  };
  EXPECT_EQ(std::count_if(triangles.begin(), triangles.end(), on_south),
            0);  // no picture in the air
}

TEST(Room, TellsFloorsWallsBeamsAndFurniture) {
  Scene scene = testRoom();
  scene.objects.push_back(testBox("beam", {0.2, 4, 0.9}, {3, 2, 2.05}));
  const auto room = sortRoom(scene, 0);
  ASSERT_EQ(room.size(), 7u);
  EXPECT_EQ(room[0].part, RoomPart::kFloor);
  for (int i = 1; i <= 4; ++i) EXPECT_EQ(room[i].part, RoomPart::kWall);
  EXPECT_EQ(room[5].part, RoomPart::kFurniture);
  EXPECT_EQ(room[6].part, RoomPart::kOverhead);
}

TEST(RenderStrip, IsAGridOfTiles) {
  StripSettings settings;
  settings.pictures = 5;
  settings.columns = 3;
  settings.tile_width = 60;
  settings.tile_height = 80;
  const Image strip = renderStrip(makeTestWalk()->view, settings);
  EXPECT_EQ(strip.width, 180);
  EXPECT_EQ(strip.height, 160);
}

int redPixels(const Image& image) {
  int count = 0;
  for (size_t i = 0; i < image.rgb.size(); i += 3)
    count += image.rgb[i] > 150 && image.rgb[i + 1] < 60 && image.rgb[i + 2] < 75;
  return count;
}

TEST(RenderStrip, DrawsWhatSinksBelowTheFloorRed) {
  const auto walk = makeTestWalk();
  StripSettings settings;
  settings.pictures = 1;
  settings.tile_width = 120;
  settings.tile_height = 160;
  EXPECT_EQ(redPixels(renderStrip(walk->view, settings)), 0);
  walk->animation.poses.p_WR(0).z() -= 0.05;
  EXPECT_GT(redPixels(renderStrip(walk->view, settings)), 5);
}

// On a stair the path's ground is between the treads that the feet stand on.
TEST(RenderStrip, AFootOnATreadBelowThePathIsNotBelowTheFloor) {
  const auto walk = makeTestWalk();
  for (FrameState& state : walk->animation.states) state.position.z() += 0.1;
  const StripSettings settings{.pictures = 4, .columns = 4, .tile_width = 120, .tile_height = 160};
  EXPECT_EQ(redPixels(renderStrip(walk->view, settings)), 0);
}

TEST(RenderStrip, OfNothingIsOneTile) {
  const Scene room = testRoom();
  WalkView view;
  view.scene = &room;
  EXPECT_EQ(renderStrip(view).width, StripSettings{}.tile_width);
}

TEST(WalkView, ShoesAreMirrorImagesWithTheBigToeInside) {
  const auto left = shoeOutline(kLeft, 0.27), right = shoeOutline(kRight, 0.27);
  ASSERT_EQ(left.size(), right.size());
  for (const auto& outline : {left, right}) {
    double area = 0;
    for (size_t i = 0; i < outline.size(); ++i) {
      const auto &a = outline[i], &b = outline[(i + 1) % outline.size()];
      area += (a.x() * b.y() - a.y() * b.x()) / 2;
    }
    EXPECT_GT(area, 0.012);  // counter-clockwise, and a sole's size
    EXPECT_LT(area, 0.03);
  }
  for (size_t i = 0; i < left.size(); ++i) {
    EXPECT_DOUBLE_EQ(left[i].x(), right[left.size() - 1 - i].x());
    EXPECT_DOUBLE_EQ(left[i].y(), -right[left.size() - 1 - i].y());
  }
  const auto tip = *std::max_element(right.begin(), right.end(),
                                     [](const auto& a, const auto& b) { return a.x() < b.x(); });
  EXPECT_GT(tip.y(), 0);  // of the right foot: to the left of its middle
}

TEST(WalkView, SoleLengthIsThatOfTheBody) {
  EXPECT_NEAR(soleLength(makeTestWalk()->view), 0.18 + 2 * 0.04, 1e-9);
  EXPECT_NEAR(soleLength(WalkView{}), 0.27, 1e-9);
}

TEST(Colors, AreWhatTheNamesSay) {
  EXPECT_EQ(hexColor(rgb(255, 0, 16)), "#ff0010");
  EXPECT_TRUE(namedColor("flat", "IKEA_sofa").has_value());
  EXPECT_FALSE(namedColor("zzz", "").has_value());
  EXPECT_EQ(otherColor("zzz"), otherColor("zzz"));
}

}  // namespace
}  // namespace amble

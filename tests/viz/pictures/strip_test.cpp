#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "animation/ground/slope_ground.h"
#include "tests/viz/test_walk.h"
#include "viz/pictures/color.h"
#include "viz/pictures/render.h"
#include "viz/pictures/tiny_text.h"

namespace amble {
namespace {

constexpr StripSettings kSmallStrip{
    .pictures = 3, .columns = 3, .tile_width = 60, .tile_height = 80};

long pixelsOf(const Image& image, const Color& color) {
  long count = 0;
  for (size_t i = 0; i < image.rgb.size(); i += 3) {
    const Color here = rgb(image.rgb[i], image.rgb[i + 1], image.rgb[i + 2]);
    count += (here - color).cwiseAbs().maxCoeff() < 0.01f;
  }
  return count;
}

TEST(RenderStrip, ThreadsChangeNoByte) {
  const auto walk = makeTestWalk();
  StripSettings two = kSmallStrip;
  two.threads = 2;
  EXPECT_EQ(renderStrip(walk->view, kSmallStrip).rgb, renderStrip(walk->view, two).rgb);
}

TEST(RenderStrip, AFootHasItsBarWhileItIsPlanted) {
  const auto walk = makeTestWalk();
  StripSettings one{.pictures = 1, .columns = 1};
  constexpr long kBar = 60;  // less of a colour may be a limb in the light [pixels]
  one.first = 5;             // the left foot stands, the right one does not yet
  const Image left_only = renderStrip(walk->view, one);
  one.first = 16;  // both
  const Image both = renderStrip(walk->view, one);
  EXPECT_LT(pixelsOf(left_only, sideColor(kRight)), kBar);
  EXPECT_GT(pixelsOf(left_only, sideColor(kLeft)), kBar);
  EXPECT_GT(pixelsOf(both, sideColor(kRight)), kBar);
}

TEST(RenderStrip, FollowsAWalkOntoHigherGround) {
  const auto low = makeTestWalk(), high = makeTestWalk();
  for (int i = 0; i < high->animation.size(); ++i) {
    high->animation.poses.p_WR(i).z() += 1.0;
    high->animation.states[i].position.z() += 1.0;
  }
  for (Footprint& print : high->animation.footprints) print.position.z() += 1.0;
  const Image a = renderStrip(low->view, kSmallStrip), b = renderStrip(high->view, kSmallStrip);
  long differ = 0;
  for (size_t i = 0; i < a.rgb.size(); ++i) differ += std::abs(a.rgb[i] - b.rgb[i]) > 8;
  EXPECT_LT(differ, static_cast<long>(a.rgb.size() / 100));  // but for rounding at edges
}

TEST(RenderStrip, ABodyOfAnySizeIsShownWhole) {
  for (const double size : {0.3, 1.0, 1.4}) {
    const auto walk = makeTestWalk();
    for (BodyPart& part : walk->body.parts) {
      part.from *= size;
      part.to *= size;
      part.radius *= size;
    }
    for (int i = 0; i < walk->animation.size(); ++i) walk->animation.poses.p_WR(i).z() *= size;
    const Image tile = renderStrip(walk->view, {.pictures = 1, .columns = 1});
    const auto dark = [&](int x, int y) { return tile.pixel(x, y)[0] < 220; };
    constexpr int kLabel = 16;  // it ends above the head
    int head = 0;
    while (head < tile.height && !dark(tile.width / 2 + 10, head)) ++head;
    EXPECT_GE(head, kLabel) << size;
    EXPECT_LT(head, tile.height / 4) << size;
  }
}

TEST(RenderStrip, WhatIsInTheWalkersPlaneIsDrawn) {
  const auto plain = makeTestWalk(), with = makeTestWalk(), beside = makeTestWalk();
  with->scene.objects.push_back(testBox("log", {0.2, 1.0, 0.2}, {1.4, 2.0, 0.1}));
  beside->scene.objects.push_back(testBox("log", {0.2, 1.0, 0.2}, {1.4, 3.0, 0.1}));
  const StripSettings one{.pictures = 1, .columns = 1};
  EXPECT_NE(renderStrip(plain->view, one).rgb, renderStrip(with->view, one).rgb);
  EXPECT_EQ(renderStrip(plain->view, one).rgb, renderStrip(beside->view, one).rgb);
}

// Where the ground is known a sole on a slope is not in it.
TEST(RenderStrip, OnARampNothingIsRed) {
  const auto walk = makeTestWalk();
  const SlopeGround ramp(0.2);
  for (int i = 0; i < walk->animation.size(); ++i) {
    walk->animation.poses.p_WR(i).z() += std::tan(0.2) * walk->animation.poses.p_WR(i).x() + 0.03;
    walk->animation.states[i].position = walk->animation.poses.p_WR(i);
    walk->animation.states[i].position.z() -= 0.93;
  }
  walk->view.ground = &ramp;
  const Image strip = renderStrip(walk->view, {.pictures = 4, .columns = 4});
  for (size_t i = 0; i < strip.rgb.size(); i += 3)
    ASSERT_FALSE(strip.rgb[i] > 150 && strip.rgb[i + 1] < 60 && strip.rgb[i + 2] < 60) << i;
}

TEST(StripOfWhole, ShowsAWalkOfAnyLengthToItsEnd) {
  AnimationBuffer walk;
  walk.poses = PoseArray(1);
  for (const double frame_time : {1.0 / 24, 1.0 / 60, 1.0 / 240}) {
    walk.frame_time = frame_time;
    for (const int frames : {1, 7, 100, 5000}) {
      walk.poses.resize(frames);
      const StripSettings strip = stripOfWhole(walk);
      EXPECT_GE(strip.step, 1);
      EXPECT_LE((frames + strip.step - 1) / strip.step, strip.pictures) << frames;
    }
  }
}

/// The tile of a strip that is `index` pictures from its begin.
Image tileOf(const Image& strip, const StripSettings& settings, int columns, int index) {
  Image tile(settings.tile_width, settings.tile_height);
  for (int y = 0; y < tile.height; ++y)
    std::copy_n(strip.pixel(index % columns * tile.width, index / columns * tile.height + y),
                3 * tile.width, tile.pixel(0, y));
  return tile;
}

TEST(RenderStrip, EveryTileIsThePictureOfItsFrame) {
  const auto walk = makeTestWalk();
  StripSettings settings{
      .first = 3, .step = 11, .pictures = 5, .columns = 2, .tile_width = 60, .tile_height = 80};
  const Image strip = renderStrip(walk->view, settings);
  ASSERT_EQ(strip.width, 120);
  ASSERT_EQ(strip.height, 240);
  for (int i = 0; i < 5; ++i) {
    StripSettings one = settings;
    one.first = settings.first + i * settings.step;
    one.pictures = one.columns = 1;
    EXPECT_EQ(renderStrip(walk->view, one).rgb, tileOf(strip, settings, 2, i).rgb) << i;
  }
  // What is left of the last row stays blank.
  const Image last = tileOf(strip, settings, 2, 5);
  EXPECT_EQ(std::count(last.rgb.begin(), last.rgb.end(), 250), static_cast<long>(last.rgb.size()));
}

TEST(RenderStrip, EndsWithTheWalk) {
  const auto walk = makeTestWalk();  // 121 frames
  for (const auto& [first, step, pictures] :
       {std::array{0, 30, 5}, std::array{100, 10, 3}, std::array{120, 1, 1}}) {
    const StripSettings settings{.first = first,
                                 .step = step,
                                 .pictures = 50,
                                 .columns = 50,
                                 .tile_width = 20,
                                 .tile_height = 24};
    EXPECT_EQ(renderStrip(walk->view, settings).width, 20 * pictures) << first;
  }
}

// The root is held in the middle: a walk that moves is seen as one on the spot.
TEST(RenderStrip, FramesOfTheSamePoseLookTheSame) {
  const auto walk = makeTestWalk();
  walk->animation.footprints.clear();
  const StripSettings tile{.pictures = 1, .columns = 1, .tile_width = 120, .tile_height = 160};
  StripSettings later = tile;
  later.first = 60;  // 2 m on: the marks on the floor are again where they were
  const Image a = renderStrip(walk->view, tile), b = renderStrip(walk->view, later);
  long differ = 0;
  for (int y = 30; y < a.height; ++y)  // below the numbers
    for (int x = 0; x < a.width; ++x) differ += std::abs(a.pixel(x, y)[0] - b.pixel(x, y)[0]) > 8;
  EXPECT_LT(differ, a.width * a.height / 200);
}

TEST(RenderStrip, FromTheOtherSideTheOtherLegIsNearer) {
  const auto walk = makeTestWalk();
  walk->animation.footprints.clear();
  StripSettings right{.pictures = 1, .columns = 1};
  StripSettings left = right;
  left.side = -right.side;
  // The legs are in line: only the nearer one's colour is seen.
  const auto blue = [&](const Image& image) {
    long count = 0;
    for (size_t i = 0; i < image.rgb.size(); i += 3) count += image.rgb[i + 2] > image.rgb[i] + 40;
    return count;
  };
  const long from_left = blue(renderStrip(walk->view, left));
  const long from_right = blue(renderStrip(walk->view, right));
  EXPECT_GT(from_left, 4 * from_right);
}

TEST(RenderStrip, EveryTileHasItsFrameAndItsTime) {
  const auto walk = makeTestWalk();
  for (const auto& [frame, text] :
       {std::pair{0, "0  0.000 s"}, std::pair{45, "45  1.500 s"}, std::pair{120, "120  4.000 s"}}) {
    const StripSettings one{.first = frame, .pictures = 1, .columns = 1};
    const Image tile = renderStrip(walk->view, one);
    Image written(tile.width, 24);  // black where the text is
    std::fill(written.rgb.begin(), written.rgb.end(), uint8_t{255});
    drawText(written, 6, 6, text, 2, rgb(0, 0, 0));
    for (int y = 6; y < 20; ++y)
      for (int x = 6; x < 6 + textWidth(text, 2); ++x)
        EXPECT_EQ(tile.pixel(x, y)[0] < 128, written.pixel(x, y)[0] == 0) << text << x << " " << y;
  }
}

TEST(RenderStrip, FromAboveTheFloorHasItsGridInsteadOfALine) {
  const auto walk = makeTestWalk();
  StripSettings level{.pictures = 1, .columns = 1, .tile_width = 120, .tile_height = 160};
  StripSettings lifted = level;
  lifted.lift = 0.6;
  const Image side = renderStrip(walk->view, level), above = renderStrip(walk->view, lifted);
  // The background is seen beside a walker from the side, and hardly over a floor from above.
  const auto background = [](const Image& image) {
    long count = 0;
    for (size_t i = 0; i < image.rgb.size(); i += 3)
      count += image.rgb[i] >= 248 && image.rgb[i + 2] >= 248;  // earth is less blue than red
    return count;
  };
  EXPECT_LT(background(above), background(side) / 2);
}

}  // namespace
}  // namespace amble

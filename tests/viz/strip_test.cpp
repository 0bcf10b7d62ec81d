#include <gtest/gtest.h>

#include <algorithm>

#include "tests/viz/test_walk.h"
#include "viz/color.h"
#include "viz/render.h"

namespace amble {
namespace {

constexpr StripSettings kSmall{.pictures = 3, .columns = 3, .tile_width = 60, .tile_height = 80};

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
  StripSettings two = kSmall;
  two.threads = 2;
  EXPECT_EQ(renderStrip(walk->view, kSmall).rgb, renderStrip(walk->view, two).rgb);
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
  const Image a = renderStrip(low->view, kSmall), b = renderStrip(high->view, kSmall);
  long differ = 0;
  for (size_t i = 0; i < a.rgb.size(); ++i) differ += std::abs(a.rgb[i] - b.rgb[i]) > 8;
  EXPECT_LT(differ, static_cast<long>(a.rgb.size() / 100));  // but for rounding at edges
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

}  // namespace
}  // namespace amble

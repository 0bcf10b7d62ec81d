#include "viz/pictures/lighting.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "viz/pictures/draw_mesh.h"

namespace amble {
namespace {

using Eigen::Vector3f;

constexpr int kSize = 48;

/// From above: pixel (x, y) sees World (x / 12 - 2, 2 - y / 12) from a height of 5 m.
Camera fromAbove() {
  Camera camera;
  camera.parallel = true;
  camera.eye = {0, 0, 5};
  camera.axes << 1, 0, 0, 0, -1, 0, 0, 0, -1;
  camera.centre = {kSize / 2.0f, kSize / 2.0f};
  camera.scale = 12;
  return camera.enlarged(kSupersampling);
}

void addBox(const Eigen::Vector3d& size, const Eigen::Vector3d& at, uint8_t flags,
            std::vector<DrawTriangle>& triangles) {
  TriangleMesh box = makeBox(size);
  for (Eigen::Vector3d& p : box.vertices) p += at;
  addMesh(box, rgb(200, 160, 120), flags, triangles);
}

/// A floor of 3 x 3 m, half of the picture's edge free, with a block and a plate over it.
std::vector<DrawTriangle> things(uint8_t flags = 0) {
  std::vector<DrawTriangle> triangles;
  addBox({3, 3, 0.1}, {0, 0, -0.05}, 0, triangles);
  addBox({0.5, 0.5, 0.6}, {0.7, 0.6, 0.3}, flags, triangles);
  addBox({0.8, 0.8, 0.02}, {-0.6, -0.4, 0.5}, flags, triangles);
  return triangles;
}

Image lit(const std::vector<DrawTriangle>& triangles, LightSettings light, int threads = 1) {
  light.threads = threads;
  light.shadow_size = 256;
  light.shadowed = Eigen::AlignedBox3f(Vector3f(-2, -2, -0.1f), Vector3f(2, 2, 1));
  const SampleBuffer samples =
      rasterize(triangles, fromAbove(), kSize * kSupersampling, kSize * kSupersampling, threads);
  return lightSamples(samples, fromAbove(), triangles, light);
}

/// Whether no byte of `a` is larger than that of `b`.
bool nowhereBrighter(const Image& a, const Image& b) {
  return std::equal(a.rgb.begin(), a.rgb.end(), b.rgb.begin(), std::less_equal<>());
}

TEST(Lighting, OfNothingIsTheBackground) {
  const Image image = lit({}, {.background = rgb(10, 120, 240)});
  for (size_t i = 0; i < image.rgb.size(); i += 3) {
    EXPECT_NEAR(image.rgb[i], 10, 1);
    EXPECT_NEAR(image.rgb[i + 1], 120, 1);
    EXPECT_NEAR(image.rgb[i + 2], 240, 1);
  }
}

TEST(Lighting, WithoutLightThingsAreBlack) {
  const Image image = lit(things(), {.sun = 0.0f, .sky = 0.0f});
  EXPECT_EQ(image.pixel(kSize / 2, kSize / 2)[0], 0);
  EXPECT_GT(image.pixel(0, 0)[0], 200);  // beside the floor
}

TEST(Lighting, MoreLightIsNowhereDarker) {
  const Image dim = lit(things(), {.sun = 0.2f, .sky = 0.2f});
  const Image sunny = lit(things(), {.sun = 0.5f, .sky = 0.2f});
  const Image bright = lit(things(), {.sun = 0.5f, .sky = 0.4f});
  EXPECT_TRUE(nowhereBrighter(dim, sunny));
  EXPECT_TRUE(nowhereBrighter(sunny, bright));
  EXPECT_FALSE(nowhereBrighter(sunny, dim));
  EXPECT_FALSE(nowhereBrighter(bright, sunny));
}

TEST(Lighting, ShadowsOnlyTakeAway) {
  const Image shadowed = lit(things(), {}), open = lit(things(kNoShadow), {});
  EXPECT_TRUE(nowhereBrighter(shadowed, open));
  long darker = 0;
  for (size_t i = 0; i < open.rgb.size(); ++i) darker += shadowed.rgb[i] + 20 < open.rgb[i];
  EXPECT_GT(darker, 100);
}

TEST(Lighting, ACornerIsDarkerThanTheOpenFloor) {
  std::vector<DrawTriangle> triangles;
  addBox({3, 3, 0.1}, {0, 0, -0.05}, 0, triangles);
  addBox({1, 1, 0.15}, {0, 0, 0.075}, 0, triangles);
  const Image image = lit(triangles, {.sun = 0.0f, .sky = 0.6f});
  // The block ends at 0.5 m, 6 pixels from the middle: what is beside it, and 0.8 m farther on.
  EXPECT_LT(image.pixel(kSize / 2 + 6, kSize / 2)[0],
            image.pixel(kSize / 2 + 16, kSize / 2)[0] - 3);
}

TEST(Lighting, ThreadsChangeNoByte) {
  const Image one = lit(things(), {});
  for (const int threads : {2, 5}) EXPECT_EQ(lit(things(), {}, threads).rgb, one.rgb) << threads;
}

float linearOf(uint8_t byte) { return std::pow(static_cast<float>(byte) / 255.0f, 2.2f); }

TEST(Lighting, SunAndSkyAddUpAsLightDoes) {
  const Image sky = lit(things(), {.sun = 0.0f, .sky = 0.3f});
  const Image sun = lit(things(), {.sun = 0.3f, .sky = 0.0f});
  const Image both = lit(things(), {.sun = 0.3f, .sky = 0.3f});
  for (int y = 8; y < kSize - 8; ++y) {
    for (int x = 8; x < kSize - 8; ++x) {  // of the floor and what stands on it
      const float sum = linearOf(sky.pixel(x, y)[1]) + linearOf(sun.pixel(x, y)[1]);
      EXPECT_NEAR(linearOf(both.pixel(x, y)[1]), sum, 0.012f) << x << " " << y;
    }
  }
}

TEST(Lighting, HowLongTheWayToTheSunIsDoesNotMatter) {
  const Image once = lit(things(), {.to_sun = {-0.35f, -0.25f, 0.9f}});
  const Image far = lit(things(), {.to_sun = {-3.5f, -2.5f, 9.0f}});
  EXPECT_EQ(once.rgb, far.rgb);
}

TEST(Lighting, ASurfaceTurnedAwayFromTheSunHasTheSkyOnly) {
  const LightSettings below{.to_sun = {0.1f, 0.1f, -1.0f}, .sun = 0.6f, .sky = 0.4f};
  const LightSettings none{.sun = 0.0f, .sky = 0.4f};
  EXPECT_EQ(lit(things(), below).rgb, lit(things(), none).rgb);
}

TEST(Lighting, DarkerThingsAreDarkerEverywhere) {
  std::vector<DrawTriangle> dark = things();
  for (DrawTriangle& t : dark) t.color *= 0.6f;
  const Image bright = lit(things(), {}), dim = lit(dark, {});
  EXPECT_TRUE(nowhereBrighter(dim, bright));
  EXPECT_LT(dim.pixel(kSize / 2, kSize / 2)[0], bright.pixel(kSize / 2, kSize / 2)[0]);
}

// A plate's shadow lies where the sun's rays by it meet the floor, whichever way they come.
TEST(Lighting, AShadowLiesAsFarAsideAsTheSunIsLow) {
  constexpr float kHigh = 0.5f;
  for (const Vector3f& to_sun : {Vector3f(1, 0, 1), Vector3f(-1, 0.5f, 1), Vector3f(0, -0.8f, 1)}) {
    std::vector<DrawTriangle> plate;
    addBox({3.6, 3.6, 0.1}, {0, 0, -0.05}, 0, plate);
    const std::vector<DrawTriangle> floor = plate;
    addBox({0.5, 0.5, 0.02}, {0, 0, kHigh}, 0, plate);
    const Image shaded = lit(plate, {.to_sun = to_sun, .sky = 0.2f});
    const Image open = lit(floor, {.to_sun = to_sun, .sky = 0.2f});
    const Eigen::Vector2f at = -kHigh * to_sun.head<2>() / to_sun.z();
    const auto darker = [&](const Eigen::Vector2f& p) {  // [m]
      const int x = static_cast<int>((p.x() + 2.0f) * 12),
                y = static_cast<int>((2.0f - p.y()) * 12);
      return open.pixel(x, y)[0] - shaded.pixel(x, y)[0];
    };
    const Eigen::Vector2f out = 0.12f * at.normalized();  // away from the plate, which hides some
    EXPECT_GT(darker(at + out), 40) << to_sun.transpose();
    EXPECT_LT(darker(-1.6f * at), 8) << to_sun.transpose();
    EXPECT_LT(darker(2.2f * at), 8) << to_sun.transpose();
  }
}

}  // namespace
}  // namespace amble

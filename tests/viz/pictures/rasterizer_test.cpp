#include "viz/pictures/rasterizer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <optional>
#include <random>

#include "viz/pictures/draw_mesh.h"
#include "viz/pictures/lighting.h"

namespace amble {
namespace {

using Eigen::Vector3f;

constexpr int kBufferSize = 64;

// From above: pixel (x, y) sees World (x / 16 - 2, 2 - y / 16) from a height of 5 m.
Camera fiveMetresAbove() {
  Camera camera;
  camera.parallel = true;
  camera.eye = {0, 0, 5};
  camera.axes << 1, 0, 0, 0, -1, 0, 0, 0, -1;
  camera.centre = {kBufferSize / 2.0f, kBufferSize / 2.0f};
  camera.scale = 16;
  return camera;
}

DrawTriangle level(float height, const Color& color, uint8_t flags = 0) {
  DrawTriangle t;
  t.p = {Vector3f(-9, -9, height), Vector3f(9, -9, height), Vector3f(0, 9, height)};
  t.normal.fill(Vector3f::UnitZ());
  t.color = color;
  t.flags = flags;
  return t;
}

DrawTriangle turnedOver(DrawTriangle t) {
  std::swap(t.p[1], t.p[2]);
  t.normal.fill(-Vector3f::UnitZ());
  return t;
}

TEST(Rasterizer, NormalsAreKeptToATenthOfAMilliradian) {
  std::mt19937 random(1);
  std::normal_distribution<float> draw;
  Look look;
  for (int i = 0; i < 20000; ++i) {
    const Vector3f n(draw(random), draw(random), draw(random));
    look.setNormal(n);
    EXPECT_LT((look.normal() - n.normalized()).norm(), 1e-4f);
  }
  for (int axis = 0; axis < 3; ++axis) {
    for (const float sign : {-1.0f, 1.0f}) {
      look.setNormal(sign * Vector3f::Unit(axis));
      EXPECT_EQ(look.normal(), sign * Vector3f::Unit(axis));
    }
  }
}

TEST(Rasterizer, NothingIsSeenOfNothing) {
  const SampleBuffer buffer = rasterize({}, fiveMetresAbove(), kBufferSize, kBufferSize);
  for (const float depth : buffer.depth) EXPECT_EQ(depth, 0);
}

TEST(Rasterizer, TheNearerWinsInEitherOrder) {
  const DrawTriangle low = level(0, rgb(10, 20, 30)), high = level(1, rgb(200, 100, 50));
  for (const auto& triangles : {std::vector{low, high}, std::vector{high, low}}) {
    const SampleBuffer buffer = rasterize(triangles, fiveMetresAbove(), kBufferSize, kBufferSize);
    EXPECT_NEAR(buffer.at(32, 32).depth, 4, 1e-5);
    EXPECT_EQ(buffer.at(32, 32).color[0], 200);
  }
}

TEST(Rasterizer, BacksAreNotDrawnUnlessTwoSidedOrCut) {
  const DrawTriangle back = turnedOver(level(0, rgb(9, 9, 9)));
  EXPECT_EQ(
      rasterize(std::vector{back}, fiveMetresAbove(), kBufferSize, kBufferSize).at(32, 32).depth,
      0);
  for (const uint8_t flag : {kTwoSided, kCut}) {
    DrawTriangle shown = back;
    shown.flags = flag;
    const SampleBuffer buffer =
        rasterize(std::vector{shown}, fiveMetresAbove(), kBufferSize, kBufferSize);
    EXPECT_GT(buffer.at(32, 32).depth, 0);
    EXPECT_GT(buffer.at(32, 32).normal().z(), 0.99f);
  }
}

TEST(Rasterizer, SeeThroughCoversAQuarter) {
  const auto triangles = std::vector{level(0, rgb(0, 0, 0)), level(1, rgb(255, 0, 0), kSeeThrough)};
  const SampleBuffer buffer = rasterize(triangles, fiveMetresAbove(), kBufferSize, kBufferSize);
  int red = 0;
  for (int y = 20; y < 40; ++y)
    for (int x = 20; x < 40; ++x) red += buffer.at(x, y).color[0] == 255;
  EXPECT_EQ(red, 100);
}

TEST(Rasterizer, DecalsLieOnWhatIsJustBeforeThem) {
  const auto triangles = std::vector{level(-0.01f, rgb(255, 0, 0), kDecal), level(0, rgb(0, 0, 0))};
  EXPECT_EQ(rasterize(triangles, fiveMetresAbove(), kBufferSize, kBufferSize).at(32, 32).color[0],
            255);
  const auto deep = std::vector{level(-0.1f, rgb(255, 0, 0), kDecal), level(0, rgb(0, 0, 0))};
  EXPECT_EQ(rasterize(deep, fiveMetresAbove(), kBufferSize, kBufferSize).at(32, 32).color[0], 0);
}

TEST(Rasterizer, CutsWhatReachesBehindTheEye) {
  Camera camera;  // at the origin, looking along +x
  camera.axes = viewAxes(Vector3f::UnitX());
  camera.centre = {kBufferSize / 2.0f, kBufferSize / 2.0f};
  camera.scale = 32;
  DrawTriangle floor;
  floor.p = {Vector3f(-5, -9, -1), Vector3f(-5, 9, -1), Vector3f(60, 0, -1)};
  floor.normal.fill(Vector3f::UnitZ());
  floor.flags = kTwoSided;
  const SampleBuffer buffer = rasterize(std::vector{floor}, camera, kBufferSize, kBufferSize);
  EXPECT_EQ(buffer.at(32, 20).depth, 0);  // above the horizon
  EXPECT_NEAR(buffer.at(32, 63).depth, 1.0159,
              0.02);  // 31.5 pixels below the middle: depth 32 / 31.5
}

TEST(Rasterizer, AgreesWithItsDepthMap) {
  std::vector<DrawTriangle> triangles;
  addMesh(makeSphere(1, 24), rgb(90, 90, 90), 0, triangles);
  const SampleBuffer buffer = rasterize(triangles, fiveMetresAbove(), kBufferSize, kBufferSize);
  const DepthMap map = rasterizeDepth(triangles, fiveMetresAbove(), kBufferSize, kBufferSize, 0);
  for (int y = 0; y < kBufferSize; ++y)
    for (int x = 0; x < kBufferSize; ++x) EXPECT_EQ(buffer.at(x, y).depth, map.at(x, y));
  EXPECT_NEAR(map.at(32, 32), 4, 0.01);
}

TEST(Rasterizer, WhatIsNearerHidesWhatIsFartherInAnyOrder) {
  std::vector<DrawTriangle> triangles = {level(0.5f, rgb(1, 0, 0)), level(1.5f, rgb(2, 0, 0)),
                                         level(1.0f, rgb(3, 0, 0))};
  for (int order = 0; order < 3; ++order) {
    std::rotate(triangles.begin(), triangles.begin() + 1, triangles.end());
    for (const int threads : {1, 4}) {
      const SampleBuffer buffer =
          rasterize(triangles, fiveMetresAbove(), kBufferSize, kBufferSize, threads);
      for (size_t i = 0; i < buffer.depth.size(); ++i)
        EXPECT_TRUE(buffer.depth[i] == 0 || buffer.look[i].color[0] == 2);
    }
  }
}

TEST(Rasterizer, BandsCoverEveryRowOnce) {
  for (const int rows : {1, 7, 100}) {
    std::vector<std::atomic<int>> seen(rows);
    forBands(rows, 3, [&](int first, int last) {
      for (int y = first; y < last; ++y) ++seen[y];
    });
    for (const auto& count : seen) EXPECT_EQ(count, 1);
  }
}

TEST(Lighting, WhatLiesUnderAPlateIsInItsShadow) {
  std::vector<DrawTriangle> triangles = {level(0, rgb(200, 200, 200))};
  TriangleMesh plate = makeBox({1, 1, 0.02});
  for (auto& p : plate.vertices) p.z() += 0.5;
  addMesh(plate, rgb(200, 200, 200), 0, triangles);
  LightSettings light;
  light.to_sun = {-1, 0, 1};  // the shadow falls half a metre towards +x
  light.shadowed = Eigen::AlignedBox3f(Vector3f(-2, -2, 0), Vector3f(2, 2, 1));
  const Camera large = fiveMetresAbove().enlarged(kSupersampling);
  const SampleBuffer samples =
      rasterize(triangles, large, kBufferSize * kSupersampling, kBufferSize * kSupersampling);
  const Image image = lightSamples(samples, large, triangles, light);
  const int shade = image.pixel(32 + 12, 32)[0];  // (0.75, 0): shaded, and not hidden by the plate
  const int open = image.pixel(32 - 20, 32)[0];
  EXPECT_LT(shade, open - 30);
  EXPECT_NEAR(image.pixel(32 + 24, 32)[0], open, 6);  // (1.5, 0) is in the sun
}

// Every sample by itself: a line through its middle down to the triangles it meets.
TEST(Rasterizer, ASampleSeesTheNearestOfRandomTriangles) {
  std::mt19937 generator(4);
  std::uniform_real_distribution<float> place(-2.5f, 2.5f), height(-1.0f, 3.0f);
  std::vector<DrawTriangle> triangles;
  for (int i = 0; i < 40; ++i) {
    DrawTriangle t;
    for (auto& p : t.p) p = {place(generator), place(generator), height(generator)};
    t.normal.fill(Vector3f::UnitZ());
    t.color = rgb(i + 1, 0, 0);
    t.flags = kTwoSided;
    triangles.push_back(t);
  }
  const Camera camera = fiveMetresAbove();
  const SampleBuffer buffer = rasterize(triangles, camera, kBufferSize, kBufferSize);
  int seen = 0;
  for (int y = 0; y < kBufferSize; ++y) {
    for (int x = 0; x < kBufferSize; ++x) {
      const double px = (x + 0.5 - 32) / 16, py = (32 - y - 0.5) / 16;
      double highest = -1e9;
      bool doubtful = false;
      int owner = 0;
      for (size_t i = 0; i < triangles.size(); ++i) {
        const Eigen::Vector3d a = triangles[i].p[0].cast<double>(),
                              b = triangles[i].p[1].cast<double>(),
                              c = triangles[i].p[2].cast<double>();
        const auto area = [](const Eigen::Vector3d& u, const Eigen::Vector3d& v, double qx,
                             double qy) {
          return (u.x() - qx) * (v.y() - qy) - (u.y() - qy) * (v.x() - qx);
        };
        const double whole = area(b, c, a.x(), a.y());
        const double wa = area(b, c, px, py) / whole, wb = area(c, a, px, py) / whole;
        const double least = std::min({wa, wb, 1 - wa - wb});
        doubtful = doubtful || std::abs(least) < 1e-4;
        if (least < 0) continue;
        const double z = wa * a.z() + wb * b.z() + (1 - wa - wb) * c.z();
        doubtful = doubtful || std::abs(z - highest) < 1e-4;
        if (z > highest) owner = static_cast<int>(i) + 1;
        highest = std::max(highest, z);
      }
      if (doubtful) continue;
      const Sample& sample = buffer.at(x, y);
      EXPECT_EQ(sample.color[0], owner);
      if (owner > 0) {
        EXPECT_NEAR(sample.depth, 5 - highest, 1e-3);
        ++seen;
      }
    }
  }
  EXPECT_GT(seen, 1000);
}

/// How far along a ray a triangle is met, or none; `doubtful` near its edges (Moeller and
/// Trumbore).
std::optional<double> meets(const DrawTriangle& t, const Eigen::Vector3d& eye,
                            const Eigen::Vector3d& way, bool& doubtful) {
  const Eigen::Vector3d a = t.p[0].cast<double>(), ab = t.p[1].cast<double>() - a,
                        ac = t.p[2].cast<double>() - a;
  const Eigen::Vector3d q = way.cross(ac), r = (eye - a).cross(ab);
  const double det = ab.dot(q), u = (eye - a).dot(q) / det, v = way.dot(r) / det;
  const double least = std::min({u, v, 1 - u - v}), s = ac.dot(r) / det;
  doubtful = doubtful || (std::abs(least) < 1e-3 && s > 0.0);
  if (least < 0.0 || s < 0.0) return std::nullopt;
  return s;
}

// A perspective picture against rays from the eye, each through the middle of its sample.
TEST(Rasterizer, PerspectiveSamplesSeeWhatTheirRaysMeetFirst) {
  std::mt19937 generator(5);
  std::uniform_real_distribution<float> place(-3.0f, 3.0f), away(2.0f, 9.0f);
  std::vector<DrawTriangle> triangles;
  for (int i = 0; i < 25; ++i) {
    DrawTriangle t;
    const float x = away(generator);
    for (auto& p : t.p) p = {x + 0.5f * place(generator), place(generator), place(generator)};
    t.normal.fill(-Vector3f::UnitX());
    t.color = rgb(i + 1, 0, 0);
    t.flags = kTwoSided;
    triangles.push_back(t);
  }
  Camera camera;  // at the origin, looking along +x
  camera.axes = viewAxes(Vector3f::UnitX());
  camera.centre = {kBufferSize / 2.0f, kBufferSize / 2.0f};
  camera.scale = 40;
  const SampleBuffer buffer = rasterize(triangles, camera, kBufferSize, kBufferSize);
  int seen = 0;
  for (int y = 0; y < kBufferSize; y += 3) {
    for (int x = 0; x < kBufferSize; x += 3) {
      const Eigen::Vector2f middle(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
      const Eigen::Vector3d way = camera.toWorld(middle, 1.0f).cast<double>();
      double nearest = 1e9, second = 1e9;
      int owner = 0;
      bool doubtful = false;
      for (size_t i = 0; i < triangles.size(); ++i) {
        const auto s = meets(triangles[i], Eigen::Vector3d::Zero(), way, doubtful);
        if (!s || *s < kNearest) continue;
        if (*s < nearest) owner = static_cast<int>(i) + 1;
        second = std::min(second, std::max(*s, nearest));
        nearest = std::min(nearest, *s);
      }
      if (doubtful || second - nearest < 1e-3) continue;
      EXPECT_EQ(buffer.at(x, y).color[0], owner) << x << " " << y;
      if (owner == 0) continue;
      EXPECT_NEAR(buffer.at(x, y).depth, nearest, 1e-3 * nearest);  // along the view, as the ray is
      ++seen;
    }
  }
  EXPECT_GT(seen, 80);
}

TEST(Rasterizer, WhatIsSkippedIsNotInTheDepths) {
  const auto triangles = std::vector{level(0, rgb(1, 1, 1)), level(1, rgb(2, 2, 2), kNoShadow)};
  EXPECT_NEAR(rasterizeDepth(triangles, fiveMetresAbove(), kBufferSize, kBufferSize, 0).at(32, 32),
              4, 1e-5);
  EXPECT_NEAR(
      rasterizeDepth(triangles, fiveMetresAbove(), kBufferSize, kBufferSize, kNoShadow).at(32, 32),
      5, 1e-5);
  EXPECT_EQ(rasterizeDepth({}, fiveMetresAbove(), kBufferSize, kBufferSize, 0).at(32, 32), 0);
}

}  // namespace
}  // namespace amble

#include "viz/pictures/camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace amble {
namespace {

using Eigen::Vector2f;
using Eigen::Vector3f;

const std::vector<Vector3f> kBox = {{0, 0, 0}, {8, 0, 0}, {8, 6, 0}, {0, 6, 0},
                                    {0, 0, 2}, {8, 0, 2}, {8, 6, 2}, {0, 6, 2}};

TEST(Camera, AxesAreOrthonormalWithUpInThePicture) {
  const Eigen::Matrix3f axes = viewAxes({0.3f, -0.8f, -0.5f});
  EXPECT_TRUE((axes * axes.transpose()).isIdentity(1e-5f));
  EXPECT_LT(axes.row(1).dot(Vector3f::UnitZ()), 0);  // the second row points down
  EXPECT_NEAR(axes.row(0).z(), 0, 1e-6);
}

TEST(Camera, PointsComeBackFromPixelAndDepth) {
  Camera camera = frameView(kBox, {-0.9, 0.7}, 800, 500, 20);
  for (const bool parallel : {false, true}) {
    camera.parallel = parallel;
    if (parallel) camera.scale = 60;
    for (const Vector3f& p : kBox) {
      const Vector3f view = camera.toView(p);
      EXPECT_LT((camera.toWorld(camera.toPixel(view), view.z()) - p).norm(), 1e-3f);
    }
  }
}

TEST(Camera, FrameViewShowsEveryPointAndTouchesTheMargin) {
  for (const double azimuth : {-2.2, -0.9, 0.4, 3.0}) {
    const Camera camera = frameView(kBox, {azimuth, 0.7}, 800, 500, 20);
    Eigen::AlignedBox2f seen;
    for (const Vector3f& p : kBox) seen.extend(camera.toPixel(camera.toView(p)));
    EXPECT_GT(seen.min().minCoeff(), 19);
    EXPECT_LT(seen.max().x(), 781);
    EXPECT_LT(seen.max().y(), 481);
    EXPECT_TRUE(seen.sizes().x() > 750 || seen.sizes().y() > 450) << "too far away";
  }
}

TEST(Camera, EnlargedSeesTheSameInMorePixels) {
  const Camera camera = frameView(kBox, {-0.9, 0.7}, 800, 500, 20);
  const Camera large = camera.enlarged(2);
  for (const Vector3f& p : kBox)
    EXPECT_LT((large.toPixel(large.toView(p)) - 2 * camera.toPixel(camera.toView(p))).norm(),
              1e-2f);
}

TEST(Camera, TheEyeStandsWhereItsDirectionSays) {
  for (const ViewDirection from : {ViewDirection{0.0, 0.5}, {2.0, 1.2}, {-1.1, 0.1}}) {
    const Camera camera = frameView(kBox, from, 640, 480, 10);
    const Vector3f back = -camera.axes.row(2).transpose();
    EXPECT_NEAR(std::atan2(back.y(), back.x()), from.azimuth, 1e-5);
    EXPECT_NEAR(std::asin(back.z()), from.elevation, 1e-5);
    for (const Vector3f& p : kBox) {
      EXPECT_GT(camera.toView(p).z(), 0.0f);  // before it
      EXPECT_NEAR(camera.towardsEye(p).norm(), 1.0f, 1e-5f);
      EXPECT_GT(camera.towardsEye(p).dot(camera.eye - p), 0.0f);
    }
  }
}

TEST(Camera, WhatIsHigherIsHigherInThePicture) {
  const Camera camera = frameView(kBox, {0.3, 0.6}, 640, 480, 10);
  for (int i = 0; i < 4; ++i) {
    const float low = camera.toPixel(camera.toView(kBox[i])).y();
    EXPECT_LT(camera.toPixel(camera.toView(kBox[i + 4])).y(), low);
  }
}

TEST(Camera, ParallelViewsShowEqualLengthsEqual) {
  Camera camera;
  camera.parallel = true;
  camera.axes = viewAxes({1, 0.5f, -0.3f});
  camera.scale = 50;
  const Vector3f step(0.3f, -0.8f, 0.5f);
  const auto seen = [&](const Vector3f& p) {
    return Vector2f(camera.toPixel(camera.toView(p + step)) - camera.toPixel(camera.toView(p)));
  };
  EXPECT_LT((seen({0, 0, 0}) - seen({40, -7, 3})).norm(), 1e-2f);
}

}  // namespace
}  // namespace amble

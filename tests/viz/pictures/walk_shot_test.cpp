#include "viz/pictures/walk_shot.h"

#include <gtest/gtest.h>

#include "tests/viz/test_walk.h"

namespace amble {
namespace {

using Eigen::Vector2f;
using Eigen::Vector3f;

constexpr int kWide = 640, kTall = 400;

WalkShot shotOf(const WalkView& view, PointOfView from, std::optional<int> corner = {}) {
  ShotSettings settings;
  settings.from = from;
  settings.corner = corner;
  settings.width = kWide;
  settings.height = kTall;
  settings.frames = {0, 60, 120};
  return takeShot(view, settings);
}

// Whether a point is in the picture, before the eye.
bool isSeen(const Camera& camera, const Vector3f& p) {
  const Vector3f v = camera.toView(p);
  if (!camera.parallel && v.z() <= 0.0F) return false;
  const Vector2f pixel = camera.toPixel(v);
  return pixel.x() >= 0 && pixel.y() >= 0 && pixel.x() <= kWide && pixel.y() <= kTall;
}

TEST(WalkShot, AllOfTheWalkIsInThePictureFromOutside) {
  const auto walk = makeTestWalk();
  for (const PointOfView from : {PointOfView::kTop, PointOfView::kSide, PointOfView::kCorner}) {
    const Camera camera = shotOf(walk->view, from).camera;
    for (float x = 1.0F; x <= 5.0F; x += 0.5F)
      for (const float z : {0.0F, 0.9F, 1.6F})
        EXPECT_TRUE(isSeen(camera, {x, 2.0F, z})) << static_cast<int>(from) << " " << x << " " << z;
  }
}

TEST(WalkShot, FromAboveItIsAPlanWithoutPerspective) {
  const auto walk = makeTestWalk();
  const Camera camera = shotOf(walk->view, PointOfView::kTop).camera;
  EXPECT_TRUE(camera.parallel);
  EXPECT_LT((camera.axes.row(2).transpose() - Vector3f(0, 0, -1)).norm(), 1e-6F);
  const auto pixelOf = [&](const Vector3f& p) { return camera.toPixel(camera.toView(p)); };
  const float metre = (pixelOf({2, 2, 0}) - pixelOf({1, 2, 0})).norm();
  EXPECT_NEAR((pixelOf({1, 3, 0}) - pixelOf({1, 2, 0})).norm(), metre, 1e-3F);
  EXPECT_LT((pixelOf({1, 2, 0}) - pixelOf({1, 2, 2})).norm(), 1e-3F);
}

TEST(WalkShot, FromTheSideTheWayGoesAcrossThePicture) {
  const auto walk = makeTestWalk();
  const Camera camera = shotOf(walk->view, PointOfView::kSide).camera;
  const Vector2f from = camera.toPixel(camera.toView({1, 2, 0})),
                 to = camera.toPixel(camera.toView({5, 2, 0}));
  EXPECT_GT(std::abs(to.x() - from.x()), 0.4F * kWide);
  EXPECT_LT(std::abs(to.y() - from.y()), 0.1F * std::abs(to.x() - from.x()));
}

TEST(WalkShot, TheEyesAreWhereTheWalkerIsInTheMiddleOfHisWalkAndLookAhead) {
  const auto walk = makeTestWalk();
  for (FrameState& state : walk->animation.states) state.heading = 0.0;
  const int middle = middleFrame(walk->view);
  EXPECT_GE(middle, 30);
  EXPECT_LE(middle, 90);
  const Camera camera = shotOf(walk->view, PointOfView::kFirst).camera;
  const Vector3f root = walk->animation.poses.p_WR(middle).cast<float>();
  EXPECT_LT((camera.eye - root).head<2>().norm(), 0.4F);
  EXPECT_GT(camera.eye.z(), 1.2F);
  EXPECT_GT(camera.axes(2, 0), 0.8F);
}

TEST(WalkShot, CornersLookFromTheFourCornersOfTheRoom) {
  const auto walk = makeTestWalk();
  std::set<std::pair<bool, bool>> quarters;
  for (int corner = 0; corner < 4; ++corner) {
    const Camera camera = shotOf(walk->view, PointOfView::kCorner, corner).camera;
    quarters.emplace(camera.eye.x() > 3.0F, camera.eye.y() > 2.0F);
    EXPECT_LT(camera.axes(2, 2), 0.0F) << "it looks down";
  }
  EXPECT_EQ(quarters.size(), 4u);
}

TEST(WalkShot, AxesOfEveryCameraAreATurn) {
  const auto walk = makeTestWalk();
  for (const PointOfView from :
       {PointOfView::kTop, PointOfView::kSide, PointOfView::kCorner, PointOfView::kFirst}) {
    const Eigen::Matrix3f axes = shotOf(walk->view, from).camera.axes;
    EXPECT_LT((axes * axes.transpose() - Eigen::Matrix3f::Identity()).norm(), 1e-5F);
    EXPECT_NEAR(axes.determinant(), 1.0F, 1e-5F);
  }
}

TEST(WalkShot, ThreadsChangeNoTriangle) {
  const auto walk = makeTestWalk();
  ShotSettings settings;
  settings.frames = {0, 60};
  const WalkShot one = takeShot(walk->view, settings);
  settings.threads = 3;
  const WalkShot three = takeShot(walk->view, settings);
  ASSERT_EQ(one.triangles.size(), three.triangles.size());
  for (size_t i = 0; i < one.triangles.size(); ++i)
    for (int k = 0; k < 3; ++k) ASSERT_EQ(one.triangles[i].p[k], three.triangles[i].p[k]);
}

}  // namespace
}  // namespace amble

#include "viz/walk_view.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/viz/test_walk.h"

namespace amble {
namespace {

TEST(WalkView, WithoutAPathThereIsNoLine) { EXPECT_TRUE(pathLine(WalkView{}).empty()); }

TEST(WalkView, ThePathsLineGoesFromEndToEndInSmallSteps) {
  const auto walk = makeTestWalk();
  const auto line = pathLine(walk->view);
  EXPECT_LT((line.front() - Eigen::Vector2d(1, 2)).norm(), 1e-9);
  EXPECT_LT((line.back() - Eigen::Vector2d(5, 2)).norm(), 1e-6);
  double length = 0.0;
  for (size_t i = 1; i < line.size(); ++i) {
    const double step = (line[i] - line[i - 1]).norm();
    EXPECT_LE(step, 0.021);
    length += step;
  }
  EXPECT_NEAR(length, walk->path.length(), 1e-6);
}

TEST(WalkView, APlacedBodyKeepsTheLengthsOfItsParts) {
  const auto walk = makeTestWalk();
  for (const int frame : {0, 60, 120}) {
    const PlacedBody placed = placeBodyAt(walk->view, frame);
    for (size_t i = 0; i < walk->body.parts.size(); ++i) {
      const BodyPart& part = walk->body.parts[i];
      EXPECT_NEAR((placed.to[i] - placed.from[i]).norm(), (part.to - part.from).norm(), 1e-9);
    }
  }
}

TEST(WalkView, APlacedShoeIsTheShoeMoved) {
  Footprint print;
  print.side = kRight;
  print.heading = 0.8;
  print.position = {3, -1, 0.5};
  const auto shoe = shoeOutline(kRight, 0.27), placed = placedShoe(print, 0.27);
  ASSERT_EQ(shoe.size(), placed.size());
  for (size_t i = 0; i < shoe.size(); ++i) {
    EXPECT_NEAR((placed[i] - print.position.head<2>()).norm(), shoe[i].norm(), 1e-12);
    const double turned = std::atan2((placed[i] - print.position.head<2>()).y(),
                                     (placed[i] - print.position.head<2>()).x()) -
                          std::atan2(shoe[i].y(), shoe[i].x());
    EXPECT_NEAR(std::cos(turned - print.heading), 1.0, 1e-12);
  }
}

TEST(WalkView, ABodyIsPlacedByItsPose) {
  const auto walk = makeTestWalk();
  const PlacedBody first = placeBodyAt(walk->view, 0), later = placeBodyAt(walk->view, 60);
  for (size_t i = 0; i < first.from.size(); ++i) {  // 2 m on, in the same pose
    EXPECT_LT((later.from[i] - first.from[i] - Eigen::Vector3d(2, 0, 0)).norm(), 1e-9);
    EXPECT_LT((later.to[i] - first.to[i] - Eigen::Vector3d(2, 0, 0)).norm(), 1e-9);
  }
}

TEST(WalkView, AViewHasABodyWhenAllOfItIsThere) {
  const auto walk = makeTestWalk();
  EXPECT_TRUE(walk->view.hasBody());
  for (int missing = 0; missing < 3; ++missing) {
    WalkView view = walk->view;
    if (missing == 0) view.body = nullptr;
    if (missing == 1) view.skeleton = nullptr;
    if (missing == 2) view.animation = nullptr;
    EXPECT_FALSE(view.hasBody());
    EXPECT_NEAR(soleLength(view), 0.27, 1e-9);
  }
}

TEST(WalkView, ShoesScaleWithTheirLength) {
  const auto small = shoeOutline(kLeft, 0.2), large = shoeOutline(kLeft, 0.3);
  ASSERT_EQ(small.size(), large.size());
  for (size_t i = 0; i < small.size(); ++i) EXPECT_LT((1.5 * small[i] - large[i]).norm(), 1e-12);
}

}  // namespace
}  // namespace amble

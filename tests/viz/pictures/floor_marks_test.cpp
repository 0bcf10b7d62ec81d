#include "viz/pictures/floor_marks.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "base/rotation.h"
#include "tests/viz/test_walk.h"
#include "viz/pictures/color.h"

namespace amble {
namespace {

using Eigen::Vector3f;

std::vector<DrawTriangle> marksOf(const WalkView& view) {
  std::vector<DrawTriangle> triangles;
  addFloorMarks(view, triangles);
  return triangles;
}

// Seen from above [m^2].
float groundArea(const std::vector<DrawTriangle>& triangles) {
  float area = 0.0F;
  for (const DrawTriangle& t : triangles)
    area += 0.5F * std::abs((t.p[1] - t.p[0]).cross(t.p[2] - t.p[0]).z());
  return area;
}

std::vector<DrawTriangle> ofColor(const std::vector<DrawTriangle>& triangles, const Color& color) {
  std::vector<DrawTriangle> some;
  for (const DrawTriangle& t : triangles)
    if (t.color == color) some.push_back(t);
  return some;
}

Eigen::AlignedBox3f around(const std::vector<DrawTriangle>& triangles) {
  Eigen::AlignedBox3f box;
  for (const DrawTriangle& t : triangles)
    for (const Vector3f& p : t.p) box.extend(p);
  return box;
}

TEST(FloorMarks, FaceUpAndLieWithinACentimetreOfTheFloor) {
  const auto walk = makeTestWalk();
  walk->view.via = {PlaceView{{3, 1}, 1.0}};
  for (const DrawTriangle& t : marksOf(walk->view)) {
    EXPECT_GE((t.p[1] - t.p[0]).cross(t.p[2] - t.p[0]).z(), 0.0F);
    for (const Vector3f& p : t.p) {
      EXPECT_GT(p.z(), 0.0F);
      EXPECT_LT(p.z(), 0.01F);
    }
  }
}

TEST(FloorMarks, ThePathIsARibbonFromStartToGoal) {
  const auto walk = makeTestWalk();
  const auto path = ofColor(marksOf(walk->view), kPathColor);
  EXPECT_NEAR(groundArea(path), 4.0F * 0.022F, 1e-3F);
  const Eigen::AlignedBox3f box = around(path);
  EXPECT_NEAR(box.min().x(), 1.0F, 0.02F);
  EXPECT_NEAR(box.max().x(), 5.0F, 0.02F);
}

TEST(FloorMarks, StartAndGoalAreDiscsWithAWedgeWhereAHeadingIsGiven) {
  const auto walk = makeTestWalk();
  for (const double heading : {0.0, 1.3, -2.4}) {
    walk->view.start->heading = heading;
    const auto start = ofColor(marksOf(walk->view), kStartColor);
    const auto goal = ofColor(marksOf(walk->view), kGoalColor);
    EXPECT_GT(groundArea(start), groundArea(goal));  // the goal has no heading
    EXPECT_LT((around(goal).center().head<2>() - Eigen::Vector2f(5, 2)).norm(), 1e-3F);
    Vector3f farthest = Vector3f::Zero();
    for (const DrawTriangle& t : start)
      for (const Vector3f& p : t.p)
        if ((p - Vector3f(1, 2, p.z())).norm() > farthest.norm())
          farthest = p - Vector3f(1, 2, p.z());
    EXPECT_NEAR(std::remainder(std::atan2(farthest.y(), farthest.x()) - heading, 2.0 * kPi), 0.0,
                1e-4);
  }
}

TEST(FloorMarks, EveryPrintIsAShoeInTheColourOfItsSide) {
  const auto walk = makeTestWalk();
  const auto marks = marksOf(walk->view);
  for (const Side side : {kLeft, kRight}) {
    const auto prints = ofColor(marks, sideColor(side));
    EXPECT_NEAR(around(prints).center().y(), side == kLeft ? 2.1F : 1.9F, 0.02F);
  }
  walk->animation.footprints.resize(4);
  const auto half = marksOf(walk->view);
  EXPECT_NEAR(groundArea(ofColor(half, sideColor(kLeft))),
              groundArea(ofColor(marks, sideColor(kLeft))) / 2.0F, 1e-5F);
}

// A walk that climbs has its marks on the ground under it.
TEST(FloorMarks, GoUpWithTheWalk) {
  const auto walk = makeTestWalk();
  const auto height = [](double x) { return 0.1 * (x - 1.0); };
  for (int i = 0; i <= 120; ++i) {
    const double x = 1 + 4.0 * i / 120;
    walk->animation.states[i].position = {x, 2, height(x)};
  }
  for (Footprint& print : walk->animation.footprints)
    print.position.z() = height(print.position.x());
  const auto marks = marksOf(walk->view);
  for (const DrawTriangle& t : ofColor(marks, kPathColor))
    for (const Vector3f& p : t.p) EXPECT_NEAR(p.z(), height(p.x()), 0.012);
  EXPECT_NEAR(around(ofColor(marks, kGoalColor)).min().z(), 0.4F, 0.01F);
  EXPECT_NEAR(around(ofColor(marks, kStartColor)).max().z(), 0.0F, 0.01F);
}

TEST(FloorMarks, WithoutAWalkTheGroundThatIsReachedIsVeiledAndWhatStopsItPinned) {
  const auto walk = makeTestWalk();
  WalkView& view = walk->view;
  view.animation = nullptr;
  view.path = nullptr;
  ReachedRegion reached;
  reached.breadth = 0.1;
  reached.strips = {{{1, 1, 0}, {3, 1, 0}}, {{1, 1.1, 0}, {2, 1.1, 0}}};
  reached.near = {3, 1, 0};
  reached.far = {4, 1, 0};
  Obstruction why;
  why.at = {3.5, 1, 0.8};
  why.body = {3.4, 1, 0.0};
  view.reached = &reached;
  view.obstruction = &why;
  const auto marks = marksOf(view);
  // Strips end half their breadth beyond the middles of their ends.
  EXPECT_NEAR(groundArea(ofColor(marks, kReachedColor)), 0.1F * (2.1F + 1.1F), 1e-4F);
  const Eigen::AlignedBox3f pin = around(ofColor(marks, kStopColor));
  EXPECT_NEAR(pin.max().z(), 0.8F + 0.11F, 1e-3F);
  EXPECT_NEAR(pin.max().x(), 4.0F, 0.02F);  // the line that is missing
  EXPECT_TRUE(ofColor(marks, kPathColor).empty());
}

TEST(FloorMarks, OfNothingAreNone) { EXPECT_TRUE(marksOf(WalkView{}).empty()); }

}  // namespace
}  // namespace amble

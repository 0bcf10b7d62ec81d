#include "viz/outline.h"

#include <gtest/gtest.h>

#include <cmath>

namespace amble {
namespace {

constexpr double kPi = 3.14159265358979323846;

TriangleMesh moved(TriangleMesh mesh, const Eigen::Vector3d& by) {
  for (auto& p : mesh.vertices) p += by;
  return mesh;
}

TriangleMesh joined(TriangleMesh a, const TriangleMesh& b) {
  const int base = static_cast<int>(a.vertices.size());
  a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
  for (const auto& t : b.triangles) a.triangles.push_back({t[0] + base, t[1] + base, t[2] + base});
  return a;
}

TEST(Outline, OfNothingIsNothing) {
  EXPECT_TRUE(traceOutlines({}, {}).empty());
  EXPECT_TRUE(traceConvexOutline({}, {}).empty());
  EXPECT_TRUE(
      traceOutlines(moved(makeBox({1, 1, 0.1}), {0, 0, 2.5}), {}).empty());  // above what is seen
}

TEST(Outline, OfAWallThatIsCutIsFilled) {
  // A wall from the floor to 2.5 m has neither top nor bottom within the cut.
  const auto outlines = traceOutlines(moved(makeBox({3, 0.4, 2.5}), {1, 1, 1.25}), {});
  ASSERT_EQ(outlines.size(), 1u);
  EXPECT_NEAR(coveredArea(outlines), 1.2, 0.04);
}

TEST(Outline, OfADiscHasItsArea) {
  for (const double radius : {0.2, 0.5, 1.3}) {
    const auto outlines = traceOutlines(moved(makeCylinder(radius, 1, 96), {0.3, -0.7, 0.6}), {});
    ASSERT_EQ(outlines.size(), 1u);
    EXPECT_NEAR(coveredArea(outlines), kPi * radius * radius, 2 * kPi * radius * 0.01) << radius;
  }
}

TEST(Outline, OfATableIsItsTopAboveAndItsLegsBelow) {
  TriangleMesh table = moved(makeBox({1, 0.6, 0.04}), {0, 0, 0.72});
  for (const double x : {-0.45, 0.45})
    for (const double y : {-0.25, 0.25})
      table = joined(table, moved(makeBox({0.06, 0.06, 0.69}), {x, y, 0.345}));
  EXPECT_EQ(traceOutlines(table, {0.05, 0.6, 0.005}).size(), 4u);
  EXPECT_NEAR(coveredArea(traceOutlines(table, {0.05, 0.6, 0.005})), 4 * 0.06 * 0.06, 0.006);
  EXPECT_NEAR(coveredArea(traceOutlines(table, {0.05, 1.8, 0.005})), 0.6, 0.02);
}

TEST(Outline, OfARoundOfWallsHasAHole) {
  TriangleMesh walls = moved(makeBox({2, 0.2, 2}), {0, 0.9, 1});
  walls = joined(walls, moved(makeBox({2, 0.2, 2}), {0, -0.9, 1}));
  walls = joined(walls, moved(makeBox({0.2, 1.7, 2}), {0.9, 0, 1}));
  walls = joined(walls, moved(makeBox({0.2, 1.7, 2}), {-0.9, 0, 1}));
  const auto outlines = traceOutlines(walls, {});
  ASSERT_EQ(outlines.size(), 2u);
  EXPECT_NEAR(coveredArea(outlines), 4 - 1.6 * 1.6, 0.12);
}

TEST(Outline, OfAnOpenSheetIsTheSheet) {
  TriangleMesh sheet;
  sheet.vertices = {{0, 0, 0.5}, {1, 0, 0.5}, {1, 1, 0.5}, {0, 1, 0.5}};
  sheet.triangles = {{0, 1, 2}, {0, 2, 3}};
  EXPECT_NEAR(coveredArea(traceOutlines(sheet, {})), 1, 0.05);
}

TEST(Outline, OfAConvexShapeIsExact) {
  const auto outlines = traceConvexOutline(moved(makeBox({3, 0.4, 2.5}), {1, 1, 1.25}), {});
  ASSERT_EQ(outlines.size(), 1u);
  EXPECT_EQ(outlines[0].size(), 4u);
  EXPECT_NEAR(coveredArea(outlines), 1.2, 1e-9);
}

TEST(Outline, OfASphereIsCutAtTheHeightsThatAreSeen) {
  // Of a ball of 1 m around z = 0 only what is above 0.6 m is seen: a disc of 0.8 m.
  const auto outlines = traceConvexOutline(makeSphere(1, 256), {0.6, 1.8, 0.01});
  EXPECT_NEAR(coveredArea(outlines), kPi * 0.64, 0.01);
}

}  // namespace
}  // namespace amble

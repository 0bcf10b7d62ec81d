#include "viz/pictures/draw_mesh.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/rotation.h"
#include "tests/viz/test_walk.h"

namespace amble {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3f;

double areaOf(const std::vector<DrawTriangle>& triangles) {
  double area = 0.0;
  for (const DrawTriangle& t : triangles)
    area += 0.5 * static_cast<double>((t.p[1] - t.p[0]).cross(t.p[2] - t.p[0]).norm());
  return area;
}

Vector3f faceOf(const DrawTriangle& t) {
  return (t.p[1] - t.p[0]).cross(t.p[2] - t.p[0]).normalized();
}

TEST(CornerNormals, OfABoxAreThoseOfItsFaces) {
  std::vector<DrawTriangle> triangles;
  addMesh(makeBox({1, 2, 3}), rgb(1, 2, 3), 0, triangles);
  ASSERT_EQ(triangles.size(), 12u);
  for (const DrawTriangle& t : triangles)
    for (const Vector3f& normal : t.normal) EXPECT_LT((normal - faceOf(t)).norm(), 1e-5f);
  EXPECT_NEAR(areaOf(triangles), 2 * (2 + 3 + 6), 1e-5);
}

TEST(CornerNormals, OfASphereAreItsRadii) {
  const TriangleMesh sphere = makeSphere(2.0, 64);
  const std::vector<Vector3f> normals = cornerNormals(sphere, 0.7);
  ASSERT_EQ(normals.size(), 3 * sphere.triangles.size());
  for (size_t t = 0; t < sphere.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      const Vector3f radius = sphere.vertices[sphere.triangles[t][k]].normalized().cast<float>();
      EXPECT_GT(normals[3 * t + k].dot(radius), std::cos(4.0 * kDegree));
    }
}

TEST(AddBody, EveryPointLiesOnItsCapsule) {
  const auto walk = makeTestWalk();
  const PlacedBody placed = placeBodyAt(walk->view, 30);
  const size_t parts = walk->body.parts.size();
  std::vector<Color> colors;
  for (size_t i = 0; i < parts; ++i) colors.push_back(rgb(static_cast<int>(i), 0, 0));
  std::vector<DrawTriangle> triangles;
  addBody(walk->view, 30, colors, triangles);
  std::vector<int> drawn(parts, 0);
  for (const DrawTriangle& t : triangles) {
    const size_t part = static_cast<size_t>(std::lround(t.color.x() * 255.0f));
    ++drawn[part];
    const Eigen::Vector3d axis = placed.to[part] - placed.from[part];
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d p = t.p[k].cast<double>();
      const double along =
          std::clamp((p - placed.from[part]).dot(axis) / axis.squaredNorm(), 0.0, 1.0);
      const double off = (p - placed.from[part] - along * axis).norm();
      EXPECT_NEAR(off, walk->body.parts[part].radius, 1e-5);
      EXPECT_NEAR(t.normal[k].norm(), 1.0f, 1e-5f);
    }
  }
  for (const int count : drawn) EXPECT_GT(count, 100);
}

TEST(AddPolygon, CoversItsOutlineAtItsHeight) {
  std::vector<DrawTriangle> triangles;
  const std::vector<Vector2d> outline = {{0, 0}, {2, 0}, {3, 1}, {1, 2}, {-1, 1}};
  addPolygon(outline, 0.4, rgb(9, 9, 9), triangles);
  double area = 0.0;
  for (size_t i = 0; i < outline.size(); ++i) {
    const Vector2d &a = outline[i], &b = outline[(i + 1) % outline.size()];
    area += 0.5 * (a.x() * b.y() - a.y() * b.x());
  }
  EXPECT_NEAR(areaOf(triangles), area, 1e-5);
  for (const DrawTriangle& t : triangles) {
    EXPECT_GT(faceOf(t).z(), 0.999f);
    for (const Vector3f& p : t.p) EXPECT_FLOAT_EQ(p.z(), 0.4f);
  }
}

TEST(AddRibbon, IsAsWideAsItIsSaidToBe) {
  std::vector<DrawTriangle> triangles;
  std::vector<Vector2d> line;
  for (int i = 0; i <= 200; ++i)
    line.push_back({std::cos(kPi * i / 200), std::sin(kPi * i / 200)});  // half a circle
  addRibbon(line, 0.05, 0.0, rgb(9, 9, 9), triangles);
  EXPECT_NEAR(areaOf(triangles), 0.05 * kPi, 0.002);
  for (const DrawTriangle& t : triangles)
    for (const Vector3f& p : t.p) EXPECT_NEAR(p.head<2>().norm(), 1.0f, 0.027f);
}

TEST(AddRibbon, OfNothingIsNothing) {
  std::vector<DrawTriangle> triangles;
  addRibbon({}, 0.05, 0.0, rgb(9, 9, 9), triangles);
  EXPECT_TRUE(triangles.empty());
}

TEST(CornerNormals, EdgesFlatterThanTheCreaseAreSmoothAndOthersSharp) {
  // A roof of two slopes: 0.5 rad between their normals.
  const double h = std::tan(0.25);
  const TriangleMesh roof{{{-1, 0, 0}, {0, 0, h}, {0, 1, h}, {-1, 1, 0}, {1, 0, 0}, {1, 1, 0}},
                          {{0, 1, 2}, {0, 2, 3}, {1, 4, 5}, {1, 5, 2}}};
  const auto smooth = cornerNormals(roof, 0.6), sharp = cornerNormals(roof, 0.4);
  // The ridge's corners: 1 of triangles 0, 2, 3 and 2 of triangles 0, 1, 3.
  EXPECT_NEAR(smooth[1].x(), smooth[6].x(), 0.2f);
  EXPECT_GT(sharp[6].x() - sharp[1].x(), 0.45f);
  for (const auto& normals : {smooth, sharp})
    for (const Vector3f& normal : normals) EXPECT_NEAR(normal.norm(), 1.0f, 1e-5f);
}

TEST(AddMesh, KeepsEveryTriangleItsColourAndItsFlags) {
  std::vector<DrawTriangle> triangles;
  const TriangleMesh ball = makeSphere(1.0, 20);
  addMesh(ball, rgb(7, 8, 9), kTwoSided | kNoShadow, triangles);
  ASSERT_EQ(triangles.size(), ball.triangles.size());
  for (size_t i = 0; i < triangles.size(); ++i) {
    EXPECT_EQ(triangles[i].color, rgb(7, 8, 9));
    EXPECT_EQ(triangles[i].flags, kTwoSided | kNoShadow);
    for (int k = 0; k < 3; ++k)
      EXPECT_EQ(triangles[i].p[k], ball.vertices[ball.triangles[i][k]].cast<float>());
  }
}

}  // namespace
}  // namespace amble

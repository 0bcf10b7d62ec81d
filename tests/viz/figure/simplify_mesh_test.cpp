#include "viz/figure/simplify_mesh.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "tests/environments/test_meshes.h"
#include "tests/viz/figure/lofts.h"
#include "viz/figure/loft_surface.h"

namespace amble {
namespace {

using Eigen::Vector3d;

// Bars that run into one another, closed.
TriangleMesh branches() {
  static const TriangleMesh kMesh = [] {
    Generator random(30);
    std::vector<LoftGroup> groups(1);
    for (int i = 0; i < 4; ++i) {
      groups[0].lofts.push_back(loftIn(random));
      groups[0].lofts.back().a.at = {0, 0, 0};
    }
    return loftSurface(groups, 0.012);
  }();
  return kMesh;
}

// How far the corners of one are from the other's corners or faces, at most.
double farthest(const TriangleMesh& from, const TriangleMesh& to) {
  double most = 0.0;
  for (size_t i = 0; i < from.vertices.size(); i += 7) {
    const Vector3d& p = from.vertices[i];
    double least = 1e9;
    for (const auto& t : to.triangles) {
      const Vector3d &a = to.vertices[t[0]], &b = to.vertices[t[1]], &c = to.vertices[t[2]];
      for (int u = 0; u <= 4; ++u)
        for (int v = 0; u + v <= 4; ++v)
          least = std::min(least, (p - (a + u / 4.0 * (b - a) + v / 4.0 * (c - a))).norm());
    }
    most = std::max(most, least);
  }
  return most;
}

TEST(SimplifyMesh, HasNoMoreTrianglesThanAskedAndIsClosedStill) {
  for (const int triangles : {2000, 500, 120}) {
    const TriangleMesh few = simplifyMesh(branches(), triangles);
    EXPECT_LE(static_cast<int>(few.triangles.size()), triangles);
    EXPECT_GE(static_cast<int>(few.triangles.size()), triangles - 2);  // no more than needed
    EXPECT_TRUE(isWatertight(few));
  }
}

TEST(SimplifyMesh, KeepsTheNumberOfPiecesAndHandles) {
  const TriangleMesh two = joined(branches(), moved(branches(), {2, 0, 0}));
  const int before = eulerNumber(two);
  for (const int triangles : {1500, 400, 60})
    EXPECT_EQ(eulerNumber(simplifyMesh(two, triangles)), before);
}

TEST(SimplifyMesh, KeepsTheShapeTheBetterTheMoreIsLeft) {
  const double volume = volumeOf(branches());
  const TriangleMesh many = simplifyMesh(branches(), 1200), few = simplifyMesh(branches(), 200);
  EXPECT_NEAR(volumeOf(many) / volume, 1.0, 0.01);
  EXPECT_NEAR(volumeOf(few) / volume, 1.0, 0.08);
  EXPECT_LT(farthest(branches(), many), 0.02);
  EXPECT_LT(farthest(branches(), many), farthest(branches(), few));
}

// What is flat costs nothing: the eight corners stay.
TEST(SimplifyMesh, ABoxOfManyTrianglesIsTheBox) {
  constexpr int kSide = 6;
  TriangleMesh fine;
  const auto add = [&](const Vector3d& corner, const Vector3d& u, const Vector3d& v) {
    for (int i = 0; i < kSide; ++i)
      for (int k = 0; k < kSide; ++k) {
        const auto first = static_cast<int>(fine.vertices.size());
        for (const auto& [a, b] : {std::pair(i, k), {i + 1, k}, {i + 1, k + 1}, {i, k + 1}})
          fine.vertices.push_back(corner + a * u / kSide + b * v / kSide);
        fine.triangles.push_back({first, first + 1, first + 2});
        fine.triangles.push_back({first, first + 2, first + 3});
      }
  };
  const Vector3d x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  add({0, 0, 0}, y, x);
  add({0, 0, 1}, x, y);
  add({0, 0, 0}, x, z);
  add({0, 1, 0}, z, x);
  add({0, 0, 0}, z, y);
  add({1, 0, 0}, y, z);
  fine = cleanMesh(fine);
  ASSERT_TRUE(isWatertight(fine));
  const TriangleMesh box = simplifyMesh(fine, 12);
  EXPECT_EQ(box.triangles.size(), 12u);
  EXPECT_NEAR(volumeOf(box), 1.0, 1e-3);
  EXPECT_LT(boundsOf(box).min().norm(), 1e-3);
  EXPECT_LT((boundsOf(box).max() - Vector3d::Ones()).norm(), 1e-3);
}

TEST(SimplifyMesh, NoTriangleIsTurnedOver) {
  const TriangleMesh sphere = cleanMesh(makeSphere(0.5, 32));
  for (const int triangles : {800, 200, 60}) {
    const TriangleMesh few = simplifyMesh(sphere, triangles);
    for (const auto& t : few.triangles) {
      const Vector3d &a = few.vertices[t[0]], &b = few.vertices[t[1]], &c = few.vertices[t[2]];
      EXPECT_GT((b - a).cross(c - a).dot(a + b + c), 0.0);
    }
  }
}

TEST(SimplifyMesh, ATetrahedronIsNotTakenApart) {
  TriangleMesh tetrahedron;
  tetrahedron.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  tetrahedron.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  EXPECT_EQ(simplifyMesh(tetrahedron, 1).triangles.size(), 4u);
}

TEST(SimplifyMesh, WhatHasFewTrianglesStaysAsItIs) {
  const TriangleMesh box = cleanMesh(makeBox({1, 2, 3}));
  const TriangleMesh same = simplifyMesh(box, 100);
  EXPECT_EQ(same.triangles.size(), box.triangles.size());
  EXPECT_NEAR(volumeOf(same), 6.0, 1e-12);
}

TEST(SimplifyMesh, TheSameMeshGivesTheSameBytes) {
  const TriangleMesh a = simplifyMesh(branches(), 300), b = simplifyMesh(branches(), 300);
  EXPECT_EQ(a.vertices, b.vertices);
  EXPECT_EQ(a.triangles, b.triangles);
}

}  // namespace
}  // namespace amble

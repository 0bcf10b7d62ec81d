#include "environments/scene/mesh.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "base/rotation.h"

namespace amble {
namespace {

Eigen::AlignedBox3d boundsOf(const TriangleMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& v : mesh.vertices) box.extend(v);
  return box;
}

double volumeOf(const TriangleMesh& mesh) {
  double volume = 0.0;
  for (const auto& t : mesh.triangles)
    volume += mesh.vertices[t[0]].dot(mesh.vertices[t[1]].cross(mesh.vertices[t[2]])) / 6.0;
  return volume;
}

void expectBounds(const TriangleMesh& mesh, const Eigen::Vector3d& min,
                  const Eigen::Vector3d& max) {
  EXPECT_LT((boundsOf(mesh).min() - min).norm(), 1e-6) << boundsOf(mesh).min().transpose();
  EXPECT_LT((boundsOf(mesh).max() - max).norm(), 1e-6) << boundsOf(mesh).max().transpose();
}

TEST(Primitives, AreClosedAndOfTheirVolume) {
  const std::vector<std::pair<TriangleMesh, double>> shapes = {
      {makeBox({1, 2, 3}), 6.0},
      {makeCylinder(0.5, 2.0, 96), kPi * 0.25 * 2.0},
      {makeSphere(0.5, 96), kPi / 6.0},
      {makeCapsule(0.5, 2.0, 96), kPi / 6.0 + kPi * 0.25}};
  for (const auto& [mesh, volume] : shapes) {
    const auto pieces = splitComponents(mesh);
    ASSERT_EQ(pieces.size(), 1u);
    EXPECT_TRUE(pieces[0].closed);
    EXPECT_NEAR(volumeOf(mesh), volume, 0.004 * volume);
    EXPECT_LE(volumeOf(mesh), volume + 1e-12);
  }
}

TEST(Primitives, AreCentredWithTheirWholeHeight) {
  expectBounds(makeCapsule(0.25, 1.0), {-0.25, -0.25, -0.5}, {0.25, 0.25, 0.5});
  expectBounds(makeCylinder(0.25, 1.0), {-0.25, -0.25, -0.5}, {0.25, 0.25, 0.5});
  expectBounds(makeBox({1, 2, 3}), {-0.5, -1, -1.5}, {0.5, 1, 1.5});
}

TEST(SplitComponents, PartsThatShareNoEdgeAreApart) {
  TriangleMesh mesh = makeBox({1, 1, 1});
  const TriangleMesh other = makeBox({1, 1, 1});
  const int base = static_cast<int>(mesh.vertices.size());
  for (const Eigen::Vector3d& v : other.vertices)
    mesh.vertices.push_back(v + Eigen::Vector3d(3, 0, 0));
  for (const auto& t : other.triangles)
    mesh.triangles.push_back({t[0] + base, t[1] + base, t[2] + base});
  mesh.triangles.pop_back();
  const auto pieces = splitComponents(mesh);
  ASSERT_EQ(pieces.size(), 2u);
  EXPECT_TRUE(pieces[0].closed);
  EXPECT_FALSE(pieces[1].closed);
  EXPECT_EQ(pieces[1].mesh.triangles.size(), 11u);
}

TEST(SplitComponents, VerticesOfTheSamePlaceCloseAMesh) {
  TriangleMesh soup;
  const TriangleMesh box = makeBox({1, 1, 1});
  for (const auto& t : box.triangles) {
    const int base = static_cast<int>(soup.vertices.size());
    for (int v : t) soup.vertices.push_back(box.vertices[v]);
    soup.triangles.push_back({base, base + 1, base + 2});
  }
  const auto pieces = splitComponents(soup);
  ASSERT_EQ(pieces.size(), 1u);
  EXPECT_TRUE(pieces[0].closed);
}

TEST(SplitComponents, OfNothingIsNothing) { EXPECT_TRUE(splitComponents({}).empty()); }

}  // namespace
}  // namespace amble

#include "environments/scene/mesh.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <random>

#include "base/rotation.h"
#include "tests/environments/test_meshes.h"

namespace amble {
namespace {

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
  TriangleMesh mesh = joined(makeBox({1, 1, 1}), moved(makeBox({1, 1, 1}), {3, 0, 0}));
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

/// Triangles each with corners of its own, in any order.
TriangleMesh soupOf(const TriangleMesh& mesh, std::mt19937_64& generator) {
  TriangleMesh soup;
  auto triangles = mesh.triangles;
  std::shuffle(triangles.begin(), triangles.end(), generator);
  for (const auto& t : triangles) {
    const int base = static_cast<int>(soup.vertices.size());
    for (const int v : t) soup.vertices.push_back(mesh.vertices[v]);
    soup.triangles.push_back({base, base + 1, base + 2});
  }
  return soup;
}

TEST(SplitComponents, OfShuffledSoupAreTheSolidsThatItWasMadeOf) {
  std::mt19937_64 generator(51);
  const std::vector<TriangleMesh> solids = {makeBox({1, 2, 3}), makeSphere(0.7),
                                            makeCylinder(0.3, 1.1), makeCapsule(0.2, 0.9)};
  TriangleMesh all;
  double volume = 0.0;
  for (size_t i = 0; i < solids.size(); ++i) {
    all = joined(all, moved(solids[i], {5.0 * static_cast<double>(i), 0, 0}));
    volume += volumeOf(solids[i]);
  }
  const auto pieces = splitComponents(soupOf(all, generator));
  ASSERT_EQ(pieces.size(), solids.size());
  double sum = 0.0;
  for (const MeshComponent& piece : pieces) {
    EXPECT_TRUE(piece.closed);
    sum += volumeOf(piece.mesh);
    const size_t solid = static_cast<size_t>(boundsOf(piece.mesh).center().x() / 5.0 + 0.5);
    EXPECT_EQ(piece.mesh.triangles.size(), solids[solid].triangles.size());
    EXPECT_EQ(piece.mesh.vertices.size(), solids[solid].vertices.size());
  }
  EXPECT_NEAR(sum, volume, 1e-12);
}

TEST(SplitComponents, ComeInTheOrderOfTheMesh) {
  TriangleMesh all;
  for (int i = 0; i < 6; ++i) all = joined(all, moved(makeBox({1, 1, 1}), {0, 3.0 * (5 - i), 0}));
  const auto pieces = splitComponents(all);
  ASSERT_EQ(pieces.size(), 6u);
  for (int i = 0; i < 6; ++i)
    EXPECT_NEAR(boundsOf(pieces[i].mesh).center().y(), 3.0 * (5 - i), 1e-12);
}

// Two cubes that share an edge: four triangles meet in it, and both are closed.
TEST(SplitComponents, SolidsThatMeetInAnEdgeAreClosed) {
  const auto pieces =
      splitComponents(joined(makeBox({1, 1, 1}), moved(makeBox({1, 1, 1}), {1, 1, 0})));
  for (const MeshComponent& piece : pieces) EXPECT_TRUE(piece.closed);
}

TEST(CleanMesh, JoinsSoupAndIsDoneAtOnce) {
  std::mt19937_64 generator(52);
  const TriangleMesh ball = makeSphere(1.0, 32);
  const TriangleMesh once = cleanMesh(soupOf(ball, generator)), again = cleanMesh(once);
  EXPECT_EQ(once.vertices.size(), ball.vertices.size());
  EXPECT_EQ(once.triangles.size(), ball.triangles.size());
  EXPECT_EQ(once.triangles, again.triangles);
  EXPECT_EQ(once.vertices, again.vertices);
  EXPECT_NEAR(volumeOf(once), volumeOf(ball), 1e-12);
}

TEST(CleanMesh, ZerosOfEitherSignAreOnePlace) {
  const TriangleMesh mesh{{{0.0, 0.0, 0.0}, {1, 0, 0}, {0, 1, 0}, {-0.0, 0.0, -0.0}, {0, 0, 1}},
                          {{0, 1, 2}, {3, 4, 1}}};
  const TriangleMesh clean = cleanMesh(mesh);
  EXPECT_EQ(clean.vertices.size(), 4u);
  EXPECT_EQ(clean.triangles[0][0], clean.triangles[1][0]);
}

TEST(CleanMesh, DropsWhatHasNoAreaWhereverItIs) {
  TriangleMesh mesh = makeBox({1, 1, 1});
  const size_t before = mesh.triangles.size();
  for (const double scale : {1e-3, 1.0, 1e3}) {
    const int base = static_cast<int>(mesh.vertices.size());
    for (const double t : {0.0, 0.3, 1.0})
      mesh.vertices.push_back(scale * Eigen::Vector3d(t, t, 0));
    mesh.triangles.push_back({base, base + 1, base + 2});
    mesh.triangles.push_back({base, base, base + 2});
  }
  EXPECT_EQ(cleanMesh(mesh).triangles.size(), before);
  EXPECT_EQ(cleanMesh(mesh).vertices.size(), 8u);
}

}  // namespace
}  // namespace amble

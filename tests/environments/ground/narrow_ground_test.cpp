#include "environments/ground/narrow_ground.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/sample_stream.h"
#include "tests/environments/test_scenes.h"

namespace amble {
namespace {

constexpr double kCell = 0.1;  // [m]
const Eigen::Vector2d kMin(-3, -3);
const Eigen::Vector2i kCount(60, 60);

NarrowGround narrowOf(const TriangleMesh& mesh, Role role) {
  const Scene scene = sceneOf({makeObject("it", mesh, {0, 0, 0}, role)});
  const ScenePieces pieces = splitScene(scene);
  return NarrowGround(scene, pieces, std::vector<bool>(pieces.triangles().size(), true), kMin,
                      kCell, kCount);
}

size_t squaresOf(const NarrowGround& narrow) {
  size_t squares = 0;
  for (int row = 0; row < kCount.y(); ++row)
    for (int column = 0; column < kCount.x(); ++column)
      squares += !narrow.over(column, row).empty();
  return squares;
}

TriangleMesh randomTriangle(SampleStream& stream, double breadth) {
  const Eigen::Vector3d a(stream.uniform(-2, 2), stream.uniform(-2, 2), stream.uniform(0, 1));
  const Eigen::Vector3d b = a + Eigen::Vector3d(stream.uniform(-0.9, 0.9), 0.8, 0.02);
  return {{a, b, a + Eigen::Vector3d(breadth, 0, 0.01)}, {{0, 1, 2}}};
}

TEST(NarrowGround, IsOverAllSquaresThatANarrowTriangleReachesAndAtItsHeight) {
  SampleStream stream(31, 0);
  int narrow_ones = 0;
  for (int i = 0; i < 60; ++i) {
    const TriangleMesh mesh = randomTriangle(stream, stream.uniform(0.002, 0.1));
    const Triangle3 t = {mesh.vertices[0], mesh.vertices[1], mesh.vertices[2]};
    const NarrowGround narrow = narrowOf(mesh, Role::kGround);
    EXPECT_EQ(squaresOf(narrowOf(mesh, Role::kAuto)), 0u);
    bool has_middle = false;
    for (int k = 0; k < kCount.prod(); ++k) {
      const Eigen::Vector2d p =
          kMin + kCell * Eigen::Vector2d(k % kCount.x() + 0.5, k / kCount.x() + 0.5);
      has_middle = has_middle || heightOver(t, p.x(), p.y());
    }
    narrow_ones += !has_middle;
    if (has_middle) {
      EXPECT_EQ(squaresOf(narrow), 0u) << "the squares know of it";
      continue;
    }
    for (int k = 0; k < 200; ++k) {
      const double u = stream.uniform(0, 1), v = stream.uniform(0, 1 - u);
      const Eigen::Vector3d p = t[0] + u * (t[1] - t[0]) + v * (t[2] - t[0]);
      const Eigen::Array2i at = ((p.head<2>() - kMin) / kCell).array().floor().cast<int>();
      const auto heights = narrow.over(at.x(), at.y());
      EXPECT_TRUE(
          std::ranges::any_of(heights, [&](double z) { return std::abs(z - p.z()) < kCell; }));
    }
  }
  EXPECT_GT(narrow_ones, 10);
  EXPECT_LT(narrow_ones, 60);
}

TEST(NarrowGround, BesideTheSquaresIsNone) {
  SampleStream stream(32, 0);
  const NarrowGround narrow = narrowOf(randomTriangle(stream, 0.01), Role::kGround);
  EXPECT_TRUE(narrow.over(-1, 5).empty());
  EXPECT_TRUE(narrow.over(5, kCount.y()).empty());
}

}  // namespace
}  // namespace amble

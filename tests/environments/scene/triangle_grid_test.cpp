#include "environments/scene/triangle_grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

namespace amble {
namespace {

TEST(TriangleGrid, OfNothingHasNothing) {
  const TriangleGrid grid{std::vector<Triangle3>{}};
  grid.visitAt(0, 0, [](int) { FAIL(); });
  grid.visitBox({Eigen::Vector2d(-1, -1), Eigen::Vector2d(1, 1)}, [](int) { FAIL(); });
}

TEST(HeightOver, IsThePlanesWithinTheTriangle) {
  const Triangle3 t = {Eigen::Vector3d(0, 0, 1), Eigen::Vector3d(2, 0, 3),
                       Eigen::Vector3d(0, 2, 1)};
  EXPECT_NEAR(heightOver(t, 0.5, 0.5).value(), 1.5, 1e-12);
  EXPECT_NEAR(heightOver(t, 0, 0).value(), 1.0, 1e-12);
  EXPECT_FALSE(heightOver(t, 1.1, 1.1).has_value());
  EXPECT_FALSE(heightOver(t, -0.001, 0.5).has_value());
  EXPECT_TRUE(heightOver(t, -0.5 * kSeam, 0.5).has_value());
}

TEST(HeightOver, OfAnUprightTriangleIsNone) {
  const Triangle3 t = {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 0, 0),
                       Eigen::Vector3d(0, 0, 1)};
  EXPECT_FALSE(heightOver(t, 0.2, 0.0).has_value());
}

TEST(IsBeside, WhereTheBoundsInThePlaneAreApart) {
  std::mt19937_64 generator(5);
  std::uniform_int_distribution<int> place(-6, 6);  // often on the box's sides
  const Eigen::AlignedBox2d box(Eigen::Vector2d(-1, -1), Eigen::Vector2d(1, 2));
  int beside = 0, over = 0;
  for (int n = 0; n < 2000; ++n) {
    Triangle3 t;
    Eigen::AlignedBox2d bounds;
    for (Eigen::Vector3d& corner : t) {
      corner = Eigen::Vector3d(place(generator), place(generator), place(generator));
      bounds.extend(Eigen::Vector2d(corner.head<2>()));
    }
    EXPECT_EQ(isBeside(t, box), !bounds.intersects(box));
    ++(isBeside(t, box) ? beside : over);
    EXPECT_FALSE(isBeside(t, box) && heightsWithin(t, box).has_value());
  }
  EXPECT_GT(std::min(beside, over), 200);
}

TEST(HeightsWithin, AreThoseOfThePartInTheBox) {
  const Triangle3 t = {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(4, 0, 4),
                       Eigen::Vector3d(0, 4, 0)};
  const auto range = heightsWithin(t, {Eigen::Vector2d(1, 1), Eigen::Vector2d(2, 2)});
  ASSERT_TRUE(range.has_value());
  EXPECT_NEAR(range->low, 1.0, 1e-12);
  EXPECT_NEAR(range->high, 2.0, 1e-12);
  EXPECT_FALSE(heightsWithin(t, {Eigen::Vector2d(3, 3), Eigen::Vector2d(4, 4)}).has_value());
}

// Slivers, large ones and small ones, at random.
std::vector<Triangle3> manyTriangles(int count) {
  std::mt19937_64 generator(8);
  const auto number = [&](double a, double b) {
    return std::uniform_real_distribution<double>(a, b)(generator);
  };
  std::vector<Triangle3> triangles;
  for (int i = 0; i < count; ++i) {
    const double size = std::pow(10.0, number(-2, 1));
    Triangle3 t;
    const Eigen::Vector3d at(number(-5, 5), number(-5, 5), number(0, 3));
    for (Eigen::Vector3d& corner : t)
      corner = at + size * Eigen::Vector3d(number(-1, 1), number(-0.1, 0.1), number(-0.1, 0.1));
    triangles.push_back(t);
  }
  return triangles;
}

TEST(TriangleGrid, FindsEveryTriangleOverAPoint) {
  const TriangleGrid grid(manyTriangles(300));
  std::mt19937_64 generator(9);
  std::uniform_real_distribution<double> place(-6, 6);
  for (int n = 0; n < 2000; ++n) {
    const double x = place(generator), y = place(generator);
    std::set<int> found, all;
    grid.visitAt(x, y, [&](int t) {
      if (heightOver(grid.triangles()[t], x, y)) found.insert(t);
    });
    for (int t = 0; t < 300; ++t)
      if (heightOver(grid.triangles()[t], x, y)) all.insert(t);
    EXPECT_EQ(found, all) << x << " " << y;
  }
}

TEST(TriangleGrid, FindsEveryTriangleOverABox) {
  const TriangleGrid grid(manyTriangles(300));
  std::mt19937_64 generator(10);
  std::uniform_real_distribution<double> place(-6, 6), size(0, 1);
  for (int n = 0; n < 500; ++n) {
    const Eigen::Vector2d low(place(generator), place(generator));
    const Eigen::AlignedBox2d box(low, low + Eigen::Vector2d(size(generator), size(generator)));
    std::set<int> found, all;
    grid.visitBox(box, [&](int t) {
      if (heightsWithin(grid.triangles()[t], box)) found.insert(t);
    });
    for (int t = 0; t < 300; ++t)
      if (heightsWithin(grid.triangles()[t], box)) all.insert(t);
    EXPECT_EQ(found, all);
  }
}

// Of n triangles of 5 m in one place squares of 0.05 m would list 5,000 n.
TEST(TriangleGrid, ListsAreAboutAsLongAsThereAreTrianglesHoweverTheyOverlap) {
  std::vector<Triangle3> pile;
  for (int k = 0; k < 3000; ++k) {
    const Eigen::Vector3d at(1e-4 * k, -1e-4 * k, 0.0);
    pile.push_back({at, at + Eigen::Vector3d(5, 0, 0), at + Eigen::Vector3d(0, 5, 0)});
  }
  const TriangleGrid grid(pile);
  int listed = 0, over = 0;
  grid.visitBox(grid.extent(), [&](int) { ++listed; });
  EXPECT_LT(listed, 2200000);
  grid.visitAt(1.5, 1.5, [&](int t) { over += heightOver(grid.triangles()[t], 1.5, 1.5) ? 1 : 0; });
  EXPECT_EQ(over, 3000);
}

TEST(AreaWithin, OfABoxInSidesAddsUpToTheTriangle) {
  const Triangle3 t = {Eigen::Vector3d(0.3, 0.1, 0), {3.7, 0.4, 1}, {1.2, 2.9, 2}};
  const double whole = areaWithin(t, {Eigen::Vector2d(-9, -9), Eigen::Vector2d(9, 9)});
  EXPECT_NEAR(whole, 0.5 * (3.4 * 2.8 - 0.3 * 0.9), 1e-12);
  double sum = 0.0;
  for (int i = 0; i < 8; ++i)
    for (int j = 0; j < 8; ++j)
      sum += areaWithin(t, {0.5 * Eigen::Vector2d(i, j), 0.5 * Eigen::Vector2d(i + 1, j + 1)});
  EXPECT_NEAR(sum, whole, 1e-12);
  EXPECT_EQ(areaWithin(t, {Eigen::Vector2d(5, 5), Eigen::Vector2d(6, 6)}), 0.0);
}

}  // namespace
}  // namespace amble

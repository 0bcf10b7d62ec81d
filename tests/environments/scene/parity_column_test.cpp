#include "environments/scene/parity_column.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "environments/scene/triangle_grid.h"
#include "tests/environments/test_scenes.h"

namespace amble {
namespace {

constexpr double kBeside = 0.012;  // a ray serves for a metre

/// Boxes and balls in one another, each a little aside, so that the ray of one point meets others
/// of their edges than that of the next.
TriangleMesh nestedShells(std::mt19937_64& generator, int count) {
  std::uniform_real_distribution<double> aside(-0.002, 0.002);
  TriangleMesh mesh;
  for (int k = 0; k < count; ++k) {
    const double size = 4.0 - 3.6 * k / count;
    const TriangleMesh shell =
        k % 3 == 2 ? makeSphere(0.45 * size, 12) : makeBox({size, size, size});
    const Eigen::Vector3d by(aside(generator), aside(generator), aside(generator));
    mesh = joined(mesh, moved(k % 2 ? turned(shell) : shell, by));
  }
  return mesh;
}

/// Whether a surface has the height z near the vertical.
bool isNear(const TriangleMesh& mesh, const Eigen::Vector2d& at, double z) {
  const Eigen::AlignedBox2d near(at.array() - kBeside, (at.array() + kBeside).matrix());
  return std::any_of(mesh.triangles.begin(), mesh.triangles.end(), [&](const auto& t) {
    const auto heights =
        heightsWithin({mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]}, near);
    return heights && heights->low <= z && z <= heights->high;
  });
}

TEST(ParityColumn, SaysWhatParitySaysPointByPoint) {
  std::mt19937_64 generator(7);
  std::uniform_real_distribution<double> place(-2.2, 2.2);
  int inside = 0, outside = 0;
  for (int n = 0; n < 60; ++n) {
    // The second, of shells that overlap, stands in the first, the third beside both.
    const TriangleMesh all[] = {nestedShells(generator, 4 + n % 20),
                                moved(joined(nestedShells(generator, 5),
                                             moved(nestedShells(generator, 4), {0.5, 0.3, 0.2})),
                                      {0.7, 0.4, 0.3}),
                                moved(nestedShells(generator, 3), {6, 0, 0})};
    const Parity a(solidOf(all[0])), b(solidOf(all[1])), c(solidOf(all[2]));
    const Eigen::Vector2d at(place(generator), place(generator));
    ParityColumn column(at, kBeside, {&a, &b, &c});
    for (double z = -2.5; z < 2.5; z += 0.031) {
      if (isNear(all[0], at, z) || isNear(all[1], at, z)) continue;
      const Eigen::Vector3d p(at.x(), at.y(), z);
      const bool expected = a.inside(p) || b.inside(p) || c.inside(p);
      EXPECT_EQ(column.isInside(z), expected) << p.transpose();
      ++(expected ? inside : outside);
    }
  }
  EXPECT_GT(inside, 1000);
  EXPECT_GT(outside, 1000);
}

TEST(ParityColumn, TheWallOfATowerStaysOneAllTheWayUp) {
  // The vertical is 2 cm within the wall of a tower, along which a single ray would leave it.
  const Parity tower(solidOf(joined(makeBox({2, 2, 400}), makeBox({1.9, 1.9, 399}))));
  for (const auto& [x, expected] : {std::pair(0.98, true), std::pair(0.92, false)}) {
    ParityColumn column({x, 0}, 0.015, {&tower});
    for (double z = -199; z < 199; z += 0.7) EXPECT_EQ(column.isInside(z), expected) << z;
  }
}

TEST(ParityColumn, OfNothingIsOutside) {
  ParityColumn column({0, 0}, 0.05, {});
  EXPECT_FALSE(column.isInside(-1.0));
  EXPECT_FALSE(column.isInside(1e6));
}

}  // namespace
}  // namespace amble

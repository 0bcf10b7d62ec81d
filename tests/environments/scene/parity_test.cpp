#include "environments/scene/parity.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "tests/environments/test_scenes.h"

namespace amble {
namespace {

TEST(Parity, AMeshWithoutClosedPiecesHasNoInside) {
  TriangleMesh open = makeBox({2, 2, 2});
  open.triangles.pop_back();
  EXPECT_TRUE(Parity(open).empty());
  EXPECT_FALSE(Parity(open).inside({0, 0, 0}));
  EXPECT_FALSE(Parity().inside({0, 0, 0}));
}

TEST(Parity, AgreesWithTheFormulaOfABox) {
  std::mt19937_64 generator(4);
  std::uniform_real_distribution<double> number(-1.5, 1.5);
  const Parity solid(makeBox({2, 2, 2}));
  for (int n = 0; n < 10000; ++n) {
    const Eigen::Vector3d p(number(generator), number(generator), number(generator));
    EXPECT_EQ(solid.inside(p), p.cwiseAbs().maxCoeff() < 1.0) << p.transpose();
  }
}

TEST(Parity, AgreesWithTheFormulaOfASphere) {
  std::mt19937_64 generator(5);
  std::uniform_real_distribution<double> number(-1.2, 1.2);
  const Parity solid(makeSphere(1.0, 64));
  for (int n = 0; n < 10000; ++n) {
    const Eigen::Vector3d p(number(generator), number(generator), number(generator));
    if (p.norm() > 0.99 && p.norm() < 1.0) continue;  // between the sphere and its facets
    EXPECT_EQ(solid.inside(p), p.norm() < 1.0);
  }
}

TEST(Parity, WindingDoesNotMatterAndHollowShellsAreFreeWithin) {
  const TriangleMesh outer = makeBox({4, 4, 4}), inner = makeBox({2, 2, 2});
  for (const TriangleMesh& mesh :
       {joined(outer, inner), joined(outer, turned(inner)), joined(turned(outer), inner),
        joined(turned(outer), turned(inner))}) {
    const Parity solid(mesh);
    EXPECT_FALSE(solid.inside({0, 0, 0}));
    EXPECT_TRUE(solid.inside({1.5, 0, 0}));
    EXPECT_TRUE(solid.inside({0, 0, -1.5}));
    EXPECT_FALSE(solid.inside({2.5, 0, 0}));
  }
}

TEST(Parity, PointsStraightAboveAndBelowEdgesAndCornersAreTold) {
  // The ray is off the vertical, but walls, edges and corners in line with the point must not
  // matter anyway.
  const Parity solid(joined(makeBox({2, 2, 2}), makeBox({1, 1, 1})));
  for (const double x : {-1.0, -0.5, 0.0, 0.5, 1.0})
    for (const double y : {-1.0, -0.5, 0.0, 0.5, 1.0}) {
      EXPECT_FALSE(solid.inside({x, y, -1.5}));
      EXPECT_FALSE(solid.inside({x, y, 1.5}));
      const bool within = std::abs(x) < 1.0 && std::abs(y) < 1.0;
      if (within) {
        EXPECT_TRUE(solid.inside({x, y, -0.75}));
        EXPECT_TRUE(solid.inside({x, y, 0.75}));
      }
    }
}

/// A ball whose corners are pushed in and out at random, so that it is closed and bent everywhere.
TriangleMesh potato(std::mt19937_64& generator) {
  std::uniform_real_distribution<double> radius(0.5, 1.0);
  TriangleMesh mesh = makeSphere(1.0, 16);
  for (Eigen::Vector3d& v : mesh.vertices) v *= radius(generator);
  return mesh;
}

/// How often a ray from p crosses the mesh (Moeller and Trumbore 1997).
int crossings(const TriangleMesh& mesh, const Eigen::Vector3d& p, const Eigen::Vector3d& way) {
  int count = 0;
  for (const auto& t : mesh.triangles) {
    const Eigen::Vector3d &a = mesh.vertices[t[0]], ab = mesh.vertices[t[1]] - a,
                          ac = mesh.vertices[t[2]] - a;
    const Eigen::Vector3d q = way.cross(ac), r = (p - a).cross(ab);
    const double det = ab.dot(q), u = (p - a).dot(q) / det, v = way.dot(r) / det;
    count += u >= 0.0 && v >= 0.0 && u + v <= 1.0 && ac.dot(r) / det > 0.0;
  }
  return count;
}

// The ray of Parity is near the vertical: any other must count the same, but for parity.
TEST(Parity, AgreesWithCountingAlongARayAnyWay) {
  std::mt19937_64 generator(41);
  std::uniform_real_distribution<double> number(-1.3, 1.3);
  int within = 0;
  for (int n = 0; n < 12; ++n) {
    TriangleMesh mesh = potato(generator);
    const int more = n % 3;
    for (int i = 0; i < more; ++i) {  // others beside, around and through it
      TriangleMesh other = potato(generator);
      const Eigen::Vector3d by(number(generator), number(generator), number(generator));
      mesh = joined(mesh, moved(i == 0 ? turned(other) : other, 0.4 * by));
    }
    const Parity solid(mesh);
    for (int k = 0; k < 300; ++k) {
      const Eigen::Vector3d p(number(generator), number(generator), number(generator));
      const Eigen::Vector3d way(number(generator), number(generator), number(generator));
      within += solid.inside(p);
      EXPECT_EQ(solid.inside(p), crossings(mesh, p, way) % 2 == 1) << p.transpose();
    }
  }
  EXPECT_GT(within, 300);
}

TEST(Parity, DoesNotDependOnWhereAMeshIsNorOnTheOrderOfItsTriangles) {
  std::mt19937_64 generator(42);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  TriangleMesh mesh = potato(generator);
  const Parity here(mesh);
  const Eigen::Vector3d by(120, -35, 8);
  std::shuffle(mesh.triangles.begin(), mesh.triangles.end(), generator);
  const Parity there(moved(mesh, by));
  for (int k = 0; k < 2000; ++k) {
    const Eigen::Vector3d p(number(generator), number(generator), number(generator));
    EXPECT_EQ(here.inside(p), there.inside(p + by));
  }
}

}  // namespace
}  // namespace amble

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
  EXPECT_TRUE(Parity(solidOf(open)).empty());
  EXPECT_FALSE(Parity(solidOf(open)).inside({0, 0, 0}));
  EXPECT_FALSE(Parity().inside({0, 0, 0}));
}

TEST(Parity, AgreesWithTheFormulaOfABox) {
  std::mt19937_64 generator(4);
  std::uniform_real_distribution<double> number(-1.5, 1.5);
  const Parity solid(solidOf(makeBox({2, 2, 2})));
  for (int n = 0; n < 10000; ++n) {
    const Eigen::Vector3d p(number(generator), number(generator), number(generator));
    EXPECT_EQ(solid.inside(p), p.cwiseAbs().maxCoeff() < 1.0) << p.transpose();
  }
}

TEST(Parity, AgreesWithTheFormulaOfASphere) {
  std::mt19937_64 generator(5);
  std::uniform_real_distribution<double> number(-1.2, 1.2);
  const Parity solid(solidOf(makeSphere(1.0, 64)));
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
    const Parity solid(solidOf(mesh));
    EXPECT_FALSE(solid.inside({0, 0, 0}));
    EXPECT_TRUE(solid.inside({1.5, 0, 0}));
    EXPECT_TRUE(solid.inside({0, 0, -1.5}));
    EXPECT_FALSE(solid.inside({2.5, 0, 0}));
  }
}

TEST(Parity, PointsStraightAboveAndBelowEdgesAndCornersAreTold) {
  // The ray is off the vertical, but walls, edges and corners in line with the point must not
  // matter anyway.
  const Parity solid(solidOf(joined(makeBox({2, 2, 2}), makeBox({1, 1, 1}))));
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

// The ray of Parity is near the vertical: any other must count the same, but for parity. None of
// those beside and through one another is the hollow of another.
TEST(Parity, IsInsideWhereCountingAlongARayAnyWayIsOfAnyPart) {
  std::mt19937_64 generator(41);
  std::uniform_real_distribution<double> number(-1.3, 1.3);
  int within = 0, doubly = 0;
  for (int n = 0; n < 12; ++n) {
    std::vector<TriangleMesh> potatoes = {potato(generator)};
    for (int i = 0; i < n % 3; ++i) {
      TriangleMesh other = potato(generator);
      const Eigen::Vector3d by(number(generator), number(generator), number(generator));
      potatoes.push_back(moved(i == 0 ? turned(other) : other, 0.4 * by));
    }
    TriangleMesh mesh;
    for (const TriangleMesh& one : potatoes) appendMesh(mesh, one);
    const Parity solid(solidOf(mesh));
    for (int k = 0; k < 300; ++k) {
      const Eigen::Vector3d p(number(generator), number(generator), number(generator));
      const Eigen::Vector3d way(number(generator), number(generator), number(generator));
      const auto count = std::ranges::count_if(
          potatoes, [&](const TriangleMesh& one) { return crossings(one, p, way) % 2 == 1; });
      EXPECT_EQ(solid.inside(p), count > 0) << p.transpose();
      within += count > 0;
      doubly += count > 1;
    }
  }
  EXPECT_GT(within, 300);
  EXPECT_GT(doubly, 100);
}

// A frame of beams as one mesh: each overlaps others, none has another within it.
TEST(Parity, PartsThatOverlapAreSolidWhereTheyDo) {
  std::mt19937_64 generator(43);
  std::uniform_real_distribution<double> number(-1.0, 1.0), breadth(0.3, 1.0);
  for (int n = 0; n < 20; ++n) {
    TriangleMesh mesh;
    std::vector<Eigen::AlignedBox3d> beams;
    for (int i = 0; i < 6; ++i) {
      Eigen::Vector3d size(breadth(generator), breadth(generator), breadth(generator));
      size[i % 3] = 3.0;
      const Eigen::Vector3d at(number(generator), number(generator), number(generator));
      beams.emplace_back(at - 0.5 * size, at + 0.5 * size);
      const TriangleMesh beam = moved(makeBox(size), at);
      appendMesh(mesh, i % 2 == 0 ? beam : turned(beam));
    }
    const Parity solid(solidOf(mesh));
    for (int k = 0; k < 500; ++k) {
      const Eigen::Vector3d p =
          1.5 * Eigen::Vector3d(number(generator), number(generator), number(generator));
      EXPECT_EQ(solid.inside(p),
                std::ranges::any_of(
                    beams, [&](const Eigen::AlignedBox3d& beam) { return beam.contains(p); }))
          << p.transpose();
    }
  }
}

// A room whose walls are a shell with a hollow, and in one mesh with it: a pillar through its wall,
// an open sheet across it, and a block that stands in the hollow, hollow itself.
TEST(Parity, OverlapsHollowsAndOpenSheetsOfOneMeshAreToldApart) {
  TriangleMesh sheet;
  sheet.vertices = {{-1.5, -1, 0}, {1.5, -1, 0}, {1.5, 1, 0}, {-1.5, 1, 0}};
  sheet.triangles = {{0, 1, 2}, {0, 2, 3}};
  TriangleMesh mesh;
  for (const TriangleMesh& part :
       {makeBox({1, 1, 1}), sheet, moved(makeBox({1, 1, 9}), {3, 0, 0}), makeBox({8, 8, 8}),
        turned(makeBox({6, 6, 6})), makeBox({2, 2, 2})})
    appendMesh(mesh, part);
  const Parity solid(solidOf(mesh));
  EXPECT_FALSE(solid.inside({0, 0, 0})) << "in the hollow block";
  EXPECT_TRUE(solid.inside({0.75, 0, 0.1})) << "in its wall";
  EXPECT_FALSE(solid.inside({1.2, 0, 0.1})) << "over the sheet, in the room";
  EXPECT_FALSE(solid.inside({1.2, 0, -0.1})) << "under it";
  EXPECT_TRUE(solid.inside({2.7, 0, 0})) << "in the pillar, in the room";
  EXPECT_TRUE(solid.inside({3.3, 0, 0})) << "in the pillar and the wall";
  EXPECT_TRUE(solid.inside({3.8, 0, 0})) << "in the wall beside it";
  EXPECT_TRUE(solid.inside({3, 0, 4.2})) << "in the pillar over the roof";
  EXPECT_FALSE(solid.inside({3.8, 0, 4.2})) << "over the roof";
}

TEST(Parity, DoesNotDependOnWhereAMeshIsNorOnTheOrderOfItsTriangles) {
  std::mt19937_64 generator(42);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  TriangleMesh mesh = potato(generator);
  const Parity here(solidOf(mesh));
  const Eigen::Vector3d by(120, -35, 8);
  std::shuffle(mesh.triangles.begin(), mesh.triangles.end(), generator);
  const Parity there(solidOf(moved(mesh, by)));
  for (int k = 0; k < 2000; ++k) {
    const Eigen::Vector3d p(number(generator), number(generator), number(generator));
    EXPECT_EQ(here.inside(p), there.inside(p + by));
  }
}

}  // namespace
}  // namespace amble

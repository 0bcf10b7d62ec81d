#include "environments/scene/parity.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace amble

#include "viz/pictures/outline.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <random>

#include "tests/environments/test_meshes.h"

namespace amble {
namespace {

constexpr double kPi = 3.14159265358979323846;

TEST(Outline, OfNothingIsNothing) {
  EXPECT_TRUE(traceOutlines({}, {}).empty());
  EXPECT_TRUE(traceConvexOutline({}, {}).empty());
  EXPECT_TRUE(
      traceOutlines(moved(makeBox({1, 1, 0.1}), {0, 0, 2.5}), {}).empty());  // above what is seen
}

TEST(Outline, OfAWallThatIsCutIsFilled) {
  // A wall from the floor to 2.5 m has neither top nor bottom within the cut.
  const auto outlines = traceOutlines(moved(makeBox({3, 0.4, 2.5}), {1, 1, 1.25}), {});
  ASSERT_EQ(outlines.size(), 1u);
  EXPECT_NEAR(coveredArea(outlines), 1.2, 0.04);
}

TEST(Outline, OfADiscHasItsArea) {
  for (const double radius : {0.2, 0.5, 1.3}) {
    const auto outlines = traceOutlines(moved(makeCylinder(radius, 1, 96), {0.3, -0.7, 0.6}), {});
    ASSERT_EQ(outlines.size(), 1u);
    EXPECT_NEAR(coveredArea(outlines), kPi * radius * radius, 2 * kPi * radius * 0.01) << radius;
  }
}

TEST(Outline, OfATableIsItsTopAboveAndItsLegsBelow) {
  TriangleMesh table = moved(makeBox({1, 0.6, 0.04}), {0, 0, 0.72});
  for (const double x : {-0.45, 0.45})
    for (const double y : {-0.25, 0.25})
      table = joined(table, moved(makeBox({0.06, 0.06, 0.69}), {x, y, 0.345}));
  EXPECT_EQ(traceOutlines(table, {0.05, 0.6, 0.005}).size(), 4u);
  EXPECT_NEAR(coveredArea(traceOutlines(table, {0.05, 0.6, 0.005})), 4 * 0.06 * 0.06, 0.006);
  EXPECT_NEAR(coveredArea(traceOutlines(table, {0.05, 1.8, 0.005})), 0.6, 0.02);
}

TEST(Outline, OfARoundOfWallsHasAHole) {
  TriangleMesh walls = moved(makeBox({2, 0.2, 2}), {0, 0.9, 1});
  walls = joined(walls, moved(makeBox({2, 0.2, 2}), {0, -0.9, 1}));
  walls = joined(walls, moved(makeBox({0.2, 1.7, 2}), {0.9, 0, 1}));
  walls = joined(walls, moved(makeBox({0.2, 1.7, 2}), {-0.9, 0, 1}));
  const auto outlines = traceOutlines(walls, {});
  ASSERT_EQ(outlines.size(), 2u);
  EXPECT_NEAR(coveredArea(outlines), 4 - 1.6 * 1.6, 0.12);
}

TEST(Outline, OfAnOpenSheetIsTheSheet) {
  TriangleMesh sheet;
  sheet.vertices = {{0, 0, 0.5}, {1, 0, 0.5}, {1, 1, 0.5}, {0, 1, 0.5}};
  sheet.triangles = {{0, 1, 2}, {0, 2, 3}};
  EXPECT_NEAR(coveredArea(traceOutlines(sheet, {})), 1, 0.05);
}

TEST(Outline, OfAConvexShapeIsExact) {
  const auto outlines = traceConvexOutline(moved(makeBox({3, 0.4, 2.5}), {1, 1, 1.25}), {});
  ASSERT_EQ(outlines.size(), 1u);
  EXPECT_EQ(outlines[0].size(), 4u);
  EXPECT_NEAR(coveredArea(outlines), 1.2, 1e-9);
}

TEST(Outline, OfASphereIsCutAtTheHeightsThatAreSeen) {
  // Of a ball of 1 m around z = 0 only what is above 0.6 m is seen: a disc of 0.8 m.
  const auto outlines = traceConvexOutline(makeSphere(1, 256), {0.6, 1.8, 0.01});
  EXPECT_NEAR(coveredArea(outlines), kPi * 0.64, 0.01);
}

/// Blocks that stand on the floor, anywhere and turned any way about the vertical.
struct Blocks {
  explicit Blocks(std::uint64_t seed) {
    std::mt19937_64 generator(seed);
    std::uniform_real_distribution<double> place(-1.5, 1.5), size(0.2, 1.2), turn(-3.0, 3.0);
    for (int i = 0; i < 7; ++i) {
      Eigen::Isometry3d X(Eigen::AngleAxisd(turn(generator), Eigen::Vector3d::UnitZ()));
      X.pretranslate(Eigen::Vector3d(place(generator), place(generator), 0.5));
      const Eigen::Vector3d wide(size(generator), size(generator), 1.0);
      TriangleMesh box = makeBox(wide);
      for (auto& v : box.vertices) v = X * v;
      mesh = joined(mesh, box);
      places.push_back({X, 0.5 * wide.head<2>()});
    }
  }
  bool covers(const Eigen::Vector2d& p) const {
    return std::any_of(places.begin(), places.end(), [&](const auto& place) {
      const Eigen::Vector3d local = place.first.inverse() * Eigen::Vector3d(p.x(), p.y(), 0.5);
      return (local.head<2>().cwiseAbs().array() <= place.second.array()).all();
    });
  }
  TriangleMesh mesh;
  std::vector<std::pair<Eigen::Isometry3d, Eigen::Vector2d>> places;
};

/// How often an outline goes round a point.
int turnsRound(const Outline& outline, const Eigen::Vector2d& p) {
  double angle = 0.0;
  for (size_t i = 0; i < outline.size(); ++i) {
    const Eigen::Vector2d a = outline[i] - p, b = outline[(i + 1) % outline.size()] - p;
    angle += std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
  }
  return static_cast<int>(std::lround(angle / (2 * kPi)));
}

TEST(Outline, OfRandomBlocksHoldsWhatTheyCoverAndNothingElse) {
  for (const std::uint64_t seed : {1, 2, 3, 4}) {
    const Blocks blocks(seed);
    const auto outlines = traceOutlines(blocks.mesh, {});
    std::mt19937_64 generator(seed + 100);
    std::uniform_real_distribution<double> place(-2.5, 2.5);
    int wrong = 0;
    for (int n = 0; n < 4000; ++n) {
      const Eigen::Vector2d p(place(generator), place(generator));
      int turns = 0;
      for (const Outline& outline : outlines) turns += turnsRound(outline, p);
      EXPECT_TRUE(turns == 0 || turns == 1) << turns;  // round what is covered, back round holes
      wrong += (turns > 0) != blocks.covers(p);
    }
    // Only within a cell or two of an edge: of 25 m^2, some 30 m of them.
    EXPECT_LT(wrong, 4000 * 30 * 0.02 / 25) << seed;
  }
}

TEST(Outline, OfAConvexMeshIsThatOfItsPointsWhicheverOutlineIsTraced) {
  std::mt19937_64 generator(9);
  std::uniform_real_distribution<double> turn(-3.0, 3.0);
  for (int n = 0; n < 6; ++n) {
    TriangleMesh ball = makeSphere(0.6, 40);
    const Eigen::Quaterniond q(
        Eigen::AngleAxisd(turn(generator), Eigen::Vector3d(1, 2, 3).normalized()));
    for (auto& v : ball.vertices) v = q * v.cwiseProduct(Eigen::Vector3d(1, 1.5, 0.8));
    ball = moved(ball, {0.2, -0.1, 0.9});
    const auto exact = traceConvexOutline(ball, {}), traced = traceOutlines(ball, {});
    ASSERT_EQ(exact.size(), 1u);
    EXPECT_NEAR(coveredArea(traced), coveredArea(exact), 0.06);
    EXPECT_GT(coveredArea(exact), 0.0);  // counter-clockwise
    for (const auto& v : ball.vertices) {
      if (v.z() < 0.05 || v.z() > 1.8) continue;
      for (size_t i = 0; i < exact[0].size(); ++i) {  // every point lies to the left of every edge
        const Eigen::Vector2d a = exact[0][i], b = exact[0][(i + 1) % exact[0].size()];
        const Eigen::Vector2d ab = b - a, ap = v.head<2>() - a;
        EXPECT_GT(ab.x() * ap.y() - ab.y() * ap.x(), -1e-6);
      }
    }
  }
}

TEST(Outline, CoveredAreaTakesHolesOff) {
  const Outline outer = {{0, 0}, {4, 0}, {4, 3}, {0, 3}}, hole = {{1, 1}, {1, 2}, {2, 2}, {2, 1}};
  EXPECT_EQ(coveredArea({}), 0.0);
  EXPECT_DOUBLE_EQ(coveredArea({outer}), 12.0);
  EXPECT_DOUBLE_EQ(coveredArea({outer, hole}), 11.0);
}

}  // namespace
}  // namespace amble

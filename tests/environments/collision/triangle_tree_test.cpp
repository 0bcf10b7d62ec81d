#include "environments/collision/triangle_tree.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "environments/collision/fcl_surface.h"
#include "environments/collision/segment_distance.h"
#include "tests/environments/test_scenes.h"

namespace amble {
namespace {

const Eigen::AlignedBox3d kAround(Eigen::Vector3d(-2, -2, -2), Eigen::Vector3d(2, 2, 2));
constexpr double kInfinity = std::numeric_limits<double>::infinity();

Eigen::Vector3d randomPoint(std::mt19937_64& generator) {
  std::uniform_real_distribution<double> at(-2.0, 2.0);
  return {at(generator), at(generator), at(generator)};
}

// Triangles every way, slivers among them, that meet nowhere but by chance.
TriangleMesh randomTriangles(std::mt19937_64& generator, int count) {
  TriangleMesh mesh;
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3d a = randomPoint(generator), way = 0.3 * randomPoint(generator);
    const double thin = i % 3 == 0 ? 1e-4 : 0.3;
    for (const Eigen::Vector3d& v :
         {a, Eigen::Vector3d(a + way),
          Eigen::Vector3d(a + 0.4 * way + thin * randomPoint(generator))})
      mesh.vertices.push_back(v);
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return mesh;
}

Triangle3 triangleOf(const TriangleMesh& mesh, size_t t) {
  const auto& [a, b, c] = mesh.triangles[t];
  return {mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]};
}

double leastByBruteForce(const TriangleMesh& mesh, const Capsule& capsule) {
  double least = kInfinity;
  for (size_t t = 0; t < mesh.triangles.size(); ++t)
    least = std::min(least, squaredDistance({capsule.from, capsule.to}, triangleOf(mesh, t)));
  return std::max(0.0, std::sqrt(least) - capsule.radius);
}

// Of a convex function on a convex set a descent by shrinking steps, from many beginnings.
double leastBySearch(const Segment& s, const Triangle3& t) {
  double best = kInfinity;
  const auto at = [&](double k, double u, double v) {
    const Eigen::Vector3d p = s.from + k * (s.to - s.from);
    return (p - t[0] - u * (t[1] - t[0]) - v * (t[2] - t[0])).squaredNorm();
  };
  for (const double start : {0.0, 0.5, 1.0}) {
    double k = start, u = 0.3, v = 0.3, here = at(k, u, v);
    for (double step = 0.3; step > 1e-8; step *= 0.8) {
      for (int n = 0; n < 27 * 4; ++n) {
        const double k1 = std::clamp(k + step * (n % 3 - 1), 0.0, 1.0);
        double u1 = std::max(0.0, u + step * (n / 3 % 3 - 1)),
               v1 = std::max(0.0, v + step * (n / 9 % 3 - 1));
        if (u1 + v1 > 1.0) {
          const double over = 0.5 * (u1 + v1 - 1.0);
          u1 = std::clamp(u1 - over, 0.0, 1.0);
          v1 = 1.0 - u1;
        }
        if (at(k1, u1, v1) >= here) continue;
        k = k1, u = u1, v = v1, here = at(k1, u1, v1);
      }
    }
    best = std::min(best, here);
  }
  return best;
}

TEST(SegmentDistance, IsTheLeastOverAllPairsOfPoints) {
  std::mt19937_64 generator(1);
  for (int n = 0; n < 60; ++n) {
    const TriangleMesh mesh = randomTriangles(generator, 2);
    const Segment s{randomPoint(generator), randomPoint(generator)};
    const Triangle3 t = triangleOf(mesh, 1);
    EXPECT_NEAR(std::sqrt(squaredDistance(s, t)), std::sqrt(leastBySearch(s, t)), 2e-3) << n;
    EXPECT_LE(squaredDistance(s, t), leastBySearch(s, t) + 1e-12) << n;
  }
}

TEST(SegmentDistance, DoesNotCareForTheOrderOfEndsAndCorners) {
  std::mt19937_64 generator(2);
  for (int n = 0; n < 2000; ++n) {
    const Triangle3 t = triangleOf(randomTriangles(generator, 2), n % 2);
    const Segment s{randomPoint(generator), n % 7 ? randomPoint(generator) : t[0]};
    const double square = squaredDistance(s, t);
    EXPECT_NEAR(squaredDistance({s.to, s.from}, t), square, 1e-9);
    EXPECT_NEAR(squaredDistance(s, Triangle3{t[1], t[2], t[0]}), square, 1e-9);
    EXPECT_NEAR(squaredDistance(s, Triangle3{t[1], t[0], t[2]}), square, 1e-9);
    EXPECT_NEAR(squaredDistance(s, Segment{t[0], t[1]}), squaredDistance(Segment{t[0], t[1]}, s),
                1e-9);
  }
}

TEST(SegmentDistance, IsZeroOnlyWhereTheyMeet) {
  const Triangle3 t{Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0, 1, 0)};
  const auto upright = [](double x, double y) { return Segment{{x, y, -1.0}, {x, y, 1.0}}; };
  EXPECT_EQ(squaredDistance(upright(0.25, 0.25), t), 0.0);
  EXPECT_NEAR(squaredDistance(upright(-0.5, 0.25), t), 0.25, 1e-15);
  EXPECT_NEAR(squaredDistance(upright(1.0, 1.0), t), 0.5, 1e-15);
  EXPECT_NEAR(squaredDistance({{0.25, 0.25, 0.5}, {0.25, 0.25, 2.0}}, t), 0.25, 1e-15);
  EXPECT_NEAR(squaredDistance({{3, 0, 0}, {3, 0, 0}}, t), 4.0, 1e-15);   // a point in its plane
  EXPECT_NEAR(squaredDistance({{-1, 2, 0}, {2, 2, 0}}, t), 1.0, 1e-15);  // a line in its plane
  EXPECT_EQ(squaredDistance({{-1, 0.5, 0}, {2, 0.5, 0}}, t), 0.0);       // and through it
  EXPECT_FALSE(isWithin(0.249, upright(-0.5, 0.25), t));
  EXPECT_TRUE(isWithin(0.251, upright(-0.5, 0.25), t));
}

TEST(TriangleTree, IsBruteForceOverItsTriangles) {
  std::mt19937_64 generator(3);
  for (const int count : {1, 3, 8, 33, 700}) {
    const TriangleMesh mesh = randomTriangles(generator, count);
    const TriangleTree tree(mesh);
    for (int n = 0; n < 400; ++n) {
      const Capsule capsule = randomCapsule(generator, kAround);
      const double least = leastByBruteForce(mesh, capsule);
      EXPECT_NEAR(tree.distance(capsule, kInfinity), least, 1e-12);
      EXPECT_EQ(tree.touches(capsule), least <= 0.0);
      // Grown to within a nanometre of contact.
      if (least <= 0.0) continue;
      EXPECT_FALSE(tree.touches(capsule.inflated(least - 1e-9)));
      EXPECT_TRUE(tree.touches(capsule.inflated(least + 1e-9)));
      EXPECT_EQ(tree.distance(capsule, 0.5 * least), 0.5 * least);
    }
  }
}

TEST(TriangleTree, IsAsExactFarFromTheOrigin) {
  std::mt19937_64 generator(4);
  const Eigen::Vector3d away(40000.0, -25000.0, 300.0);  // a town from its datum [m]
  TriangleMesh mesh = randomTriangles(generator, 300);
  for (Eigen::Vector3d& v : mesh.vertices) v += away;
  const TriangleTree tree(mesh);
  for (int n = 0; n < 400; ++n) {
    Capsule capsule = randomCapsule(generator, kAround);
    capsule.from += away;
    capsule.to += away;
    const double least = leastByBruteForce(mesh, capsule);
    EXPECT_NEAR(tree.distance(capsule, kInfinity), least, 1e-9);
    EXPECT_EQ(tree.touches(capsule), least <= 0.0);
  }
}

TEST(TriangleTree, OfNothingTouchesNothing) {
  const TriangleTree none;
  EXPECT_TRUE(none.empty());
  EXPECT_FALSE(none.touches({{0, 0, 0}, {1, 0, 0}, 5.0}));
  EXPECT_EQ(none.distance({{0, 0, 0}, {1, 0, 0}, 5.0}, 3.0), 3.0);
}

TEST(TriangleTree, HoldsManyTrianglesInOnePlace) {
  TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {}};
  mesh.triangles.assign(5000, {0, 1, 2});
  const TriangleTree tree(mesh);
  EXPECT_TRUE(tree.touches({{0.2, 0.2, -1}, {0.2, 0.2, 1}, 0.01}));
  EXPECT_NEAR(tree.distance({{0.2, 0.2, 1}, {0.2, 0.2, 2}, 0.1}, kInfinity), 0.9, 1e-12);
}

TEST(TriangleTree, AgreesWithFclUpToItsAccuracy) {
  std::mt19937_64 generator(5);
  for (const TriangleMesh& mesh :
       {makeSphere(0.7), makeBox({1.0, 0.3, 2.0}), randomTriangles(generator, 60)}) {
    const TriangleTree tree(mesh);
    const SurfacePtr fcl = makeFclSurface(mesh, Eigen::Isometry3d::Identity());
    for (int n = 0; n < 500; ++n) {
      Capsule capsule = randomCapsule(generator, kAround);
      const double ours = tree.distance(capsule, 10.0);
      EXPECT_NEAR(ours, fcl->distance(capsule, 10.0), 1e-4);
      for (const double off : {-2e-6, 2e-6, -1e-3, 1e-3}) {
        const Capsule near = capsule.inflated(ours + off);
        if (near.radius <= 0.0 || ours <= 0.0) continue;
        EXPECT_EQ(fcl->touches(near), off > 0.0) << off;
        EXPECT_EQ(tree.touches(near), off > 0.0) << off;
      }
    }
  }
}

}  // namespace
}  // namespace amble

#include "environments/furniture/mesh_kit.h"

#include <cmath>
#include <sstream>

#include "tests/environments/furniture/pieces.h"

namespace amble {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kPi = 3.14159265358979323846;

/// Of a regular polygon about a circle's points, as a share of radius^2.
double polygonArea(int segments) { return 0.5 * segments * std::sin(2.0 * kPi / segments); }

/// Of what a profile encloses that is turned about z in so many steps: frustums, one on another.
double turnedVolume(const std::vector<Vector2d>& profile, int segments, bool ring) {
  double sum = 0.0;
  const size_t n = profile.size();
  for (size_t i = 0; i + 1 < n + (ring ? 1 : 0); ++i) {
    const Vector2d &a = profile[i], &b = profile[(i + 1) % n];
    sum += (b.y() - a.y()) * (a.x() * a.x() + a.x() * b.x() + b.x() * b.x()) / 3.0;
  }
  return polygonArea(segments) * sum;
}

void expectClosed(const Surface& surface) {
  std::map<std::pair<int, int>, int> edges;
  for (const auto& t : surface.triangles)
    for (int k = 0; k < 3; ++k) ++edges[{t[k], t[(k + 1) % 3]}];
  for (const auto& [edge, count] : edges) {
    EXPECT_EQ(count, 1);
    EXPECT_EQ(edges.count({edge.second, edge.first}), 1u);
  }
  EXPECT_GT(volumeOf(surface), 0.0);
}

TEST(RoundedBox, OfSharpEdgesIsTheBox) {
  const Surface box = makeRoundedBox({{0.4, 0.6, 0.8}, 0.05, 0, {2, 3, 1}});
  expectClosed(box);
  EXPECT_NEAR(volumeOf(box), 0.4 * 0.6 * 0.8, 1e-12);
  EXPECT_LT((boxOf(box).sizes() - Vector3d(0.4, 0.6, 0.8)).norm(), 1e-12);
  EXPECT_LT(boxOf(box).center().norm(), 1e-12);
}

TEST(RoundedBox, EveryPointIsItsRadiusFromTheBoxWithin) {
  for (const int arc : {1, 2, 5}) {
    const RoundedBox asked{{0.4, 0.6, 0.2}, 0.07, arc, {3, 1, 2}};
    const Surface box = makeRoundedBox(asked);
    expectClosed(box);
    const Vector3d inner = asked.size / 2 - Vector3d::Constant(asked.radius);
    const Eigen::AlignedBox3d within(-inner, inner);
    for (const Vector3d& p : box.vertices)
      EXPECT_NEAR(within.exteriorDistance(p), asked.radius, 1e-9);
    EXPECT_LT((boxOf(box).sizes() - asked.size).norm(), 1e-12);
  }
}

// Steiner's formula: box, slabs on its faces, quarter cylinders along its edges, a ball.
TEST(RoundedBox, TheFinerItsArcsTheNearerToSteinersVolume) {
  constexpr double r = 0.05;
  const Vector3d size(0.3, 0.4, 0.5), w = size - Vector3d::Constant(2 * r);
  const double exact = w.prod() + 2 * r * (w.x() * w.y() + w.y() * w.z() + w.z() * w.x()) +
                       kPi * r * r * w.sum() + 4.0 / 3.0 * kPi * r * r * r;
  double miss = 1.0;
  for (const int arc : {1, 2, 4, 8}) {
    const double now = exact - volumeOf(makeRoundedBox({size, r, arc}));
    EXPECT_GT(now, 0.0);  // corners lie on the round, edges within
    EXPECT_LT(now, 0.5 * miss);
    miss = now;
  }
  EXPECT_LT(miss, 1e-3 * exact);
}

TEST(Lathe, HasTheVolumeOfItsFrustums) {
  const std::vector<Vector2d> profile = {{0, 0}, {0.2, 0}, {0.15, 0.3}, {0.25, 0.5}, {0, 0.6}};
  for (const int segments : {3, 8, 31}) {
    const Surface turned = makeLathe(profile, segments);
    expectClosed(turned);
    EXPECT_NEAR(volumeOf(turned), turnedVolume(profile, segments, false), 1e-12);
  }
}

TEST(Lathe, OfARingHasAHoleThrough) {
  const std::vector<Vector2d> profile = {{0.3, 0.0}, {0.4, 0.1}, {0.3, 0.2}, {0.2, 0.1}};
  const Surface ring = makeLathe(profile, 24, true);
  expectClosed(ring);
  EXPECT_NEAR(volumeOf(ring), turnedVolume(profile, 24, true), 1e-12);
  for (const Vector3d& p : ring.vertices) EXPECT_GE(p.head<2>().norm(), 0.2 - 1e-12);
  EXPECT_EQ(ring.vertices.size(), 4u * 24u);
  const int euler = static_cast<int>(ring.vertices.size()) -
                    static_cast<int>(ring.triangles.size()) * 3 / 2 +
                    static_cast<int>(ring.triangles.size());
  EXPECT_EQ(euler, 0);  // a torus
}

TEST(SmoothCurve, PassesThroughItsPointsInOrder) {
  const std::vector<Vector2d> points = {{0, 0}, {1, 0.5}, {2, -1}, {2.5, 0.3}, {4, 1}};
  constexpr int kSteps = 7;
  const auto curve = smoothCurve(points, kSteps);
  ASSERT_EQ(curve.size(), (points.size() - 1) * kSteps + 1);
  for (size_t i = 0; i < points.size(); ++i)
    EXPECT_LT((curve[i * kSteps] - points[i]).norm(), 1e-12);
}

TEST(SmoothCurve, OfPointsOnALineStaysOnIt) {
  const Vector2d along(0.6, 0.8);
  std::vector<Vector2d> points;
  for (int i = 0; i < 5; ++i) points.emplace_back(0.3 * i * along);
  for (const Vector2d& p : smoothCurve(points, 6))
    EXPECT_NEAR(p.x() * along.y() - p.y() * along.x(), 0.0, 1e-12);
}

TEST(SmoothCurve, HasNoCornerAtItsPoints) {
  constexpr int kSteps = 1000;
  const auto curve = smoothCurve({{0, 0}, {1, 1}, {2, 0}, {3, 1}}, kSteps);
  for (const size_t at : {size_t{kSteps}, size_t{2 * kSteps}}) {
    const Vector2d before = (curve[at] - curve[at - 1]).normalized();
    const Vector2d after = (curve[at + 1] - curve[at]).normalized();
    EXPECT_GT(before.dot(after), std::cos(0.02));
  }
}

TEST(Tube, StraightOnesHaveTheVolumeOfTheirPrism) {
  for (const Vector3d& way : {Vector3d(0, 0, 2), Vector3d(1.5, 0, 0), Vector3d(-0.5, 1, 0.7)}) {
    const Surface tube = makeTube({{1, 2, 3}, Vector3d(1, 2, 3) + way}, {0.1, 0.1}, 16);
    expectClosed(tube);
    EXPECT_NEAR(volumeOf(tube), polygonArea(16) * 0.01 * way.norm(), 1e-12);
  }
}

TEST(Tube, RingsLieRoundTheirPointsAcrossTheWay) {
  const std::vector<Vector3d> path = {{0, 0, 0}, {0, 0.3, 0.4}, {0.2, 0.5, 0.8}, {0.6, 0.5, 0.9}};
  const std::vector<double> radius = {0.05, 0.04, 0.03, 0.02};
  constexpr int kSegments = 10;
  const Surface tube = makeTube(path, radius, kSegments);
  expectClosed(tube);
  for (size_t i = 0; i < path.size(); ++i) {
    const Vector3d along = path[std::min(i + 1, path.size() - 1)] - path[i > 0 ? i - 1 : 0];
    for (int k = 0; k < kSegments; ++k) {
      const Vector3d out = tube.vertices[i * kSegments + k] - path[i];
      EXPECT_NEAR(out.norm(), radius[i], 1e-12);
      EXPECT_NEAR(out.dot(along), 0.0, 1e-12);
    }
  }
}

TEST(Leg, StandsFlatWhereItsFootIsAndReachesItsTop) {
  const Leg asked{{0.3, -0.2}, {0.25, -0.1}, 0.7, 0.015, 0.03, 20};
  const Surface leg = makeLeg(asked);
  expectClosed(leg);
  const Eigen::AlignedBox3d box = boxOf(leg);
  EXPECT_EQ(box.min().z(), 0.0);
  EXPECT_NEAR(box.max().z(), 0.7, 1e-12);
  for (const Vector3d& p : leg.vertices) {
    if (p.z() == 0.0) {
      EXPECT_LE((p.head<2>() - asked.foot).norm(), asked.foot_radius);
    }
    if (p.z() > 0.7 - 1e-9) {
      EXPECT_LE((p.head<2>() - asked.top).norm(), asked.top_radius + 1e-12);
    }
  }
}

TEST(Loft, OfAPlateIsItsOutlineWithinItsHeights) {
  std::vector<Vector2d> outline;
  for (int i = 0; i < 60; ++i)
    outline.emplace_back(0.5 * std::cos(kPi * i / 30), 0.3 * std::sin(kPi * i / 30));
  constexpr double kBevel = 0.01;
  const auto rings = plateRings(0.7, 0.75, kBevel);
  const Surface plate = makeLoft(outline, {0, 0}, rings);
  expectClosed(plate);
  const Eigen::AlignedBox3d box = boxOf(plate);
  EXPECT_LT((box.min() - Vector3d(-0.5, -0.3, 0.7)).norm(), 1e-9);
  EXPECT_LT((box.max() - Vector3d(0.5, 0.3, 0.75)).norm(), 1e-9);
  const double area = polygonArea(60) * 0.5 * 0.3, round = 2 * kPi * 0.5;  // at most its length
  EXPECT_LT(volumeOf(plate), area * 0.05);
  EXPECT_GT(volumeOf(plate), (area - round * kBevel) * 0.05);
}

TEST(Loft, APlatesEdgesAreRoundedAlikeBelowAndAbove) {
  const auto rings = plateRings(0.2, 0.5, 0.03);
  EXPECT_EQ(rings.front().height, 0.2);
  EXPECT_EQ(rings.back().height, 0.5);
  for (size_t i = 0; i < rings.size(); ++i) {
    const LoftRing &low = rings[i], &high = rings[rings.size() - 1 - i];
    EXPECT_NEAR(low.inset, high.inset, 1e-15);
    EXPECT_NEAR(low.height - 0.2, 0.5 - high.height, 1e-12);
    // On a quarter of a circle about the point a bevel's width inside.
    if (low.height < 0.23) {
      EXPECT_NEAR(std::hypot(0.03 - low.inset, 0.23 - low.height), 0.03, 1e-12);
    }
    if (i > 0) {
      EXPECT_GT(low.height, rings[i - 1].height);
    }
  }
}

TEST(Surface, MovingAndTurningKeepItsVolume) {
  const Surface box = makeRoundedBox({{0.4, 0.6, 0.2}, 0.03, 2});
  Surface moved = box;
  moved.move(3, -2, 5).rotate(0, 33).rotate(1, -71).rotate(2, 200);
  EXPECT_NEAR(volumeOf(moved), volumeOf(box), 1e-12);
  EXPECT_EQ(moved.triangles, box.triangles);
}

TEST(Surface, QuarterTurnsTakeAxesToAxes) {
  const Vector3d p(1, 2, 3);
  const Vector3d turned[3] = {{1, -3, 2}, {3, 2, -1}, {-2, 1, 3}};  // right-handed, about x, y, z
  for (int axis = 0; axis < 3; ++axis) {
    Surface point{{p}, {}};
    EXPECT_LT((point.rotate(axis, 90).vertices[0] - turned[axis]).norm(), 1e-12);
    EXPECT_LT((point.rotate(axis, -90).vertices[0] - p).norm(), 1e-12);
  }
}

TEST(Surface, AppendedOnesKeepTheirOwnTriangles) {
  const Surface a = makeRoundedBox({{1, 1, 1}, 0.1, 1}), b = makeLathe({{0, 0}, {1, 0}, {0, 1}}, 9);
  Surface both = a;
  both.append(b);
  EXPECT_NEAR(volumeOf(both), volumeOf(a) + volumeOf(b), 1e-12);
  const auto parts = componentsOf(both);
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_EQ(parts[0].triangles, a.triangles);
  EXPECT_EQ(parts[1].triangles, b.triangles);
}

TEST(Surface, DeformingMapsEveryVertex) {
  Surface box = makeRoundedBox({{1, 1, 1}, 0.1, 2});
  const double before = volumeOf(box);
  box.deform([](const Vector3d& p) { return Vector3d(2 * p.x(), p.y() + p.x(), 3 * p.z()); });
  EXPECT_NEAR(volumeOf(box), 6 * before, 1e-9);  // the map's determinant
}

TEST(Furniture, GroupsGatherWhatIsAddedUnderTheirName) {
  Furniture piece{"thing", {}};
  const Surface box = makeRoundedBox({{1, 1, 1}, 0.1, 0});
  piece.add("a", box);
  piece.add("b", box);
  piece.add("a", box);
  ASSERT_EQ(piece.groups.size(), 2u);
  EXPECT_EQ(piece.groups[0].first, "a");
  EXPECT_EQ(piece.groups[0].second.triangles.size(), 2 * box.triangles.size());
  EXPECT_EQ(piece.triangleCount(), 3 * static_cast<int>(box.triangles.size()));
}

TEST(WriteObj, IsReadBackTurnedUprightToItsDecimals) {
  Furniture piece{"thing", {}};
  piece.add("bar", makeTube({{0, 0, 0}, {0.3, 0.2, 0.9}}, {0.02, 0.03}, 5));
  piece.add("box", makeRoundedBox({{0.4, 0.6, 0.2}, 0.03, 1}).move(1, 2, 3));
  std::ostringstream out;
  writeObj(out, piece);
  EXPECT_EQ(out.str().find("-0.00000"), std::string::npos);
  std::istringstream in(out.str());
  Furniture read{"thing", {}};
  std::string word;
  size_t before = 0;  // vertices of the groups before
  while (in >> word) {
    if (word == "#") std::getline(in, word);
    if (word == "o") {
      if (!read.groups.empty()) before += read.groups.back().second.vertices.size();
      in >> word;
      read.groups.emplace_back(word, Surface{});
    } else if (word == "v") {
      Vector3d p;
      in >> p.x() >> p.y() >> p.z();
      read.groups.back().second.vertices.emplace_back(p.x(), -p.z(), p.y());
    } else if (word == "f") {
      std::array<int, 3> t{};
      for (int& v : t) {
        in >> v;
        v -= 1 + static_cast<int>(before);
      }
      read.groups.back().second.triangles.push_back(t);
    }
  }
  ASSERT_EQ(read.groups.size(), piece.groups.size());
  for (size_t i = 0; i < read.groups.size(); ++i) {
    EXPECT_EQ(read.groups[i].first, piece.groups[i].first);
    const Surface &a = read.groups[i].second, &b = piece.groups[i].second;
    EXPECT_EQ(a.triangles, b.triangles);
    ASSERT_EQ(a.vertices.size(), b.vertices.size());
    for (size_t v = 0; v < a.vertices.size(); ++v)
      EXPECT_LT((a.vertices[v] - b.vertices[v]).cwiseAbs().maxCoeff(), 0.51e-5);
  }
}

}  // namespace
}  // namespace amble

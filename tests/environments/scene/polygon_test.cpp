#include "environments/scene/polygon.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <random>

namespace amble {
namespace {

using Generator = std::mt19937_64;
using Corners = std::vector<Eigen::Vector3d>;

double drawn(Generator& generator, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(generator);
}

// Twice the area, along the normal.
Eigen::Vector3d areaOf(const Corners& corners) {
  Eigen::Vector3d area = Eigen::Vector3d::Zero();
  for (size_t i = 0; i < corners.size(); ++i)
    area += corners[i].cross(corners[(i + 1) % corners.size()]);
  return area;
}

// Corners at random distances around a centre: most are dents.
Corners star(Generator& generator, int count) {
  Corners corners;
  for (int i = 0; i < count; ++i) {
    const double angle = 2.0 * M_PI * i / count, radius = drawn(generator, 0.2, 2.0);
    corners.push_back({radius * std::cos(angle), radius * std::sin(angle), 0.0});
  }
  return corners;
}

// Two arms that wind around one another; outside and inside of a wall.
Corners spiral(int count) {
  Corners out, back;
  for (int i = 0; i < count; ++i) {
    const double angle = 0.3 * i;
    const Eigen::Vector3d direction(std::cos(angle), std::sin(angle), 0.0);
    out.push_back((1.0 + 0.1 * angle) * direction);
    back.push_back((1.3 + 0.1 * angle) * direction);
  }
  out.insert(out.end(), back.rbegin(), back.rend());
  return out;
}

Corners comb(int teeth) {
  Corners corners = {{teeth + 0.5, -1.0, 0.0}, {0.0, -1.0, 0.0}};
  for (int i = 0; i < teeth; ++i) {
    corners.push_back({i + 0.1, 3.0, 0.0});
    corners.push_back({i + 0.5, 0.0, 0.0});
  }
  std::reverse(corners.begin(), corners.end());
  return corners;
}

// Triangles that all turn as the polygon does and have its area together overlap nowhere.
void expectCoversOnce(const Corners& corners) {
  const auto triangles = cutPolygon(corners);
  ASSERT_EQ(triangles.size(), corners.size() - 2);
  const Eigen::Vector3d whole = areaOf(corners), normal = whole.normalized();
  double sum = 0.0;
  for (const auto& t : triangles) {
    const double area = normal.dot(areaOf({corners[t[0]], corners[t[1]], corners[t[2]]}));
    EXPECT_GE(area, -1e-12);
    sum += area;
  }
  EXPECT_NEAR(sum, whole.norm(), 1e-9 * whole.norm());
}

// Sides that two triangles have run both ways; those of the polygon are left.
void expectSidesAreKept(const Corners& corners) {
  std::map<std::pair<int, int>, int> runs;
  for (const auto& t : cutPolygon(corners))
    for (int k = 0; k < 3; ++k) {
      const int from = t[k], to = t[(k + 1) % 3];
      if (runs[{to, from}] > 0) {
        --runs[{to, from}];
      } else {
        ++runs[{from, to}];
      }
    }
  const int count = static_cast<int>(corners.size());
  for (int i = 0; i < count; ++i) --runs[{i, (i + 1) % count}];
  for (const auto& [side, left] : runs) EXPECT_EQ(left, 0) << side.first << " " << side.second;
}

Corners placed(Generator& generator, Corners corners) {
  const Eigen::Quaterniond q(Eigen::Vector4d::NullaryExpr([&] { return drawn(generator, -1, 1); }));
  const Eigen::Vector3d at(drawn(generator, -9, 9), drawn(generator, -9, 9), 4.0);
  for (Eigen::Vector3d& p : corners) p = q.normalized() * p + at;
  return corners;
}

TEST(CutPolygon, CoversAnyThatDoesNotCrossItselfOnceInAnyPlaneEitherWayRound) {
  Generator generator(1);
  for (int trial = 0; trial < 300; ++trial) {
    SCOPED_TRACE(trial);
    Corners flat = trial % 3 == 0   ? star(generator, 4 + trial % 40)
                   : trial % 3 == 1 ? spiral(3 + trial % 30)
                                    : comb(1 + trial % 20);
    if (trial % 2) std::reverse(flat.begin(), flat.end());
    std::rotate(flat.begin(), flat.begin() + trial % static_cast<int>(flat.size()), flat.end());
    const Corners corners = placed(generator, flat);
    expectCoversOnce(corners);
    expectSidesAreKept(corners);
    if (testing::Test::HasFailure()) break;
  }
}

// Cutting a corner off that lies on a side of the rest would open a crack beside the next face.
TEST(CutPolygon, CornersOnALineStayCornersOfTriangles) {
  Generator generator(2);
  for (int trial = 0; trial < 100; ++trial) {
    Corners corners;
    const Corners outline =
        trial % 2 ? comb(1 + trial % 7) : Corners{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
    for (size_t i = 0; i < outline.size(); ++i) {
      const Eigen::Vector3d& next = outline[(i + 1) % outline.size()];
      const int pieces = 1 << (trial + i) % 3;
      for (int k = 0; k < pieces; ++k)
        corners.push_back(outline[i] + (next - outline[i]) * (static_cast<double>(k) / pieces));
    }
    SCOPED_TRACE(trial);
    expectCoversOnce(corners);
    expectSidesAreKept(corners);
    if (testing::Test::HasFailure()) break;
    // None without an area: it would be dropped, and its sides with it. Halves of the comb's sides
    // are rounded.
    if (trial % 2 != 0) continue;
    for (const auto& t : cutPolygon(corners)) {
      EXPECT_GT(areaOf({corners[t[0]], corners[t[1]], corners[t[2]]}).norm(), 0.1);
    }
  }
}

TEST(CutPolygon, OfOneThatCrossesItselfOrIsALineSidesAreKept) {
  Generator generator(3);
  for (int trial = 0; trial < 300; ++trial) {
    Corners corners;
    for (int i = 3 + trial % 12; i > 0; --i)
      corners.push_back({drawn(generator, -1, 1), trial % 5 ? drawn(generator, -1, 1) : 0.0,
                         trial % 3 ? drawn(generator, -1, 1) : 0.0});
    if (trial % 7 == 0) corners.push_back(corners.front());
    EXPECT_EQ(cutPolygon(corners).size(), corners.size() - 2);
    expectSidesAreKept(corners);
    if (testing::Test::HasFailure()) break;
  }
}

// As Assimp does, whose triangles walks have been planned on.
TEST(CutPolygon, AConvexOneIsAFanFromItsFirstCorner) {
  Corners corners;
  for (int i = 0; i < 9; ++i) corners.push_back({std::cos(0.69 * i), std::sin(0.69 * i), 1.0});
  for (const auto& t : cutPolygon(corners)) {
    EXPECT_EQ(std::count(t.begin(), t.end(), 0), 1);
    EXPECT_EQ(*std::max_element(t.begin(), t.end()) - 1,
              t[0] + t[1] + t[2] - *std::max_element(t.begin(), t.end()));
  }
}

}  // namespace
}  // namespace amble

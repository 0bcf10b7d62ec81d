#include "viz/figure/loft_surface.h"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/environments/test_meshes.h"
#include "tests/viz/figure/lofts.h"

namespace amble {
namespace {

using Eigen::Vector3d;

std::vector<LoftGroup> oneLoft(const Loft& loft) { return {{{loft}, 0.01, {}}}; }

Loft capsuleOf(const Vector3d& from, const Vector3d& to, double radius) {
  Loft loft;
  loft.a = {from, radius};
  loft.b = {to, radius};
  return loft;
}

double volumeOfCapsule(double length, double radius) {
  return std::numbers::pi * radius * radius * (length + 4.0 / 3.0 * radius);
}

TEST(LoftSurface, OfAnyLoftsIsClosedAndHasItsTrianglesOutwards) {
  Generator random(20);
  for (int round = 0; round < 12; ++round) {
    std::vector<LoftGroup> groups(2);
    for (LoftGroup& group : groups)
      for (int i = 0; i < 3; ++i) group.lofts.push_back(loftIn(random));
    const TriangleMesh mesh = loftSurface(groups, 0.02);
    EXPECT_TRUE(isWatertight(mesh));
    EXPECT_GT(volumeOf(mesh), 0.0);
    EXPECT_EQ(eulerNumber(mesh) % 2, 0);
  }
}

TEST(LoftSurface, EveryCornerIsOnTheSurface) {
  Generator random(21);
  for (int round = 0; round < 6; ++round) {
    const std::vector<LoftGroup> groups = oneLoft(loftIn(random));
    constexpr double kCell = 0.01;
    for (const Vector3d& p : loftSurface(groups, kCell).vertices)
      EXPECT_LT(std::abs(distanceTo(groups, p)), 0.2 * kCell);
  }
}

TEST(LoftSurface, HoldsTheVolumeOfACapsuleTheNearerTheFinerItIs) {
  const auto groups = oneLoft(capsuleOf({0, 0, 0}, {0.2, 0.1, 0.3}, 0.08));
  const double whole = volumeOfCapsule(Vector3d(0.2, 0.1, 0.3).norm(), 0.08);
  double before = 1.0;
  for (const double cell : {0.04, 0.02, 0.01}) {
    const double off = std::abs(volumeOf(loftSurface(groups, cell)) / whole - 1.0);
    EXPECT_LT(off, 0.5 * before);
    before = off;
  }
  EXPECT_LT(before, 0.02);
}

TEST(LoftSurface, OfOneBarIsASphereToTopologyOfTwoApartTwo) {
  const Loft one = capsuleOf({0, 0, 0}, {0.3, 0, 0}, 0.05);
  const Loft far = capsuleOf({0, 0.5, 0}, {0.3, 0.5, 0}, 0.05);
  const Loft crossing = capsuleOf({0.15, -0.2, 0}, {0.15, 0.2, 0}, 0.05);
  EXPECT_EQ(eulerNumber(loftSurface(oneLoft(one), 0.015)), 2);
  EXPECT_EQ(eulerNumber(loftSurface({{{one}, 0.01, {}}, {{far}, 0.01, {}}}, 0.015)), 4);
  EXPECT_EQ(eulerNumber(loftSurface({{{one}, 0.01, {}}, {{crossing}, 0.01, {}}}, 0.015)), 2);
}

// A ring of bars has a hole.
TEST(LoftSurface, ARingOfBarsIsATorus) {
  std::vector<LoftGroup> groups(1);
  constexpr int kBars = 8;
  const auto at = [](int i) {
    const double a = 2.0 * std::numbers::pi * i / kBars;
    return Vector3d(0.2 * std::cos(a), 0.2 * std::sin(a), 0.0);
  };
  for (int i = 0; i < kBars; ++i) groups[0].lofts.push_back(capsuleOf(at(i), at(i + 1), 0.04));
  EXPECT_EQ(eulerNumber(loftSurface(groups, 0.015)), 0);
}

TEST(LoftSurface, AFloorCutsItFlat) {
  std::vector<LoftGroup> groups = oneLoft(capsuleOf({0, 0, 0}, {0.3, 0, 0}, 0.06));
  groups[0].floor = {Vector3d::UnitZ(), -0.02};
  const TriangleMesh mesh = loftSurface(groups, 0.01);
  EXPECT_TRUE(isWatertight(mesh));
  EXPECT_NEAR(boundsOf(mesh).min().z(), -0.02, 0.001);
  EXPECT_NEAR(boundsOf(mesh).max().z(), 0.06, 0.002);
}

TEST(LoftSurface, TheSameLoftsGiveTheSameBytes) {
  Generator random(22);
  const std::vector<LoftGroup> groups = oneLoft(loftIn(random));
  const TriangleMesh a = loftSurface(groups, 0.02), b = loftSurface(groups, 0.02);
  EXPECT_EQ(a.vertices, b.vertices);
  EXPECT_EQ(a.triangles, b.triangles);
}

// A grid of so fine cells over so long a bar would fill the memory.
TEST(LoftSurface, OfAVeryLongBarIsCoarserButWhole) {
  const TriangleMesh mesh = loftSurface(oneLoft(capsuleOf({0, 0, 0}, {30, 30, 30}, 1.0)), 0.02);
  EXPECT_TRUE(isWatertight(mesh));
  EXPECT_LT(mesh.triangles.size(), 2'000'000u);
  EXPECT_NEAR(boundsOf(mesh).max().x(), 31.0, 0.2);
}

TEST(LoftSurface, OfNothingIsNothing) {
  EXPECT_TRUE(loftSurface({}, 0.02).triangles.empty());
  EXPECT_TRUE(loftSurface({LoftGroup{}}, 0.02).triangles.empty());
}

}  // namespace
}  // namespace amble

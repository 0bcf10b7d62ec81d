#include "viz/figure/loft.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "tests/viz/figure/lofts.h"

namespace amble {
namespace {

using Eigen::Vector3d;

std::vector<LoftGroup> someGroups(Generator& random, int groups, int lofts) {
  std::vector<LoftGroup> all(groups);
  for (LoftGroup& group : all) {
    group.blend = uniform(random, 0.01, 0.04);
    for (int i = 0; i < lofts; ++i) group.lofts.push_back(loftIn(random));
  }
  return all;
}

// Of a capsule the closed form: the distance to its axis, less its radius.
TEST(Loft, OfOneRadiusAndNoStraightPartsIsACapsule) {
  Generator random(1);
  for (int i = 0; i < 500; ++i) {
    Loft loft = loftIn(random);
    loft.b.radius = loft.a.radius;
    loft.a.half = loft.b.half = 0.0;
    const Vector3d p = randomVector(random, 0.8);
    double least = 1e9;  // to many points of the axis
    for (int k = 0; k <= 2000; ++k)
      least = std::min(least, (p - loft.a.at - k / 2000.0 * (loft.b.at - loft.a.at)).norm());
    const LoftDistance found = distanceTo(loft, p);
    EXPECT_NEAR(found.distance, least - loft.a.radius, 1e-4);
    EXPECT_GE(found.along, 0.0);
    EXPECT_LE(found.along, 1.0);
  }
}

TEST(Loft, MovesAndTurnsWithWhatItIsMadeOf) {
  Generator random(2);
  for (int i = 0; i < 200; ++i) {
    const Loft loft = loftIn(random);
    const Eigen::AngleAxisd turn(uniform(random, -3.0, 3.0), directionIn(random));
    const Vector3d shift = randomVector(random, 2.0), p = randomVector(random, 0.8);
    Loft moved = loft;
    moved.a.at = turn * loft.a.at + shift;
    moved.b.at = turn * loft.b.at + shift;
    moved.across = turn * loft.across;
    const LoftDistance a = distanceTo(loft, p), b = distanceTo(moved, turn * p + shift);
    EXPECT_NEAR(a.distance, b.distance, 1e-12);
    EXPECT_NEAR(a.along, b.along, 1e-12);
  }
}

TEST(Loft, IsTheSameFromItsOtherEnd) {
  Generator random(3);
  for (int i = 0; i < 200; ++i) {
    Loft loft = loftIn(random), other = loft;
    std::swap(other.a, other.b);
    other.across = -other.across;
    const Vector3d p = randomVector(random, 0.8);
    const LoftDistance a = distanceTo(loft, p), b = distanceTo(other, p);
    EXPECT_NEAR(a.distance, b.distance, 1e-12);
    EXPECT_NEAR(a.along, 1.0 - b.along, 1e-12);
  }
}

TEST(Loft, EndsAreWhereTheyAreSaidAndAsThick) {
  Generator random(4);
  for (int i = 0; i < 200; ++i) {
    const Loft loft = loftIn(random);
    const Vector3d out = (loft.a.at - loft.b.at).normalized();
    for (const double aside : {-1.0, 0.0, 1.0}) {
      const Vector3d rim = loft.a.at + aside * loft.a.half * loft.across + loft.a.radius * out;
      EXPECT_NEAR(distanceTo(loft, rim).distance, 0.0, 1e-12);
    }
    EXPECT_LT(distanceTo(loft, loft.a.at).distance, 0.0);
  }
}

TEST(Loft, OfNoLengthIsABall) {
  Loft ball;
  ball.a = ball.b = {{0.1, 0.2, 0.3}, 0.05};
  Generator random(5);
  for (int i = 0; i < 100; ++i) {
    const Vector3d p = randomVector(random, 0.8);
    EXPECT_NEAR(distanceTo(ball, p).distance, (p - ball.a.at).norm() - 0.05, 1e-12);
  }
}

TEST(SmoothUnion, IsAtMostTheLesserAndByAQuarterOfTheBlendAtMost) {
  Generator random(6);
  for (int i = 0; i < 2000; ++i) {
    const double a = uniform(random, -0.2, 0.2), b = uniform(random, -0.2, 0.2),
                 blend = uniform(random, 1e-4, 0.1);
    const double both = smoothUnion(a, b, blend), lesser = std::min(a, b);
    EXPECT_LE(both, lesser);
    EXPECT_GE(both, lesser - 0.25 * blend - 1e-15);
    EXPECT_EQ(both, smoothUnion(b, a, blend));
    if (std::abs(a - b) >= blend) {
      EXPECT_EQ(both, lesser);
    }
  }
  EXPECT_DOUBLE_EQ(smoothUnion(0.03, 0.03, 0.04), 0.02);
}

TEST(SmoothUnion, GrowsWithEitherAndNeverFaster) {
  Generator random(7);
  for (int i = 0; i < 2000; ++i) {
    const double a = uniform(random, -0.1, 0.1), b = uniform(random, -0.1, 0.1),
                 blend = uniform(random, 1e-3, 0.1), more = uniform(random, 0.0, 0.05);
    const double before = smoothUnion(a, b, blend), after = smoothUnion(a + more, b, blend);
    EXPECT_GE(after, before - 1e-15);
    EXPECT_LE(after, before + more + 1e-15);
  }
}

// Only lofts that come in are blended with those before them, so order is part of what is made; but
// groups apart are each themselves.
TEST(LoftGroups, NothingIsFartherThanItsNearestLoft) {
  Generator random(8);
  for (int round = 0; round < 40; ++round) {
    const std::vector<LoftGroup> groups = someGroups(random, 3, 3);
    for (int i = 0; i < 50; ++i) {
      const Vector3d p = randomVector(random, 0.8);
      double least = 1e9, blends = 0.0;
      for (const LoftGroup& group : groups) {
        blends += group.blend;
        for (const Loft& loft : group.lofts) {
          blends += loft.blend;
          least = std::min(least, distanceTo(loft, p).distance);
        }
      }
      EXPECT_LE(distanceTo(groups, p), least + 1e-15);
      EXPECT_GE(distanceTo(groups, p), least - 0.25 * blends - 1e-15);
    }
  }
}

TEST(LoftGroups, BelowAFloorThereIsNothingOfTheGroup) {
  Generator random(9);
  std::vector<LoftGroup> groups = someGroups(random, 1, 3);
  groups[0].floor = {Vector3d::UnitZ(), 0.02};
  for (int i = 0; i < 500; ++i) {
    const Vector3d p = randomVector(random, 0.6);
    if (p.z() < 0.02) {
      EXPECT_GE(distanceTo(groups, p), 0.02 - p.z() - 1e-15);
    }
    std::vector<LoftGroup> whole = groups;
    whole[0].floor.reset();
    EXPECT_GE(distanceTo(groups, p), distanceTo(whole, p));
  }
}

TEST(LoftsNear, WhatIsLeftOutChangesNothingInTheBall) {
  Generator random(10);
  int left_out = 0;
  for (int round = 0; round < 60; ++round) {
    const std::vector<LoftGroup> groups = someGroups(random, 5, 4);
    const Vector3d at = randomVector(random, 0.7);
    const double radius = uniform(random, 0.005, 0.06);
    const auto some = loftsNear(groups, at, radius, distanceTo(groups, at));
    size_t kept = 0;
    for (const LoftGroup& group : some) kept += group.lofts.size();
    left_out += kept < 20;
    for (int i = 0; i < 30; ++i) {
      const Vector3d p = at + uniform(random, 0.0, radius) * directionIn(random);
      EXPECT_NEAR(distanceTo(some, p), distanceTo(groups, p), 1e-12);
    }
  }
  EXPECT_GT(left_out, 30);
}

TEST(Outwards, IsTheWayInWhichTheDistanceGrowsFastest) {
  Generator random(11);
  for (int round = 0; round < 100; ++round) {
    const std::vector<LoftGroup> groups = someGroups(random, 2, 2);
    const Vector3d p = randomVector(random, 0.6), out = outwards(groups, p);
    EXPECT_NEAR(out.norm(), 1.0, 1e-12);
    constexpr double kStep = 1e-5;
    const double along = distanceTo(groups, p + kStep * out) - distanceTo(groups, p - kStep * out);
    for (int i = 0; i < 20; ++i) {
      const Vector3d other = directionIn(random);
      EXPECT_GE(along + 2e-7,
                distanceTo(groups, p + kStep * other) - distanceTo(groups, p - kStep * other));
    }
  }
}

TEST(Outwards, OfNothingIsUp) { EXPECT_EQ(outwards({}, {1, 2, 3}), Vector3d::UnitZ()); }

}  // namespace
}  // namespace amble

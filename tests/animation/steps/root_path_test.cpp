#include "animation/steps/root_path.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/rotation.h"
#include "tests/animation/random_clip.h"
#include "tests/animation/walk_paths.h"

namespace amble {
namespace {

Eigen::Vector2d pointOf(const Bezier& c, double u) {
  const double v = 1.0 - u;
  return v * v * v * c.col(0) + 3.0 * u * v * v * c.col(1) + 3.0 * u * u * v * c.col(2) +
         u * u * u * c.col(3);
}

/// Largest |curvature| on samples every 2 cm or finer [1/m].
double largestCurvature(const RootPath& path) {
  double largest = 0.0;
  const int count = std::max(1, static_cast<int>(std::ceil(path.length() / 0.02)));
  for (int i = 0; i <= count; ++i) {
    largest = std::max(largest, std::abs(path.at(path.length() * i / count).curvature));
  }
  return largest;
}

double polylineLength(const Bezier& c, int segments) {
  double length = 0.0;
  for (int i = 0; i < segments; ++i) {
    length += (pointOf(c, (i + 1.0) / segments) - pointOf(c, 1.0 * i / segments)).norm();
  }
  return length;
}

/// A curve as walks are planned: its ends face within 100 degrees of the way from one to the other.
Bezier randomBezier(Generator& generator, const Eigen::Vector2d& from, double* heading) {
  const double way = uniform(generator, -kPi, kPi), size = uniform(generator, 0.5, 6.0);
  const Eigen::Vector2d to = from + size * Eigen::Vector2d(std::cos(way), std::sin(way));
  const double first =
      heading != nullptr ? *heading : way + uniform(generator, -100, 100) * kDegree;
  const double last = way + uniform(generator, -100, 100) * kDegree;
  if (heading != nullptr) *heading = last;
  return makeBezier(from, first, to, last, uniform(generator, 0.3, 0.7));
}

TEST(RootPath, ArcLengthIsThatOfAFinePolyline) {
  Generator generator(31);
  for (int i = 0; i < 30; ++i) {
    const Bezier curve = randomBezier(generator, Eigen::Vector2d(1, -2), nullptr);
    // Chords fall short by the square of their length: two polylines cancel that.
    const double length = (4.0 * polylineLength(curve, 8000) - polylineLength(curve, 4000)) / 3.0;
    EXPECT_NEAR(RootPath({curve}).length(), length, 1e-9 * length);
  }
}

TEST(RootPath, WalkedTheOtherWayIsAsLongAndBendsTheOtherWay) {
  Generator generator(31);
  for (int k = 0; k < 50; ++k) {
    const Bezier there = randomBezier(generator, {1.0, -2.0}, nullptr);
    const Bezier back = there.rowwise().reverse();
    const RootPath a({there}), b({back});
    ASSERT_NEAR(a.length(), b.length(), 1e-6 * a.length());
    for (const double share : {0.1, 0.35, 0.5, 0.8}) {
      const RootPath::Sample here = a.at(share * a.length()),
                             same = b.at((1.0 - share) * b.length());
      EXPECT_LT((here.position - same.position).norm(), 1e-5);
      EXPECT_NEAR(std::cos(here.heading - same.heading), -1.0, 1e-6);
      EXPECT_NEAR(here.curvature, -same.curvature, 1e-3 * std::max(1.0, std::abs(here.curvature)));
    }
  }
}

TEST(RootPath, EndsAreTheControlPointsAndHeadingsThatWereGiven) {
  Generator generator(32);
  for (int i = 0; i < 30; ++i) {
    const Eigen::Vector2d from(uniform(generator, -9, 9), uniform(generator, -9, 9));
    const Eigen::Vector2d to(uniform(generator, -9, 9), uniform(generator, -9, 9));
    const double a = uniform(generator, -kPi, kPi), b = uniform(generator, -kPi, kPi);
    const RootPath path({makeBezier(from, a, to, b)});
    EXPECT_EQ(path.at(0.0).position, from);
    EXPECT_EQ(path.at(path.length()).position, to);
    EXPECT_NEAR(wrapAngle(path.at(0.0).heading - a), 0.0, 1e-12);
    EXPECT_NEAR(wrapAngle(path.at(path.length()).heading - b), 0.0, 1e-12);
  }
}

TEST(RootPath, PlacesBeyondTheEndsAreTheEnds) {
  const RootPath path({makeBezier({0, 0}, 0.3, {2, 1}, -0.4)});
  EXPECT_EQ(path.at(-1.0).position, path.at(0.0).position);
  EXPECT_EQ(path.at(path.length() + 1.0).position, path.at(path.length()).position);
}

TEST(RootPath, PositionMovesByTheHeadingsUnitVectorAndHeadingByTheCurvature) {
  Generator generator(33);
  constexpr double h = 1e-5;
  for (int i = 0; i < 20; ++i) {
    const RootPath path({randomBezier(generator, Eigen::Vector2d::Zero(), nullptr)});
    for (int k = 1; k < 60; ++k) {
      const double s = path.length() * k / 60.0;
      const RootPath::Sample here = path.at(s), before = path.at(s - h), after = path.at(s + h);
      const Eigen::Vector2d moved = (after.position - before.position) / (2.0 * h);
      const Eigen::Vector2d along(std::cos(here.heading), std::sin(here.heading));
      EXPECT_LT((moved - along).norm(), 1e-7);
      EXPECT_NEAR((after.heading - before.heading) / (2.0 * h), here.curvature, 1e-5);
    }
  }
}

TEST(RootPath, SamplesAtEqualArcsAreEquallySpaced) {
  Generator generator(34);
  for (int i = 0; i < 20; ++i) {
    const RootPath path({randomBezier(generator, Eigen::Vector2d::Zero(), nullptr)});
    constexpr int kSamples = 2000;
    const double step = path.length() / kSamples, bend = step * largestCurvature(path);
    for (int k = 0; k < kSamples; ++k) {
      const double chord = (path.at((k + 1) * step).position - path.at(k * step).position).norm();
      // A table's error goes up and down within a piece: its slope is a few times as large.
      EXPECT_LE(chord, step * (1.0 + 10.0 * RootPath::kTableError));
      EXPECT_GE(chord, step * (1.0 - bend * bend / 20.0 - 10.0 * RootPath::kTableError));
    }
  }
}

TEST(RootPath, CurvatureAskedAloneIsThatOfTheSample) {
  Generator generator(35);
  const RootPath path({randomBezier(generator, Eigen::Vector2d::Zero(), nullptr)});
  for (double s = -0.1; s < path.length() + 0.1; s += 0.01)
    EXPECT_EQ(path.curvatureAt(s), path.at(s).curvature);
}

// Where a handle nearly vanishes the curve's parameter rushes at its end, and no table holds it.
TEST(RootPath, ArcsAreWalkedEvenlyThoughAHandleNearlyVanishes) {
  for (const double handle : {1e-3, 0.02, 0.1, 2.0}) {
    const RootPath path({makeBezier({0, 0}, 1.2, {2, 1}, -0.8, handle)});
    double walked = 0.0;
    constexpr int kSamples = 20000;
    for (int k = 0; k < kSamples; ++k)
      walked += (path.at(path.length() * (k + 1) / kSamples).position -
                 path.at(path.length() * k / kSamples).position)
                    .norm();
    EXPECT_NEAR(walked, path.length(), 1e-4) << handle;
    const double half = path.length() / 2.0, h = 1e-5;
    EXPECT_NEAR((path.at(half + h).position - path.at(half - h).position).norm(), 2.0 * h, 1e-9);
  }
}

TEST(RootPath, HeadingDoesNotJumpWhereTheAngleWraps) {
  for (const double angle : {2.0 * kPi, -2.0 * kPi}) {
    const RootPath path = circlePath(1.5, angle, 2.0);
    EXPECT_NEAR(path.at(path.length()).heading - path.at(0.0).heading, angle, 1e-9);
    double before = path.at(0.0).heading;
    for (int k = 1; k <= 500; ++k) {
      const double heading = path.at(path.length() * k / 500.0).heading;
      EXPECT_NEAR(heading - before, angle / 500.0, 1e-5);
      before = heading;
    }
  }
}

TEST(RootPath, CurvatureOfACircleIsOneOverItsRadiusLeftPositive) {
  for (const double radius : {0.4, 1.0, 5.0}) {
    const RootPath left = circlePath(radius, 2.0, 0.3), right = circlePath(-radius, -2.0, 0.3);
    EXPECT_NEAR(left.length(), 2.0 * radius, 1e-6);
    for (int k = 0; k <= 100; ++k) {
      EXPECT_NEAR(left.at(left.length() * k / 100.0).curvature * radius, 1.0, 1e-4);
      EXPECT_NEAR(right.at(right.length() * k / 100.0).curvature * radius, -1.0, 1e-4);
    }
    EXPECT_NEAR(largestCurvature(left) * radius, 1.0, 1e-4);
    EXPECT_NEAR(largestCurvature(right) * radius, 1.0, 1e-4);
  }
}

TEST(RootPath, AnAppendedPathGoesOnWhereTheFirstEnds) {
  Generator generator(35);
  double heading = 3.0;
  const RootPath first({randomBezier(generator, Eigen::Vector2d::Zero(), &heading)});
  const RootPath next({randomBezier(generator, first.curves()[0].col(3), &heading)});
  RootPath both = first;
  both.append(next);
  EXPECT_NEAR(both.length(), first.length() + next.length(), 1e-12);
  for (int k = 0; k <= 50; ++k) {
    const double s = next.length() * k / 50.0;
    EXPECT_LT((both.at(first.length() + s).position - next.at(s).position).norm(), 1e-9);
    EXPECT_NEAR(wrapAngle(both.at(first.length() + s).heading - next.at(s).heading), 0.0, 1e-9);
  }
  EXPECT_NEAR(both.at(first.length() - 1e-9).heading, both.at(first.length() + 1e-9).heading, 1e-6);
}

TEST(RootPath, ItsExtentIsTheLeastBoxAroundFineSamples) {
  constexpr int kSamples = 20000;
  Generator generator(34);
  for (int i = 0; i < 30; ++i) {
    const Bezier one = randomBezier(generator, Eigen::Vector2d(1, -2), nullptr);
    const Bezier two = randomBezier(generator, one.col(3), nullptr);
    Eigen::AlignedBox2d sampled;
    for (const Bezier& curve : {one, two}) {
      for (int k = 0; k <= kSamples; ++k) sampled.extend(pointOf(curve, 1.0 * k / kSamples));
    }
    const Eigen::AlignedBox2d box = RootPath({one, two}).extent();
    EXPECT_TRUE((box.min().array() <= sampled.min().array() + 1e-12).all());
    EXPECT_TRUE((box.max().array() >= sampled.max().array() - 1e-12).all());
    EXPECT_LT((box.sizes() - sampled.sizes()).maxCoeff(), 1e-6);
  }
  EXPECT_TRUE(RootPath().extent().isEmpty());
}

TEST(RootPath, AStraightLineHasNoCurvature) {
  const RootPath path({makeBezier({1, 1}, kPi / 4, {4, 4}, kPi / 4)});
  EXPECT_NEAR(path.length(), std::sqrt(18.0), 1e-12);
  EXPECT_LT(largestCurvature(path), 1e-12);
}

TEST(RootPath, AnEmptyPathAndAPointHaveNoLength) {
  EXPECT_TRUE(RootPath().empty());
  EXPECT_EQ(RootPath().length(), 0.0);
  EXPECT_EQ(RootPath().at(1.0).position, Eigen::Vector2d::Zero());
  const RootPath point({makeBezier({2, 3}, 1.0, {2, 3}, 1.0)});
  EXPECT_EQ(point.length(), 0.0);
  EXPECT_EQ(point.at(0.0).position, Eigen::Vector2d(2, 3));
  EXPECT_EQ(largestCurvature(point), 0.0);
}

}  // namespace
}  // namespace amble

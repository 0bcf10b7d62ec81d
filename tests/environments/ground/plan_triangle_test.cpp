#include "environments/ground/plan_triangle.h"

#include <gtest/gtest.h>

#include "base/sample_stream.h"
#include "tests/environments/random_scenes.h"

namespace amble {
namespace {

const Eigen::AlignedBox3d kRoom(Eigen::Vector3d(-0.2, -0.2, 0.0), Eigen::Vector3d(0.2, 0.2, 0.3));

Eigen::Vector2d pointIn(SampleStream& random, const Eigen::AlignedBox2d& box) {
  return {random.uniform(box.min().x(), box.max().x()),
          random.uniform(box.min().y(), box.max().y())};
}

Eigen::AlignedBox2d drawnBox(SampleStream& random) {
  const Eigen::Vector2d low = pointIn(random, {kRoom.min().head<2>(), kRoom.max().head<2>()});
  return {low, low + Eigen::Vector2d::Constant(random.uniform(1e-4, 0.1))};
}

// Every fourth a sliver, every eighth upright.
Triangle3 drawnTriangle(SampleStream& random, int n) {
  Triangle3 t;
  for (Eigen::Vector3d& corner : t) corner = drawnPoint(random, kRoom);
  if (n % 4 == 0)
    t[2] = t[0] + random.uniform(0.0, 1.0) * (t[1] - t[0]) + drawnVector(random, 2e-4);
  if (n % 8 == 0) t[2].head<2>() = t[0].head<2>();
  return t;
}

TEST(PlanTriangle, HoldsOnlyWhatItHasAHeightOver) {
  SampleStream random(1, 0);
  int held = 0;
  for (int n = 0; n < 20000; ++n) {
    const Triangle3 t = drawnTriangle(random, n);
    const double a = random.uniform(-0.1, 1.1), b = random.uniform(-0.1, 1.1);
    const Eigen::Vector3d p = t[0] + a * (t[1] - t[0]) + b * (t[2] - t[0]);
    if (!PlanTriangle(t).holds(p.head<2>())) continue;
    ++held;
    EXPECT_TRUE(heightOver(t, p.x(), p.y())) << n;
  }
  EXPECT_GT(held, 4000);
}

TEST(PlanTriangle, HoldsItsCornersAndTheMiddlesOfItsSides) {
  SampleStream random(2, 0);
  for (int n = 1; n < 4000; n += 4) {
    const Triangle3 t = drawnTriangle(random, n);
    const PlanTriangle seen(t);
    for (int k = 0; k < 3; ++k) {
      EXPECT_TRUE(seen.holds(t[k].head<2>())) << n;
      EXPECT_TRUE(seen.holds(0.5 * (t[k] + t[(k + 1) % 3]).head<2>())) << n;
    }
  }
}

TEST(PlanTriangle, MayMeetEveryBoxOverWhichItHasAHeightOrAPart) {
  SampleStream random(3, 0);
  int apart = 0;
  for (int n = 0; n < 20000; ++n) {
    const Triangle3 t = drawnTriangle(random, n);
    const Eigen::AlignedBox2d box = drawnBox(random);
    if (PlanTriangle(t).mayMeet(box)) continue;
    ++apart;
    EXPECT_FALSE(heightsWithin(t, box)) << n;
    for (int k = 0; k < 10; ++k) {
      const Eigen::Vector2d p = pointIn(random, box);
      EXPECT_FALSE(heightOver(t, p.x(), p.y())) << n;
    }
    for (const Eigen::Vector2d& p : cornersOf(box)) EXPECT_FALSE(heightOver(t, p.x(), p.y())) << n;
  }
  EXPECT_GT(apart, 5000);
}

TEST(PlanTriangle, TwoThatHoldABoxTogetherLeaveNoPointOfItOut) {
  SampleStream random(4, 0);
  int held = 0;
  for (int n = 0; n < 20000; ++n) {
    const Eigen::Vector3d p = drawnPoint(random, kRoom), q = drawnPoint(random, kRoom);
    const Triangle3 a = {p, q, drawnPoint(random, kRoom)}, b = {drawnPoint(random, kRoom), p, q};
    const Eigen::AlignedBox2d box = drawnBox(random);
    const PlanTriangle one(a), other(b);
    EXPECT_EQ(one.holdsWith(other, cornersOf(box)), other.holdsWith(one, cornersOf(box))) << n;
    if (!one.holdsWith(other, cornersOf(box))) continue;
    ++held;
    for (int k = 0; k < 20; ++k) {
      const Eigen::Vector2d at = pointIn(random, box);
      EXPECT_TRUE(heightOver(a, at.x(), at.y()) || heightOver(b, at.x(), at.y())) << n;
    }
  }
  EXPECT_GT(held, 200);
}

TEST(PlanTriangle, HalvesOfARectangleHoldABoxAcrossItsDiagonal) {
  const Eigen::Vector3d p(0, 0, 0), q(1, 0, 0), r(1, 0.3, 0), s(0, 0.3, 0);
  const PlanTriangle low({p, q, r}), high({p, r, s}), far({q, r, Eigen::Vector3d(2, 0, 0)});
  const BoxCorners across = cornersOf({Eigen::Vector2d(0.45, 0.1), Eigen::Vector2d(0.55, 0.2)});
  EXPECT_TRUE(low.holdsWith(high, across));
  EXPECT_TRUE(high.holdsWith(low, across));
  EXPECT_FALSE(low.holdsWith(low, across));   // on the same side
  EXPECT_FALSE(high.holdsWith(far, across));  // share a corner only
  EXPECT_FALSE(low.holdsWith(far, across));   // beside it
  // A corner on the diagonal counts for both.
  EXPECT_TRUE(
      low.holdsWith(high, cornersOf({Eigen::Vector2d(0.5, 0.15), Eigen::Vector2d(0.6, 0.2)})));
}

}  // namespace
}  // namespace amble

#include "animation/editing/walk_path.h"

#include <gtest/gtest.h>

#include <cmath>

#include "animation/editing/foot_prints.h"
#include "base/rotation.h"
#include "tests/animation/rig.h"

namespace amble {
namespace {

constexpr double kFrame = 0.01;

/// Three quarters of a circle to the left in six seconds.
std::vector<Eigen::Vector3d> circle(double radius) {
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i <= 600; ++i) {
    const double angle = 1.5 * kPi * i / 600.0;
    points.emplace_back(radius * std::sin(angle), radius * (1.0 - std::cos(angle)), 0.9);
  }
  return points;
}

TEST(WalkPath, ScalingAPathKeepsItsShapeAndItsBegin) {
  const WalkPath path(circle(2.0), kFrame);
  const auto shifts = path.scaled([](double) { return 1.3; });
  for (int i = 0; i < path.frames(); i += 50) {
    EXPECT_LT((path.at(i) + shifts[i] - path.at(0) - 1.3 * (path.at(i) - path.at(0))).norm(), 1e-9);
  }
}

TEST(WalkPath, IsPassedWhereItIsNearest) {
  const WalkPath path(circle(2.0), kFrame);
  for (const double angle : {1.0, 2.0, 3.0}) {
    const Eigen::Vector2d beside(2.3 * std::sin(angle), 2.0 - 2.3 * std::cos(angle));
    const double frame = angle / (1.5 * kPi) * 600.0;
    EXPECT_NEAR(path.passing(beside, static_cast<int>(frame) - 10, static_cast<int>(frame) + 10),
                frame, 1.0);
  }
}

TEST(WalkPath, GoesStraightOnBeyondItsEnds) {
  std::vector<Eigen::Vector3d> line;
  for (int i = 0; i <= 200; ++i) line.emplace_back(0.012 * i, 0.0, 0.9);
  const WalkPath path(line, kFrame);
  EXPECT_NEAR(path.passing({-0.3, 0.1}, 0, 20), -25.0, 1e-6);
  EXPECT_NEAR(path.passing({2.7, 0.1}, 190, 200), 225.0, 1e-6);
  const auto shifts = path.scaled([](double) { return 1.5; });
  EXPECT_NEAR(path.between(shifts, 225.0).x(), 0.5 * 2.7, 1e-9);
  EXPECT_NEAR(path.between(shifts, -25.0).x(), -0.5 * 0.3, 1e-9);
}

TEST(FootPrints, AFootIsOnItsWayByWhatItsToeHasGone) {
  const Puppet puppet;
  const Rig rig;
  const CapturedWalk walk = captureWalk(rig.walk(puppet), rig.roles);
  const WalkTracks tracks = tracksOf(walk.clip, walk.roles);
  const FootPrints prints = footPrints(walk, tracks);
  const FootTrack& foot = tracks.feet[kLeft];
  ASSERT_GE(prints[kLeft].size(), 4U);
  const FootPrint &from = prints[kLeft][1], &to = prints[kLeft][2];
  EXPECT_EQ(from.in_air, false);
  EXPECT_NEAR((to.at - from.at).x(), puppet.speed * puppet.period, 1e-3);
  double last = 0.0;
  for (int i = from.middle; i <= to.middle; ++i) {
    const PrintPair pair = printsAt(prints[kLeft], i);
    if (i < to.middle) {
      EXPECT_EQ(&pair.from, &from);
      EXPECT_EQ(&pair.to, &to);
    }
    const double share = progress({from, to}, foot, i);
    EXPECT_NEAR(foot.toe[i].x(), from.toe.x() + share * (to.toe - from.toe).x(), 1e-9);
    EXPECT_GE(share, last - 1e-6);
    last = share;
  }
  EXPECT_NEAR(last, 1.0, 1e-9);
}

TEST(FootPrints, AFootThatIsPutDownWhereItWasGoesByTime) {
  FootPrint from, to;
  from.last = from.middle = 10;
  to.first = to.middle = 30;
  from.toe = to.toe = Eigen::Vector2d(1.0, 0.0);
  FootTrack foot;
  foot.toe.assign(40, Eigen::Vector3d(1.0, 0.0, 0.1));
  EXPECT_EQ(progress({from, to}, foot, 10), 0.0);
  EXPECT_NEAR(progress({from, to}, foot, 20), 0.5, 1e-12);
  EXPECT_EQ(progress({from, to}, foot, 30), 1.0);
}

}  // namespace
}  // namespace amble

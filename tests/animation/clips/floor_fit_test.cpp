#include "animation/clips/floor_fit.h"

#include <gtest/gtest.h>

#include "base/rotation.h"
#include "tests/animation/moved_clip.h"
#include "tests/animation/random_clip.h"
#include "tests/animation/rig.h"

namespace amble {
namespace {

TEST(FloorFit, ALevelFloorIsFoundLevelAtTheAnklesHeight) {
  const Rig rig;
  const FloorFit fit = fitFloor(rig.walk(onACircle()), rig.roles);
  EXPECT_LT((fit.normal - Eigen::Vector3d::UnitZ()).norm(), 1e-4);
  EXPECT_NEAR(fit.height, Puppet::kAnkle, 1e-4);
  EXPECT_LT(fit.residual, 1e-3);
  EXPECT_GT(fit.samples, 500);  // ten seconds at 100 Hz, each foot more than half of them
}

TEST(FloorFit, ATiltedFloorIsFoundWhereTheFeetSpread) {
  const Rig rig;
  const Eigen::Quaterniond tilt(
      Eigen::AngleAxisd(2.0 * kDegree, Eigen::Vector3d(1, 2, 0).normalized()));
  const Clip clip = moved(rig.walk(onACircle()), tilt, {0.5, -1.0, 0.3});
  const FloorFit fit = fitFloor(clip, rig.roles);
  const double angle = std::acos(std::min(1.0, fit.normal.dot(tilt * Eigen::Vector3d::UnitZ())));
  EXPECT_LT(angle, 0.1 * kDegree);  // held towards level by a few percent
}

TEST(FloorFit, ARampIsNoTiltOfTheCapture) {
  const Rig rig;
  for (const double degrees : {2.0, 5.0}) {
    const Eigen::Quaterniond tilt(Eigen::AngleAxisd(degrees * kDegree, Eigen::Vector3d::UnitY()));
    const FloorFit fit = fitFloor(moved(rig.walk(onACircle()), tilt, {0, 0, 0}), rig.roles);
    EXPECT_NEAR(fit.tilt(), degrees * kDegree, 0.2 * kDegree);
    EXPECT_EQ(doubtOf(fit).empty(), degrees < 3.0) << doubtOf(fit);
    EXPECT_EQ(levelPlane(fit).normal, Eigen::Vector3d::UnitZ());
  }
}

TEST(FloorFit, OneOrTwoPlantsSpanNoFloor) {
  FloorFit fit;
  fit.normal = Eigen::Vector3d(0.04, 0.0, 1.0).normalized();
  fit.plants = 2;
  EXPECT_NE(doubtOf(fit).find("from 2 places where a foot stood"), std::string::npos);
  fit.plants = 3;
  EXPECT_EQ(doubtOf(fit), "");
  const Rig rig;
  EXPECT_GT(fitFloor(rig.walk(onACircle()), rig.roles).plants, 10);
}

TEST(FloorFit, ALevelledClipStandsAtItsAnkleHeightWithItsFloorLevel) {
  const Rig rig;
  const Eigen::Quaterniond tilt(Eigen::AngleAxisd(1.5 * kDegree, Eigen::Vector3d::UnitY()));
  const Clip clip = moved(rig.walk(onACircle()), tilt, {0, 0, -0.4});
  const Clip level = levelClip(clip, fitFloor(clip, rig.roles), 0.11);
  const FloorFit again = fitFloor(level, rig.roles);
  EXPECT_LT((again.normal - Eigen::Vector3d::UnitZ()).norm(), 0.1 * kDegree);
  EXPECT_NEAR(again.height, 0.11, 1e-3);
}

TEST(FloorFit, AStraightWalkSaysNothingOfTheTiltAcrossIt) {
  const Rig rig;
  const Eigen::Quaterniond across(Eigen::AngleAxisd(3.0 * kDegree, Eigen::Vector3d::UnitX()));
  const FloorFit fit = fitFloor(moved(rig.walk(Puppet()), across, {0, 0, 0}), rig.roles);
  EXPECT_LT(std::abs(fit.normal.y()), 0.75 * std::sin(3.0 * kDegree));  // held towards level
}

TEST(FloorFit, TiltAcrossAStraightWalkCanBeIgnoredAndAllElseIsTaken) {
  const Rig rig;
  const Eigen::Quaterniond along(Eigen::AngleAxisd(2.0 * kDegree, Eigen::Vector3d::UnitY()));
  const Eigen::Quaterniond across(Eigen::AngleAxisd(2.0 * kDegree, Eigen::Vector3d::UnitX()));
  const auto fit = [&](const Clip& clip) {
    return fitFloor(clip, rig.roles, TiltAcross::kIgnored);
  };
  const Clip straight = rig.walk(Puppet());
  EXPECT_LT(std::abs(fit(moved(straight, across, {0, 0, 0})).normal.y()), 1e-4);
  const Clip clips[] = {moved(straight, along, {1.0, 2.0, 0.3}),
                        moved(rig.walk(onACircle()), across, {1.0, 2.0, 0.3})};
  for (const Clip& clip : clips) {
    const FloorFit tilted = fit(clip);
    EXPECT_NEAR(tilted.tilt(), 2.0 * kDegree, 0.02 * kDegree);
    const FloorFit level = fit(levelClip(clip, tilted, 0.11));
    EXPECT_LT(level.tilt(), 1e-3 * kDegree);
    EXPECT_NEAR(level.height, 0.11, 1e-6);
  }
}

TEST(FloorFit, WithoutStandingFeetTheFloorIsLevelUnderTheLowestAnkle) {
  const Rig rig;
  Clip clip = rig.walk(Puppet());
  for (int i = 0; i < clip.frames(); ++i) {  // slides all the time, and faster than its feet swing
    clip.poses.p_WR(i) += Eigen::Vector3d(-8.0 * i * clip.frame_time, 0, 0.5);
  }
  const FloorFit fit = fitFloor(clip, rig.roles);
  EXPECT_EQ(fit.samples, 0);
  EXPECT_EQ(fit.normal, Eigen::Vector3d::UnitZ());
  EXPECT_NEAR(fit.height, Puppet::kAnkle + 0.5, 2e-3);
}

}  // namespace
}  // namespace amble

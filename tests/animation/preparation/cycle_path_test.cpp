#include "animation/preparation/cycle_path.h"

#include <gtest/gtest.h>

#include "base/rotation.h"
#include "tests/animation/level_walk.h"
#include "tests/animation/moved_clip.h"
#include "tests/animation/random_clip.h"
#include "tests/animation/rig.h"

namespace amble {
namespace {

constexpr int kPhases = 64;

FittedPath randomPath(Generator& generator) {
  return {randomVector(generator, 5.0).head<2>(), uniform(generator, -kPi, kPi),
          uniform(generator, 0.3, 3.0), uniform(generator, -2.0, 2.0)};
}

Eigen::Vector2d along(double heading) { return {std::cos(heading), std::sin(heading)}; }

TEST(FittedPath, GoesAtItsHeadingAndAtOneSpeed) {
  Generator generator(1);
  constexpr double kStep = 1e-5;
  for (int trial = 0; trial < 100; ++trial) {
    const FittedPath path = randomPath(generator);
    const double u = uniform(generator, -1.0, 2.0);
    const Eigen::Vector2d way = (path.at(u + kStep) - path.at(u - kStep)) / (2.0 * kStep);
    EXPECT_LT((way - path.length * along(path.headingAt(u))).norm(), 1e-8);
  }
}

TEST(FittedPath, OfAlmostNoTurnIsTheLine) {
  Generator generator(2);
  for (const double turn : {1e-7, -1e-7, 1e-9, 0.0}) {
    FittedPath path = randomPath(generator);
    path.turn = turn;
    for (const double u : {-1.0, 0.0, 0.5, 1.0}) {
      const Eigen::Vector2d line = path.start + u * path.length * along(path.heading);
      EXPECT_LT((path.at(u) - line).norm(), 1e-6);
    }
  }
}

TEST(FittedPath, WhatIsSeenFromItIsWhereItWasPut) {
  Generator generator(3);
  for (int trial = 0; trial < 100; ++trial) {
    const FittedPath path = randomPath(generator);
    const double u = uniform(generator, -1.0, 2.0);
    const Eigen::Vector2d wanted = randomVector(generator, 1.0).head<2>();
    const Eigen::Vector2d there =
        path.at(u) + Eigen::Rotation2Dd(path.headingAt(u)).toRotationMatrix() * wanted;
    EXPECT_LT((path.seen(there, u) - wanted).norm(), 1e-12);
  }
}

// On a circle whose centre is told by radius and turn.
TEST(FittedPath, OfATurnStaysAsFarFromItsCentre) {
  Generator generator(4);
  for (int trial = 0; trial < 50; ++trial) {
    const FittedPath path = randomPath(generator);
    const double radius = path.length / path.turn;
    const Eigen::Vector2d centre = path.start + radius * along(path.heading + 0.5 * kPi);
    for (double u = 0.0; u <= 1.0; u += 0.125) {
      EXPECT_NEAR((path.at(u) - centre).norm(), std::abs(radius), 1e-9 * (1.0 + std::abs(radius)));
    }
  }
}

/// A drawn walk on a line or a circle, and a stretch of it that is a cycle.
struct DrawnStretch {
  Rig rig;
  Puppet puppet;
  Clip clip;
  GaitTrack track{clip, rig.roles, rig.feet};
  Stretch stretch;

  explicit DrawnStretch(const Puppet& the_puppet) : puppet(the_puppet), clip(rig.walk(puppet)) {
    const double begin = 1.06 * puppet.period * puppet.rate, cycle = puppet.period * puppet.rate;
    stretch = {begin, begin + 0.5 * cycle, begin + cycle, kLeft, 0.0, 0.0, puppet.speed, 0.0};
    stretch.turn = puppet.turn_rate * puppet.period;
  }
};

class DrawnPaths : public testing::TestWithParam<double> {};

TEST_P(DrawnPaths, AreFoundAgain) {
  Puppet puppet;
  puppet.turn_rate = GetParam();
  const DrawnStretch drawn(puppet);
  const FittedPath path = fitPath(drawn.track, drawn.stretch, GetParam() != 0.0, kPhases);
  const double time = drawn.stretch.begin * drawn.clip.frame_time;
  EXPECT_NEAR(path.length, puppet.speed * puppet.period, 1e-4);
  EXPECT_NEAR(wrapAngle(path.heading - puppet.heading(time)), 0.0, 1e-4);
  for (double u = 0.0; u <= 1.0; u += 0.1) {
    const Eigen::Vector2d wanted = puppet.pelvis(time + u * puppet.period).head<2>();
    EXPECT_LT((path.at(u) - wanted).norm(), 1e-4) << u;
  }
}

// Of a drawn cycle nothing is left between its ends: the channels are the drawing's.
TEST_P(DrawnPaths, LeaveOfADrawnWalkWhatItDoesBesideThem) {
  Puppet puppet;
  puppet.turn_rate = GetParam();
  const DrawnStretch drawn(puppet);
  const FittedPath path = fitPath(drawn.track, drawn.stretch, GetParam() != 0.0, kPhases);
  const Eigen::MatrixXd samples =
      closedSamples(drawn.track, drawn.stretch, path, drawn.rig.reference(), kPhases);
  ASSERT_EQ(samples.cols(), kPhases);
  ASSERT_EQ(samples.rows(), 3 + 3 * drawn.rig.skeleton.size());
  const double begin = drawn.stretch.begin * drawn.clip.frame_time;
  for (int i = 0; i < kPhases; ++i) {
    const double turn = 2.0 * kPi * (begin / puppet.period + static_cast<double>(i) / kPhases);
    EXPECT_LT(samples.col(i).head<2>().norm(), 1e-4);
    EXPECT_NEAR(samples(2, i), Puppet::kHip + Rig::kBob * std::cos(2.0 * turn), 1e-4);
    EXPECT_LT(samples.col(i).segment<3>(3).norm(), 1e-4);  // the root heads along the path
    const Eigen::Vector3d chest = samples.col(i).segment<3>(3 + 3 * drawn.rig.roles.chest);
    EXPECT_LT((chest - Eigen::Vector3d(0, Rig::kChestSwing * std::sin(turn), 0)).norm(), 1e-3);
  }
}

INSTANTIATE_TEST_SUITE_P(, DrawnPaths, testing::Values(0.0, 0.5, -0.8));

class CapturedPaths : public testing::Test {
 protected:
  void SetUp() override { AMBLE_NEEDS_CAPTURES(); }
};

TEST_F(CapturedPaths, OfALineHaveTheRootNeitherLeftNorRightOfThemOnTheMean) {
  const LevelWalk walk("cmu_mb2/07_01.bvh");
  for (const Stretch& stretch : wholeCycles(walk.track, {"walk", false, 0, {}})) {
    const FittedPath path = fitPath(walk.track, stretch, false, kPhases);
    double left = 0.0;
    for (int i = 0; i < kPhases; ++i) {
      const double u = static_cast<double>(i) / kPhases;
      const Eigen::Vector3d root = walk.track.jointsAt(frameAt(stretch, u))[0].p_WJ;
      left += path.seen(root.head<2>(), u).y() / kPhases;
    }
    EXPECT_NEAR(left, 0.0, 1e-12);
    EXPECT_EQ(path.turn, 0.0);
  }
}

// From end to end the root goes as far as the path, in the same direction: nothing is left to
// spread.
TEST_F(CapturedPaths, HaveTheRootAsFarBesideTheirEndAsBesideTheirBegin) {
  const LevelWalk walk("cmu_mb2/07_01.bvh");
  for (const Stretch& stretch : wholeCycles(walk.track, {"walk", false, 0, {}})) {
    const FittedPath path = fitPath(walk.track, stretch, false, kPhases);
    const Eigen::Vector3d from = walk.track.jointsAt(stretch.begin)[0].p_WJ;
    const Eigen::Vector3d to = walk.track.jointsAt(stretch.end)[0].p_WJ;
    EXPECT_LT((path.seen(from.head<2>(), 0.0) - path.seen(to.head<2>(), 1.0)).norm(), 1e-12);
  }
}

TEST_F(CapturedPaths, MeetAtTheirEndsWhateverTheCaptureDoes) {
  const LevelWalk walk("accad_female1/Female1_B09_WalkTurnLeft90.bvh");
  constexpr int kMany = 1024;
  const auto reference = walk.reference();
  for (const Stretch& stretch : wholeCycles(walk.track, {"walk", true, 0, {}})) {
    const FittedPath path = fitPath(walk.track, stretch, true, kPhases);
    const Eigen::MatrixXd samples = closedSamples(walk.track, stretch, path, reference, kMany);
    const double across_ends = (samples.col(0) - samples.col(kMany - 1)).cwiseAbs().maxCoeff();
    const double within =
        (samples.rightCols(kMany - 1) - samples.leftCols(kMany - 1)).cwiseAbs().maxCoeff();
    EXPECT_LE(across_ends, within + 1e-3);
  }
}

TEST_F(CapturedPaths, AreSampledAlikeByFewAndByMany) {
  const LevelWalk walk("cmu_mb2/08_03.bvh");
  const Stretch stretch = findStretches(walk.track, {"walk", false, 0, {}}).front();
  const FittedPath path = fitPath(walk.track, stretch, false, kPhases);
  const Eigen::MatrixXd few =
      closedSamples(walk.track, stretch, path, walk.reference(), kPhases / 4);
  const Eigen::MatrixXd many = closedSamples(walk.track, stretch, path, walk.reference(), kPhases);
  for (int i = 0; i < few.cols(); ++i) EXPECT_EQ(few.col(i), many.col(4 * i));
}

TEST_F(CapturedPaths, GoWithTheClipWhereItIsMovedAndTurned) {
  const LevelWalk walk("accad_female1/Female1_B09_WalkTurnLeft90.bvh");
  const Eigen::Vector3d by(-3.0, 11.0, 0.0);
  const double turned = 2.2;
  const LevelWalk there(moved(walk.clip, aboutZ(turned), by), walk.roles);
  const auto reference = walk.reference();
  for (const Stretch& stretch : wholeCycles(walk.track, {"walk", true, 0, {}})) {
    const FittedPath one = fitPath(walk.track, stretch, true, kPhases);
    const FittedPath other = fitPath(there.track, stretch, true, kPhases);
    const Eigen::Vector3d start(one.start.x(), one.start.y(), 0.0);
    EXPECT_LT(((aboutZ(turned) * start + by).head<2>() - other.start).norm(), 1e-9);
    EXPECT_NEAR(wrapAngle(other.heading - one.heading - turned), 0.0, 1e-9);
    EXPECT_NEAR(other.length, one.length, 1e-9);
    const Eigen::MatrixXd a = closedSamples(walk.track, stretch, one, reference, kPhases);
    const Eigen::MatrixXd b = closedSamples(there.track, stretch, other, reference, kPhases);
    EXPECT_LT((a - b).cwiseAbs().maxCoeff(), 1e-9);
  }
}

}  // namespace
}  // namespace amble

#include "animation/preparation/heel_rise_fit.h"

#include <gtest/gtest.h>

#include <cmath>

#include "animation/preparation/leg_track.h"
#include "animation/preparation/mirror_cycle.h"
#include "animation/preparation/walk_cycle_fit.h"
#include "animation/steps/stride_law.h"
#include "base/rotation.h"
#include "tests/animation/default_library.h"
#include "tests/animation/rig.h"

namespace amble {
namespace {

constexpr int kStanceSamples = FootCycle::kStanceSamples;
constexpr int kSamples = FootCycle::kStanceSamples + FootCycle::kSwingSamples;

/// Heels that rise over the end of the stance and come first at the next: 0 while the foot is flat.
double drawnPitch(double at) {
  if (at < 0.15) return -0.2 * (1.0 - at / 0.15);
  if (at < 0.6) return 0.0;
  if (at < 1.2) return 0.8 * std::pow(std::sin(kPi * (at - 0.6) / 1.2), 2);
  return 0.8 - 1.0 * (at - 1.2) / 0.8;
}

/// A drawn walk whose feet roll so.
struct RollingWalk {
  Rig rig;
  WalkCycle cycle;

  explicit RollingWalk(double turn_rate = 0.0, double (*pitch)(double at) = drawnPitch) {
    Puppet puppet;
    puppet.turn_rate = turn_rate;
    puppet.pitch = pitch;
    const FootPlants plants = puppet.plants();
    cycle = prepareWalkCycle(rig.walk(puppet), rig.roles, rig.feet, rig.reference(),
                             {"the clip", turn_rate != 0.0, 6, {}, &plants});
  }
  WalkCycle fitted(WalkCycle of) const {
    fitHeelRise(rig.skeleton, rig.roles, rig.feet, rig.reference(), of);
    return of;
  }
};

double pitchGap(const FootCycle& a, const FootCycle& b) {
  double gap = 0.0;
  for (int i = 0; i < kSamples; ++i) gap = std::max(gap, std::abs(a.pitch[i] - b.pitch[i]));
  return gap;
}

// The pelvis goes by a few slow waves beside its captured way, along the path and up: its mean
// height stays, and no joint turns otherwise.
TEST(HeelRise, ChangesNothingButPitchesAndSwingsAndWherePrintsAreAndTheWayOfThePelvis) {
  const RollingWalk walk;
  const WalkCycle fitted = walk.fitted(walk.cycle);
  EXPECT_EQ(fitted.speed, walk.cycle.speed);
  EXPECT_EQ(fitted.period, walk.cycle.period);
  EXPECT_EQ(fitted.step_width, walk.cycle.step_width);
  EXPECT_EQ(fitted.toe_out, walk.cycle.toe_out);
  for (auto series : {&FourierSeries::alpha, &FourierSeries::beta}) {
    const Eigen::MatrixXd moved = fitted.series.*series - walk.cycle.series.*series;
    const Eigen::Index joints = moved.rows() - 3;
    EXPECT_EQ(moved.bottomRows(joints).norm(), 0.0);
    EXPECT_EQ(moved.row(1).norm(), 0.0);
    EXPECT_EQ(moved.col(0).norm(), 0.0);
    EXPECT_LT(moved.row(0).norm(), 0.02);
    EXPECT_LT(moved.row(2).norm(), 0.01);
  }
  for (const Side side : {kLeft, kRight}) {
    EXPECT_EQ(fitted.feet[side].strike, walk.cycle.feet[side].strike);
    EXPECT_EQ(fitted.feet[side].lift_off, walk.cycle.feet[side].lift_off);
    EXPECT_EQ(fitted.feet[side].sideways, walk.cycle.feet[side].sideways);
    EXPECT_EQ(fitted.feet[side].yaw, walk.cycle.feet[side].yaw);
  }
}

// A foot that no capture rolls is not rolled: walks of rigid feet stay flat.
TEST(HeelRise, OfFeetThatStayFlatIsNone) {
  const RollingWalk walk(0.0, nullptr);
  WalkCycle rigid = walk.cycle;
  for (FootCycle& foot : rigid.feet) foot.pitch.assign(kSamples, 0.0);
  for (const FootCycle& foot : walk.fitted(rigid).feet) {
    for (const double pitch : foot.pitch) EXPECT_EQ(pitch, 0.0);
    for (const double toes : foot.toes) EXPECT_EQ(toes, 0.0);
  }
}

TEST(HeelRise, LeavesAFootFlatThatStandsFlat) {
  const RollingWalk walk;
  for (const FootCycle& foot : walk.fitted(walk.cycle).feet) {
    for (int i = kStanceSamples / 4; i < 6 * kStanceSamples / 10; ++i)
      EXPECT_NEAR(foot.pitch[i], 0.0, 0.5 * kDegree) << i;
  }
}

// Toes that rolled farther than the heel has risen would leave the ground or curl.
TEST(HeelRise, RollsNoToesFarOverASoleThatLies) {
  for (const Motion& motion : defaultLibrary().motions) {
    if (motion.kind != MotionKind::kWalk) continue;
    for (const FootCycle& foot : motion.cycle.feet) {
      for (double at = 0.5; at <= 1.3; at += 0.01) {
        EXPECT_LT(toeRoll(foot, at), std::max(footPitch(foot, at), 0.0) + 6.0 * kDegree)
            << motion.name << ' ' << at;
      }
    }
  }
}

// Every foot is flat at that moment, whichever cycle it comes from and goes to.
TEST(HeelRise, LeavesEveryFootFlatForAWhile) {
  for (const Motion& motion : defaultLibrary().motions) {
    if (motion.kind != MotionKind::kWalk) continue;
    for (const FootCycle& foot : motion.cycle.feet) {
      for (double at = FootCycle::kFlat - 0.05; at <= FootCycle::kFlat + 0.05; at += 0.01)
        EXPECT_EQ(footPitch(foot, at), 0.0) << motion.name << ' ' << at;
    }
  }
}

class RollingTurns : public testing::TestWithParam<double> {};

TEST_P(RollingTurns, InAMirrorRollAsTheMirrored) {
  const RollingWalk walk(GetParam());
  const auto reference = walk.rig.reference();
  const auto image = [&](const WalkCycle& cycle) {
    return mirrorCycle(cycle, walk.rig.skeleton, walk.rig.roles, reference);
  };
  const WalkCycle one = image(walk.fitted(walk.cycle)), two = walk.fitted(image(walk.cycle));
  for (const Side side : {kLeft, kRight}) {
    EXPECT_LT(pitchGap(one.feet[side], two.feet[side]), 1e-6);
    for (int k = 0; k < FootCycle::kToeSplines; ++k)
      EXPECT_NEAR(one.feet[side].toes[k], two.feet[side].toes[k], 1e-6);
    EXPECT_NEAR(one.foot_forward[side], two.foot_forward[side], 1e-6);
    for (double tau = 0.1; tau < 1.0; tau += 0.2) {
      EXPECT_NEAR(swingProgress(one.feet[side], tau), swingProgress(two.feet[side], tau), 1e-6);
      EXPECT_NEAR(swingPolynomial(one.feet[side].height, tau),
                  swingPolynomial(two.feet[side].height, tau), 1e-6);
    }
  }
}

TEST_P(RollingTurns, AreAsTheyWereIfTheyGoAnotherWayByNothing) {
  const RollingWalk walk(GetParam());
  WalkCycle nearly = walk.cycle;
  nearly.turn_rate += 1e-7;
  const WalkCycle one = walk.fitted(walk.cycle), two = walk.fitted(nearly);
  for (const Side side : {kLeft, kRight}) EXPECT_LT(pitchGap(one.feet[side], two.feet[side]), 1e-4);
}

INSTANTIATE_TEST_SUITE_P(, RollingTurns, testing::Values(0.0, 0.5, -0.7));

/// How far the line from hip to ankle is from being as long as captured, over the stance of the
/// left foot [m, root mean square]: what bends knees otherwise than captured.
double legError(const MotionLibrary& library, const WalkCycle& cycle) {
  const LegTrack track(library.skeleton, library.roles, library.feet()[kLeft],
                       library.stand().rotations, cycle, kLeft);
  double squares = 0.0;
  for (int i = 0; i < kStanceSamples; ++i)
    squares += std::pow(track.made(i).line.norm() - track.capturedLength(i), 2) / kStanceSamples;
  return std::sqrt(squares);
}

// The captured walks of the library, with heels that rise half as far as they do there, and toes
// that lie: heels, toes, prints and the pelvis make up for it.
TEST(HeelRise, BringsLegsNearerToTheirCapturedLength) {
  for (const Motion& motion : defaultLibrary().motions) {
    if (motion.kind != MotionKind::kWalk || motion.turning) continue;
    WalkCycle lower = motion.cycle;
    for (FootCycle& foot : lower.feet) {
      for (double& pitch : foot.pitch) pitch *= 0.5;
      foot.toes.fill(0.0);
    }
    WalkCycle fitted = lower;
    fitHeelRise(defaultLibrary().skeleton, defaultLibrary().roles, defaultLibrary().feet(),
                defaultLibrary().stand().rotations, fitted);
    EXPECT_LT(legError(defaultLibrary(), fitted), legError(defaultLibrary(), lower)) << motion.name;
  }
}

}  // namespace
}  // namespace amble

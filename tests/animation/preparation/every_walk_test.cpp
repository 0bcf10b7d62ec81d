// What a prepared cycle is must hold for any walk that was captured: where and which way it went,
// how many frames a second were taken, how tall the person is and which side is left change
// nothing that they should not.

#include <gtest/gtest.h>

#include <memory>

#include "animation/clips/mirror_clip.h"
#include "animation/clips/resample_clip.h"
#include "animation/preparation/mirror_cycle.h"
#include "animation/preparation/motion_library_add.h"
#include "base/rotation.h"
#include "tests/animation/level_walk.h"
#include "tests/animation/moved_clip.h"
#include "tests/animation/taller_clip.h"

namespace amble {
namespace {

struct Prepared {
  LevelWalk walk;
  std::vector<Eigen::Quaterniond> reference = walk.reference();
  WalkCycle cycle = walk.cycle(reference);

  explicit Prepared(const std::string& path)
      : walk(readForLibrary(sharedFolder() / "mocap" / path, {}).motion) {}
};

/// Read and prepared once for all tests.
const Prepared& prepared(const std::string& path) {
  static std::map<std::string, std::unique_ptr<Prepared>> known;
  std::unique_ptr<Prepared>& one = known[path];
  if (!one) one = std::make_unique<Prepared>(path);
  return *one;
}

class EveryWalk : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override { AMBLE_NEEDS_CAPTURES(); }
  const LevelWalk& walk() const { return prepared(GetParam()).walk; }
  const WalkCycle& cycle() const { return prepared(GetParam()).cycle; }
  const std::vector<Eigen::Quaterniond>& reference() const {
    return prepared(GetParam()).reference;
  }
};

TEST_P(EveryWalk, IsTheSameWhereverAndWhicheverWayItWent) {
  const LevelWalk there(moved(walk().clip, aboutZ(2.6), {-7.0, 3.0, 0.0}), walk().roles);
  const WalkCycle other = there.cycle(reference());
  EXPECT_EQ(other.cycles, cycle().cycles);
  EXPECT_NEAR(other.speed, cycle().speed, 1e-6);
  EXPECT_NEAR(other.period, cycle().period, 1e-6);
  EXPECT_NEAR(other.step_width, cycle().step_width, 1e-6);
  EXPECT_LT(seriesGap(other, cycle()), 1e-5);
  for (const Side side : {kLeft, kRight}) {
    EXPECT_NEAR(other.toe_out[side], cycle().toe_out[side], 1e-5);
    EXPECT_NEAR(other.foot_forward[side], cycle().foot_forward[side], 1e-5);
    for (double tau = 0.1; tau < 1.0; tau += 0.2) {
      EXPECT_NEAR(swingPolynomial(other.feet[side].height, tau),
                  swingPolynomial(cycle().feet[side].height, tau), 1e-5);
    }
  }
}

// The clip in a mirror is prepared from its own plants and stretches; the rigs are not quite their
// own mirror images, and an event may be seen a frame off.
TEST_P(EveryWalk, InAMirrorIsTheMirroredCycle) {
  const LevelWalk there(mirrorClip(walk().clip, walk().roles), walk().roles);
  const WalkCycle image = mirrorCycle(cycle(), walk().clip.skeleton, walk().roles, reference());
  const WalkCycle other = there.cycle(reference());
  EXPECT_NEAR(other.speed, image.speed, 0.03 * image.speed);
  EXPECT_NEAR(other.period, image.period, 0.02 * image.period);
  EXPECT_NEAR(other.step_width, image.step_width, 0.015);
  for (const Side side : {kLeft, kRight}) {
    EXPECT_LT(std::abs(std::remainder(other.feet[side].strike - image.feet[side].strike, 1.0)),
              0.03);
    EXPECT_LT(std::abs(std::remainder(other.feet[side].lift_off - image.feet[side].lift_off, 1.0)),
              0.03);
    EXPECT_NEAR(other.toe_out[side], image.toe_out[side], 0.5 * kDegree);
  }
}

TEST_P(EveryWalk, MeasuresTheSameAtAnotherFrameRate) {
  for (const double rate : {60.0, 100.0}) {
    const LevelWalk there(resampleClip(walk().clip, 1.0 / rate), walk().roles);
    const WalkCycle other = there.cycle(reference());
    EXPECT_NEAR(other.speed, cycle().speed, 0.02 * cycle().speed) << rate;
    EXPECT_NEAR(other.period, cycle().period, 0.02 * cycle().period) << rate;
    EXPECT_NEAR(other.step_width, cycle().step_width, 0.01) << rate;
    EXPECT_NEAR(other.doubleSupport(), cycle().doubleSupport(), 0.05) << rate;
  }
}

// All lengths are told in leg lengths: who is an eighth taller takes an eighth longer steps in the
// same time.
TEST_P(EveryWalk, OfATallerPersonIsTheSameInLegLengths) {
  constexpr double kTaller = 1.125;
  const LevelWalk there(taller(walk().clip, kTaller), walk().roles);
  const WalkCycle other = there.cycle(reference());
  EXPECT_NEAR(other.period, cycle().period, 0.01 * cycle().period);
  EXPECT_NEAR(other.speed, kTaller * cycle().speed, 0.02 * kTaller * cycle().speed);
  EXPECT_NEAR(other.step_width, kTaller * cycle().step_width, 0.01);
  EXPECT_NEAR(other.doubleSupport(), cycle().doubleSupport(), 0.02);
}

TEST_P(EveryWalk, HasEachFootDownForMostOfTheCycleAndInTurn) {
  EXPECT_GT(cycle().doubleSupport(), 0.0);
  EXPECT_LT(cycle().doubleSupport(), 0.6);
  const auto ahead = [](double from, double to) { return to - from - std::floor(to - from); };
  for (const Side side : {kLeft, kRight}) {
    const FootCycle& foot = cycle().feet[side];
    const double stance = ahead(foot.strike, foot.lift_off);
    EXPECT_GT(stance, 0.5);
    EXPECT_LT(stance, 0.85);
    EXPECT_NEAR(ahead(foot.strike, cycle().feet[other(side)].strike), 0.5, 0.1);
  }
  // Phase 0 is the middle of the double support with the left foot in front.
  EXPECT_LT(std::abs(std::remainder(
                cycle().feet[kLeft].strike + cycle().feet[kRight].lift_off - 1.0, 1.0)),
            0.08);
}

// Nothing of a foot's way may begin or end in the middle of it.
TEST_P(EveryWalk, SwingsFromPrintToPrintWithoutDipping) {
  for (const Side side : {kLeft, kRight}) {
    const FootCycle& foot = cycle().feet[side];
    EXPECT_EQ(swingProgress(foot, 0.0), 0.0);
    EXPECT_EQ(swingProgress(foot, 1.0), 1.0);
    for (double tau = 0.0; tau <= 1.0; tau += 1.0 / 32.0) {
      EXPECT_GT(swingProgress(foot, tau), -0.1) << tau;
      EXPECT_LT(swingProgress(foot, tau), 1.1) << tau;
      const double pitch = footPitch(foot, 1.0 + tau);
      const Eigen::Quaterniond rolled(Eigen::AngleAxisd(pitch, Eigen::Vector3d::UnitY()));
      const FootShape& shape = walk().feet[side];
      const Eigen::Vector3d ankle =
          rolledAnkle(shape, pitch) + Eigen::Vector3d(0, 0, swingPolynomial(foot.height, tau));
      const SoleEnds ends = soleEnds(shape, ankle, rolled * shape.q_SF);
      EXPECT_GT(std::min(ends.heel.z(), ends.ball.z()), -1e-3) << tau;
    }
  }
}

// More waves leave out less, and never change what fewer have: they do not mix at even phases. But
// for the pelvis, which goes by waves of its own (fitHeelRise).
TEST_P(EveryWalk, LeavesOutLessWithMoreHarmonics) {
  double before = 1.0;
  for (const int harmonics : {2, 4, 8}) {
    const WalkCycle more = walk().cycle(reference(), {"the clip", false, harmonics, {}});
    EXPECT_LT(more.residual, before);
    before = more.residual;
    const Eigen::MatrixXd change = more.series.alpha.leftCols(3) - cycle().series.alpha.leftCols(3);
    EXPECT_LT(change.bottomRows(change.rows() - 3).cwiseAbs().maxCoeff(), 1e-9);
    EXPECT_LT(change.row(1).cwiseAbs().maxCoeff(), 1e-9);
  }
}

INSTANTIATE_TEST_SUITE_P(, EveryWalk,
                         testing::Values("accad_female1/Female1_B03_Walk1.bvh",
                                         "accad_male1/Male1_B3_Walk.bvh", "cmu_mb2/07_01.bvh",
                                         "cmu_mb2/08_03.bvh", "cmu_asfamc/07_05-walk.amc",
                                         "cmu_daz/07_01.bvh", "cmu_mb2/02_01.bvh"));

}  // namespace
}  // namespace amble

#include "animation/preparation/mirror_cycle.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/rotation.h"
#include "tests/animation/default_library.h"

namespace amble {
namespace {

WalkCycle mirrored(const WalkCycle& cycle) {
  return mirrorCycle(cycle, defaultLibrary().skeleton, defaultLibrary().roles,
                     defaultLibrary().stand().rotations);
}

/// Places of the joints at a phase, from the path's point and heading.
std::vector<JointFrame> jointsAt(const WalkCycle& cycle, double phase) {
  const std::vector<Eigen::Quaterniond>& reference = defaultLibrary().stand().rotations;
  const Eigen::VectorXd c = fourierAt(cycle.series, phase);
  Pose pose;
  pose.p_WR = c.head<3>();
  for (size_t j = 0; j < reference.size(); ++j) {
    pose.rotations.push_back(reference[j] *
                             expRotation(c.segment<3>(3 + 3 * static_cast<Eigen::Index>(j))));
  }
  std::vector<JointFrame> joints(defaultLibrary().skeleton.size());
  forwardKinematics(defaultLibrary().skeleton, pose, joints);
  return joints;
}

// The rig's own left and right differ by millimetres, and a joint's by what it hangs on.
constexpr double kOfTheRig = 0.015;

TEST(MirrorCycle, IsTheCycleInAMirrorHalfAPeriodOn) {
  for (const Motion& motion : defaultLibrary().motions) {
    if (motion.kind != MotionKind::kWalk || motion.source.mirrored) continue;
    const WalkCycle other = mirrored(motion.cycle);
    for (double phase = 0.0; phase < 1.0; phase += 0.125) {
      const auto here = jointsAt(motion.cycle, phase), there = jointsAt(other, phase + 0.5);
      for (const auto& [side, far] : {std::pair(kLeft, kRight), std::pair(kRight, kLeft)}) {
        const Eigen::Vector3d& p = here[defaultLibrary().roles.legs[side].foot].p_WJ;
        const Eigen::Vector3d& q = there[defaultLibrary().roles.legs[far].foot].p_WJ;
        EXPECT_LT((Eigen::Vector3d(p.x(), -p.y(), p.z()) - q).norm(), kOfTheRig)
            << motion.name << " at " << phase;
      }
    }
  }
}

TEST(MirrorCycle, KeepsSpeedAndPeriodAndTurnsTheOtherWay) {
  const WalkCycle& cycle = defaultLibrary().find("turn-left")->cycle;
  const WalkCycle other = mirrored(cycle);
  EXPECT_EQ(other.speed, cycle.speed);
  EXPECT_EQ(other.period, cycle.period);
  EXPECT_EQ(other.turn_rate, -cycle.turn_rate);
  EXPECT_EQ(other.prints_left, -cycle.prints_left);
  EXPECT_NE(cycle.prints_left, 0.0);
  EXPECT_EQ(other.series.harmonics(), cycle.series.harmonics());
  for (const Side side : {kLeft, kRight}) {
    const FootCycle &foot = cycle.feet[side], &far = other.feet[amble::other(side)];
    EXPECT_NEAR(wrapAngle(2.0 * kPi * (far.strike - foot.strike - 0.5)), 0.0, 1e-12);
    EXPECT_NEAR(wrapAngle(2.0 * kPi * (far.lift_off - foot.lift_off - 0.5)), 0.0, 1e-12);
    EXPECT_EQ(far.pitch, foot.pitch);
    EXPECT_EQ(far.sideways[0], -foot.sideways[0]);
    EXPECT_EQ(other.toe_out[amble::other(side)], -cycle.toe_out[side]);
    EXPECT_EQ(other.foot_drops.value()[amble::other(side)], cycle.foot_drops.value()[side]);
  }
}

TEST(MirrorCycle, OfItsMirrorImageIsTheCycle) {
  const WalkCycle& cycle = defaultLibrary().find("walk-free")->cycle;
  const WalkCycle twice = mirrored(mirrored(cycle));
  EXPECT_LT((twice.series.alpha - cycle.series.alpha).cwiseAbs().maxCoeff(), 0.01);
  EXPECT_LT((twice.series.beta - cycle.series.beta).cwiseAbs().maxCoeff(), 0.01);
  EXPECT_EQ(twice.turn_rate, cycle.turn_rate);
  EXPECT_EQ(twice.toe_out, cycle.toe_out);
}

}  // namespace
}  // namespace amble

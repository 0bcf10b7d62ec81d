#include "animation/preparation/motion_library_add.h"

#include <gtest/gtest.h>

#include "animation/body/foot_shape.h"
#include "animation/library/motion_library_reader.h"
#include "animation/synthesis/walk_synthesizer.h"
#include "base/error.h"
#include "base/rotation.h"
#include "tests/animation/engine_library.h"

namespace amble {
namespace {

MotionRequest walkOf(const std::string& clip) {
  MotionRequest request;
  request.name = "walk";
  request.file = sharedFolder() / "mocap" / clip;
  request.source = {clip, {0, 0}, false, "as the captures'", "their makers"};
  return request;
}

/// The error of adding the motion to an empty library.
std::string addRefusal(const MotionRequest& request) {
  MotionLibrary library;
  try {
    addMotion(library, request);
  } catch (const InputError& error) {
    return error.what();
  }
  return "nothing was refused";
}

TEST(AddMotion, WhatIsUnfitIsRefusedWithTheReason) {
  AMBLE_NEEDS_CAPTURES();
  EXPECT_NE(addRefusal(walkOf("accad_female1/Female1_B05_WalkBackwards.bvh")).find("backwards"),
            std::string::npos);
  EXPECT_NE(addRefusal(walkOf("accad_female1/Female1_A01_Stand.bvh")).find("no whole cycle"),
            std::string::npos);
  MotionRequest turn = walkOf("accad_female1/Female1_B03_Walk1.bvh");
  turn.turning = true;
  EXPECT_NE(addRefusal(turn).find("walks straight"), std::string::npos);
  MotionRequest start = walkOf("accad_female1/Female1_B03_Walk1.bvh");
  start.kind = MotionKind::kStart;
  EXPECT_NE(addRefusal(start).find("does not stand"), std::string::npos);
}

TEST(AddMotion, ANameIsGivenOnce) {
  AMBLE_NEEDS_CAPTURES();
  MotionLibrary library;
  addMotion(library, walkOf("accad_female1/Female1_B03_Walk1.bvh"));
  EXPECT_THROW(addMotion(library, walkOf("accad_female1/Female1_B03_Walk1.bvh")), InputError);
}

// Other subjects, other rigs, another format: each alone makes a library that walks.
TEST(AddMotion, OneWalkOfAnySubjectMakesALibraryThatWalks) {
  AMBLE_NEEDS_CAPTURES();
  for (const char* const clip :
       {"accad_male1/Male1_B3_Walk.bvh", "cmu_mb2/08_03.bvh", "cmu_asfamc/07_05-walk.amc"}) {
    MotionLibrary library;
    addMotion(library, walkOf(clip));
    ASSERT_NE(library.find("stand"), nullptr);
    const FlatGround ground;
    const WalkSynthesizer synthesizer(library, ground, {});
    Stance from, to;
    to.position.x() = 5.0;
    const RootPath path({makeBezier(from.position.head<2>(), 0.0, to.position.head<2>(), 0.0)});
    AnimationBuffer walk;
    EXPECT_EQ(synthesizer.walk(from, to, path, true, walk).refused, WalkRule::kNone) << clip;
    std::vector<JointFrame> joints(library.skeleton.size());
    forwardKinematics(library.skeleton, walk.poses[walk.size() / 2], joints);
    EXPECT_GT(joints[library.roles.head].p_WJ.z(), 0.75 * library.stature) << clip;
    for (const ArmJoints& arm : library.roles.arms) {  // arms hang
      EXPECT_LT(joints[arm.fore_arm].p_WJ.z(), joints[arm.arm].p_WJ.z() - 0.1) << clip;
    }
  }
}

// Their rig's feet hang in its rest pose and its arms are twisted there by up to half a turn; the
// walks are slow, gangly, marching, limping.
TEST(AddMotion, ALoopOfARigWhoseFeetHangMakesALibraryThatWalksOnItsSoles) {
  AMBLE_NEEDS_CAPTURES();
  for (const char* const clip : {"120_17", "120_19", "137_12", "137_18", "137_33", "142_04",
                                 "142_05", "142_08", "142_11", "142_12"}) {
    SCOPED_TRACE(clip);
    MotionLibrary library;
    addMotion(library, walkOf(std::string("cmu_style_loops/") + clip + "_EDIT_LOOP.bvh"));
    const FlatGround ground;
    const WalkSynthesizer synthesizer(library, ground,
                                      {.speed = library.motions.back().cycle.speed});
    Stance from, to;
    to.position.x() = 4.0;
    const RootPath path({makeBezier(from.position.head<2>(), 0.0, to.position.head<2>(), 0.0)});
    AnimationBuffer walk;
    ASSERT_EQ(synthesizer.walk(from, to, path, true, walk).refused, WalkRule::kNone);
    std::vector<JointFrame> joints(library.skeleton.size());
    const std::array<FootShape, 2> feet = library.feet();
    double lowest = 0.0, toes = 0.0;
    for (int i = 0; i < walk.size(); ++i) {
      forwardKinematics(library.skeleton, walk.poses[i], joints);
      for (const Side side : {kLeft, kRight}) {
        const JointFrame& foot = joints[library.roles.legs[side].foot];
        const SoleEnds ends = soleEnds(feet[side], foot.p_WJ, foot.q_WJ);
        const Joint& toe = library.skeleton.joint(library.roles.legs[side].toe);
        const Eigen::Vector3d tip = joints[library.roles.legs[side].toe] * toe.end_sites[0];
        lowest = std::min({lowest, ends.heel.z(), ends.ball.z()});
        // The centre of the toes' round end, over whose tip the foot rolls before it leaves.
        const Eigen::Quaterniond q_WT = joints[library.roles.legs[side].toe].q_WJ *
                                        (feet[side].q_SF * feet[side].q_FT).conjugate();
        const Eigen::Vector3d centre = tip - q_WT * Eigen::Vector3d(feet[side].radius, 0.0, 0.0);
        toes = std::min(toes, centre.z() - feet[side].radius);
      }
    }
    EXPECT_GT(lowest, -0.001);
    EXPECT_GT(toes, -0.005);
  }
}

TEST(AddMotion, AMovementChangesItsChainsOnly) {
  const MotionLibrary library = openMotionLibrary("default");
  ASSERT_NE(library.find("carry"), nullptr);
  const FlatGround ground;
  CharacterSettings carrying;
  carrying.actions = {"carry"};
  const WalkSynthesizer plain(library, ground, {}), carries(library, ground, carrying);
  Stance from, to;
  to.position.x() = 5.0;
  const RootPath path({makeBezier(from.position.head<2>(), 0.0, to.position.head<2>(), 0.0)});
  AnimationBuffer a, b;
  ASSERT_EQ(plain.walk(from, to, path, true, a).refused, WalkRule::kNone);
  ASSERT_EQ(carries.walk(from, to, path, true, b).refused, WalkRule::kNone);
  ASSERT_EQ(a.size(), b.size());
  std::vector<bool> moved(library.skeleton.size(), false);
  for (const char* const chain : {"left_arm", "right_arm"}) {
    for (const int j : chainJoints(library.skeleton, library.roles, chain)) moved[j] = true;
  }
  double most = 0.0;
  for (int i = 0; i < a.size(); i += 5) {
    for (int j = 0; j < library.skeleton.size(); ++j) {
      const double angle = a.poses.rotations(i)[j].angularDistance(b.poses.rotations(i)[j]);
      if (moved[j]) {
        most = std::max(most, angle);
      } else {
        EXPECT_EQ(angle, 0.0) << library.skeleton.joint(j).name;
      }
    }
  }
  EXPECT_GT(most, 30.0 * kDegree);  // a box is carried on bent elbows
}

// Series are sums of waves that do not mix: what a mean of cycles has of a wave is the mean of what
// they have. Mirrored ones are mirrored pose by pose, and close to it.
// By Froude, as captures of other people are: who has longer legs does it faster.
TEST(AddMotion, AnEnginesWalkIsCarriedOverToALibraryOfSomebodyElse) {
  AMBLE_NEEDS_CAPTURES();
  const EngineInFile made(fitSpeedEngine(engineRequestOf({"cmu_mb2/02_01.bvh"})));
  MotionLibrary library = made.library({1.0}), other;
  MotionRequest request;
  request.name = "own";
  request.file = sharedFolder() / "mocap/accad_male1/Male1_B3_Walk.bvh";
  addMotion(other, request);
  addMotion(other, made.request(1.0));
  const WalkCycle &walk = library.motions.back().cycle, &carried = other.motions.back().cycle;
  const double root = std::sqrt(other.stature / library.stature);
  ASSERT_GT(std::abs(root - 1.0), 0.02);
  EXPECT_NEAR(carried.period, walk.period * root, 1e-6);
  EXPECT_NEAR(carried.speed, walk.speed * root, 0.02 * walk.speed);
  EXPECT_NEAR(carried.capture.joint_jerk * root, walk.capture.joint_jerk, 1e-6);
  EXPECT_NEAR(carried.doubleSupport(), walk.doubleSupport(), 1e-6);
}

TEST(CapturedCycles, TheirMeanIsTheSeriesOfTheLibrary) {
  AMBLE_NEEDS_CAPTURES();
  const MotionLibrary library = openMotionLibrary("default");
  for (const char* const name : {"walk-slow", "walk-free-mirrored", "turn-left", "carry"}) {
    const Motion& motion = *library.find(name);
    const auto cycles =
        capturedCycles(library, motion, sharedFolder() / "mocap" / motion.source.clip);
    ASSERT_EQ(static_cast<int>(cycles.size()), motion.cycle.cycles) << name;
    const FourierSeries& mean = motion.cycle.series;
    Eigen::MatrixXd alpha = Eigen::MatrixXd::Zero(mean.channels(), mean.harmonics() + 1);
    for (const FourierSeries& one : cycles)
      alpha += one.alpha.leftCols(alpha.cols()) / static_cast<double>(cycles.size());
    // Offsets are read as they were written, to a micrometre, by which feet of 0.13 m drop
    // otherwise.
    const double near = motion.source.mirrored ? 5e-3 : 6e-6;
    Eigen::MatrixXd off = (alpha - mean.alpha).cwiseAbs();
    // Beside its captured way the pelvis goes by some millimetres along the path and up, and not in
    // the mean (fitHeelRise).
    for (const int axis : {0, 2}) {
      EXPECT_LT(off.row(axis).maxCoeff(), 0.015) << name;
      off.row(axis).tail(off.cols() - 1).setZero();
    }
    EXPECT_LT(off.maxCoeff(), near) << name;
  }
}

TEST(CapturedCycles, OfAnotherCaptureAreRefused) {
  AMBLE_NEEDS_CAPTURES();
  const MotionLibrary library = openMotionLibrary("default");
  const auto other = sharedFolder() / "mocap/cmu_mb2/07_12.bvh";
  EXPECT_THROW(capturedCycles(library, *library.find("walk-slow"), other), InputError);
}

}  // namespace
}  // namespace amble

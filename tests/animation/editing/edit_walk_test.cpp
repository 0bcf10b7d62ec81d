#include "animation/editing/edit_walk.h"

#include <gtest/gtest.h>

#include "animation/analysis/motion_measures.h"
#include "animation/body/pelvis.h"
#include "base/rotation.h"
#include "tests/animation/editing/edited_walks.h"

namespace amble {
namespace {

/// Straight walks of three subjects, one with a T-pose first; turns; a walk out of a stand.
const std::array<std::string, 4> kStraight = {"mocap/accad_female1/Female1_B03_Walk1.bvh",
                                              "mocap/accad_male1/Male1_B3_Walk.bvh",
                                              "mocap/cmu_mb2/02_01.bvh", "mocap/cmu_mb2/07_06.bvh"};
const std::array<std::string, 8> kAll = {kStraight[0],
                                         kStraight[1],
                                         kStraight[2],
                                         kStraight[3],
                                         "mocap/accad_female1/Female1_B12_WalkTurnRight90.bvh",
                                         "mocap/accad_female1/Female1_B15_WalkTurnAround180.bvh",
                                         "mocap/accad_male1/Male1_B1_StandToWalk.bvh",
                                         "gait/trials/zoo_HC031A06.bvh"};

double farthest(const Clip& a, const Clip& b) {
  std::vector<JointFrame> of_a(a.skeleton.size()), of_b(b.skeleton.size());
  double most = 0.0;
  for (int i = 0; i < a.frames(); ++i) {
    forwardKinematics(a, i, of_a);
    forwardKinematics(b, i, of_b);
    for (size_t j = 0; j < of_a.size(); ++j) {
      most = std::max(most, (of_a[j].p_WJ - of_b[j].p_WJ).norm());
    }
  }
  return most;
}

double mostTurned(const Clip& a, const Clip& b) {
  double most = 0.0;
  for (int i = 0; i < a.frames(); ++i) {
    for (int j = 0; j < a.skeleton.size(); ++j) {
      most = std::max(most, a.poses.rotations(i)[j].angularDistance(b.poses.rotations(i)[j]));
    }
  }
  return most;
}

TEST(EditWalk, FactorsOfOneGiveTheClipBack) {
  AMBLE_NEEDS_CAPTURES();
  for (const std::string& path : kAll) {
    const CapturedWalk walk = capturedWalk(path);
    ASSERT_EQ(whyNoWalk(walk), "") << path;
    EditRequest same = withStride(1.0, 1.0);
    same.lift = EditAmount{{1.0, 1.0}, true};
    same.incline = Ramp{0.0, 0.0};
    const EditedWalk edited = editWalk(walk, same);
    EXPECT_EQ(edited.refused, "") << path;
    EXPECT_LT(farthest(edited.clip, walk.clip), 1e-3) << path;
    EXPECT_LT(mostTurned(edited.clip, walk.clip), 0.1 * kDegree) << path;
  }
}

TEST(EditWalk, StepsGetAsLongAsIsAsked) {
  AMBLE_NEEDS_CAPTURES();
  for (const std::string& path : kStraight) {
    const CapturedWalk walk = capturedWalk(path);
    for (const double factor : {0.75, 1.25}) {
      EditRequest request = withStride(factor, factor);
      request.foot_lock = true;
      const EditedWalk edited = editWalk(walk, request);
      const GaitMeasures gait = analysed(edited.clip, walk.roles);
      const double wanted = factor * walk.analysis.gait.step_length;
      EXPECT_NEAR(gait.step_length, wanted, 0.02 * wanted) << path << factor;
      EXPECT_NEAR(gait.step_width, walk.analysis.gait.step_width, 0.01) << path << factor;
    }
  }
}

TEST(EditWalk, ALengthInMetresIsTheMeanSteps) {
  AMBLE_NEEDS_CAPTURES();
  const CapturedWalk walk = capturedWalk(kStraight[1]);
  EditRequest request;
  request.stride = EditAmount{{0.6, 0.6}, false};
  EXPECT_NEAR(analysed(editWalk(walk, request).clip, walk.roles).step_length, 0.6, 0.012);
}

TEST(EditWalk, ARampOfStridesGrowsOverTheWalk) {
  AMBLE_NEEDS_CAPTURES();
  const CapturedWalk walk = capturedWalk(kStraight[0]);
  const EditedWalk edited = editWalk(walk, withStride(0.8, 1.2));
  const GaitMeasures gait = analysed(edited.clip, walk.roles);
  const std::vector<StepMeasure>& before = walk.analysis.gait.steps;
  ASSERT_EQ(gait.steps.size(), before.size());
  const double length = edited.clip.duration();
  for (size_t i = 0; i < before.size(); ++i) {
    // The root passes the middle of the step about when the foot lands; it goes evenly.
    const double share = before[i].strike / length;
    const double factor = gait.steps[i].stride / before[i].stride;
    EXPECT_NEAR(factor, 0.8 + 0.4 * share, 0.02) << i;
  }
}

TEST(EditWalk, FeetSwingAsHighAsIsAsked) {
  AMBLE_NEEDS_CAPTURES();
  for (const std::string& path : kStraight) {
    const CapturedWalk walk = capturedWalk(path);
    for (const double factor : {0.7, 2.0}) {
      EditRequest request;
      request.lift = EditAmount{{factor, factor}, true};
      request.foot_lock = true;
      const GaitMeasures gait = analysed(editWalk(walk, request).clip, walk.roles);
      const double wanted = factor * walk.analysis.gait.lift;
      EXPECT_NEAR(gait.lift, wanted, 0.02 * wanted) << path << factor;
      EXPECT_LT(gait.penetration, walk.analysis.gait.penetration + 0.004) << path << factor;
    }
  }
}

// Feet that swing lower or come down on treads stand sooner, or longer, than they were captured.
TEST(EditWalk, HeldFeetStayOfWhateverIsAskedByWhoeverFindsThem) {
  AMBLE_NEEDS_CAPTURES();
  for (const char* path : {"mocap/cmu_mb2/06_01.bvh", "mocap/cmu_mb2/07_01.bvh",
                           "mocap/cmu_mb2/08_06.bvh", "mocap/accad_male1/Male1_B3_Walk.bvh"}) {
    const CapturedWalk walk = capturedWalk(path);
    std::array<EditRequest, 5> requests;
    requests[0].lift = EditAmount{{0.6, 0.6}, true};
    requests[1].incline = Ramp{8.0 * kDegree, 8.0 * kDegree};
    requests[2].stairs = StairSize{0.17, 0.29};
    requests[3].stairs = StairSize{-0.17, 0.29};
    requests[4] = withStride(0.7, 0.7);
    for (EditRequest& request : requests) {
      request.foot_lock = true;
      const EditedWalk edited = editWalk(walk, request);
      ASSERT_EQ(edited.refused, "") << path;
      const GaitMeasures gait = analysed(edited.clip, walk.roles);
      EXPECT_LT(gait.largest_drift, 0.002) << path << " " << &request - requests.data();
      EXPECT_LT(gait.toe_skate, 0.010) << path << " " << &request - requests.data();
    }
  }
}

TEST(EditWalk, OnASlopeEachPrintIsAsMuchHigherAsTheSlopeHasIt) {
  AMBLE_NEEDS_CAPTURES();
  const CapturedWalk walk = capturedWalk(kStraight[1]);
  for (const double degrees : {-8.0, 8.0}) {
    EditRequest request;
    request.incline = Ramp{degrees * kDegree, degrees * kDegree};
    request.foot_lock = true;
    const EditedWalk edited = editWalk(walk, request);
    const GaitMeasures gait = analysed(edited.clip, walk.roles);
    const double step = walk.analysis.gait.step_length;
    EXPECT_NEAR(gait.step_length, step * std::cos(degrees * kDegree), 0.02 * step);
    double rise = 0.0;  // of one foot, over two steps
    int count = 0;
    for (size_t i = 2; i < gait.plants.size(); ++i) {
      rise += gait.plants[i].ends.ball.z() - gait.plants[i - 2].ends.ball.z();
      count += 2;
    }
    const double wanted = step * std::sin(degrees * kDegree);
    EXPECT_NEAR(rise / count, wanted, 0.02 * std::abs(wanted)) << degrees;
    // Standing feet lie on it as they lay on the floor.
    const GaitMeasures on_slope =
        measureGait(edited.clip, walk.roles, walk.analysis.plants, edited.ground.get());
    for (const Side side : {kLeft, kRight}) {
      EXPECT_NEAR(on_slope.toe_height[side], walk.analysis.gait.toe_height[side], 0.003);
      EXPECT_NEAR(on_slope.ankle_height[side], walk.analysis.gait.ankle_height[side], 0.005);
    }
  }
}

TEST(EditWalk, PlantedFeetThatAreHeldStayHeldWhateverElseIsAsked) {
  AMBLE_NEEDS_CAPTURES();
  for (const std::string& path : kStraight) {
    const CapturedWalk walk = capturedWalk(path);
    EditRequest request = withStride(1.15, 0.9);
    request.lift = EditAmount{{1.5, 1.5}, true};
    request.incline = Ramp{5.0 * kDegree, 5.0 * kDegree};
    request.foot_lock = true;
    const GaitMeasures gait = analysed(editWalk(walk, request).clip, walk.roles);
    EXPECT_LT(gait.largest_drift, 0.002) << path;
    EXPECT_LT(gait.toe_skate, 0.010) << path;
  }
}

TEST(EditWalk, TheRootArrivesWhereItIsAskedTo) {
  AMBLE_NEEDS_CAPTURES();
  for (const std::string& path : {kAll[0], kAll[4], kAll[6]}) {
    const CapturedWalk walk = capturedWalk(path);
    const PoseArray& poses = walk.clip.poses;
    const Eigen::Vector2d begin = poses.p_WR(0).head<2>();
    const Eigen::Vector2d way = poses.p_WR(walk.clip.frames() - 1).head<2>() - begin;
    EditRequest request;
    request.arrive = begin + 0.85 * Eigen::Vector2d(-way.y(), way.x());
    request.foot_lock = true;
    const EditedWalk edited = editWalk(walk, request);
    const Eigen::Vector3d& end = edited.clip.poses.p_WR(edited.clip.frames() - 1);
    EXPECT_LT((end.head<2>() - *request.arrive).norm(), 0.001) << path;
    EXPECT_NEAR(edited.stride, 0.85, 0.005);  // held feet take the root along
    // It is the same walk, a quarter turn to the left.
    const std::vector<double> before = pelvisHeadings(walk.clip, walk.roles);
    const std::vector<double> after = pelvisHeadings(edited.clip, walk.roles);
    EXPECT_NEAR(wrapAngle(after.back() - before.back()), 0.5 * kPi, 0.5 * kDegree) << path;
  }
}

TEST(EditWalk, TheUpperBodyIsPlayedBackToTheBit) {
  AMBLE_NEEDS_CAPTURES();
  const CapturedWalk walk = capturedWalk(kStraight[2]);
  EditRequest request = withStride(1.2, 1.2);
  request.incline = Ramp{6.0 * kDegree, 6.0 * kDegree};
  request.foot_lock = true;
  const EditedWalk edited = editWalk(walk, request);
  std::vector<bool> of_legs(walk.clip.skeleton.size(), false);
  for (const LegJoints& leg : walk.roles.legs) {
    for (const int joint : {leg.up_leg, leg.leg, leg.foot}) of_legs[joint] = true;
  }
  for (int i = 0; i < walk.clip.frames(); ++i) {
    for (int j = 0; j < walk.clip.skeleton.size(); ++j) {
      const auto before = walk.clip.poses.rotations(i)[j].coeffs();
      const auto after = edited.clip.poses.rotations(i)[j].coeffs();
      EXPECT_TRUE(of_legs[j] || after == before) << j;
    }
  }
}

// QUALITY.md, of edits that keep the walk's speed.
TEST(EditWalk, EditedWalksAreAsSmoothAsTheirCaptures) {
  AMBLE_NEEDS_CAPTURES();
  for (const std::string& path : kStraight) {
    const CapturedWalk walk = capturedWalk(path);
    EditRequest request = withStride(0.9, 1.1);
    request.incline = Ramp{3.0 * kDegree, 3.0 * kDegree};
    request.foot_lock = true;
    const Clip clip = editWalk(walk, request).clip;
    EXPECT_LT(jointJerk(clip), 1.1 * jointJerk(walk.clip)) << path;
    EXPECT_LT(rootAcceleration(clip), 1.15 * rootAcceleration(walk.clip)) << path;
    EXPECT_LT(pops(clip), std::max(2.5, 1.05 * pops(walk.clip))) << path;
    EXPECT_EQ(kneeBackwardsShare(clip, walk.roles), 0.0) << path;
  }
}

TEST(EditWalk, WhatLegsAreTooShortForIsRefused) {
  AMBLE_NEEDS_CAPTURES();
  const CapturedWalk walk = capturedWalk("mocap/cmu_mb2/08_07.bvh");  // steps of 1.1 m
  const EditedWalk edited = editWalk(walk, withStride(1.4, 1.4));
  EXPECT_NE(edited.refused.find("hips would go down"), std::string::npos);
  EditRequest far;
  far.arrive = Eigen::Vector2d(100.0, 0.0);
  EXPECT_NE(editWalk(walk, far).refused.find("strides are scaled by 0.6 to 1.4"),
            std::string::npos);
}

}  // namespace
}  // namespace amble

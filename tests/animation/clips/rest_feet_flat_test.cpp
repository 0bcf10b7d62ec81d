#include "animation/clips/rest_feet_flat.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "animation/body/reference_pose.h"
#include "animation/body/rest_feet.h"
#include "animation/clips/level_capture.h"
#include "base/rotation.h"
#include "tests/animation/captures.h"
#include "tests/animation/rig.h"

namespace amble {
namespace {

// The rig's walk with joint frames in which the feet hang at rest, by so much more than they do
// (about the rig's x, its left), and the toes straight down.
Clip hanging(const Rig& rig, double more) {
  const Clip walk = rig.walk({});
  std::vector<Eigen::Quaterniond> turns(walk.skeleton.size(), Eigen::Quaterniond::Identity());
  for (const LegJoints& leg : rig.roles.legs) {
    turns[leg.foot] = Eigen::AngleAxisd(-more, Eigen::Vector3d::UnitX());
    turns[leg.toe] = Eigen::AngleAxisd(-0.5 * kPi, Eigen::Vector3d::UnitX());
  }
  return withTurnedFrames(walk, turns);
}

// Joints and tips of both are at the same places.
void expectSamePlaces(const Clip& a, const Clip& b) {
  std::vector<JointFrame> at(a.skeleton.size()), bt(b.skeleton.size());
  for (int i = 0; i < a.frames(); i += 7) {
    forwardKinematics(a, i, at);
    forwardKinematics(b, i, bt);
    for (int j = 0; j < a.skeleton.size(); ++j) {
      EXPECT_LT((at[j].p_WJ - bt[j].p_WJ).norm(), 1e-9) << i << " " << j;
      const auto &tips = a.skeleton.joint(j).end_sites, &others = b.skeleton.joint(j).end_sites;
      for (size_t k = 0; k < tips.size(); ++k) {
        EXPECT_LT((at[j] * tips[k] - bt[j] * others[k]).norm(), 1e-9) << i << " " << j;
      }
    }
  }
}

TEST(RestFeetFlat, FlatFeetStayAsTheyAre) {
  const Rig rig;
  const Clip walk = rig.walk({});
  Clip rested = walk;
  EXPECT_FALSE(restFeetFlat(rested, rig.roles));
  for (int j = 0; j < walk.skeleton.size(); ++j) {
    EXPECT_EQ(rested.skeleton.joint(j).offset, walk.skeleton.joint(j).offset);
  }
}

TEST(RestFeetFlat, FeetThatNeverStandStayAsTheyAre) {
  const Rig rig;
  Clip clip = hanging(rig, 1.2);
  for (int i = 0; i < clip.frames(); ++i) clip.poses.p_WR(i).x() += 3.0 * i * clip.frame_time;
  EXPECT_FALSE(standingFootDrops(clip, rig.roles).has_value());
  EXPECT_FALSE(restFeetFlat(clip, rig.roles));
}

TEST(RestFeetFlat, NothingMoves) {
  const Rig rig;
  const Clip hung = hanging(rig, 1.2);
  Clip rested = hung;
  ASSERT_TRUE(restFeetFlat(rested, rig.roles));
  expectSamePlaces(hung, rested);
  expectSamePlaces(hung, rig.walk({}));
}

// However far they hang, even beyond straight down, where the toes point backwards: what is read
// is the foot that stands in the clip, which is this rig's.
TEST(RestFeetFlat, FeetAreShapedAsTheyStand) {
  const Rig rig;
  for (const double more : {0.9, 1.2, 1.5}) {
    Clip clip = hanging(rig, more);
    ASSERT_GT(restFootDrop(clip.skeleton, rig.roles), kHangingFoot) << more;
    ASSERT_TRUE(restFeetFlat(clip, rig.roles)) << more;
    for (const Side side : {kLeft, kRight}) {
      const FootShape foot =
          makeFootShape(clip.skeleton, rig.roles, side, statureOf(clip.skeleton, rig.roles));
      EXPECT_NEAR(foot.ankle_height, rig.feet[side].ankle_height, 1e-6) << more;
      EXPECT_NEAR(foot.ball_x, rig.feet[side].ball_x, 1e-6) << more;
      EXPECT_NEAR(foot.tip_x, rig.feet[side].tip_x, 1e-6) << more;
      EXPECT_LT(foot.q_SF.angularDistance(rig.feet[side].q_SF), 1e-6) << more;
    }
  }
}

// Markers tilt feet, the left and the right one differently: the rig's walk with frames of its feet
// turned by so much each.
TEST(RestFeetFlat, EachFootIsFlatAsItStandsItself) {
  const Rig rig;
  const Clip walk = rig.walk({});
  for (const auto& [left, right] : {std::pair(13.0, 4.0), std::pair(-6.0, 4.0)}) {
    std::vector<Eigen::Quaterniond> turns(walk.skeleton.size(), Eigen::Quaterniond::Identity());
    for (const Side side : {kLeft, kRight}) {
      const LegJoints& leg = rig.roles.legs[side];
      const double tilt = (side == kLeft ? left : right) * kDegree;
      turns[leg.foot] = turns[leg.toe] = Eigen::AngleAxisd(tilt, Eigen::Vector3d::UnitX());
    }
    const Clip tilted = withTurnedFrames(walk, turns);
    Clip rested = tilted;
    ASSERT_TRUE(restFeetFlat(rested, rig.roles));
    expectSamePlaces(tilted, rested);
    const std::array<double, 2> drops = footDrops(rested.skeleton, rig.roles);
    const std::array<double, 2> own = footDrops(rig.skeleton, rig.roles);
    for (const Side side : {kLeft, kRight}) {
      EXPECT_NEAR(drops[side], own[side], 1e-6);
      const LegJoints& leg = rig.roles.legs[side];
      for (int i = 0; i < walk.frames(); i += 11) {
        for (const int joint : {leg.foot, leg.toe}) {
          EXPECT_LT(
              rested.poses.rotations(i)[joint].angularDistance(walk.poses.rotations(i)[joint]),
              1e-6);
        }
      }
    }
    Clip again = rested;
    EXPECT_FALSE(restFeetFlat(again, rig.roles));
  }
}

// In these captures the rest pose is off by half a turn about the arms' bones, so that what is
// relative to it flips over. Relative to a natural one an arm turns by no more than people do.
TEST(RestFeetFlat, ArmsAreTwistedAtRestAsTheyAreInTheClip) {
  AMBLE_NEEDS_CAPTURES();
  int rigs = 0;
  for (const Capture& capture : captures()) {
    if (!capture.path.starts_with("cmu_style_loops/")) continue;
    SCOPED_TRACE(capture.path);
    LevelCapture read = readLevelCapture(capture.file);
    Clip& clip = read.motion.clip;
    const JointRoles& roles = read.motion.roles;
    ASSERT_TRUE(restFeetFlat(clip, roles));
    const ReferencePose rest = referenceOf(clip, roles), mean = meanPose(clip, roles);
    for (const ArmJoints& arm : roles.arms) {
      for (const int j : {arm.arm, arm.fore_arm}) {
        const Eigen::Vector3d bone = clip.skeleton.joint(j + 1).offset.normalized();
        const Eigen::Quaterniond turn = rest.q_HJ[j].conjugate() * mean.q_HJ[j];
        const double twist = 2.0 * std::atan2(turn.vec().dot(bone), turn.w());
        EXPECT_LT(std::abs(wrapAngle(twist)), 30.0 * kDegree) << clip.skeleton.joint(j).name;
      }
    }
    ++rigs;
  }
  EXPECT_EQ(rigs, 17);
}

}  // namespace
}  // namespace amble

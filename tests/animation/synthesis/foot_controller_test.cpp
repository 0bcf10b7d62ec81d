#include "animation/synthesis/foot_controller.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "animation/body/pelvis.h"
#include "animation/clips/carry_over.h"
#include "animation/library/motion_library_reader.h"
#include "animation/synthesis/walk_controller.h"
#include "animation/synthesis/walk_synthesizer.h"
#include "base/rotation.h"
#include "tests/animation/random_clip.h"
#include "tests/animation/walk_paths.h"

namespace amble {
namespace {

/// The default library's character, standing at the origin unless told otherwise.
struct Standing {
  MotionLibrary library = openMotionLibrary("default");
  std::array<FootShape, 2> shapes = library.feet();
  GaitBlend blend{library, 1.0};
  FootController feet{library.skeleton, library.roles, shapes, blend,
                      kneeAxes(library.roles, referenceOf(library.skeleton, library.roles,
                                                          library.stand().rotations))};

  /// `frames` frames of the standing posture with its root at a height, feet 16 cm apart.
  AnimationBuffer buffer(int frames, double root_height) const {
    AnimationBuffer out;
    out.poses = PoseArray(library.skeleton.size());
    out.poses.resize(frames);
    FrameState state;
    for (const Side side : {kLeft, kRight}) {
      FootState& foot = state.feet[side];
      foot.at = 0.5;
      foot.strike_roll = foot.lift_roll = 0.0;
      foot.from.position = foot.to.position = {0.0, side == kLeft ? 0.08 : -0.08, 0.0};
    }
    for (int i = 0; i < frames; ++i) {
      out.states.push_back(state);
      out.poses.p_WR(i) = {0.0, 0.0, root_height};
      std::ranges::copy(library.stand().rotations, out.poses.rotations(i).begin());
    }
    return out;
  }

  std::vector<JointFrame> joints(const AnimationBuffer& buffer, int frame) const {
    std::vector<JointFrame> frames(library.skeleton.size());
    forwardKinematics(library.skeleton, buffer.poses[frame], frames);
    return frames;
  }
  double low() const { return library.stand().root_height - 0.03; }  // knees bent a little
};

constexpr double kFar = 10.0;  // a leg that is never too short [m]

TEST(FootController, AFootprintOutOfReachIsRefused) {
  const Standing s;
  AnimationBuffer buffer = s.buffer(3, s.low());
  buffer.states[1].feet[kLeft].from.position.x() = 0.9;
  EXPECT_FALSE(s.feet.apply(buffer));
}

TEST(FootController, ARootTooHighForItsLegsIsRefused) {
  const Standing s;
  AnimationBuffer buffer = s.buffer(1, s.library.stand().root_height + 0.2);
  EXPECT_FALSE(s.feet.apply(buffer));
}

TEST(FootController, FeetComeToTheirTargetsAndNothingElseMoves) {
  const Standing s;
  const AnimationBuffer before = s.buffer(1, s.low());
  AnimationBuffer after = before;
  ASSERT_TRUE(s.feet.apply(after));
  const auto joints = s.joints(after, 0);
  for (const Side side : {kLeft, kRight}) {
    const LegJoints& leg = s.library.roles.legs[side];
    const FootTarget target = footTarget(after.states[0].feet[side], s.blend.foot(side),
                                         s.shapes[side], joints[leg.up_leg].p_WJ, kFar);
    EXPECT_LT((joints[leg.foot].p_WJ - target.ankle).norm(), 1e-9);
    EXPECT_LT(joints[leg.foot].q_WJ.angularDistance(target.q_WF), 1e-6);
  }
  EXPECT_EQ(after.poses.p_WR(0), before.poses.p_WR(0));
  for (int j = 0; j < s.library.skeleton.size(); ++j) {
    if (s.library.skeleton.isAncestor(s.library.roles.legs[kLeft].up_leg, j) ||
        s.library.skeleton.isAncestor(s.library.roles.legs[kRight].up_leg, j)) {
      continue;
    }
    EXPECT_EQ(after.poses.rotations(0)[j].coeffs(), before.poses.rotations(0)[j].coeffs());
  }
}

// How much lower than `root_height` the standing root is put [m].
double loweredBy(const Standing& s, double root_height) {
  AnimationBuffer buffer = s.buffer(1, root_height);
  EXPECT_TRUE(s.feet.apply(buffer));
  return root_height - buffer.poses.p_WR(0).z();
}

TEST(FootController, ARootIsLoweredUntilItsLegsReachAndNoFarther) {
  const Standing s;
  const double high = s.library.stand().root_height + 0.05;
  const double lowered = loweredBy(s, high);
  ASSERT_GT(lowered, 0.0);
  EXPECT_NEAR(loweredBy(s, high - 0.02), lowered - 0.02, 1e-3);
  EXPECT_EQ(loweredBy(s, high - lowered - 0.01), 0.0);
}

TEST(FootController, HipsDipWhereALegIsTooShortAndNotAtStancesThatReach) {
  const Standing s;
  const double high = s.library.stand().root_height + 0.05;
  AnimationBuffer buffer = s.buffer(121, s.low());
  buffer.poses.p_WR(60).z() = high;
  const AnimationBuffer before = buffer;
  ASSERT_TRUE(s.feet.apply(buffer));
  EXPECT_LE(buffer.poses.p_WR(60).z(), high - loweredBy(s, high) + 1e-9);
  EXPECT_LT(buffer.poses.p_WR(57).z(), before.poses.p_WR(57).z());
  EXPECT_EQ(buffer.poses.p_WR(0), before.poses.p_WR(0));
  EXPECT_EQ(buffer.poses.p_WR(120), before.poses.p_WR(120));
}

// Whether hips were lowered on the way or before makes no difference to the legs.
TEST(FootController, LegsUnderHipsThatDippedAreThoseOfHipsThatWereAsLow) {
  const Standing s;
  AnimationBuffer dipped = s.buffer(61, s.low());
  for (int i = 25; i <= 35; ++i) dipped.poses.p_WR(i).z() += 0.05;
  AnimationBuffer low = dipped;
  ASSERT_TRUE(s.feet.apply(dipped));
  // A little lower still: there a leg is never too short.
  for (int i = 0; i < low.size(); ++i) low.poses.p_WR(i) = dipped.poses.p_WR(i);
  for (int i = 1; i + 1 < low.size(); ++i) low.poses.p_WR(i).z() -= 1e-9;
  ASSERT_TRUE(s.feet.apply(low));
  int bent = 0;
  for (int i = 0; i < low.size(); ++i) {
    bent += low.poses.p_WR(i).z() < s.low() - 0.001;
    for (int j = 0; j < s.library.skeleton.size(); ++j) {
      EXPECT_LT(low.poses.rotations(i)[j].angularDistance(dipped.poses.rotations(i)[j]), 1e-5)
          << i << " " << j;
    }
  }
  EXPECT_GT(bent, 0);
}

TEST(FootTarget, AStandingFootIsFlatOnItsPrint) {
  const Standing s;
  FootState foot;
  foot.at = 0.5;
  foot.strike_roll = foot.lift_roll = 0.0;
  foot.from.position = foot.to.position = {1, 2, 0.3};
  foot.from.heading = foot.to.heading = 0.9;
  const FootShape& shape = s.shapes[kLeft];
  const FootTarget target = footTarget(foot, s.blend.foot(kLeft), shape, {1, 2, 1}, kFar);
  const Eigen::Vector3d on_S(shape.ankle_x, 0, shape.ankle_height);
  EXPECT_LT((target.ankle - foot.from.position - aboutZ(0.9) * on_S).norm(), 1e-12);
  EXPECT_LT(target.q_WF.angularDistance(aboutZ(0.9) * shape.q_SF), 1e-7);
  EXPECT_EQ(target.toe_bend, 0.0);
}

TEST(FootTarget, APlantedFootRollsAboutAPointThatDoesNotMove) {
  const Standing s;
  for (const Side side : {kLeft, kRight}) {
    const FootShape& shape = s.shapes[side];
    for (double at = 0.0; at <= 1.0; at += 0.01) {
      FootState foot;
      foot.at = at;
      const FootTarget target = footTarget(foot, s.blend.foot(side), shape, {0, 0, 1}, kFar);
      const Eigen::Quaterniond q_WS = target.q_WF * shape.q_SF.conjugate();
      double pivot = footPitch(s.blend.foot(side), at) < 0.0 ? shape.heel_x : shape.ball_x;
      Eigen::Vector3d p = target.ankle + q_WS * Eigen::Vector3d(pivot - shape.ankle_x, 0,
                                                                shape.radius - shape.ankle_height);
      if (toeRoll(s.blend.foot(side), at) > 0.0) {  // about the tip of its toes
        const Eigen::Vector3d toes(shape.tip_x - pivot, 0, 0);
        p += q_WS * (Eigen::AngleAxisd(-target.toe_bend, Eigen::Vector3d::UnitY()) * toes);
        pivot = shape.tip_x;
      }
      EXPECT_LT((p - Eigen::Vector3d(pivot, 0, shape.radius)).norm(), 1e-12);
    }
  }
}

TEST(FootTarget, ASwingIsContinuousWithTheStancesAroundIt) {
  const Standing s;
  FootState before, swing, after;
  before.at = 1.0;
  swing.to.position = {1.2, 0.1, 0.05};
  swing.to.heading = 0.2;
  after.from = after.to = swing.to;
  const auto targetOf = [&](const FootState& state) {
    return footTarget(state, s.blend.foot(kLeft), s.shapes[kLeft], {0.6, 0, 1}, kFar);
  };
  swing.at = 1.0 + 1e-9;
  EXPECT_LT((targetOf(before).ankle - targetOf(swing).ankle).norm(), 1e-6);
  EXPECT_LT(targetOf(before).q_WF.angularDistance(targetOf(swing).q_WF), 1e-6);
  swing.at = 2.0;
  EXPECT_LT((targetOf(after).ankle - targetOf(swing).ankle).norm(), 1e-9);
  EXPECT_LT(targetOf(after).q_WF.angularDistance(targetOf(swing).q_WF), 1e-6);
}

TEST(FootTarget, TheHeelOfALegBehindRisesWhereTheLegWouldBeTooLong) {
  const Standing s;
  FootState foot;
  foot.at = 0.5;
  const Eigen::Vector3d hip(0.45, 0.0, 0.85);  // far ahead of the foot
  const FootTarget free = footTarget(foot, s.blend.foot(kLeft), s.shapes[kLeft], hip, kFar);
  const double longest = (free.ankle - hip).norm() - 0.02;
  const FootTarget held = footTarget(foot, s.blend.foot(kLeft), s.shapes[kLeft], hip, longest);
  EXPECT_LT((held.ankle - hip).norm(), longest + 1e-6);
  EXPECT_GT(held.ankle.z(), free.ankle.z());
  EXPECT_GT(held.toe_bend, 0.0);
}

TEST(FootTarget, AHeelInFrontDoesNotRise) {
  const Standing s;
  FootState foot;
  foot.at = 0.5;
  const Eigen::Vector3d hip(-0.45, 0.0, 0.85);
  const FootTarget free = footTarget(foot, s.blend.foot(kLeft), s.shapes[kLeft], hip, kFar);
  const FootTarget held = footTarget(foot, s.blend.foot(kLeft), s.shapes[kLeft], hip, 0.5);
  EXPECT_LT((held.ankle - free.ankle).norm(), 1e-12);
}

// Captured ones go by 16 mm in a frame of 30 Hz, in turns.
TEST(FootController, AKneeNeverFlicksSidewaysInACurve) {
  const MotionLibrary library = openMotionLibrary("default");
  const FlatGround ground;
  const WalkSynthesizer walker(library, ground, {});
  std::vector<JointFrame> joints(library.skeleton.size());
  for (const Eigen::Vector2d& goal : {Eigen::Vector2d(3, 3), Eigen::Vector2d(3, 2)}) {
    const RootPath path({makeBezier(Eigen::Vector2d::Zero(), 0.0, goal, 0.0)});
    AnimationBuffer walk;
    ASSERT_EQ(walker.walk({}, stanceAt(path, true, true), path, true, walk).refused,
              WalkRule::kNone);
    std::array<double, 2> before = {};
    for (int i = 0; i < walk.size(); ++i) {
      forwardKinematics(library.skeleton, walk.poses[i], joints);
      const Eigen::Vector3d left =
          aboutZ(pelvisHeading(joints, library.roles)) * Eigen::Vector3d::UnitY();
      for (const Side side : {kLeft, kRight}) {
        const LegJoints& leg = library.roles.legs[side];
        const Eigen::Vector3d hip = joints[leg.up_leg].p_WJ, knee = joints[leg.leg].p_WJ - hip;
        const Eigen::Vector3d way = (joints[leg.foot].p_WJ - hip).normalized();
        const double aside = (knee - knee.dot(way) * way).dot(left);
        EXPECT_LT(i > 0 ? std::abs(aside - before[side]) : 0.0, 0.020) << i << " " << goal.y();
        before[side] = aside;
      }
    }
  }
}

}  // namespace
}  // namespace amble

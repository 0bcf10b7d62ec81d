#include "animation/synthesis/walk_synthesizer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "animation/body/foot_shape.h"
#include "base/rotation.h"
#include "tests/animation/default_library.h"
#include "tests/animation/random_clip.h"
#include "tests/animation/walk_paths.h"

namespace amble {
namespace {

/// The floor, but for a hole.
class HoledGround : public Ground {
 public:
  explicit HoledGround(Eigen::AlignedBox2d hole) : hole_(hole) {}
  std::optional<SurfacePoint> surface(double x, double y, double, double) const override {
    if (hole_.contains(Eigen::Vector2d(x, y))) return std::nullopt;
    return SurfacePoint{};
  }

 private:
  Eigen::AlignedBox2d hole_;
};

const FlatGround kFloor;

WalkSynthesizer walker(double speed = 1.2, double height = 0.0, double frame_time = 1.0 / 60.0) {
  return WalkSynthesizer(defaultLibrary(), kFloor, {height, speed, frame_time});
}

testing::AssertionResult samePose(PoseView a, PoseView b) {
  if (a.p_WR != b.p_WR) {
    return testing::AssertionFailure() << "roots are " << (a.p_WR - b.p_WR).norm() << " m apart";
  }
  for (size_t j = 0; j < a.rotations.size(); ++j) {
    if (a.rotations[j].coeffs() == b.rotations[j].coeffs()) continue;
    return testing::AssertionFailure()
           << "joint " << j << " is turned by " << a.rotations[j].angularDistance(b.rotations[j]);
  }
  return testing::AssertionSuccess();
}

testing::AssertionResult sameWalk(const AnimationBuffer& a, const AnimationBuffer& b) {
  if (a.size() != b.size()) return testing::AssertionFailure() << "of other lengths";
  for (int i = 0; i < a.size(); ++i) {
    const auto same = samePose(a.poses[i], b.poses[i]);
    if (!same) return testing::AssertionFailure() << "frame " << i << ": " << same.message();
  }
  return testing::AssertionSuccess();
}

/// A foot's sole in a frame: centres of heel, ball and toe tip [m, World].
struct Sole {
  Eigen::Vector3d heel, ball, tip;
};

/// A walk's joints, for theorems on what is seen.
class SeenWalk {
 public:
  SeenWalk(const WalkSynthesizer& character, const AnimationBuffer& buffer)
      : character_(character),
        buffer_(buffer),
        shapes_{shapeOf(kLeft), shapeOf(kRight)},
        joints_(character.skeleton().size()) {}

  void toFrame(int frame) {
    forwardKinematics(character_.skeleton(), buffer_.poses[frame], joints_);
  }
  const FootShape& shape(Side side) const { return shapes_[side]; }
  Sole sole(Side side) const {
    const FootShape& s = shapes_[side];
    const LegJoints& leg = character_.roles().legs[side];
    const JointFrame &foot = joints_[leg.foot], &toe = joints_[leg.toe];
    const Eigen::Quaterniond q_WS = foot.q_WJ * s.q_SF.conjugate();
    const Eigen::Vector3d ankle(s.ankle_x, 0.0, s.ankle_height);
    const Eigen::Quaterniond q_TS = (s.q_SF * s.q_FT).conjugate();
    return {foot.p_WJ + q_WS * (Eigen::Vector3d(s.heel_x, 0, s.radius) - ankle),
            foot.p_WJ + q_WS * (Eigen::Vector3d(s.ball_x, 0, s.radius) - ankle),
            toe.p_WJ + toe.q_WJ * (q_TS * Eigen::Vector3d(s.tip_x - s.ball_x, 0, 0))};
  }
  /// Sine of the knee's flexion about the walker's left, forward flexion positive.
  double kneeFlexion(Side side) const {
    const LegJoints& leg = character_.roles().legs[side];
    const Eigen::Vector3d thigh = joints_[leg.leg].p_WJ - joints_[leg.up_leg].p_WJ;
    const Eigen::Vector3d shank = joints_[leg.foot].p_WJ - joints_[leg.leg].p_WJ;
    const Eigen::Vector3d left_R =
        restToHeading(character_.skeleton(), character_.roles()).conjugate() *
        Eigen::Vector3d::UnitY();
    return thigh.normalized().cross(shank.normalized()).dot(joints_[leg.up_leg].q_WJ * left_R);
  }

 private:
  FootShape shapeOf(Side side) const {
    return makeFootShape(character_.skeleton(), character_.roles(), side, character_.stature());
  }

  const WalkSynthesizer& character_;
  const AnimationBuffer& buffer_;
  std::array<FootShape, 2> shapes_;
  std::vector<JointFrame> joints_;
};

/// Walks along a path from standing to standing.
WalkResult walkAlong(const WalkSynthesizer& character, const RootPath& path, AnimationBuffer& out,
                     bool from_standing = true, bool to_standing = true) {
  return character.walk(stanceAt(path, false, from_standing), stanceAt(path, true, to_standing),
                        path, true, out);
}

/// What must hold of every walk, wherever it goes.
void expectGoodWalk(const WalkSynthesizer& character, const AnimationBuffer& buffer) {
  SeenWalk seen(character, buffer);
  double drift = 0.0, lowest = 1.0, backwards = 0.0, unit = 0.0;
  for (int i = 0; i < buffer.size(); ++i) {
    seen.toFrame(i);
    for (const Eigen::Quaterniond& q : buffer.poses[i].rotations) {
      unit = std::max(unit, std::abs(q.norm() - 1.0));
    }
    for (const Side side : {kLeft, kRight}) {
      const FootShape& shape = seen.shape(side);
      const Sole sole = seen.sole(side);
      for (const Eigen::Vector3d& p : {sole.heel, sole.ball, sole.tip}) {
        lowest = std::min(lowest, p.z() - shape.radius);
      }
      backwards = std::min(backwards, seen.kneeFlexion(side));
      if (!buffer.states[i].planted[side]) continue;
      // It rolls about its heel, its ball or the tip of its toes, whose centres stay over the
      // footprint.
      const FootPlace& print = buffer.states[i].feet[side].from;
      const auto over = [&](double x) {
        const Eigen::Vector3d p_S(x, 0, shape.radius);
        return Eigen::Vector3d(print.position + aboutZ(print.heading) * p_S);
      };
      drift = std::max(drift, std::min({(sole.heel - over(shape.heel_x)).norm(),
                                        (sole.ball - over(shape.ball_x)).norm(),
                                        (sole.tip - over(shape.tip_x)).norm()}));
    }
  }
  EXPECT_LT(drift, 1e-4) << "a planted foot's contact moves";
  EXPECT_GT(lowest, -1e-4) << "a sole is below the ground";
  EXPECT_GT(backwards, -1e-6) << "a knee bends backwards";
  EXPECT_LT(unit, 1e-9) << "a rotation is no unit quaternion";
}

// Whole metres are whole numbers of the parts in which a path is looked at; what a rounding adds to
// their length may not add a part.
TEST(WalkSynthesizer, AWalkIsTheSameWhereverItIsAndWhicheverWayItFaces) {
  const WalkSynthesizer synthesizer = walker();
  AnimationBuffer here, there;
  for (const double length : {2.0, 5.0, 6.0}) {
    for (int i = 0; i < 12; ++i) {
      const double heading = i == 0 ? 0.0 : 0.5 * i;
      const Eigen::Vector2d place = i * Eigen::Vector2d(-13.0, 7.1);
      Stance from, to;
      from.position << place, 0.0;
      to.position << place + length * Eigen::Vector2d(std::cos(heading), std::sin(heading)), 0.0;
      from.heading = to.heading = heading;
      const RootPath path(
          {makeBezier(from.position.head<2>(), heading, to.position.head<2>(), heading)});
      ASSERT_EQ(synthesizer.walk(from, to, path, true, there).refused, WalkRule::kNone);
      if (i == 0) here = there;
      ASSERT_EQ(there.size(), here.size()) << length << " at " << heading;
      for (int k = 0; k < here.size(); ++k) {
        for (int j = 1; j < here.poses.joints(); ++j) {
          ASSERT_LT(here.poses.rotations(k)[j].angularDistance(there.poses.rotations(k)[j]), 1e-7)
              << length << " at " << heading << ", frame " << k << ", joint " << j;
        }
      }
    }
  }
}

TEST(WalkSynthesizer, RefusesSettingsOutOfRange) {
  EXPECT_THROW(walker(0.29), std::invalid_argument);
  EXPECT_THROW(walker(2.01), std::invalid_argument);
  EXPECT_THROW(walker(NAN), std::invalid_argument);
  EXPECT_THROW(walker(1.2, 0.49), std::invalid_argument);
  EXPECT_THROW(walker(1.2, 2.51), std::invalid_argument);
  EXPECT_THROW(walker(1.2, 1.7, 1.0 / 241.0), std::invalid_argument);
  EXPECT_THROW(walker(1.2, 1.7, 0.1), std::invalid_argument);
}

TEST(WalkSynthesizer, APathWithAGapInTheGroundIsRefused) {
  const HoledGround ground({Eigen::Vector2d(1.5, -1.0), Eigen::Vector2d(2.5, 1.0)});
  const WalkSynthesizer character(defaultLibrary(), ground, {0.0, 1.2, 1.0 / 60.0});
  AnimationBuffer out;
  EXPECT_EQ(walkAlong(character, straightPath(4.0), out).refused, WalkRule::kNoGround);
  EXPECT_EQ(walkAlong(character, straightPath(1.2), out).refused, WalkRule::kNone);
  EXPECT_EQ(character.stand({{2.0, 0, 0}, 0.0}, out).refused, WalkRule::kNoGround);
  EXPECT_EQ(character.turnOnSpot({{2.0, 0, 0}, 0.0}, 1.0, out).refused, WalkRule::kNoGround);
}

TEST(WalkSynthesizer, AWalkingStanceInTooTightACurveIsRefused) {
  const WalkSynthesizer character = walker();
  const double tightest = 1.2 / character.maxTurnRate();
  AnimationBuffer out;
  for (const double sign : {1.0, -1.0}) {
    const double tight = sign * 0.9 * tightest, wide = sign * 1.1 * tightest;
    for (const auto& [from, to] : {std::pair(false, true), {true, false}, {false, false}}) {
      const RootPath too_tight = circlePath(tight, 4.0 / tight);
      EXPECT_EQ(walkAlong(character, too_tight, out, from, to).refused, WalkRule::kTurnRate);
      const RootPath good = circlePath(wide, 4.0 / wide);
      EXPECT_NE(walkAlong(character, good, out, from, to).refused, WalkRule::kTurnRate);
    }
  }
}

TEST(WalkSynthesizer, APathTooShortForTwoStepsIsRefused) {
  const WalkSynthesizer character = walker();
  AnimationBuffer out;
  EXPECT_EQ(walkAlong(character, straightPath(0.04), out).refused, WalkRule::kStepLength);
  EXPECT_EQ(walkAlong(character, straightPath(0.5), out, false, false).refused,
            WalkRule::kStepLength);
}

TEST(WalkSynthesizer, StandingWalksBeginAndEndInTheStandingPoseToTheBit) {
  Generator generator(61);
  const WalkSynthesizer character = walker();
  AnimationBuffer walk, stand;
  for (int i = 0; i < 10; ++i) {
    const double heading = uniform(generator, -kPi, kPi), radius = uniform(generator, 1.5, 6.0);
    const RootPath path = circlePath(radius, uniform(generator, 1.0, 5.0) / radius, heading);
    ASSERT_EQ(walkAlong(character, path, walk).refused, WalkRule::kNone);
    character.stand(stanceAt(path, false, true), stand);
    EXPECT_TRUE(samePose(walk.poses[0], stand.poses[0]));
    character.stand(stanceAt(path, true, true), stand);
    EXPECT_TRUE(samePose(walk.poses[walk.size() - 1], stand.poses[0]));
  }
}

TEST(WalkSynthesizer, WalksMeetAtAWalkingStanceToTheBit) {
  const WalkSynthesizer character = walker();
  const double radius = 2.5;
  for (const Side leading : {kLeft, kRight}) {
    for (const double sign : {1.0, -1.0}) {
      RootPath to_b = circlePath(sign * radius, sign * 3.0 / radius, 0.7);
      const Stance bend = stanceAt(to_b, true, false);
      to_b.append(straightPath(1.5, bend.heading, bend.position.head<2>()));
      const Stance b = stanceAt(to_b, true, false, leading);
      const RootPath from_b = straightPath(3.5, b.heading, b.position.head<2>());
      AnimationBuffer one, two;
      const WalkResult first = character.walk(stanceAt(to_b, false, true), b, to_b, false, one);
      ASSERT_EQ(first.refused, WalkRule::kNone);
      EXPECT_EQ(first.leading, leading);
      const WalkResult next = character.walk(b, stanceAt(from_b, true, true), from_b, true, two);
      ASSERT_EQ(next.refused, WalkRule::kNone);
      EXPECT_TRUE(samePose(one.poses[one.size() - 1], two.poses[0]));
      one.append(two);
      expectGoodWalk(character, one);
    }
  }
}

TEST(WalkSynthesizer, WhicheverFootLeadsAtTheEndIsGivenBack) {
  const WalkSynthesizer character = walker();
  AnimationBuffer walk, on;
  for (const double length : {2.3, 2.9, 3.6}) {
    const RootPath path = straightPath(length), next = straightPath(3.0, 0.0, {length, 0.0});
    const WalkResult result = walkAlong(character, path, walk, true, false);
    ASSERT_EQ(result.refused, WalkRule::kNone);
    const Stance b = stanceAt(path, true, false, result.leading);
    ASSERT_EQ(character.walk(b, stanceAt(next, true, true), next, true, on).refused,
              WalkRule::kNone);
    EXPECT_TRUE(samePose(walk.poses[walk.size() - 1], on.poses[0]));
  }
}

TEST(WalkSynthesizer, TheSameCallGivesTheSameBits) {
  const RootPath path = circlePath(2.0, 2.0, -0.4), other = straightPath(5.0);
  const WalkSynthesizer one = walker(), two = walker();
  AnimationBuffer a, b;
  ASSERT_EQ(walkAlong(one, path, a).refused, WalkRule::kNone);
  walkAlong(two, other, b);  // a buffer and a synthesizer that were used before
  ASSERT_EQ(walkAlong(two, path, b).refused, WalkRule::kNone);
  EXPECT_TRUE(sameWalk(a, b));
}

TEST(WalkSynthesizer, EverydaySpeedsAndCurvesAreWalkedWell) {
  for (const double speed : {0.6, 1.0, 1.5, 2.0}) {
    const WalkSynthesizer character = walker(speed);
    AnimationBuffer out;
    ASSERT_EQ(walkAlong(character, straightPath(6.0), out).refused, WalkRule::kNone) << speed;
    expectGoodWalk(character, out);
    for (const double radius : {1.5, -1.5, 3.0, -3.0, 5.0, -5.0}) {
      const RootPath path = circlePath(radius, std::copysign(6.0, radius) / std::abs(radius));
      ASSERT_EQ(walkAlong(character, path, out).refused, WalkRule::kNone)
          << speed << " m/s, radius " << radius;
      expectGoodWalk(character, out);
    }
  }
}

TEST(WalkSynthesizer, ALongStraightWalkHasTheSpeedThatIsAsked) {
  for (const double speed : {0.6, 0.9, 1.2, 1.6, 2.0}) {
    const WalkSynthesizer character = walker(speed);
    AnimationBuffer out;
    const RootPath path = straightPath(20.0);
    ASSERT_EQ(walkAlong(character, path, out, false, false).refused, WalkRule::kNone);
    EXPECT_NEAR(20.0 / ((out.size() - 1) * out.frame_time), speed, 0.05 * speed);
  }
}

TEST(WalkSynthesizer, StepsOfALongStraightWalkAreAlikeAndAddUpToItsLength) {
  const WalkSynthesizer character = walker();
  const RootPath path = straightPath(20.0);
  AnimationBuffer out;
  const WalkResult result =
      character.walk(stanceAt(path, false, false), stanceAt(path, true, false), path, false, out);
  ASSERT_EQ(result.refused, WalkRule::kNone);
  ASSERT_EQ(static_cast<int>(out.footprints.size()), result.steps + 2);
  // From leading foot to leading foot the walk is as long as its path.
  const Footprint &last = out.footprints.back(), *first = nullptr;
  for (const Footprint& print : out.footprints) {
    if (print.first_frame == 0 && print.side == kLeft) first = &print;
  }
  ASSERT_NE(first, nullptr);
  EXPECT_EQ(last.side, kLeft);
  EXPECT_NEAR(last.position.x() - first->position.x(), 20.0, 1e-9);
  for (size_t i = 2; i < out.footprints.size(); ++i) {
    const Footprint &a = out.footprints[i - 1], &b = out.footprints[i];
    if (a.first_frame == 0) continue;
    EXPECT_NE(a.side, b.side);
    EXPECT_NEAR(b.position.x() - a.position.x(), character.stepLength(),
                0.05 * character.stepLength());
  }
}

TEST(WalkSynthesizer, TheRootEndsOverTheGoal) {
  const WalkSynthesizer character = walker();
  AnimationBuffer out;
  const RootPath path = circlePath(3.0, 1.5, 0.2);
  ASSERT_EQ(walkAlong(character, path, out).refused, WalkRule::kNone);
  const Eigen::Vector2d goal = path.at(path.length()).position;
  EXPECT_LT((out.poses.p_WR(out.size() - 1).head<2>() - goal).norm(), 1e-9);
  EXPECT_LT(out.poses.p_WR(0).head<2>().norm(), 1e-9);
}

TEST(WalkSynthesizer, ATurnOnTheSpotEndsAtItsAngle) {
  const WalkSynthesizer character = walker();
  const Stance at{{1, 2, 0}, 0.8};
  AnimationBuffer turn, stand;
  for (const double angle : {0.1, -0.5, kPi / 2, -kPi, 2.0 * kPi}) {
    ASSERT_EQ(character.turnOnSpot(at, angle, turn).refused, WalkRule::kNone) << angle;
    Stance end = at;
    end.heading += angle;
    character.stand(at, stand);
    EXPECT_TRUE(samePose(turn.poses[0], stand.poses[0]));
    character.stand(end, stand);
    EXPECT_TRUE(samePose(turn.poses[turn.size() - 1], stand.poses[0]));
    EXPECT_EQ(turn.states.back().heading, end.heading);
    EXPECT_LT((turn.poses.p_WR(turn.size() - 1) - turn.poses.p_WR(0)).norm(), 1e-9);
    expectGoodWalk(character, turn);
  }
}

TEST(WalkSynthesizer, ShortAndTallCharactersWalk) {
  for (const double height : {1.40, 1.90}) {
    const WalkSynthesizer character = walker(1.1, height);
    EXPECT_NEAR(character.stature(), height, 1e-12);
    EXPECT_NEAR(statureOf(character.skeleton(), character.roles()), height, 1e-6);
    AnimationBuffer out;
    for (const RootPath& path : {straightPath(5.0), circlePath(2.5, 2.0), circlePath(-2.5, -2.0)}) {
      ASSERT_EQ(walkAlong(character, path, out).refused, WalkRule::kNone) << height;
      expectGoodWalk(character, out);
    }
  }
}

TEST(WalkSynthesizer, AWalkIsTheSameAtAnyHeadingAndPlace) {
  const WalkSynthesizer character = walker();
  AnimationBuffer a, b;
  ASSERT_EQ(walkAlong(character, straightPath(4.0), a).refused, WalkRule::kNone);
  const double heading = 2.2;
  const Eigen::Vector3d to(-3, 5, 0);
  ASSERT_EQ(walkAlong(character, straightPath(4.0, heading, to.head<2>()), b).refused,
            WalkRule::kNone);
  ASSERT_EQ(a.size(), b.size());
  for (int i = 0; i < a.size(); ++i) {
    EXPECT_LT((aboutZ(heading) * a.poses.p_WR(i) + to - b.poses.p_WR(i)).norm(), 1e-6);
    for (int j = 1; j < a.poses.joints(); ++j) {
      EXPECT_LT(a.poses.rotations(i)[j].angularDistance(b.poses.rotations(i)[j]), 1e-5);
    }
  }
}

TEST(WalkSynthesizer, FootprintsAreOnTheGroundThatIsThere) {
  const FlatGround upstairs(2.7);
  const WalkSynthesizer character(defaultLibrary(), upstairs, {0.0, 1.2, 1.0 / 60.0});
  const RootPath path = straightPath(3.0);
  Stance from = stanceAt(path, false, true), to = stanceAt(path, true, true);
  from.position.z() = to.position.z() = 2.7;
  AnimationBuffer out, below;
  ASSERT_EQ(character.walk(from, to, path, true, out).refused, WalkRule::kNone);
  ASSERT_EQ(walkAlong(walker(), path, below).refused, WalkRule::kNone);
  for (const Footprint& print : out.footprints) EXPECT_EQ(print.position.z(), 2.7);
  for (int i = 0; i < out.size(); ++i) {
    EXPECT_NEAR(out.poses.p_WR(i).z(), below.poses.p_WR(i).z() + 2.7, 1e-9);
  }
}

TEST(WalkSynthesizer, TheShortestWalkIsWalkedAndAShorterOneIsNot) {
  for (const double speed : {0.4, 0.8, 1.2, 2.0}) {
    const WalkSynthesizer character = walker(speed);
    AnimationBuffer out;
    const double shortest = character.shortestWalk();
    ASSERT_EQ(walkAlong(character, straightPath(1.001 * shortest), out).refused, WalkRule::kNone);
    expectGoodWalk(character, out);
    EXPECT_EQ(walkAlong(character, straightPath(0.99 * shortest), out).refused,
              WalkRule::kStepLength);
  }
}

TEST(WalkSynthesizer, AFrameRateChangesWhatIsSeenNotWhereFeetGo) {
  const RootPath path = straightPath(5.0);
  AnimationBuffer fine, coarse;
  ASSERT_EQ(walkAlong(walker(1.2, 0.0, 1.0 / 120.0), path, fine).refused, WalkRule::kNone);
  ASSERT_EQ(walkAlong(walker(1.2, 0.0, 1.0 / 24.0), path, coarse).refused, WalkRule::kNone);
  ASSERT_EQ(fine.footprints.size(), coarse.footprints.size());
  for (size_t i = 0; i < fine.footprints.size(); ++i) {
    EXPECT_EQ(fine.footprints[i].side, coarse.footprints[i].side);
    EXPECT_LT((fine.footprints[i].position - coarse.footprints[i].position).norm(), 1e-9);
  }
}

}  // namespace
}  // namespace amble

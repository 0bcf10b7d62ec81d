// Turns on the spot of a library that has captured ones.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "animation/analysis/foot_plants.h"
#include "animation/analysis/gait_measures.h"
#include "animation/body/pelvis.h"
#include "animation/ground/stair_ground.h"
#include "animation/synthesis/captured_turns.h"
#include "animation/synthesis/motion_shares.h"
#include "animation/synthesis/turn_on_spot.h"
#include "animation/synthesis/walk_synthesizer.h"
#include "base/sample_stream.h"
#include "tests/animation/turning_library.h"
#include "tests/animation/walk_paths.h"

namespace amble {
namespace {

const FlatGround kLevelFloor;
constexpr double kHeights[] = {1.4, 0.0, 2.0};
constexpr double kTurns[] = {45.0, -45.0, 60.0, 90.0, -100.0, 135.0, -180.0, 225.0, 270.0, 360.0};

class TurnAsCaptured : public testing::Test {
 protected:
  void SetUp() override {
    AMBLE_NEEDS_CAPTURES();
    library_ = &turningLibrary();
  }
  Clip clipOf(const WalkSynthesizer& walker, const AnimationBuffer& buffer) const {
    Clip clip;
    clip.skeleton = walker.skeleton();
    clip.frame_time = buffer.frame_time;
    clip.poses = buffer.poses;
    return clip;
  }

  const MotionLibrary* library_ = nullptr;
};

void expectSamePose(const AnimationBuffer& a, int i, const AnimationBuffer& b, int k) {
  EXPECT_EQ(Eigen::Vector3d(a.poses.p_WR(i)), Eigen::Vector3d(b.poses.p_WR(k)));
  for (int j = 0; j < a.poses.joints(); ++j)
    EXPECT_EQ(a.poses.rotations(i)[j].coeffs(), b.poses.rotations(k)[j].coeffs()) << j;
}

TEST_F(TurnAsCaptured, BeginsAndEndsInTheStandingPoseOfItsStancesToTheBit) {
  AnimationBuffer turn, stood;
  for (const double height : kHeights) {
    const WalkSynthesizer walker(*library_, kLevelFloor, {.height = height});
    for (int index = 0; index < 20; ++index) {
      SampleStream stream(3, index);
      Stance at{{stream.uniform(-9.0, 9.0), stream.uniform(-9.0, 9.0), 0.0},
                stream.uniform(-kPi, kPi)};
      const double angle = stream.uniform(-2.0 * kPi, 2.0 * kPi);
      ASSERT_EQ(walker.turnOnSpot(at, angle, turn).refused, WalkRule::kNone);
      ASSERT_EQ(walker.stand(at, stood).refused, WalkRule::kNone);
      expectSamePose(turn, 0, stood, 0);
      at.heading += angle;
      ASSERT_EQ(walker.stand(at, stood).refused, WalkRule::kNone);
      expectSamePose(turn, turn.size() - 1, stood, 0);
    }
  }
}

TEST_F(TurnAsCaptured, NoFootIsTurnedFartherThanThirtyDegreesAgainstThePelvis) {
  AnimationBuffer turn;
  MotionLibrary without = *library_;
  std::erase_if(without.motions,
                [](const Motion& motion) { return motion.kind == MotionKind::kTurnOnSpot; });
  for (const auto& [library, height] :
       {std::pair(library_, 1.4), {library_, 0.0}, {library_, 2.0}, {&without, 0.0}}) {
    const WalkSynthesizer walker(*library, kLevelFloor, {.height = height});
    std::vector<JointFrame> joints(walker.skeleton().size());
    for (const double degrees : kTurns) {
      ASSERT_EQ(walker.turnOnSpot({}, degrees * kDegree, turn).refused, WalkRule::kNone);
      const std::vector<double> headings = pelvisHeadings(clipOf(walker, turn), walker.roles());
      for (int i = 0; i < turn.size(); ++i) {
        forwardKinematics(walker.skeleton(), turn.poses[i], std::span<JointFrame>(joints));
        for (const Side side : {kLeft, kRight}) {
          const Eigen::Vector3d forward = joints[walker.roles().legs[side].foot].q_WJ *
                                          walker.feet()[side].q_SF.conjugate() *
                                          Eigen::Vector3d::UnitX();
          const double yaw = wrapAngle(std::atan2(forward.y(), forward.x()) - headings[i]);
          EXPECT_LE(std::abs(yaw), 30.0 * kDegree)
              << height << " m, " << degrees << ", frame " << i;
        }
      }
    }
  }
}

// As one finds who has the motion only: walk, turn, walk on.
TEST_F(TurnAsCaptured, AJudgeThatFindsPlantsItselfSeesNoSlide) {
  for (const double height : kHeights) {
    const WalkSynthesizer walker(*library_, kLevelFloor, {.height = height});
    for (const double degrees : kTurns) {
      AnimationBuffer all, part;
      const RootPath there = straightPath(3.0);
      Stance at = stanceAt(there, true, true);
      walker.walk(stanceAt(there, false, true), at, there, true, all);
      ASSERT_EQ(walker.turnOnSpot(at, degrees * kDegree, part).refused, WalkRule::kNone);
      all.append(part);
      at.heading += degrees * kDegree;
      const RootPath on = straightPath(3.0, at.heading, at.position.head<2>());
      ASSERT_EQ(walker.walk(at, stanceAt(on, true, true), on, true, part).refused, WalkRule::kNone);
      all.append(part);
      const Clip clip = clipOf(walker, all);
      const GaitMeasures seen =
          measureGait(clip, walker.roles(), detectPlants(clip, walker.roles()));
      EXPECT_LE(seen.toe_skate, 0.010) << height << " m, " << degrees;
      EXPECT_LE(seen.largest_drift, 0.002) << height << " m, " << degrees;
    }
  }
}

TEST_F(TurnAsCaptured, TheBodyGoesItsCapturedWayByTheTurnOfItsPelvis) {
  const WalkSynthesizer walker(*library_, kLevelFloor, {});
  const std::vector<Eigen::Quaterniond>& reference = library_->stand().rotations;
  AnimationBuffer turn;
  for (const char* const name : {"half", "quarter", "about-mirrored"}) {
    const TurnSequence& sequence = library_->find(name)->turn;
    const CubicSpline share = shareTurned(sequence);
    ASSERT_EQ(walker.turnOnSpot({}, sequence.angle, turn).refused, WalkRule::kNone);
    std::vector<double> channels(sequence.spline.rows());
    double before = 0.0;
    for (int i = 1; i + 1 < turn.size(); ++i) {
      const double clock = turn.states[i].spot.clock;
      EXPECT_GE(clock, before) << name << i;
      before = clock;
      EXPECT_NEAR(turn.states[i].heading, sequence.angle * share.at(clock), 1e-12) << name << i;
      turnChannels(sequence, clock, channels);
      for (int j = 1; j < walker.skeleton().size(); ++j) {
        const auto& legs = walker.roles().legs;
        if (walker.skeleton().isAncestor(legs[kLeft].up_leg, j) ||
            walker.skeleton().isAncestor(legs[kRight].up_leg, j))
          continue;
        const Eigen::Quaterniond captured =
            reference[j] * expRotation(Eigen::Vector3d(&channels[3 + 3 * j]));
        EXPECT_LT(turn.poses.rotations(i)[j].angularDistance(captured), 1e-7) << name << i << j;
      }
    }
  }
}

TEST_F(TurnAsCaptured, LastsAtLeastAsLongAsCapturedAndNoStepIsQuickerThanPeopleStep) {
  const WalkSynthesizer walker(*library_, kLevelFloor, {});
  AnimationBuffer turn;
  for (const Motion& motion : library_->motions) {
    if (motion.kind != MotionKind::kTurnOnSpot) continue;
    ASSERT_EQ(walker.turnOnSpot({}, motion.turn.angle, turn).refused, WalkRule::kNone);
    EXPECT_GE((turn.size() - 1) * turn.frame_time, motion.turn.duration - 1e-9) << motion.name;
    std::vector<int> landings;
    for (const Footprint& print : turn.footprints)
      if (print.first_frame > 0) landings.push_back(print.first_frame);
    std::sort(landings.begin(), landings.end());
    for (size_t i = 1; i < landings.size(); ++i)
      EXPECT_GE((landings[i] - landings[i - 1] + 1) * turn.frame_time, SpotTurnGait::kQuickStep)
          << motion.name;
  }
}

// Largest angular acceleration over some joints [rad/s²].
template <typename Joints>
double accelerationOf(const Clip& clip, int first, int last, int every, Joints joints) {
  const double time = every * clip.frame_time;
  double most = 0.0;
  for (int i = first + every; i + every <= last; ++i) {
    for (int j = 1; j < clip.skeleton.size(); ++j) {
      if (!joints(j)) continue;
      const auto q = [&](int k) { return clip.poses.rotations(k)[j]; };
      const Eigen::Vector3d change = logRotation(q(i).conjugate() * q(i + every)) -
                                     logRotation(q(i - every).conjugate() * q(i));
      most = std::max(most, change.norm() / (time * time));
    }
  }
  return most;
}

// At 30 Hz. The body is that of the turn; the legs make our own steps, and are held against those
// of captured walks. Captures begin and end with a jump.
TEST_F(TurnAsCaptured, NoJointIsJerkedMoreThanItsCaptures) {
  constexpr double kFrame = 1.0 / 30.0;
  const WalkSynthesizer walker(*library_, kLevelFloor, {.frame_time = kFrame});
  const auto ofLegs = [&](int j) {
    const auto& legs = library_->roles.legs;
    return library_->skeleton.isAncestor(legs[kLeft].up_leg, j) ||
           library_->skeleton.isAncestor(legs[kRight].up_leg, j);
  };
  const auto ofBody = [&](int j) { return !ofLegs(j); };
  constexpr int kJump = 10;  // frames
  const auto capturedIn = [&](const Motion& motion, bool whole, const auto& joints) {
    MotionLibrary library = defaultLibrary();
    const auto file = sharedFolder() / "mocap" / motion.source.clip;
    const LevelCapture capture = readForLibrary(file, {});
    const Clip clip = clipForLibrary(library, capture, file.string());
    const int every = static_cast<int>(std::lround(kFrame / clip.frame_time));
    const auto [first, last] = motion.source.frames;
    return whole ? accelerationOf(clip, kJump, clip.frames() - kJump, every, joints)
                 : accelerationOf(clip, first - capture.first_frame, last - capture.first_frame,
                                  every, joints);
  };
  double legs = 0.0;
  for (const char* const name : {"walk-slow", "turn-left"})
    legs = std::max(legs, capturedIn(*library_->find(name), true, ofLegs));
  AnimationBuffer turn;
  for (const char* const name : {"half", "quarter", "about"}) {
    const Motion& motion = *library_->find(name);
    const double body = capturedIn(motion, false, ofBody);
    for (const double share : {0.75, 1.0, 1.4}) {
      ASSERT_EQ(walker.turnOnSpot({}, share * motion.turn.angle, turn).refused, WalkRule::kNone);
      const Clip clip = clipOf(walker, turn);
      EXPECT_LE(accelerationOf(clip, 0, turn.size() - 1, 1, ofBody), 1.05 * body) << name << share;
      EXPECT_LE(accelerationOf(clip, 0, turn.size() - 1, 1, ofLegs), 1.05 * legs) << name << share;
    }
  }
}

TEST_F(TurnAsCaptured, ToTheOtherSideItIsItsMirrorImage) {
  const WalkSynthesizer walker(*library_, kLevelFloor, {});
  AnimationBuffer left, right;
  for (const double degrees : {50.0, 90.0, 171.0, 200.0, 300.0}) {
    const WalkResult one = walker.turnOnSpot({}, degrees * kDegree, left);
    const WalkResult other = walker.turnOnSpot({}, -degrees * kDegree, right);
    ASSERT_EQ(left.size(), right.size()) << degrees;
    EXPECT_EQ(one.steps, other.steps);
    EXPECT_NE(one.leading, other.leading);
    for (int i = 0; i < left.size(); ++i) {
      EXPECT_NEAR(left.states[i].heading, -right.states[i].heading, 1e-6) << degrees << i;
      EXPECT_EQ(left.states[i].planted[kLeft], right.states[i].planted[kRight]) << degrees << i;
    }
  }
}

TEST_F(TurnAsCaptured, SmallStepsEndWhereTheyAreToToTheBit) {
  const WalkSynthesizer walker(*library_, kLevelFloor, {});
  const Stance at{{1.0, 2.0, 0.0}, 0.4};
  AnimationBuffer turn, stood;
  for (const double angle : {1.5, -3.0, 6.0}) {
    const Eigen::Vector3d to = at.position + Eigen::Vector3d(0.11, -0.07, 0.0);
    ASSERT_EQ(walker.smallSteps(at, to, angle, turn).refused, WalkRule::kNone);
    ASSERT_EQ(walker.stand({to, at.heading + angle}, stood).refused, WalkRule::kNone);
    expectSamePose(turn, turn.size() - 1, stood, 0);
    EXPECT_NEAR(turn.states.back().arc, (to - at.position).norm(), 1e-12);
  }
}

TEST_F(TurnAsCaptured, OverAnEdgeOrNothingItIsRefused) {
  AnimationBuffer turn;
  const FlatGround nothing(1.0);
  EXPECT_EQ(WalkSynthesizer(*library_, nothing, {}).turnOnSpot({}, 3.0, turn).refused,
            WalkRule::kNoGround);
  const StairGround edge({.rise = -0.2, .going = 1.0, .count = 1, .start = 0.02});
  EXPECT_NE(WalkSynthesizer(*library_, edge, {}).turnOnSpot({}, 3.0, turn).refused,
            WalkRule::kNone);
}

TEST_F(TurnAsCaptured, WhatIsSmallerThanHalfOfAllIsTurnedAsWithoutThem) {
  const WalkSynthesizer walker(*library_, kLevelFloor, {}),
      plain(defaultLibrary(), kLevelFloor, {});
  AnimationBuffer one, other;
  for (const double angle : {0.3, -0.6}) {
    walker.turnOnSpot({}, angle, one);
    plain.turnOnSpot({}, angle, other);
    ASSERT_EQ(one.size(), other.size());
    for (int i = 0; i < one.size(); ++i) expectSamePose(one, i, other, i);
  }
}

TEST_F(TurnAsCaptured, ItsFramesAreOfTheMotionThatWasTaken) {
  const WalkSynthesizer walker(*library_, kLevelFloor, {});
  const MotionShares shares(*library_, walker);
  const CapturedTurns turns(*library_, 1.0);
  AnimationBuffer turn;
  const double angle = 3.2;
  ASSERT_EQ(walker.turnOnSpot({}, angle, turn).refused, WalkRule::kNone);
  const Motion* taken = &turns.motion(turns.take(angle).turn);
  for (int i = 0; i < turn.size(); ++i) {
    const std::vector<double> all = shares.at(turn.states[i]);
    ASSERT_EQ(all.size(), shares.motions().size());
    const bool inside = i > 0 && i + 1 < turn.size();
    for (size_t k = 0; k < all.size(); ++k) {
      const Motion* whose = inside ? taken : library_->find("stand");
      EXPECT_EQ(all[k], shares.motions()[k][0] == whose ? 1.0 : 0.0) << i;
    }
  }
}

}  // namespace
}  // namespace amble

// Walks that go at more than one pace: each place has the gait of its own.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "animation/library/fourier.h"
#include "animation/synthesis/gait_blend.h"
#include "animation/synthesis/walk_synthesizer.h"
#include "base/rotation.h"
#include "tests/animation/default_library.h"
#include "tests/animation/walk_paths.h"

namespace amble {
namespace {

const FlatGround kFlatFloor;

/// The default library without its turns: bends are walked by straight walks, at kNoTurns.
const MotionLibrary& straightLibrary() {
  static const MotionLibrary kLibrary = [] {
    MotionLibrary library = defaultLibrary();
    std::erase_if(library.motions, [](const Motion& m) { return m.turning; });
    return library;
  }();
  return kLibrary;
}

/// Flexion of hips and knees, by Side [rad], where the walk goes along `heading` [rad].
struct Flexions {
  std::array<double, 2> hip, knee;
};
Flexions flexionsOf(const PoseView& pose, double heading) {
  const MotionLibrary& library = straightLibrary();
  std::vector<JointFrame> joints(library.skeleton.size());
  forwardKinematics(library.skeleton, pose, joints);
  const Eigen::Quaterniond back = aboutZ(-heading);
  Flexions flexions;
  for (const Side side : {kLeft, kRight}) {
    const LegJoints& leg = library.roles.legs[side];
    const Eigen::Vector3d thigh = back * (joints[leg.leg].p_WJ - joints[leg.up_leg].p_WJ);
    const Eigen::Vector3d shank = back * (joints[leg.foot].p_WJ - joints[leg.leg].p_WJ);
    flexions.hip[side] = std::atan2(thigh.x(), -thigh.z());
    flexions.knee[side] = std::atan2(thigh.cross(shank).norm(), thigh.dot(shank));
  }
  return flexions;
}

/// Of the mean of a captured walk and its mirror image, at a phase.
Flexions capturedFlexions(const std::string& walk, double phase) {
  const MotionLibrary& library = straightLibrary();
  const Eigen::VectorXd channels =
      0.5 * (fourierAt(library.find(walk)->cycle.series, phase) +
             fourierAt(library.find(walk + "-mirrored")->cycle.series, phase));
  Pose pose;
  pose.p_WR = channels.head<3>();
  for (int j = 0; j < library.skeleton.size(); ++j)
    pose.rotations.push_back(library.stand().rotations[j] *
                             expRotation(channels.segment<3>(3 + 3 * j)));
  return flexionsOf(pose, 0.0);
}

/// Straight on at the pace of `walk-fast`, then around a bend that is walked at that of
/// `walk-slow`, and straight on again.
struct FastAndSlow {
  static constexpr double kStraight =
      24.0;  // long: over 12 m whole steps stretch by 1.3 % in the bend, too [m]
  double fast = straightLibrary().find("walk-fast")->cycle.speed;
  double slow = straightLibrary().find("walk-slow")->cycle.speed;
  double radius = slow / GaitBlend::kNoTurns, bend = kPi * radius;  // [m]
  AnimationBuffer buffer;

  explicit FastAndSlow(double speed = 0.0) {
    const WalkSynthesizer walker(straightLibrary(), kFlatFloor,
                                 {.speed = speed > 0.0 ? speed : fast});
    RootPath path = straightPath(kStraight, 0.0, {-kStraight, 0.0});
    path.append(circlePath(radius, kPi));
    path.append(straightPath(kStraight, kPi, {0.0, 2.0 * radius}));
    const WalkResult result =
        walker.walk(stanceAt(path, false, false), stanceAt(path, true, false), path, true, buffer);
    EXPECT_EQ(result.refused, WalkRule::kNone);
  }

  /// The frames between two arcs, without what is left over of whole cycles.
  std::pair<int, int> wholeCycles(double from, double to) const {
    int first = 0, end = 0;
    while (buffer.states[first].arc < from) ++first;
    while (end < buffer.size() && buffer.states[end].arc <= to) ++end;
    const auto phase = [&](int i) { return buffer.states[i].phase; };
    int last = first;
    for (int i = first + 1; i < end; ++i) {
      const double before = std::remainder(phase(i - 1) - phase(first), 1.0),
                   now = std::remainder(phase(i) - phase(first), 1.0);
      if (before < 0.0 && now >= 0.0) last = i;
    }
    return {first, last};
  }

  /// Largest RMS difference from a captured walk over whole cycles between two arcs [rad].
  struct Off {
    double hip = 0.0, knee = 0.0;
    int frames = 0;
  };
  Off offFrom(const std::string& walk, double from, double to, double speed) const {
    Off off;
    std::array<double, 2> hip = {0, 0}, knee = {0, 0};
    const auto [first, end] = wholeCycles(from, to);
    for (int i = first; i < end; ++i) {
      const FrameState& state = buffer.states[i];
      EXPECT_NEAR(state.speed, speed, 0.03 * speed);
      const Flexions made = flexionsOf(buffer.poses[i], state.heading);
      const Flexions captured = capturedFlexions(walk, state.phase);
      for (const Side side : {kLeft, kRight}) {
        hip[side] += std::pow(made.hip[side] - captured.hip[side], 2);
        knee[side] += std::pow(made.knee[side] - captured.knee[side], 2);
      }
      ++off.frames;
    }
    off.hip = std::sqrt(std::max(hip[kLeft], hip[kRight]) / off.frames);
    off.knee = std::sqrt(std::max(knee[kLeft], knee[kRight]) / off.frames);
    return off;
  }
};

// On the straight within the bars of walks at one speed (Fidelity). A bend costs the captured gait
// something: no more than who planned to go as slowly all the way, to a fifth of a degree.
TEST(SlowingWalk, IsEachCapturedWalkWhereItGoesAtItsPace) {
  const FastAndSlow walk;
  const FastAndSlow always_slow(walk.slow);
  const double begin = FastAndSlow::kStraight, end = begin + walk.bend;
  // A second of slowing down and a stride to change feet are left out on either side.
  const auto fast = walk.offFrom("walk-fast", 0.8, begin - 2.8, walk.fast);
  const auto slow = walk.offFrom("walk-slow", begin + 1.3, end - 1.3, walk.slow);
  const auto planned = always_slow.offFrom("walk-slow", begin + 1.3, end - 1.3, walk.slow);
  EXPECT_GT(fast.frames, 60);
  EXPECT_GT(slow.frames, 140);
  EXPECT_LT(fast.hip, 3.0 * kDegree);
  EXPECT_LT(fast.knee, 3.8 * kDegree);
  EXPECT_LT(slow.hip, planned.hip + 0.2 * kDegree);
  EXPECT_LT(slow.knee, planned.knee + 0.2 * kDegree);
  EXPECT_LT(slow.hip, 2.5 * kDegree);
}

/// The default library, its walks below a speed [m/s] replaced by what nobody does; how fast these
/// are, and how long their steps, stays.
MotionLibrary withSillySlowWalks(double below) {
  MotionLibrary library = defaultLibrary();
  for (Motion& motion : library.motions) {
    if (motion.kind != MotionKind::kWalk || motion.turning || motion.cycle.speed >= below) continue;
    motion.cycle.series.alpha *= 1.5;
    motion.cycle.series.beta *= -1.0;
    motion.cycle.step_width *= 3.0;
    for (FootCycle& foot : motion.cycle.feet) foot.height[1] += 0.2;
  }
  return library;
}

TEST(SlowingWalk, AtOneSpeedItIsTheSameToTheBitWhateverSlowerWalksAreLike) {
  const double speed = defaultLibrary().find("walk-fast")->cycle.speed;
  const MotionLibrary silly = withSillySlowWalks(speed);
  for (const double angle : {0.0, 1.0}) {
    const RootPath path = angle == 0.0 ? straightPath(8.0) : circlePath(6.0 / angle, angle);
    std::array<AnimationBuffer, 2> made;
    for (const bool is_silly : {false, true}) {
      const WalkSynthesizer walker(is_silly ? silly : defaultLibrary(), kFlatFloor,
                                   {.speed = speed});
      ASSERT_EQ(walker
                    .walk(stanceAt(path, false, false), stanceAt(path, true, false), path, true,
                          made[is_silly ? 1 : 0])
                    .refused,
                WalkRule::kNone);
    }
    ASSERT_EQ(made[0].size(), made[1].size());
    for (int i = 0; i < made[0].size(); ++i) {
      EXPECT_EQ(made[0].states[i].slower, 0.0);
      EXPECT_EQ(made[0].poses.p_WR(i), made[1].poses.p_WR(i)) << i;
      for (int j = 0; j < made[0].poses.joints(); ++j)
        EXPECT_EQ(made[0].poses.rotations(i)[j].coeffs(), made[1].poses.rotations(i)[j].coeffs());
    }
  }
}

// Stances that are walked through slowly are as canonical as others: with which walk they are come
// to and left does not matter.
TEST(SlowingWalk, JoinsToTheBitAtASlowStance) {
  const WalkSynthesizer walker(defaultLibrary(), kFlatFloor, {.speed = 1.7});
  for (const double pace : {0.9, 0.7, 0.5}) {
    const RootPath path = straightPath(4.0);
    Stance begin = stanceAt(path, false, false), end = stanceAt(path, true, false);
    end.pace = pace;
    AnimationBuffer first, second;
    const WalkResult come = walker.walk(begin, end, path, true, first);
    ASSERT_EQ(come.refused, WalkRule::kNone) << pace;
    const RootPath on = straightPath(4.0, 0.0, {4.0, 0.0});
    end.leading = come.leading;
    ASSERT_EQ(walker.walk(end, stanceAt(on, true, true), on, true, second).refused,
              WalkRule::kNone);
    const int last = first.size() - 1;
    EXPECT_GT(first.states[last].slower, 0.0);
    EXPECT_EQ(first.poses.p_WR(last), second.poses.p_WR(0)) << pace;
    for (int j = 0; j < first.poses.joints(); ++j)
      EXPECT_EQ(first.poses.rotations(last)[j].coeffs(), second.poses.rotations(0)[j].coeffs());
  }
}

// Rear heels are up at a walking stance: if they followed another cycle a frame later they would
// jump, by 20 degrees where the paces of two stances two steps apart differ as much.
TEST(SlowingWalk, FeetFollowAtTheFramesBesideAStanceWhatTheyFollowThere) {
  const WalkSynthesizer walker(defaultLibrary(), kFlatFloor, {.speed = 1.8});
  int of_two_steps = 0;
  for (const double pace : {0.35, 0.5, 0.7, 1.0}) {
    for (double length = 0.8; length < 2.5; length += 0.1) {
      const RootPath path = straightPath(length);
      Stance begin = stanceAt(path, false, false), end = stanceAt(path, true, false);
      begin.pace = 0.5;
      end.pace = pace;
      AnimationBuffer walk;
      const WalkResult made = walker.walk(begin, end, path, true, walk);
      if (made.refused != WalkRule::kNone) continue;
      of_two_steps += made.steps == 2 && pace != begin.pace;
      const int last = walk.size() - 1;
      for (const Side side : {kLeft, kRight}) {
        EXPECT_TRUE(followsSame(walk.states[0].feet[side], walk.states[1].feet[side]))
            << pace << ' ' << length;
        EXPECT_TRUE(followsSame(walk.states[last - 1].feet[side], walk.states[last].feet[side]))
            << pace << ' ' << length;
      }
    }
  }
  EXPECT_GE(of_two_steps, 4);
}

// Speeds change by onset().acceleration at most; what is blended changes no faster, and that change
// no faster than the mean over its moment lets it.
TEST(SlowingWalk, GoesOverFromPaceToPaceSmoothly) {
  const FastAndSlow walk;
  const std::vector<FrameState>& states = walk.buffer.states;
  const double frame = walk.buffer.frame_time;
  const double acceleration = GaitBlend(straightLibrary(), 1.0).law().onset().acceleration;
  double most = 0.0;
  for (size_t i = 1; i + 1 < states.size(); ++i) {
    const double change = (states[i + 1].slower - states[i].slower) / frame;
    const double before = (states[i].slower - states[i - 1].slower) / frame;
    EXPECT_LT(std::abs(change), 1.1 * acceleration) << i;
    EXPECT_LT(std::abs(change - before) / frame, 1.1 * acceleration / GaitBlend::kBlendTime) << i;
    most = std::max(most, states[i].slower);
  }
  EXPECT_GT(most, 0.45);
}

}  // namespace
}  // namespace amble

#include "animation/preparation/transition_sequence_fit.h"

#include <gtest/gtest.h>

#include <cmath>

#include "animation/clips/mirror_clip.h"
#include "animation/preparation/gait_track.h"
#include "animation/preparation/motion_library_add.h"
#include "base/rotation.h"
#include "tests/animation/captures.h"
#include "tests/animation/default_library.h"

namespace amble {
namespace {

/// A clip of mocap/ on the default library's skeleton, and what is made of it.
struct Sequence {
  MotionLibrary library = defaultLibrary();
  Clip clip;
  std::array<int, 2> frames = {0, 0};
  std::optional<TransitionSequence> sequence;

  Sequence(const std::string& path, bool start, bool mirrored = false) {
    const std::filesystem::path file = sharedFolder() / "mocap" / path;
    clip = clipForLibrary(library, readForLibrary(file, {}), file.string());
    if (mirrored) clip = mirrorClip(clip, library.roles);
    sequence =
        fitTransitionSequence(clip, library.roles, library.feet(), library.stand(), start, frames);
  }
};

constexpr const char* kStartClip = "accad_female1/Female1_B01_StandToWalk.bvh";
constexpr const char* kStopClip = "accad_female1/Female1_B02_WalkToStand.bvh";

TEST(TransitionSequence, AWalkThatNeverStandsHasNone) {
  AMBLE_NEEDS_CAPTURES();
  EXPECT_FALSE(Sequence("cmu_mb2/07_01.bvh", true).sequence);
}

TEST(TransitionSequence, ItLeavesThePostureStandAtRest) {
  AMBLE_NEEDS_CAPTURES();
  for (const bool start : {true, false}) {
    const Sequence made(start ? kStartClip : kStopClip, start);
    ASSERT_TRUE(made.sequence);
    const TransitionSequence& sequence = *made.sequence;
    std::vector<double> at(sequence.spline.rows()), after = at;
    transitionAt(sequence, -sequence.sway, at);
    transitionAt(sequence, -sequence.sway + 1e-3, after);
    for (size_t i = 0; i < at.size(); ++i) {
      EXPECT_NEAR(at[i], i == 2 ? made.library.stand().root_height : 0.0, 1e-12);
      EXPECT_NEAR(after[i], at[i], 1e-7);  // neither speed nor acceleration
    }
  }
}

TEST(TransitionSequence, OnItsWayTheBodyTurnsItsJointsAsCaptured) {
  AMBLE_NEEDS_CAPTURES();
  const Sequence made(kStartClip, true);
  ASSERT_TRUE(made.sequence);
  const TransitionSequence& sequence = *made.sequence;
  const GaitTrack track(made.clip, made.library.roles, made.library.feet());
  // From its frames: the clock's two ends are theirs.
  const double rate =
      (made.frames[1] - made.frames[0]) / (TransitionSequence::kEnd + sequence.sway);
  std::vector<double> channels(sequence.spline.rows());
  Pose pose;
  pose.rotations.resize(made.library.skeleton.size());
  for (double clock = 0.2; clock <= 1.9; clock += 0.1) {
    transitionAt(sequence, clock, channels);
    track.poseAt(made.frames[0] + rate * (clock + sequence.sway), pose);
    for (int j = 1; j < made.library.skeleton.size(); ++j) {
      const Eigen::Vector3d v(channels[3 + 3 * j], channels[4 + 3 * j], channels[5 + 3 * j]);
      const Eigen::Quaterniond q = made.library.stand().rotations[j] * expRotation(v);
      // Two frames of a swinging leg are that far apart, and standing differs until clock 1.
      const double most = clock < 1.0 ? 12.0 : 8.0;
      EXPECT_LT(q.angularDistance(pose.rotations[j]), most * kDegree) << j << " at " << clock;
    }
  }
}

TEST(TransitionSequence, SeenInAMirrorTheOtherFootSteps) {
  AMBLE_NEEDS_CAPTURES();
  for (const bool start : {true, false}) {
    const Sequence own(start ? kStartClip : kStopClip, start);
    const Sequence seen(start ? kStartClip : kStopClip, start, true);
    ASSERT_TRUE(own.sequence && seen.sequence);
    EXPECT_EQ(seen.sequence->side, other(own.sequence->side));
    EXPECT_NEAR(seen.sequence->advance, own.sequence->advance, 0.002);
    EXPECT_NEAR(seen.sequence->step_time, own.sequence->step_time, 0.01);
    std::vector<double> a(own.sequence->spline.rows()), b = a;
    for (double clock = 0.0; clock <= 2.0; clock += 0.25) {
      transitionAt(*own.sequence, clock, a);
      transitionAt(*seen.sequence, clock, b);
      EXPECT_NEAR(a[0], b[0], 0.005);
      EXPECT_NEAR(a[1], -b[1], 0.005);
      EXPECT_NEAR(a[2], b[2], 0.005);
    }
  }
}

// A walk of a few steps is nothing but a start and a stop (QUALITY.md, mean path error).
TEST(TransitionSequence, OnAverageTheBodyIsNoFartherBesideItsPathThanAWalkMayBe) {
  AMBLE_NEEDS_CAPTURES();
  for (const bool start : {true, false}) {
    const Sequence made(start ? kStartClip : kStopClip, start);
    ASSERT_TRUE(made.sequence);
    std::vector<double> channels(made.sequence->spline.rows());
    const double from = -made.sequence->sway, length = TransitionSequence::kEnd - from;
    constexpr int kMoments = 200;
    double mean = 0.0;
    for (int i = 0; i < kMoments; ++i) {
      transitionAt(*made.sequence, from + length * (i + 0.5) / kMoments, channels);
      mean += std::abs(channels[1]) / kMoments;
    }
    EXPECT_LT(mean, 0.02) << start;
  }
}

TEST(TransitionSequence, WeightGoesToTheStandingFootBeforeTheOtherLeaves) {
  AMBLE_NEEDS_CAPTURES();
  const Sequence made(kStartClip, true);
  ASSERT_TRUE(made.sequence);
  const TransitionSequence& sequence = *made.sequence;
  std::vector<double> channels(sequence.spline.rows());
  const double away = sequence.side == kLeft ? -1.0 : 1.0;  // from the foot that leaves
  const double half = 0.5 * made.library.stand().step_width;
  transitionAt(sequence, 0.5, channels);
  EXPECT_GT(away * channels[1], 0.5 * half);
  EXPECT_LT(away * channels[1], 1.1 * half);
}

}  // namespace
}  // namespace amble

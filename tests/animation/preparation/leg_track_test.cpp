#include "animation/preparation/leg_track.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/rotation.h"
#include "tests/animation/default_library.h"

namespace amble {
namespace {

constexpr int kLegStance = FootCycle::kStanceSamples, kLegSamples = LegTrack::kSamples;

const WalkCycle& straightWalk() {
  for (const Motion& motion : defaultLibrary().motions)
    if (motion.kind == MotionKind::kWalk && !motion.turning) return motion.cycle;
  throw std::logic_error("no straight walk in the library");
}

LegTrack trackOf(Side side) {
  const MotionLibrary& library = defaultLibrary();
  return {library.skeleton,          library.roles,  library.feet()[side],
          library.stand().rotations, straightWalk(), side};
}

PelvisSway drawnSway() {
  PelvisSway sway;
  for (int k = 0; k < kSwayNumbers; ++k) sway[k] = 0.004 * std::sin(1.0 + 3.0 * k);
  return sway;
}

TEST(LegTrack, APelvisThatSwaysIsInTheMeanWhereItWas) {
  const PelvisSway sway = drawnSway();
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (int i = 0; i < 16; ++i) mean += swayAt(sway, i / 16.0) / 16.0;
  EXPECT_LT(mean.norm(), 1e-15);
  EXPECT_LT((swayAt(sway, 0.3) - swayAt(sway, 1.3)).norm(), 1e-15);
  EXPECT_EQ(swayAt(sway, 0.3).y(), 0.0);
}

// Where a swing is the sole under the captured ankle, the leg is as far forward as captured,
// however the foot is pitched and the pelvis sways.
TEST(LegTrack, ASoleUnderTheCapturedAnkleLetsTheLegGoAsCaptured) {
  for (const Side side : {kLeft, kRight}) {
    LegTrack track = trackOf(side);
    FootCycle foot = straightWalk().feet[side];
    for (double& pitch : foot.pitch) pitch *= 0.8;
    foot.toes.fill(0.2);
    track.make(foot, 0.01, drawnSway());
    for (int sample = kLegStance + 6; sample < kLegSamples - 8; ++sample) {
      const double tau = LegTrack::timeOf(sample) - 1.0;
      const Eigen::Vector2d sole = track.soleUnderAnkle(tau);
      LegMoves moved = {};
      moved[kByWay] = (sole[0] - swingProgress(foot, tau)) * track.wayLength();
      moved[kByHeight] = sole[1] - swingPolynomial(foot.height, tau);
      const LegBend bend = track.bendOf(sample, track.made(sample, moved));
      EXPECT_NEAR(bend[1], track.capturedBend(sample)[1], 1e-6) << sample;
    }
  }
}

// Of a foot that swings under a bent knee no heel has to rise.
TEST(LegTrack, AHipThatGoesAwayLeavesTheFootWhereItIs) {
  LegTrack track = trackOf(kLeft);
  track.make(straightWalk().feet[kLeft], 0.0, drawnSway());
  const int sample = kLegStance + FootCycle::kSwingSamples / 3;
  const Eigen::Vector3d line = track.made(sample).line;
  LegMoves moved = {};
  moved[kByHip] = 0.003;
  moved[kByHipUp] = -0.002;
  EXPECT_LT((track.made(sample, moved).line - line - Eigen::Vector3d(-0.003, 0.0, 0.002)).norm(),
            1e-12);
  moved = {};
  moved[kByPrint] = 0.003;
  moved[kByHeight] = 0.002;
  EXPECT_LT((track.made(sample, moved).line - line - Eigen::Vector3d(0.003, 0.0, 0.002)).norm(),
            1e-12);
}

// Heels rise only where the leg would be too long, and then it is not; ankles are bent as heels
// that have risen.
TEST(LegTrack, LegsThatWouldBeTooLongAreNot) {
  LegTrack track = trackOf(kRight);
  FootCycle flat = straightWalk().feet[kRight];
  flat.pitch.assign(flat.pitch.size(), 0.0);
  flat.toes.fill(0.0);
  track.make(flat, 0.0, PelvisSway::Zero());
  for (int sample = kLegStance - 4; sample < kLegStance; ++sample) {
    const LegTrack::Made leg = track.made(sample);
    EXPECT_LT(leg.line.norm(), track.length()) << sample;
    EXPECT_GT(leg.pitch, 1.0 * kDegree) << sample;
    const LegBend bend = track.bendOf(sample, leg);
    EXPECT_DOUBLE_EQ(bend[2], bend[0] - bend[1] - leg.pitch);
  }
}

}  // namespace
}  // namespace amble

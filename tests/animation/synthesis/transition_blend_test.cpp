#include "animation/synthesis/transition_blend.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/animation/default_library.h"

namespace amble {
namespace {

/// A walk that stands still in the library's posture: what transitions are joined to here.
void stillWalk(double /*clock*/, Side /*side*/, bool /*start*/, std::span<double> channels) {
  std::fill(channels.begin(), channels.end(), 0.0);
}

TransitionBlend blendAt(double speed, double scale = 1.0) {
  return {defaultLibrary(), scale, speed, stillWalk};
}

/// Calls `of` with every joined start and stop.
template <typename Of>
void forJoined(const TransitionBlend& blend, const Of& of) {
  for (const Side side : {kLeft, kRight}) {
    for (const auto* joined : {blend.start(side), blend.stop(side)}) {
      if (joined != nullptr) of(*joined, side);
    }
  }
}

TEST(TransitionBlend, OfNoLibraryHasNone) {
  const TransitionBlend none;
  forJoined(none, [](const auto&, Side) { FAIL() << "one is there"; });
  EXPECT_EQ(none.startSway(), 0.0);
  for (const EndSwing& swing : none.firstSwings()) EXPECT_FALSE(swing.captured);
}

TEST(TransitionBlend, OfALibraryWithoutSequencesHasNone) {
  MotionLibrary plain = defaultLibrary();
  for (Motion& motion : plain.motions) motion.transition.sequence = {};
  forJoined(TransitionBlend(plain, 1.0, 1.2, stillWalk),
            [](const auto&, Side) { FAIL() << "one is there"; });
}

TEST(TransitionBlend, TakesTheNearestWalkThatIsNoFaster) {
  bool any = false;
  for (double speed = 0.2; speed < 2.2; speed += 0.1) {
    forJoined(blendAt(speed), [&](const TransitionBlend::Joined& joined, Side side) {
      any = true;
      const Transition& taken = joined.motion->transition;
      EXPECT_LE(taken.speed, speed);
      EXPECT_EQ(joined.sequence.side, side);
      for (const Motion& other : defaultLibrary().motions) {
        if (other.kind != joined.motion->kind || other.style != joined.motion->style) continue;
        const Transition& t = other.transition;
        if (t.sequence.empty() || t.sequence.side != side || t.speed > speed) continue;
        EXPECT_LE(t.speed, taken.speed) << other.name;
      }
    });
  }
  EXPECT_TRUE(any);
}

TEST(TransitionBlend, IsAllOfItAtFirstNoneAtLastAndNeverMoreAgain) {
  forJoined(blendAt(1.4), [](const TransitionBlend::Joined& joined, Side) {
    EXPECT_LT(joined.blend_from, joined.blend_to);
    EXPECT_LE(joined.blend_to, TransitionSequence::kEnd + 1e-9);
    double before = 1.0;
    for (double clock = -joined.sequence.sway - 0.5; clock < 3.0; clock += 0.01) {
      const double share = joined.share(clock);
      EXPECT_LE(share, before);
      EXPECT_GE(share, 0.0);
      if (clock <= joined.blend_from) {
        EXPECT_EQ(share, 1.0);
      }
      if (clock >= joined.blend_to) {
        EXPECT_EQ(share, 0.0);
      }
      before = share;
    }
  });
}

// Where none of it is left channels stay to the bit; where all is, they are the sequence's own,
// whatever the walk was about: but for the root's way along the path, which goes with the steps.
TEST(TransitionBlend, MixesByItsShare) {
  const int channels = 3 + 3 * defaultLibrary().skeleton.size();
  forJoined(blendAt(1.4), [&](const TransitionBlend::Joined& joined, Side) {
    std::vector<double> scratch(channels), was(channels), is;
    for (int i = 0; i < channels; ++i) was[i] = 0.01 * i;
    is = was;
    joined.mix(joined.blend_to + 0.1, 0.6, scratch, is.data(), 1);
    EXPECT_EQ(is, was);
    std::vector<double> other(channels, 0.5), one(channels, -0.5);
    joined.mix(0.0, 0.6, scratch, other.data(), 1);
    joined.mix(0.0, 0.6, scratch, one.data(), 1);
    for (int i = 1; i < channels; ++i) EXPECT_NEAR(other[i], one[i], 1e-12) << i;
    // Strided, only its own places are written.
    std::vector<double> wide(4 * static_cast<size_t>(channels), 9.0);
    for (int i = 0; i < channels; ++i) wide[4 * i] = -0.5;
    joined.mix(0.0, 0.6, scratch, wide.data(), 4);
    for (int i = 0; i < channels; ++i) {
      EXPECT_EQ(wide[4 * i], one[i]);
      for (int k = 1; k < 4; ++k) EXPECT_EQ(wide[4 * i + k], 9.0);
    }
  });
}

TEST(TransitionBlend, SwingsLieWithinTheFirstStepAndTheLast) {
  for (const double speed : {0.9, 1.2, 1.5}) {
    const TransitionBlend blend = blendAt(speed);
    for (const auto& swings : {blend.firstSwings(), blend.lastSwings()}) {
      for (const EndSwing& swing : swings) {
        if (!swing.captured) continue;
        EXPECT_LT(std::min(swing.lift_off, swing.strike), std::max(swing.lift_off, swing.strike));
        EXPECT_GT(std::min(swing.lift_off, swing.strike), -1.0);
        EXPECT_LT(std::max(swing.lift_off, swing.strike), 1.5);
      }
    }
    EXPECT_GE(blend.startSway(), 0.0);
    EXPECT_GE(blend.stopSway(), 0.0);
    forJoined(blend, [&](const TransitionBlend::Joined& joined, Side) {
      const double longest =
          joined.motion->kind == MotionKind::kStart ? blend.startSway() : blend.stopSway();
      EXPECT_LE(joined.sequence.sway, longest);
    });
  }
}

TEST(TransitionBlend, LengthsGrowWithTheWalkerAndTimesWithTheRootOfThat) {
  for (const double scale : {0.8, 1.0, 1.3}) {
    forJoined(blendAt(1.4, scale), [scale](const TransitionBlend::Joined& joined, Side) {
      const TransitionSequence& own = joined.motion->transition.sequence;
      EXPECT_NEAR(joined.sequence.step_time, std::sqrt(scale) * own.step_time, 1e-12);
      EXPECT_NEAR(joined.sequence.advance, scale * own.advance, 1e-12);
      EXPECT_EQ(joined.sequence.sway, own.sway);
      EXPECT_EQ(joined.sequence.swing.lift_off, own.swing.lift_off);
      EXPECT_EQ(joined.sequence.swing.strike, own.swing.strike);
      const Eigen::MatrixXd& spline = joined.sequence.spline;
      EXPECT_LT((spline.row(2) - scale * own.spline.row(2)).norm(), 1e-12);
      EXPECT_EQ(spline.bottomRows(spline.rows() - 3), own.spline.bottomRows(spline.rows() - 3));
    });
  }
}

TEST(TransitionBlend, HalfMixedItLiesHalfWayBetweenTheWalkAndTheSequence) {
  forJoined(blendAt(1.4), [](const TransitionBlend::Joined& joined, Side) {
    const auto rows = static_cast<size_t>(joined.sequence.spline.rows());
    std::vector<double> scratch(rows), sequence(rows), channels(rows, 7.0);
    const double middle = 0.5 * (joined.blend_from + joined.blend_to);
    EXPECT_NEAR(joined.share(middle), 0.5, 1e-9);
    // A step as long as was captured, so that the way is its own.
    joined.mix(middle, 2.0 * joined.sequence.advance, scratch, channels.data(), 1);
    transitionAt(joined.sequence, middle, sequence);
    for (size_t i = 0; i < rows; ++i) EXPECT_NEAR(channels[i], 0.5 * (sequence[i] + 7.0), 1e-9);
  });
}

TEST(TransitionBlend, ItsWayIsAsLongAsTheStepAsks) {
  forJoined(blendAt(1.4), [](const TransitionBlend::Joined& joined, Side) {
    const auto rows = static_cast<size_t>(joined.sequence.spline.rows());
    std::vector<double> scratch(rows), one(rows, 0.0), two(rows, 0.0);
    joined.mix(0.4, 0.4, scratch, one.data(), 1);
    joined.mix(0.4, 0.8, scratch, two.data(), 1);
    EXPECT_NEAR(two[0], 2.0 * one[0], 1e-12);
    for (size_t i = 1; i < rows; ++i) EXPECT_EQ(one[i], two[i]) << i;
  });
}

// A side without a captured start or stop steps there as in the walk.
TEST(TransitionBlend, SwingsThatAreAddedAreTheSequencesOrTheWalks) {
  for (const double speed : {0.2, 1.4}) {
    const TransitionBlend blend = blendAt(speed);
    SwingCycles cycles;
    for (const Side side : {kLeft, kRight}) cycles.walk[side].strike = 0.77;
    blend.addSwings(cycles);
    for (const Side side : {kLeft, kRight}) {
      const auto *start = blend.start(side), *stop = blend.stop(side);
      EXPECT_EQ(cycles.first[side].strike, start ? start->sequence.swing.strike : 0.77);
      EXPECT_EQ(cycles.last[side].strike, stop ? stop->sequence.swing.strike : 0.77);
      EXPECT_EQ(cycles.walk[side].strike, 0.77);
    }
  }
}

}  // namespace
}  // namespace amble

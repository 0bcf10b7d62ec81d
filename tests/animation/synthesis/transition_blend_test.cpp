#include "animation/synthesis/transition_blend.h"

#include <gtest/gtest.h>

#include <cmath>

#include "animation/synthesis/gait_blend.h"
#include "tests/animation/default_library.h"

namespace amble {
namespace {

/// Every joined start and stop of walkers of several sizes and speeds, with their speed.
template <typename Check>
int forEachJoined(const Check& check) {
  int count = 0;
  for (const double scale : {0.8, 1.0, 1.2}) {
    for (const double speed : {0.9, 1.2, 1.5}) {
      const GaitBlend blend(defaultLibrary(), scale, speed);
      for (const Side side : {kLeft, kRight}) {
        for (const bool start : {true, false}) {
          const auto* joined =
              start ? blend.transitions().start(side) : blend.transitions().stop(side);
          if (joined == nullptr) continue;
          SCOPED_TRACE(joined->motion->name);
          check(*joined, side, start, scale, speed);
          ++count;
        }
      }
    }
  }
  return count;
}

TEST(TransitionBlend, OfALibraryWithoutStartsAndStopsThereAreNone) {
  MotionLibrary walks = defaultLibrary();
  std::erase_if(walks.motions, [](const Motion& m) { return m.kind != MotionKind::kWalk; });
  const GaitBlend blend(walks, 1.0, 1.2);
  for (const Side side : {kLeft, kRight}) {
    EXPECT_EQ(blend.transitions().start(side), nullptr);
    EXPECT_EQ(blend.transitions().stop(side), nullptr);
    EXPECT_FALSE(blend.transitions().firstSwings()[side].captured);
    EXPECT_FALSE(blend.transitions().lastSwings()[side].captured);
  }
  EXPECT_EQ(blend.transitions().startSway(), 0.0);
  EXPECT_EQ(blend.transitions().stopSway(), 0.0);
}

TEST(TransitionBlend, WhatIsTakenIsOfItsKindAndSideAndNoFasterThanTheWalk) {
  const int seen =
      forEachJoined([](const auto& joined, Side side, bool start, double scale, double speed) {
        EXPECT_EQ(joined.motion->kind, start ? MotionKind::kStart : MotionKind::kStop);
        EXPECT_EQ(joined.sequence.side, side);
        EXPECT_LE(joined.motion->transition.speed, speed / std::sqrt(scale));
        // No other of that kind and side is nearer from below.
        for (const Motion& other : defaultLibrary().motions) {
          if (other.kind != joined.motion->kind || other.transition.sequence.empty() ||
              other.transition.sequence.side != side ||
              other.transition.speed > speed / std::sqrt(scale))
            continue;
          EXPECT_LE(other.transition.speed, joined.motion->transition.speed);
        }
      });
  EXPECT_GT(seen, 8);
}

TEST(TransitionBlend, AStrollIsSlowerThanEveryCaptureAndBeginsByTheFormula) {
  const GaitBlend blend(defaultLibrary(), 1.0, 0.2);
  for (const Side side : {kLeft, kRight}) {
    EXPECT_EQ(blend.transitions().start(side), nullptr);
    EXPECT_EQ(blend.transitions().stop(side), nullptr);
  }
}

TEST(TransitionBlend, ItsShareIsAllAtFirstAndNothingAtItsEndAndNeverGrows) {
  forEachJoined([](const auto& joined, Side, bool, double, double) {
    EXPECT_NEAR(joined.blend_to - joined.blend_from, TransitionBlend::kBlend, 1e-9);
    EXPECT_GE(joined.blend_from, 0.0);
    EXPECT_LE(joined.blend_to, TransitionSequence::kEnd + 1e-9);
    EXPECT_EQ(joined.share(-joined.sequence.sway), 1.0);
    EXPECT_EQ(joined.share(joined.blend_from), 1.0);
    EXPECT_EQ(joined.share(joined.blend_to), 0.0);
    EXPECT_NEAR(joined.share(0.5 * (joined.blend_from + joined.blend_to)), 0.5, 1e-9);
    double before = 1.0;
    for (double clock = -1.0; clock < TransitionSequence::kEnd; clock += 0.01) {
      const double share = joined.share(clock);
      EXPECT_LE(share, before);
      EXPECT_LT(before - share, 0.03);
      before = share;
    }
  });
}

TEST(TransitionBlend, LengthsGrowWithTheWalkerAndTimesWithTheRootOfThat) {
  forEachJoined([](const auto& joined, Side, bool, double scale, double) {
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

TEST(TransitionBlend, MixedItIsTheSequenceFirstAndTheWalkAfterwardsAndBetweenBetween) {
  forEachJoined([](const auto& joined, Side, bool, double, double) {
    const auto rows = static_cast<size_t>(joined.sequence.spline.rows());
    std::vector<double> scratch(rows), wanted(rows);
    for (const double clock : {-0.1, 0.3, 0.8, 1.0, 1.3, 1.7, 1.95}) {
      std::vector<double> channels(rows, 7.0);
      // A step as long as was captured, so that the way is its own.
      joined.mix(clock, 2.0 * joined.sequence.advance, scratch, channels.data(), 1);
      transitionAt(joined.sequence, clock, wanted);
      const double share = joined.share(clock);
      for (size_t i = 0; i < rows; ++i) {
        EXPECT_NEAR(channels[i], share * wanted[i] + (1.0 - share) * 7.0, 1e-9) << i;
      }
    }
  });
}

TEST(TransitionBlend, ItsWayIsAsLongAsTheStepAsks) {
  forEachJoined([](const auto& joined, Side, bool, double, double) {
    const auto rows = static_cast<size_t>(joined.sequence.spline.rows());
    std::vector<double> scratch(rows), one(rows, 0.0), two(rows, 0.0);
    for (const double clock : {0.2, 0.6}) {
      joined.mix(clock, 0.4, scratch, one.data(), 1);
      joined.mix(clock, 0.8, scratch, two.data(), 1);
      if (joined.share(clock) < 1.0) continue;
      EXPECT_NEAR(two[0], 2.0 * one[0], 1e-12);
      for (size_t i = 1; i < rows; ++i) EXPECT_EQ(one[i], two[i]) << i;
    }
  });
}

TEST(TransitionBlend, FramesSideBySideAreMixedAlikeAndNeighboursAreLeft) {
  forEachJoined([](const auto& joined, Side, bool, double, double) {
    const auto rows = static_cast<size_t>(joined.sequence.spline.rows());
    std::vector<double> scratch(rows), alone(rows, 2.0), lanes(4 * rows, 2.0);
    joined.mix(0.7, 0.6, scratch, alone.data(), 1);
    joined.mix(0.7, 0.6, scratch, lanes.data() + 2, 4);
    for (size_t i = 0; i < rows; ++i) {
      EXPECT_EQ(lanes[4 * i + 2], alone[i]);
      for (const size_t lane : {0u, 1u, 3u}) EXPECT_EQ(lanes[4 * i + lane], 2.0);
    }
  });
}

TEST(TransitionBlend, SwingsAndSwayAreThoseOfTheSequences) {
  const GaitBlend blend(defaultLibrary(), 1.0, 1.2);
  const TransitionBlend& transitions = blend.transitions();
  SwingCycles cycles = blend.feet();
  transitions.addSwings(cycles);
  double longest = 0.0;
  for (const Side side : {kLeft, kRight}) {
    const auto* start = transitions.start(side);
    const EndSwing first = transitions.firstSwings()[side];
    EXPECT_EQ(first.captured, start != nullptr);
    if (start == nullptr) {
      EXPECT_EQ(cycles.first[side].strike, cycles.walk[side].strike);
      continue;
    }
    EXPECT_EQ(first.lift_off, start->sequence.swing.lift_off);
    EXPECT_EQ(first.strike, start->sequence.swing.strike);
    EXPECT_LT(first.lift_off, first.strike);
    EXPECT_EQ(cycles.first[side].strike, first.strike);
    longest = std::max(longest, start->sequence.sway);
  }
  EXPECT_EQ(transitions.startSway(), longest);
}

}  // namespace
}  // namespace amble

#include "animation/library/transition.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/animation/random_clip.h"

namespace amble {
namespace {

TEST(SplineWeights, SumToOneAndHoldAtTheEnds) {
  for (double x = -0.5; x <= 1.5; x += 0.01) {
    const SplineWeights w = splineWeights(7, x);
    EXPECT_NEAR(w.weight[0] + w.weight[1] + w.weight[2] + w.weight[3], 1.0, 1e-14);
    EXPECT_GE(w.first, 0);
    EXPECT_LE(w.first + 3, 9);
  }
}

TEST(SplineWeights, ALineOfCoefficientsIsALine) {
  constexpr int kPieces = 5;
  for (double x = 0.0; x <= 1.0; x += 0.03) {
    const SplineWeights w = splineWeights(kPieces, x);
    double value = 0.0;
    for (int k = 0; k < 4; ++k) value += w.weight[k] * (w.first + k - 1);
    EXPECT_NEAR(value, kPieces * x, 1e-12);
  }
}

TEST(Transition, ThePathsPointGainsTheSpeedOfTheWalkFromRest) {
  constexpr double kStep = 1e-6;
  const auto slope = [](double clock) {
    return (transitionAdvance(clock + kStep) - transitionAdvance(clock - kStep)) / (2.0 * kStep);
  };
  EXPECT_EQ(transitionAdvance(-1.0), 0.0);
  EXPECT_EQ(transitionAdvance(2.0), 1.0);
  EXPECT_NEAR(slope(kStep), 0.0, 1e-9);
  for (double clock = 0.05; clock < 1.0; clock += 0.05) {
    const double eased = clock * clock * (3.0 - 2.0 * clock);
    EXPECT_NEAR(slope(clock), 2.0 * eased, 1e-6);  // of the speed at 1, twice the mean
  }
}

/// A sequence of random coefficients.
TransitionSequence randomSequence(Generator& generator, int rows, int columns) {
  TransitionSequence sequence;
  sequence.sway = uniform(generator, 0.0, 2.0);
  sequence.spline.resize(rows, columns);
  for (Eigen::Index i = 0; i < sequence.spline.size(); ++i)
    sequence.spline(i) = uniform(generator, -1.0, 1.0);
  return sequence;
}

Eigen::VectorXd channelsAt(const TransitionSequence& sequence, double clock) {
  Eigen::VectorXd channels(sequence.spline.rows());
  transitionAt(sequence, clock, {channels.data(), static_cast<size_t>(channels.size())});
  return channels;
}

TEST(Transition, IsHeldBeforeItsBeginAndBehindItsEnd) {
  Generator generator(1);
  for (int trial = 0; trial < 10; ++trial) {
    const TransitionSequence sequence = randomSequence(generator, 4, 12);
    EXPECT_EQ(channelsAt(sequence, -sequence.sway - 3.0), channelsAt(sequence, -sequence.sway));
    EXPECT_EQ(channelsAt(sequence, 7.0), channelsAt(sequence, TransitionSequence::kEnd));
  }
}

// A B-spline's values are means of its coefficients, and its slope and bend go over from piece to
// piece.
TEST(Transition, StaysWithinItsCoefficientsAndBendsWithoutAJump) {
  Generator generator(2);
  constexpr double kStep = 1e-4;
  const TransitionSequence sequence = randomSequence(generator, 3, 11);
  Eigen::VectorXd bend_before;
  const double length = TransitionSequence::kEnd + sequence.sway;
  const double most = 8.0 / std::pow(length / sequence.pieces(), 3);  // of the third derivative
  for (double clock = -sequence.sway + 2 * kStep; clock < TransitionSequence::kEnd - 2 * kStep;
       clock += kStep) {
    const Eigen::VectorXd here = channelsAt(sequence, clock);
    for (int i = 0; i < 3; ++i) {
      EXPECT_LE(here[i], sequence.spline.row(i).maxCoeff() + 1e-12);
      EXPECT_GE(here[i], sequence.spline.row(i).minCoeff() - 1e-12);
    }
    const Eigen::VectorXd bend =
        (channelsAt(sequence, clock + kStep) - 2.0 * here + channelsAt(sequence, clock - kStep)) /
        (kStep * kStep);
    if (bend_before.size() > 0) {
      EXPECT_LT((bend - bend_before).cwiseAbs().maxCoeff(), most * kStep + 1e-5);
    }
    bend_before = bend;
  }
}

// At its begin three alike coefficients are left at rest.
TEST(Transition, LeavesAPostureOfThreeAlikeCoefficientsAtRest) {
  Generator generator(3);
  TransitionSequence sequence = randomSequence(generator, 5, 10);
  for (int k = 1; k < TransitionSequence::kStanding; ++k)
    sequence.spline.col(k) = sequence.spline.col(0);
  const Eigen::VectorXd first = channelsAt(sequence, -sequence.sway);
  EXPECT_LT((first - sequence.spline.col(0)).cwiseAbs().maxCoeff(), 1e-12);
  constexpr double kStep = 1e-5;
  const Eigen::VectorXd soon = channelsAt(sequence, -sequence.sway + kStep);
  EXPECT_LT((soon - first).cwiseAbs().maxCoeff(), 1e-12);
}

}  // namespace
}  // namespace amble

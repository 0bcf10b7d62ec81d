#include "animation/library/turn_sequence.h"

#include <gtest/gtest.h>

#include "animation/library/transition.h"
#include "base/sample_stream.h"

namespace amble {
namespace {

constexpr int kRows = 5, kColumns = 14;

TurnSequence randomTurn(int index) {
  constexpr int kStood = TurnSequence::kStanding;
  SampleStream stream(1, index);
  TurnSequence turn;
  turn.spline.resize(kRows, kColumns);
  turn.turned.resize(1, kColumns);
  for (Eigen::Index i = 0; i < turn.spline.size(); ++i) turn.spline(i) = stream.uniform(-1.0, 1.0);
  for (int i = 0; i < kColumns; ++i) turn.turned(i) = stream.uniform(-0.5, 1.5);
  turn.turned.leftCols(kStood).setZero();
  turn.turned.rightCols(kStood).setOnes();
  const Eigen::VectorXd stand = turn.spline.col(0);
  turn.spline.leftCols(kStood) = turn.spline.rightCols(kStood) = stand.replicate(1, kStood);
  return turn;
}

TEST(TurnSequence, BeginsAndEndsInOnePostureAtRest) {
  for (int index = 0; index < 20; ++index) {
    const TurnSequence turn = randomTurn(index);
    std::vector<double> channels(kRows);
    for (const double clock : {-1.0, 0.0, 1.0, 2.0}) {
      turnChannels(turn, clock, channels);
      for (int row = 0; row < kRows; ++row) EXPECT_NEAR(channels[row], turn.spline(row, 0), 1e-12);
    }
    constexpr double kSoon = 1e-4;
    for (const double clock : {kSoon, 1.0 - kSoon}) {  // as a cube of the time does
      turnChannels(turn, clock, channels);
      for (int row = 0; row < kRows; ++row) EXPECT_NEAR(channels[row], turn.spline(row, 0), 1e-8);
    }
  }
}

TEST(TurnSequence, TheShareIsTheSplineItselfAlsoBetweenItsKnots) {
  for (int index = 0; index < 20; ++index) {
    const TurnSequence turn = randomTurn(index);
    const CubicSpline share = shareTurned(turn);
    for (int i = 0; i <= 1000; ++i) {
      const double clock = i / 1000.0;
      double value = 0.0;
      splineAt(turn.turned, clock, {&value, 1});
      EXPECT_NEAR(share.at(clock), value, 1e-12) << clock;
    }
    EXPECT_EQ(share.at(0.0), 0.0);
    EXPECT_NEAR(share.at(1.0), 1.0, 1e-15);
    EXPECT_NEAR(share.slope(0.0), 0.0, 1e-12);
    EXPECT_NEAR(share.slope(1.0), 0.0, 1e-12);
  }
}

}  // namespace
}  // namespace amble

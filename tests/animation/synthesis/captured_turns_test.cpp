#include "animation/synthesis/captured_turns.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "base/sample_stream.h"
#include "tests/animation/default_library.h"

namespace amble {
namespace {

Motion turnBy(double degrees, Side first) {
  Motion motion;
  motion.kind = MotionKind::kTurnOnSpot;
  motion.turn.angle = degrees * kDegree;
  motion.turn.duration = 2.0;
  motion.turn.first = first;
  motion.turn.spline = Eigen::MatrixXd::Ones(6, 10);
  motion.turn.turned = Eigen::MatrixXd::Ones(1, 10);
  return motion;
}

CapturedTurns turnsOf(const std::vector<Motion>& motions) {
  static MotionLibrary library;  // that the turns' motions stay
  library.motions = motions;
  return CapturedTurns(library, 1.0);
}

TEST(CapturedTurns, ALibraryWithoutThemTakesNone) {
  MotionLibrary library = defaultLibrary();
  std::erase_if(library.motions,
                [](const Motion& motion) { return motion.kind == MotionKind::kTurnOnSpot; });
  EXPECT_EQ(CapturedTurns(library, 1.0).size(), 0);
  const CapturedTurns turns;
  for (const double angle : {-kPi, -0.1, 0.0, 1.0, 2.0 * kPi}) {
    EXPECT_EQ(turns.take(angle).turn, -1);
    EXPECT_EQ(turns.take(angle).times, 1);
  }
}

TEST(CapturedTurns, NoneIsTakenToTheOtherSideNorByLessThanHalfOfWhatWasCaptured) {
  const CapturedTurns turns = turnsOf({turnBy(90.0, kLeft)});
  EXPECT_EQ(turns.take(-90.0 * kDegree).turn, -1);
  EXPECT_EQ(turns.take(0.0).turn, -1);
  EXPECT_EQ(turns.take(44.9 * kDegree).turn, -1);
  EXPECT_EQ(turns.take(45.1 * kDegree).turn, 0);
}

TEST(CapturedTurns, ATurnAsCapturedIsMadeOnce) {
  const CapturedTurns turns =
      turnsOf({turnBy(90.0, kLeft), turnBy(180.0, kLeft), turnBy(-90.0, kRight)});
  for (int i = 0; i < turns.size(); ++i) {
    EXPECT_EQ(turns.take(turns.sequence(i).angle).turn, i);
    EXPECT_EQ(turns.take(turns.sequence(i).angle).times, 1);
  }
  EXPECT_EQ(turns.take(360.0 * kDegree).turn, 1);
  EXPECT_EQ(turns.take(360.0 * kDegree).times, 2);
}

TEST(CapturedTurns, OfTwoByOneAngleThatWithTheInsideFootIsTaken) {
  const CapturedTurns turns = turnsOf(
      {turnBy(90.0, kRight), turnBy(90.0, kLeft), turnBy(-90.0, kLeft), turnBy(-90.0, kRight)});
  EXPECT_EQ(turns.take(90.0 * kDegree).turn, 1);
  EXPECT_EQ(turns.take(-90.0 * kDegree).turn, 3);
}

// As one tries them all.
TEST(CapturedTurns, TheNearestIsTakenWithinItsBounds) {
  for (int index = 0; index < 200; ++index) {
    SampleStream stream(7, index);
    std::vector<Motion> motions;
    for (int i = 0; i < 4; ++i)
      motions.push_back(turnBy((stream.below(2) == 0 ? -1.0 : 1.0) * stream.uniform(20.0, 250.0),
                               stream.below(2) == 0 ? kLeft : kRight));
    const CapturedTurns turns = turnsOf(motions);
    const double angle = stream.uniform(-2.0 * kPi, 2.0 * kPi);
    const Side inside = angle > 0.0 ? kLeft : kRight;
    const auto cost = [&](int i, int times) {
      const TurnSequence& turn = turns.sequence(i);
      const double ratio = angle / (times * turn.angle);
      if (!(ratio >= CapturedTurns::kLeast && ratio <= CapturedTurns::kMost))
        return std::numeric_limits<double>::infinity();
      return std::abs(std::log(ratio)) + CapturedTurns::kOneMore * (times - 1) +
             (turn.first == inside ? 0.0 : CapturedTurns::kOtherFoot);
    };
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < turns.size(); ++i)
      for (int times = 1; times < 50; ++times) least = std::min(least, cost(i, times));
    const CapturedTurns::Taken taken = turns.take(angle);
    ASSERT_EQ(taken.turn >= 0, std::isfinite(least)) << index;
    if (taken.turn < 0) continue;
    EXPECT_EQ(cost(taken.turn, taken.times), least) << index;
  }
}

TEST(CapturedTurns, LengthsGrowWithTheCharacterAndTimesWithTheirRoot) {
  MotionLibrary library;
  library.motions = {turnBy(90.0, kLeft)};
  const CapturedTurns turns(library, 1.44);
  EXPECT_DOUBLE_EQ(turns.sequence(0).duration, 1.2 * 2.0);
  EXPECT_DOUBLE_EQ(turns.sequence(0).spline(2, 4), 1.44);
  EXPECT_DOUBLE_EQ(turns.sequence(0).spline(3, 4), 1.0);
  EXPECT_EQ(turns.sequence(0).turned, library.motions[0].turn.turned);
  EXPECT_EQ(&turns.motion(0), &library.motions[0]);
}

}  // namespace
}  // namespace amble

#include "animation/synthesis/gait_blend.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "base/rotation.h"
#include "tests/animation/default_library.h"

namespace amble {
namespace {

/// Mean of the values of those cycles of the library that `which` chooses, at a phase.
template <typename Which>
Eigen::VectorXd meanOf(double phase, Which which) {
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(3 + 3 * defaultLibrary().skeleton.size());
  int count = 0;
  for (const Motion& motion : defaultLibrary().motions) {
    if (motion.kind != MotionKind::kWalk || !which(motion)) continue;
    const FourierSeries& s = motion.cycle.series;
    for (int k = 0; k <= s.harmonics(); ++k) {
      sum += std::cos(2.0 * kPi * k * phase) * s.alpha.col(k) +
             std::sin(2.0 * kPi * k * phase) * s.beta.col(k);
    }
    ++count;
  }
  return sum / count;
}

Eigen::VectorXd valueOf(const GaitBlend& blend, double phase, double turn_rate, double step) {
  Eigen::VectorXd channels;
  blend.evaluate(phase, turn_rate, step, channels);
  return channels;
}

TEST(GaitBlend, ALibraryWithoutAStraightWalkIsRefused) {
  MotionLibrary turns = defaultLibrary();
  std::erase_if(turns.motions,
                [](const Motion& m) { return m.kind == MotionKind::kWalk && !m.turning; });
  EXPECT_THROW(GaitBlend(turns, 1.0), std::invalid_argument);
}

/// Mean planted step of those walks.
template <typename Which>
double stepOf(Which which) {
  double sum = 0.0;
  int count = 0;
  for (const Motion& motion : defaultLibrary().motions) {
    if (motion.kind != MotionKind::kWalk || !which(motion)) continue;
    sum += motion.cycle.stepLength();
    ++count;
  }
  return sum / count;
}

/// Extreme of a number over the library's walks that `which` chooses.
template <typename Which, typename Number>
double largestOf(Which which, Number number) {
  double largest = -1e9;
  for (const Motion& motion : defaultLibrary().motions) {
    if (motion.kind == MotionKind::kWalk && which(motion)) {
      largest = std::max(largest, number(motion.cycle));
    }
  }
  return largest;
}

TEST(GaitBlend, AtACapturedPaceAndBeyondItIsTheMeanOfItsWalks) {
  const auto straight = [](const Motion& m) { return !m.turning; };
  const double fastest = largestOf(straight, [](const WalkCycle& c) { return c.speed; });
  const double slowest = -largestOf(straight, [](const WalkCycle& c) { return -c.speed; });
  for (const auto& [pace, speed] : {std::pair(slowest, 0.5 * slowest), {fastest, 1.1 * fastest}}) {
    const auto ofPace = [&](const Motion& m) {
      return !m.turning && std::abs(m.cycle.speed / pace - 1.0) < 0.5 * GaitBlend::kSamePace;
    };
    const GaitBlend blend(defaultLibrary(), 1.0, speed);
    for (double phase = 0.0; phase < 1.0; phase += 0.07) {
      const auto value = valueOf(blend, phase, 0.0, stepOf(ofPace));
      EXPECT_LT((value - meanOf(phase, ofPace)).norm(), 1e-12) << speed;
    }
  }
}

TEST(GaitBlend, AtACapturedTurnRateAndBeyondItsLowHarmonicsAreThoseOfThatTurn) {
  const GaitBlend blend(defaultLibrary(), 1.0);
  for (const double sign : {1.0, -1.0}) {
    const double fastest = largestOf([](const Motion& m) { return m.turning; },
                                     [&](const WalkCycle& c) { return sign * c.turn_rate; });
    const auto ofRate = [&](const Motion& m) {
      return m.turning && sign * m.cycle.turn_rate > fastest / (1.0 + GaitBlend::kSamePace);
    };
    for (const double rate : {1.01, 2.0}) {  // left and right differ by 1e-4: nothing extrapolates
      for (int k = 0; k <= GaitBlend::kTurnHarmonics; ++k) {
        Eigen::VectorXd cosine = Eigen::VectorXd::Zero(3 + 3 * defaultLibrary().skeleton.size());
        Eigen::VectorXd sine = cosine;
        for (double phase = 0.0; phase < 1.0; phase += 1.0 / 32) {
          const Eigen::VectorXd off =
              valueOf(blend, phase, sign * rate * blend.maxTurnRate(), stepOf(ofRate)) -
              meanOf(phase, ofRate);
          cosine += std::cos(2.0 * kPi * k * phase) * off;
          sine += std::sin(2.0 * kPi * k * phase) * off;
        }
        EXPECT_LT(cosine.norm() + sine.norm(), 1e-10) << k;
      }
    }
  }
}

TEST(GaitBlend, BetweenTwoPacesItIsContinuousInSpeed) {
  for (double speed = 0.9; speed < 2.1; speed += 0.01) {
    const GaitBlend a(defaultLibrary(), 1.0, speed), b(defaultLibrary(), 1.0, speed + 1e-6);
    EXPECT_LT((valueOf(a, 0.3, 0.2, 0.6) - valueOf(b, 0.3, 0.2, 0.6)).norm(), 1e-4) << speed;
    EXPECT_NEAR(a.stepWidth(), b.stepWidth(), 1e-5);
  }
}

// Beside the prints, which are put down where the plan's walk has them.
TEST(GaitBlend, WhoSlowsToACapturedPaceWalksAsItsWalks) {
  const GaitBlend blend(defaultLibrary(), 1.0, 1.7);
  const WalkDepartures& departures = blend.feet().departures;
  ASSERT_EQ(departures.slower.size(), 3u);
  for (const double slower : departures.slower) {
    const double speed = departures.steady - slower;
    const auto ofPace = [&](const Motion& m) {
      return !m.turning && std::abs(m.cycle.speed / speed - 1.0) < 0.5 * GaitBlend::kSamePace;
    };
    const double moved = GaitBlend(defaultLibrary(), 1.0, speed).footForward();
    for (double phase = 0.0; phase < 1.0; phase += 0.07) {
      Eigen::VectorXd value;
      blend.evaluate(phase, 0.0, stepOf(ofPace), value, slower);
      value[0] += moved - blend.footForward();
      EXPECT_LT((value - meanOf(phase, ofPace)).norm(), 1e-12) << speed;
    }
  }
}

TEST(GaitBlend, ATurnIsTheSameInItsLowHarmonicsHoweverSlowTheWalkThere) {
  const GaitBlend blend(defaultLibrary(), 1.0, 1.7);
  const double rate = 2.0 * blend.maxTurnRate(), step = blend.law().capturedStep();
  const double slowest = blend.feet().departures.slower.back();
  double high = 0.0;
  for (int k = 0; k <= GaitBlend::kTurnHarmonics + 1; ++k) {
    Eigen::VectorXd cosine = Eigen::VectorXd::Zero(blend.channels()), sine = cosine;
    for (double phase = 0.0; phase < 1.0; phase += 1.0 / 32) {
      Eigen::VectorXd fast, slow;
      blend.evaluate(phase, rate, step, fast);
      blend.evaluate(phase, rate, step, slow, slowest);
      cosine += std::cos(2.0 * kPi * k * phase) * (slow - fast);
      sine += std::sin(2.0 * kPi * k * phase) * (slow - fast);
    }
    if (k <= GaitBlend::kTurnHarmonics) {
      EXPECT_LT(cosine.norm() + sine.norm(), 1e-10) << k;
    }
    high = cosine.norm() + sine.norm();
  }
  EXPECT_GT(high, 1e-3);  // these are the straight walks'
}

TEST(GaitBlend, HalfWayToTheSlowestTurnHalfOfItIsAdded) {
  const GaitBlend blend(defaultLibrary(), 1.0);
  const double step = blend.law().capturedStep();
  const Eigen::VectorXd straight = valueOf(blend, 0.6, 0.0, step);
  const double slowest =
      -largestOf([](const Motion& m) { return m.turning && m.cycle.turn_rate > 0.0; },
                 [](const WalkCycle& c) { return -c.turn_rate; });
  const Eigen::VectorXd half = valueOf(blend, 0.6, 0.5 * slowest, step) - straight;
  const Eigen::VectorXd whole = valueOf(blend, 0.6, slowest, step) - straight;
  EXPECT_LT((2.0 * half - whole).norm(), 1e-12);
  EXPECT_GT(whole.norm(), 1e-3);
}

TEST(GaitBlend, AmplitudesGrowWithTheStepAndMeansStay) {
  const GaitBlend blend(defaultLibrary(), 1.0);
  const double step = blend.law().capturedStep();
  constexpr int kPhases = 32;
  const auto meanAt = [&](double length) {
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(3 + 3 * defaultLibrary().skeleton.size());
    for (int i = 0; i < kPhases; ++i) {
      sum += valueOf(blend, static_cast<double>(i) / kPhases, 0.2, length) / kPhases;
    }
    return sum;
  };
  const Eigen::VectorXd mean = meanAt(step);
  for (const double warp : {0.5, 1.3}) {
    EXPECT_LT((meanAt(warp * step) - mean).norm(), 1e-12);
    for (const double phase : {0.1, 0.45}) {
      const Eigen::VectorXd expected = warp * (valueOf(blend, phase, 0.2, step) - mean);
      EXPECT_LT((valueOf(blend, phase, 0.2, warp * step) - mean - expected).norm(), 1e-12);
    }
  }
}

TEST(GaitBlend, ScaleEnlargesLengthsAndSlowsByFroudesLaw) {
  const GaitBlend one(defaultLibrary(), 1.0, 1.2), tall(defaultLibrary(), 1.21, 1.1 * 1.2);
  EXPECT_NEAR(tall.stepWidth(), 1.21 * one.stepWidth(), 1e-12);
  EXPECT_NEAR(tall.footForward(), 1.21 * one.footForward(), 1e-12);
  for (const Side side : {kLeft, kRight})
    EXPECT_NEAR(tall.toeOut()[side], one.toeOut()[side], 1e-15);
  EXPECT_NEAR(tall.maxTurnRate(), one.maxTurnRate() / 1.1, 1e-12);
  EXPECT_NEAR(tall.law().capturedStep(), 1.21 * one.law().capturedStep(), 1e-12);
  EXPECT_NEAR(tall.law().speed(tall.law().capturedStep()),
              1.1 * one.law().speed(one.law().capturedStep()), 1e-12);
  const Eigen::VectorXd a = valueOf(one, 0.2, 0.0, one.law().capturedStep());
  const Eigen::VectorXd b = valueOf(tall, 0.2, 0.0, tall.law().capturedStep());
  EXPECT_LT((b.head(3) - 1.21 * a.head(3)).norm(), 1e-12);
  EXPECT_LT((b.tail(b.size() - 3) - a.tail(a.size() - 3)).norm(), 1e-12);
}

TEST(GaitBlend, PathsMayTurnAsFastAsAnyTurnOfTheFastestPace) {
  const GaitBlend blend(defaultLibrary(), 1.0);
  for (const double sign : {1.0, -1.0}) {
    const double fastest = largestOf([](const Motion& m) { return m.turning; },
                                     [&](const WalkCycle& c) { return sign * c.turn_rate; });
    EXPECT_GE(blend.maxTurnRate(), fastest);
    EXPECT_LE(blend.maxTurnRate(), (1.0 + GaitBlend::kSamePace) * fastest);
  }
}

TEST(GaitBlend, TurnsAreToldByTheirTurnRateNotByTheirName) {
  MotionLibrary renamed = defaultLibrary();
  for (Motion& motion : renamed.motions) {
    if (motion.kind == MotionKind::kWalk) motion.name = "m" + motion.name;
  }
  const GaitBlend a(defaultLibrary(), 1.0), b(renamed, 1.0);
  EXPECT_EQ(valueOf(a, 0.3, 0.5, 0.6), valueOf(b, 0.3, 0.5, 0.6));
}

TEST(GaitBlend, WithoutTurnsAWalkIsTheStraightOneAndTurnsSlowly) {
  MotionLibrary straight = defaultLibrary();
  std::erase_if(straight.motions, [](const Motion& m) { return m.turning; });
  const GaitBlend blend(straight, 1.0);
  EXPECT_EQ(blend.maxTurnRate(), GaitBlend::kNoTurns);
  EXPECT_EQ(valueOf(blend, 0.3, 0.4, 0.6), valueOf(blend, 0.3, 0.0, 0.6));
}

}  // namespace
}  // namespace amble

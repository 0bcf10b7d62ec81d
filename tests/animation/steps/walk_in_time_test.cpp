// How far a walk gets and how its speed goes, of both clocks that there are: SpeedProfile, which
// chooses its steps itself, and StepTiming, whose steps are given.

#include <gtest/gtest.h>

#include <cmath>

#include "animation/steps/speed_profile.h"
#include "animation/steps/step_timing.h"
#include "tests/animation/random_clip.h"
#include "tests/animation/step_character.h"
#include "tests/animation/walk_paths.h"

namespace amble {
namespace {

SpeedLimits limitsOfLibrary(double speed) {
  const GaitBlend& blend = stepCharacter().blend;
  SpeedLimits limits;
  limits.law = blend.law();
  limits.speed = speed;
  limits.max_turn_rate = blend.maxTurnRate();
  return limits;
}

class WalkedPaths : public testing::TestWithParam<double> {
 protected:
  static std::vector<RootPath> paths() {
    RootPath bends = circlePath(2.0, 1.5);
    const RootPath::Sample end = bends.at(bends.length());
    bends.append(straightPath(2.5, end.heading, end.position));
    return {straightPath(3.0), straightPath(7.3, 1.1, {2.0, -4.0}), circlePath(3.0, 2.0),
            circlePath(-2.5, -1.8), bends};
  }
  /// Calls `check` with every profile that is not refused, of which there are most.
  template <typename Check>
  void forProfiles(const Check& check) const {
    int walked = 0, asked = 0;
    for (const RootPath& path : paths()) {
      for (const bool standing : {true, false}) {
        const SpeedLimits limits = limitsOfLibrary(GetParam());
        const SpeedProfile profile(path, limits, {standing, standing, {}});
        ++asked;
        if (profile.refusal() != SpeedProfile::Refusal::kNone) continue;
        ++walked;
        check(profile, path, limits);
      }
    }
    EXPECT_GE(3 * walked, 2 * asked);
  }
};

// Simpson's rule over each two frames: the way is what the speed adds up to.
TEST_P(WalkedPaths, AreAsLongAsTheirSpeedAddsUpTo) {
  forProfiles([](const SpeedProfile& profile, const RootPath& path, const SpeedLimits& limits) {
    double way = 0.0;
    for (int k = 0; k < profile.frames(); ++k) {
      way += 0.5 * limits.frame_time * (profile.at(k).speed + profile.at(k + 1).speed);
    }
    EXPECT_NEAR(way, path.length(), 0.005 * path.length());
  });
}

TEST_P(WalkedPaths, AreNeverPassedFasterThanWasAskedByMuch) {
  forProfiles([](const SpeedProfile& profile, const RootPath&, const SpeedLimits& limits) {
    for (int k = 0; k <= profile.frames(); ++k) {
      EXPECT_GE(profile.at(k).speed, 0.0);
      // Whole steps may ask for steps a fifth longer (StepFit::kMostStretch), and speed follows.
      EXPECT_LT(profile.at(k).speed, 1.5 * limits.speed);
    }
  });
}

// Nobody speeds up or slows down by more than half of gravity.
TEST_P(WalkedPaths, AreWalkedWithoutAJolt) {
  forProfiles([](const SpeedProfile& profile, const RootPath&, const SpeedLimits& limits) {
    for (int k = 0; k < profile.frames(); ++k) {
      const double change = profile.at(k + 1).speed - profile.at(k).speed;
      EXPECT_LT(std::abs(change) / limits.frame_time, 4.9) << k;
    }
  });
}

TEST_P(WalkedPaths, AreTheSameWhereverTheyLie) {
  const SpeedLimits limits = limitsOfLibrary(GetParam());
  const SpeedProfile here(straightPath(5.0), limits, {});
  const SpeedProfile there(straightPath(5.0, -2.0, {100.0, -50.0}), limits, {});
  ASSERT_EQ(here.refusal(), SpeedProfile::Refusal::kNone);
  ASSERT_EQ(here.frames(), there.frames());
  for (int k = 0; k <= here.frames(); ++k) {
    EXPECT_NEAR(here.at(k).arc, there.at(k).arc, 1e-9);
    EXPECT_NEAR(here.at(k).steps, there.at(k).steps, 1e-9);
  }
}

TEST_P(WalkedPaths, TurnedLeftAreAsTurnedRight) {
  // The captured turns to both sides differ a little; of a law without turns nothing does.
  SpeedLimits limits = limitsOfLibrary(GetParam());
  limits.law = StrideLaw(1.1, 0.6);
  const SpeedProfile left(circlePath(3.0, 2.0), limits, {});
  const SpeedProfile right(circlePath(-3.0, -2.0), limits, {});
  ASSERT_EQ(left.refusal(), SpeedProfile::Refusal::kNone);
  ASSERT_EQ(left.frames(), right.frames());
  ASSERT_EQ(left.steps(), right.steps());
  for (int k = 0; k <= left.frames(); ++k) EXPECT_NEAR(left.at(k).arc, right.at(k).arc, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(, WalkedPaths, testing::Values(0.6, 0.9, 1.2, 1.5));

TEST(SpeedProfile, OnGroundThatAllowsHalfTheSpeedAWalkTakesLonger) {
  const SpeedLimits level = limitsOfLibrary(1.2);
  SpeedLimits rough = level;
  rough.pace = [](double) { return 0.5; };
  const SpeedProfile fast(straightPath(8.0), level, {}), slow(straightPath(8.0), rough, {});
  ASSERT_EQ(slow.refusal(), SpeedProfile::Refusal::kNone);
  EXPECT_GT(slow.frames(), 1.5 * fast.frames());
  EXPECT_GT(slow.steps(), fast.steps());
}

TEST(SpeedProfile, AStrideThatIsAskedForIsWalkedAtItsCadence) {
  const SpeedLimits plain = limitsOfLibrary(1.2);
  SpeedLimits longer = plain;
  const double step = plain.law.stepLength(1.2);
  longer.stride = [step](double) { return 1.15 * step; };
  const SpeedProfile a(straightPath(12.0), plain, {}), b(straightPath(12.0), longer, {});
  ASSERT_EQ(b.refusal(), SpeedProfile::Refusal::kNone);
  EXPECT_NEAR(b.at(b.frames() / 2).step_length, 1.15 * step, 0.05 * step);
  EXPECT_LT(b.steps(), a.steps());
  const auto cadence = [](const SpeedProfile& profile) {
    const SpeedProfile::Sample middle = profile.at(profile.frames() / 2);
    return middle.speed / middle.step_length;
  };
  EXPECT_NEAR(cadence(b), cadence(a), 0.06 * cadence(a));
}

/// A walk of random steps, from standing to standing.
TimedSteps randomSteps(Generator& generator) {
  TimedSteps steps;
  steps.arcs = {0.0};
  const int count = 4 + static_cast<int>(uniform(generator, 0.0, 6.0));
  for (int i = 0; i < count; ++i) {
    const double length = uniform(generator, 0.4, 0.7);
    steps.arcs.push_back(steps.arcs.back() + length);
    steps.lengths.push_back(length);
    steps.durations.push_back(uniform(generator, 0.45, 0.7));
  }
  steps.lengths.push_back(steps.lengths.back());
  return steps;
}

TEST(StepTiming, OfRandomStepsEndsWhereTheyEnd) {
  Generator generator(5);
  for (int trial = 0; trial < 30; ++trial) {
    const TimedSteps steps = randomSteps(generator);
    const StepTiming timing(steps);
    double wanted = 0.0, way = 0.0;
    for (const double duration : steps.durations) wanted += duration;
    EXPECT_NEAR(timing.frames() * steps.frame_time, wanted, 0.5 * steps.frame_time + 1e-9);
    EXPECT_NEAR(timing.at(timing.frames()).arc, steps.arcs.back(), 1e-9);
    EXPECT_NEAR(timing.at(timing.frames()).steps, steps.durations.size(), 1e-9);
    for (int k = 0; k < timing.frames(); ++k)
      way += 0.5 * steps.frame_time * (timing.at(k).speed + timing.at(k + 1).speed);
    EXPECT_NEAR(way, steps.arcs.back(), 0.005 * steps.arcs.back());
  }
}

// Where all lengths are doubled, the walk is as long in time, and twice as fast.
TEST(StepTiming, ScalesWithItsArcs) {
  Generator generator(6);
  for (int trial = 0; trial < 10; ++trial) {
    const TimedSteps steps = randomSteps(generator);
    TimedSteps twice = steps;
    for (double& arc : twice.arcs) arc *= 2.0;
    for (double& length : twice.lengths) length *= 2.0;
    const StepTiming a(steps), b(twice);
    ASSERT_EQ(a.frames(), b.frames());
    for (int k = 0; k <= a.frames(); ++k) {
      EXPECT_NEAR(2.0 * a.at(k).arc, b.at(k).arc, 1e-9);
      EXPECT_NEAR(2.0 * a.at(k).speed, b.at(k).speed, 1e-9);
      EXPECT_NEAR(a.at(k).steps, b.at(k).steps, 1e-12);
    }
  }
}

// The same steps in the other order of time are the same walk backwards.
TEST(StepTiming, OfTheSameStepsBackwardsIsTheSameBackwards) {
  Generator generator(7);
  for (int trial = 0; trial < 10; ++trial) {
    const TimedSteps steps = randomSteps(generator);
    TimedSteps back = steps;
    std::reverse(back.durations.begin(), back.durations.end());
    std::reverse(back.lengths.begin(), back.lengths.end());
    for (size_t i = 0; i < back.arcs.size(); ++i)
      back.arcs[i] = steps.arcs.back() - steps.arcs[steps.arcs.size() - 1 - i];
    const StepTiming a(steps), b(back);
    ASSERT_EQ(a.frames(), b.frames());
    for (int k = 0; k <= a.frames(); ++k) {
      EXPECT_NEAR(a.at(k).arc, steps.arcs.back() - b.at(a.frames() - k).arc, 1e-6) << k;
    }
  }
}

TEST(StepTiming, WeightThatIsShiftedStandsFirstAndLast) {
  Generator generator(8);
  TimedSteps steps = randomSteps(generator);
  const StepTiming plain(steps);
  steps.start_sway = 0.6, steps.stop_sway = 0.4;
  const StepTiming swaying(steps);
  EXPECT_GT(swaying.frames(), plain.frames());
  EXPECT_LT(swaying.at(0).sway, 0.0);
  EXPECT_GT(swaying.at(swaying.frames()).sway, 0.0);
  for (int k = 0; k <= swaying.frames(); ++k) {
    const SpeedProfile::Sample at = swaying.at(k);
    if (at.sway != 0.0) {
      EXPECT_NEAR(at.arc, at.sway < 0.0 ? 0.0 : steps.arcs.back(), 1e-9);
    }
  }
}

}  // namespace
}  // namespace amble

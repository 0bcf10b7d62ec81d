#include "animation/steps/speed_profile.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/animation/random_clip.h"
#include "tests/animation/walk_paths.h"

namespace amble {
namespace {

SpeedLimits limitsOf(double speed) { return {StrideLaw(1.1, 0.57), speed, 1.1, 1.0 / 60.0}; }

/// Curves as wide as the walker can turn at 1 m/s, and straights between them.
RootPath randomPath(Generator& generator, double longest = 9.0) {
  const double length = uniform(generator, 1.5, longest), radius = uniform(generator, 1.0, 8.0);
  const double sign = uniform(generator, -1.0, 1.0) < 0.0 ? -1.0 : 1.0;
  const double bend = std::min(length, 2.0 * radius);
  RootPath path = circlePath(sign * radius, sign * bend / radius);
  const RootPath::Sample end = path.at(path.length());
  if (length > bend) path.append(straightPath(length - bend, end.heading, end.position));
  return path;
}

/// Calls `check(profile, path, limits, ends)` with many profiles that are not refused.
template <typename Check>
void forProfiles(Check check) {
  Generator generator(71);
  int profiles = 0;
  for (int i = 0; i < 300; ++i) {
    const RootPath path = randomPath(generator);
    const SpeedLimits limits = limitsOf(uniform(generator, 0.4, 2.0));
    SpeedProfileEnds ends{i % 2 == 0, i % 4 < 2, std::nullopt};
    if (i % 3 == 0) ends.parity = i % 2;
    const SpeedProfile profile(path, limits, ends);
    if (profile.refusal() != SpeedProfile::Refusal::kNone) continue;
    ++profiles;
    check(profile, path, limits, ends);
  }
  EXPECT_GT(profiles, 150);  // the generator draws paths that can be walked, most of them
}

TEST(SpeedProfile, RefusesAPathTooShortForTwoSteps) {
  const SpeedProfile point(straightPath(0.03), limitsOf(1.2), {});
  EXPECT_EQ(point.refusal(), SpeedProfile::Refusal::kStepLength);
  const SpeedProfile step(straightPath(0.5), limitsOf(1.2), {false, false, std::nullopt});
  EXPECT_EQ(step.refusal(), SpeedProfile::Refusal::kStepLength);
}

TEST(SpeedProfile, RefusesAnEmptyPath) {
  EXPECT_EQ(SpeedProfile(RootPath(), limitsOf(1.2), {}).refusal(),
            SpeedProfile::Refusal::kStepLength);
}

TEST(SpeedProfile, RefusesAWalkingStanceInACurveTooTightForItsSpeed) {
  const SpeedLimits limits = limitsOf(1.4);
  const double tightest = limits.speed / limits.max_turn_rate;
  for (const double sign : {1.0, -1.0}) {
    for (const bool from_standing : {true, false}) {
      const SpeedProfileEnds ends{from_standing, !from_standing, std::nullopt};
      const double tight = sign * 0.98 * tightest, wide = sign * 1.02 * tightest;
      EXPECT_EQ(SpeedProfile(circlePath(tight, 4.0 / tight), limits, ends).refusal(),
                SpeedProfile::Refusal::kTurnRate);
      EXPECT_EQ(SpeedProfile(circlePath(wide, 4.0 / wide), limits, ends).refusal(),
                SpeedProfile::Refusal::kNone);
    }
    const double tight = sign * 0.5 * tightest;  // standing, it may slow down
    EXPECT_EQ(SpeedProfile(circlePath(tight, 3.0 / tight), limits, {}).refusal(),
              SpeedProfile::Refusal::kNone);
  }
}

TEST(SpeedProfile, RefusesAWalkingStanceTooNearATightCurve) {
  RootPath path = straightPath(3.0);
  path.append(
      circlePath(0.4, 2.0));  // meets the line's end only in shape: curvature is what counts
  const SpeedProfile profile(path, limitsOf(1.4), {true, false, std::nullopt});
  EXPECT_EQ(profile.refusal(), SpeedProfile::Refusal::kTurnRate);
}

TEST(SpeedProfile, EndsAreExact) {
  forProfiles([](const SpeedProfile& p, const RootPath& path, const SpeedLimits& limits,
                 const SpeedProfileEnds& ends) {
    const SpeedProfile::Sample first = p.at(0), last = p.at(p.frames());
    EXPECT_EQ(first.arc, 0.0);
    EXPECT_EQ(first.steps, 0.0);
    EXPECT_EQ(last.arc, path.length());
    EXPECT_EQ(last.steps, static_cast<double>(p.steps()));
    EXPECT_GE(p.steps(), 2);
    if (ends.from_standing) {
      EXPECT_EQ(first.speed, 0.0);
    } else {
      EXPECT_NEAR(first.speed, limits.speed, 1e-9);
      EXPECT_NEAR(first.step_length, limits.law.stepLength(limits.speed), 1e-9);
    }
    if (ends.to_standing) {
      EXPECT_EQ(last.speed, 0.0);
    } else {
      EXPECT_NEAR(last.speed, limits.speed, 1e-9);
      EXPECT_NEAR(last.step_length, limits.law.stepLength(limits.speed), 1e-9);
    }
  });
}

TEST(SpeedProfile, ArcAndStepsGrowWithEveryFrame) {
  forProfiles(
      [](const SpeedProfile& p, const RootPath&, const SpeedLimits&, const SpeedProfileEnds&) {
        for (int k = 1; k <= p.frames(); ++k) {
          EXPECT_GT(p.at(k).arc, p.at(k - 1).arc);
          EXPECT_GT(p.at(k).steps, p.at(k - 1).steps);
        }
      });
}

TEST(SpeedProfile, SpeedIsTheRateOfTheArc) {
  forProfiles([](const SpeedProfile& p, const RootPath&, const SpeedLimits& limits,
                 const SpeedProfileEnds&) {
    for (int k = 1; k < p.frames(); ++k) {
      const double rate = (p.at(k + 1).arc - p.at(k - 1).arc) / (2.0 * limits.frame_time);
      EXPECT_NEAR(p.at(k).speed, rate, 0.08);  // one frame on, a start gains 6 m/s^2 at most
    }
  });
}

// People speed up by 9 m/s^2 at most in a start of a sixth of a metre: 5 mm/s in a frame so short.
TEST(SpeedProfile, SpeedDoesNotJumpWhereAStartOrAStopJoins) {
  Generator generator(73);
  int profiles = 0;
  for (int i = 0; i < 100; ++i) {
    const RootPath path = randomPath(generator, 5.0);
    SpeedLimits limits = limitsOf(uniform(generator, 0.4, 2.0));
    limits.frame_time = 1.0 / 2000.0;
    const SpeedProfile p(path, limits, {});
    if (p.refusal() != SpeedProfile::Refusal::kNone) continue;
    ++profiles;
    double jump = 0.0;
    for (int k = 1; k <= p.frames(); ++k) {
      jump = std::max(jump, std::abs(p.at(k).speed - p.at(k - 1).speed));
    }
    EXPECT_LT(jump, 0.005) << path.length() << " m at " << limits.speed << " m/s";
  }
  EXPECT_GT(profiles, 70);
}

// Captured starts and stops are as long as it says: the pelvis would jump.
TEST(SpeedProfile, TheStepThatCyclesAreWarpedToDoesNotJumpWhereAStartOrAStopJoins) {
  Generator generator(72);
  int checked = 0;
  for (int i = 0; i < 300; ++i) {
    SpeedLimits limits = limitsOf(uniform(generator, 0.4, 2.0));
    limits.law.setOnset({.start_sway = 0.5, .stop_sway = 0.3});
    const SpeedProfile profile(randomPath(generator, i % 2 == 0 ? 2.0 : 9.0), limits, {});
    if (profile.refusal() != SpeedProfile::Refusal::kNone) continue;
    ++checked;
    for (int k = 1; k <= profile.frames(); ++k) {
      const double before = profile.at(k - 1).step_length, now = profile.at(k).step_length;
      ASSERT_LT(std::abs(now - before), 0.02 * before) << i << " frame " << k;
    }
  }
  EXPECT_GT(checked, 150);
}

TEST(SpeedProfile, AWalkIsAsManyStepsAsItsParityAsks) {
  forProfiles(
      [](const SpeedProfile& p, const RootPath&, const SpeedLimits&, const SpeedProfileEnds& ends) {
        EXPECT_EQ(p.steps() % 2, ends.parity.value_or(p.steps() % 2));
      });
}

TEST(SpeedProfile, StepsLieWhereTheirArcsAre) {
  forProfiles(
      [](const SpeedProfile& p, const RootPath& path, const SpeedLimits&, const SpeedProfileEnds&) {
        EXPECT_EQ(p.arcAtStep(0), 0.0);
        EXPECT_EQ(p.arcAtStep(p.steps()), path.length());
        for (int i = 1; i < p.steps(); ++i) EXPECT_GT(p.arcAtStep(i), p.arcAtStep(i - 1));
        for (int k = 0; k < p.frames(); ++k) {
          const SpeedProfile::Sample at = p.at(k);
          const int step = static_cast<int>(std::floor(at.steps + 1e-9));
          EXPECT_GE(at.arc, p.arcAtStep(step) - 1e-6);
          EXPECT_LE(at.arc, p.arcAtStep(std::min(step + 1, p.steps())) + 1e-6);
        }
      });
}

TEST(SpeedProfile, AWholeNumberOfStepsNeedsLittleChangeOfSpeedOrTurnRate) {
  Generator generator(72);
  for (int i = 0; i < 100; ++i) {
    RootPath path = randomPath(generator);
    const RootPath::Sample end = path.at(path.length());
    path.append(straightPath(8.0, end.heading, end.position));
    const SpeedLimits limits = limitsOf(uniform(generator, 0.6, 1.8));
    const SpeedProfile p(path, limits, {});
    ASSERT_EQ(p.refusal(), SpeedProfile::Refusal::kNone);
    for (int k = 0; k <= p.frames(); ++k) {
      const SpeedProfile::Sample at = p.at(k);
      EXPECT_LT(at.speed, 1.02 * limits.speed);
      EXPECT_LT(std::abs(path.at(at.arc).curvature) * at.speed, 1.05 * limits.max_turn_rate);
    }
  }
}

TEST(SpeedProfile, StepsAreWithinWhatIsWalked) {
  forProfiles([](const SpeedProfile& p, const RootPath&, const SpeedLimits& limits,
                 const SpeedProfileEnds&) {
    for (int k = 0; k <= p.frames(); ++k) {
      const double share = p.at(k).step_length / limits.law.capturedStep();
      EXPECT_GT(share, StrideLaw::kShortestStep - 1e-9);
      EXPECT_LT(share, StrideLaw::kLongestStep + 1e-9);
    }
  });
}

TEST(SpeedProfile, AWalkSlowsInATightCurveAndNowhereElse) {
  RootPath path = straightPath(6.0);
  path.append(circlePath(0.6, 1.5));
  const double bend = path.length();
  const RootPath::Sample end = path.at(bend);
  path.append(straightPath(6.0, end.heading, end.position));
  const SpeedLimits limits = limitsOf(1.4);
  const SpeedProfile p(path, limits, {});
  ASSERT_EQ(p.refusal(), SpeedProfile::Refusal::kNone);
  double slowest = limits.speed;
  for (int k = 0; k <= p.frames(); ++k) {
    const SpeedProfile::Sample at = p.at(k);
    if (at.arc > 6.0 && at.arc < bend) slowest = std::min(slowest, at.speed);
    if (std::abs(at.arc - 3.0) < 0.2) {
      EXPECT_NEAR(at.speed, limits.speed, 0.05 * limits.speed);
    }
  }
  EXPECT_NEAR(slowest, 0.6 * limits.max_turn_rate, 0.05);
}

}  // namespace
}  // namespace amble

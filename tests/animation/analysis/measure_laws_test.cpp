// How the measures of a motion change with its size, its pace and its path: by formulas.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "animation/analysis/classify_clip.h"
#include "animation/analysis/gait_measures.h"
#include "animation/analysis/motion_measures.h"
#include "base/rotation.h"
#include "tests/animation/moved_clip.h"
#include "tests/animation/puppet.h"
#include "tests/animation/random_clip.h"

namespace amble {
namespace {

/// A body of one joint on a smooth way: three sways of different tempo, none faster than 1 Hz.
Clip swaying(double size, double pace, double rate) {
  Clip clip;
  clip.skeleton = Skeleton({Joint()});
  clip.frame_time = 1.0 / rate;
  clip.poses = PoseArray(1);
  for (int i = 0; i <= std::lround(8.0 * rate / pace); ++i) {
    const double t = pace * i / rate;
    Pose pose;
    pose.p_WR = size * Eigen::Vector3d(std::sin(2.0 * kPi * 0.5 * t), std::cos(2.0 * kPi * 0.3 * t),
                                       0.4 * std::sin(2.0 * kPi * 0.8 * t));
    pose.rotations = {expRotation({0.3 * std::sin(3.0 * t), 0.2 * std::cos(2.0 * t), 0.0})};
    clip.poses.append(pose);
  }
  return clip;
}

TEST(MeasureLaws, AccelerationAndJerkGrowWithSize) {
  for (const double rate : {30.0, 120.0}) {
    const Clip one = swaying(0.1, 1.0, rate);
    for (const double size : {0.03, 0.5, 2.0}) {
      const Clip other = swaying(size, 1.0, rate);
      EXPECT_NEAR(rootAcceleration(other), 10.0 * size * rootAcceleration(one), 1e-8);
      EXPECT_NEAR(jointJerk(other), 10.0 * size * jointJerk(one), 1e-6);
    }
  }
}

// Twice as fast: four times the acceleration, eight times the jerk. The filter and differences at
// 30 Hz take a little of what is fast.
TEST(MeasureLaws, AccelerationGrowsWithTheSquareOfPaceAndJerkWithItsCube) {
  for (const double rate : {30.0, 60.0, 120.0}) {
    const Clip one = swaying(0.1, 1.0, rate);
    for (const double pace : {0.5, 1.5, 2.0}) {
      const Clip other = swaying(0.1, pace, rate);
      EXPECT_NEAR(rootAcceleration(other) / rootAcceleration(one) / std::pow(pace, 2), 1.0, 0.03)
          << rate << ' ' << pace;
      EXPECT_NEAR(jointJerk(other) / jointJerk(one) / std::pow(pace, 3), 1.0, 0.05)
          << rate << ' ' << pace;
    }
  }
}

TEST(MeasureLaws, PopsAreARatioAndKnowNoPace) {
  for (const double rate : {30.0, 120.0}) {
    Clip clip = swaying(0.1, 3.0, rate);
    const double usual = pops(clip);
    for (const double pace : {0.8, 2.0}) {
      Clip other = clip;
      other.frame_time /= pace;
      EXPECT_NEAR(pops(other), usual, 1e-9 * usual);
    }
  }
}

TEST(MeasureLaws, BackwardsAMotionIsAsSmooth) {
  for (const double rate : {30.0, 120.0}) {
    const Clip clip = swaying(0.2, 1.0, rate);
    Clip back = clip;
    const int last = clip.frames() - 1;
    for (int i = 0; i <= last; ++i) {
      back.poses.p_WR(i) = clip.poses.p_WR(last - i);
      back.poses.rotations(i)[0] = clip.poses.rotations(last - i)[0];
    }
    EXPECT_NEAR(rootAcceleration(back), rootAcceleration(clip), 0.01 * rootAcceleration(clip));
    EXPECT_NEAR(jointJerk(back), jointJerk(clip), 0.01 * jointJerk(clip));
    EXPECT_NEAR(pops(back), pops(clip), 1e-6);
  }
}

TEST(MeasureLaws, ASteadyRideTakesNothingFromAcceleration) {
  Clip clip = swaying(0.2, 1.0, 120.0);
  const double before = rootAcceleration(clip), jerk = jointJerk(clip);
  for (int i = 0; i < clip.frames(); ++i) {
    clip.poses.p_WR(i) += i * clip.frame_time * Eigen::Vector3d(7.0, -3.0, 0.2);
  }
  EXPECT_NEAR(rootAcceleration(clip), before, 1e-6);
  EXPECT_NEAR(jointJerk(clip), jerk, 1e-4);
}

TEST(MeasureLaws, TheWorstJointIsWhoseBodyPops) {
  Generator generator(311);
  for (int round = 0; round < 10; ++round) {
    Clip clip = randomClip(generator, 6, 40);
    double worst = 0.0;
    for (int j = 0; j < 6; ++j) {
      Clip alone = clip;
      for (int i = 0; i < clip.frames(); ++i) {
        for (int k = 0; k < 6; ++k) {
          if (k != j) alone.poses.rotations(i)[k].setIdentity();
        }
      }
      worst = std::max(worst, pops(alone));
    }
    EXPECT_EQ(pops(clip), worst);
  }
}

TEST(MeasureLaws, SmoothingIsLinearAndKeepsEndsAndTheMeanOfARow) {
  Generator generator(312);
  std::vector<Eigen::Vector3d> x, y, both;
  for (int i = 0; i < 100; ++i) {
    x.push_back(randomVector(generator, 1.0));
    y.push_back(randomVector(generator, 1.0));
    both.push_back(2.0 * x.back() - y.back());
  }
  const auto sx = smoothed(x, 0.01, 0.15), sy = smoothed(y, 0.01, 0.15),
             sum = smoothed(both, 0.01, 0.15);
  for (int i = 0; i < 100; ++i) EXPECT_LT((sum[i] - 2.0 * sx[i] + sy[i]).norm(), 1e-12);
  EXPECT_LT((sx.front() - x.front()).norm(), 1e-12);
  EXPECT_LT((sx.back() - x.back()).norm(), 1e-12);
  double least = 1.0, most = -1.0;
  for (const auto& p : x) least = std::min(least, p.x()), most = std::max(most, p.x());
  for (const auto& p : sx) EXPECT_TRUE(p.x() >= least - 1e-12 && p.x() <= most + 1e-12);
}

std::vector<PlannedPoint> plannedOf(const Puppet& puppet) {
  std::vector<PlannedPoint> plan;
  for (int i = 0; i <= std::lround(puppet.duration * puppet.rate); ++i) {
    plan.push_back({puppet.pelvis(i / puppet.rate).head<2>(), puppet.heading(i / puppet.rate)});
  }
  return plan;
}

TEST(MeasureLaws, PathErrorIsTheSameWhereverPlanAndWalkAre) {
  const Puppet puppet = onACircle();
  Clip clip = puppet.clip();
  for (int i = 0; i < clip.frames(); ++i) {
    clip.poses.p_WR(i) += 0.1 * Eigen::Vector3d(std::sin(0.05 * i), std::cos(0.03 * i), 0.0);
  }
  std::vector<PlannedPoint> plan = plannedOf(puppet);
  const PathError here = pathError(clip, Puppet::roles(), plan);
  EXPECT_GT(here.mean, 0.01);
  for (const double turn : {0.4, 2.9, -1.7}) {
    std::vector<PlannedPoint> other = plan;
    for (PlannedPoint& p : other) {
      p.position = Eigen::Rotation2Dd(turn) * p.position + Eigen::Vector2d(5.0, -3.0);
      p.heading += turn;
    }
    const PathError there =
        pathError(moved(clip, aboutZ(turn), {5.0, -3.0, 1.0}), Puppet::roles(), other);
    EXPECT_NEAR(there.mean, here.mean, 1e-9);
    EXPECT_NEAR(there.largest, here.largest, 1e-9);
    EXPECT_NEAR(there.end, here.end, 1e-9);
    EXPECT_NEAR(there.end_heading, here.end_heading, 1e-9);
  }
}

// A straight plan that is `off` aside of a straight walk is missed by exactly that, everywhere.
TEST(MeasureLaws, ThePathErrorOfAStraightWalkIsHowFarItIsAside) {
  const Puppet puppet;
  for (const double off : {0.0, 0.013, -0.4}) {
    std::vector<PlannedPoint> plan = plannedOf(puppet);
    for (PlannedPoint& p : plan) {
      p.position.y() += off;
      p.heading += off;
    }
    const PathError error = pathError(puppet.clip(), Puppet::roles(), plan);
    EXPECT_NEAR(error.mean, std::abs(off), 1e-9);
    EXPECT_NEAR(error.largest, std::abs(off), 1e-9);
    EXPECT_NEAR(error.end, std::abs(off), 1e-9);
    EXPECT_NEAR(error.end_heading, std::abs(off), 1e-9);
  }
}

TEST(MeasureLaws, OneFrameAsideIsTheLargestErrorAndTheMeanOfAll) {
  const Puppet puppet;
  Clip clip = puppet.clip();
  for (int i = 200; i < 300; ++i) clip.poses.p_WR(i).y() += 0.2;
  const PathError error = pathError(clip, Puppet::roles(), plannedOf(puppet));
  EXPECT_NEAR(error.largest, 0.2, 1e-9);
  EXPECT_NEAR(error.mean, 0.2 * 100.0 / clip.frames(), 1e-3);
  EXPECT_LT(error.end, 1e-9);
}

TEST(MeasureLaws, AnEndHeadingIsMissedByAtMostHalfATurn) {
  const Puppet puppet{.duration = 1.0};
  for (const double off : {3.0, 3.5, 6.2, -4.0}) {
    std::vector<PlannedPoint> plan = plannedOf(puppet);
    for (PlannedPoint& p : plan) p.heading += off;
    EXPECT_NEAR(pathError(puppet.clip(), Puppet::roles(), plan).end_heading,
                std::abs(std::remainder(off, 2.0 * kPi)), 1e-9);
  }
}

// A drawn walker of every tempo and stance measures what it was drawn with.
TEST(MeasureLaws, WalkersOfEveryTempoMeasureWhatTheyWereDrawnWith) {
  for (const double period : {0.9, 1.1, 1.4}) {
    for (const double stance : {0.55, 0.62, 0.7}) {
      for (const double speed : {0.5, 1.2, 1.6}) {
        const Puppet puppet{.speed = speed, .period = period, .stance = stance, .duration = 8.0};
        const GaitMeasures gait = measureGait(puppet.clip(), Puppet::roles(), puppet.plants());
        EXPECT_NEAR(gait.speed, speed, 0.01 * speed);
        EXPECT_NEAR(gait.cadence, 120.0 / period, 1.0);
        EXPECT_NEAR(gait.double_support, 2.0 * stance - 1.0, 0.02);
        EXPECT_EQ(gait.flight, 0.0);
        EXPECT_LT(gait.toe_skate, 1e-9);
        for (const StepMeasure& step : gait.steps) {
          EXPECT_NEAR(step.stride, 0.5 * speed * period, 0.01);
          EXPECT_NEAR(step.width, puppet.width, 0.01);
          EXPECT_NEAR(step.duration, 0.5 * period, 0.015);
        }
      }
    }
  }
}

TEST(MeasureLaws, AWalkerOnACircleTurnsAtItsRateEitherWay) {
  for (const double rate : {-0.9, -0.3, 0.2, 0.7}) {
    Puppet puppet = onACircle();
    puppet.turn_rate = rate;
    const GaitMeasures gait = measureGait(puppet.clip(), Puppet::roles(), puppet.plants());
    EXPECT_NEAR(gait.turn_rate, rate, 1e-6);
    EXPECT_NEAR(gait.peak_turn_rate, std::abs(rate), 1e-6);
  }
}

TEST(MeasureLaws, HowMuchOfTheTimeNoFootIsDownIsWhatTheStanceLeaves) {
  for (const double stance : {0.3, 0.36, 0.42, 0.47}) {
    const Puppet runner{.speed = 3.0, .period = 0.7, .stance = stance, .duration = 7.0};
    const GaitMeasures gait = measureGait(runner.clip(), Puppet::roles(), runner.plants());
    EXPECT_NEAR(gait.flight, 1.0 - 2.0 * stance, 0.03) << stance;
    EXPECT_EQ(gait.double_support, 0.0) << stance;
  }
}

// Any row of tokens, drawn under a seed: what a classification must be, whatever it says.
TEST(MeasureLaws, AnyTokensAreClassifiedFrameByFrameInSegmentsThatDiffer) {
  Generator generator(313);
  for (int round = 0; round < 300; ++round) {
    std::vector<Support> tokens;
    const int runs = std::uniform_int_distribution<int>(1, 20)(generator);
    for (int r = 0; r < runs; ++r) {
      const Support token =
          std::array{Support::kLeft, Support::kRight, Support::kBoth,
                     Support::kNone}[std::uniform_int_distribution<int>(0, 3)(generator)];
      tokens.insert(tokens.end(), std::uniform_int_distribution<int>(1, 30)(generator), token);
    }
    const ClipClass found = classifyTokens(tokens);
    ASSERT_EQ(found.frames.size(), tokens.size());
    int next = 0;
    double sum = 0.0;
    for (const double share : found.share) sum += share;
    EXPECT_NEAR(sum, 1.0, 1e-9);
    for (size_t s = 0; s < found.segments.size(); ++s) {
      const MotionSegment& segment = found.segments[s];
      EXPECT_EQ(segment.first, next);
      if (s > 0) {
        EXPECT_NE(segment.type, found.segments[s - 1].type);
      }
      for (int i = segment.first; i <= segment.last; ++i) {
        EXPECT_EQ(found.frames[i], segment.type);
        EXPECT_NE(found.frames[i], MotionType::kOther);
      }
      next = segment.last + 1;
    }
    EXPECT_EQ(next, static_cast<int>(tokens.size()));
    EXPECT_EQ(found.type == MotionType::kOther, found.segments.size() > 1);
    for (int type = 0; type < kMotionTypes; ++type) {
      EXPECT_LE(found.share[type], found.shareOf(found.largest()));
    }
  }
}

// Every frame shown k times says the same of k times as many.
TEST(MeasureLaws, TokensThatLastLongerAreOfTheSameTypes) {
  Generator generator(314);
  for (int round = 0; round < 200; ++round) {
    std::vector<Support> tokens, longer;
    for (int r = 0; r < 12; ++r) {
      const Support token =
          std::array{Support::kLeft, Support::kRight, Support::kBoth,
                     Support::kNone}[std::uniform_int_distribution<int>(0, 3)(generator)];
      const int frames = std::uniform_int_distribution<int>(2, 30)(generator);
      tokens.insert(tokens.end(), frames, token);
      longer.insert(longer.end(), 3 * frames, token);
    }
    const ClipClass once = classifyTokens(tokens), thrice = classifyTokens(longer);
    for (size_t i = 0; i < tokens.size(); ++i) EXPECT_EQ(thrice.frames[3 * i], once.frames[i]);
  }
}

TEST(MeasureLaws, ACapturedSoleTurnsWithItsFoot) {
  Generator generator(315);
  for (int i = 0; i < 200; ++i) {
    const double heel = uniform(generator, 0.04, 0.1), flat = uniform(generator, 0.1, 0.7),
                 pitch = uniform(generator, -0.6, 0.8), heading = uniform(generator, -3.0, 3.0);
    const Eigen::Vector3d ankle = randomVector(generator, 2.0);
    const double length = uniform(generator, 0.1, 0.2);
    const auto toeAt = [&](double down) -> Eigen::Vector3d {
      return ankle +
             length * (aboutZ(heading) * Eigen::Vector3d(std::cos(down), 0.0, -std::sin(down)));
    };
    const SoleEnds ends = capturedSole(ankle, toeAt(flat + pitch), heel, flat);
    EXPECT_EQ(ends.ball, toeAt(flat + pitch));
    EXPECT_NEAR((ends.heel - ankle).norm(), heel, 1e-12);
    // Flat the heel is below the ankle; a foot that goes down by more has it behind.
    EXPECT_LT((capturedSole(ankle, toeAt(flat), heel, flat).heel - ankle +
               heel * Eigen::Vector3d::UnitZ())
                  .norm(),
              1e-12);
    const Eigen::Vector3d way = aboutZ(-heading) * (ends.heel - ankle);
    EXPECT_NEAR(way.x(), -heel * std::sin(pitch), 1e-12);
    EXPECT_NEAR(way.z(), -heel * std::cos(pitch), 1e-12);
    EXPECT_NEAR(way.y(), 0.0, 1e-12);
  }
}

TEST(MeasureLaws, AFootTurnsAsFastAsItIsTurned) {
  const Puppet puppet{.speed = 0.0, .stance = 1.0, .rate = 60.0, .duration = 1.0};
  const JointRoles roles = Puppet::roles();
  for (const Side side : {kLeft, kRight}) {
    for (const double rate : {0.5, 4.0, 20.0}) {
      Clip clip = puppet.clip();
      clip.joint_positions.clear();
      for (int i = 30; i < clip.frames(); ++i) {
        clip.poses.rotations(i)[roles.legs[side].foot] =
            expRotation({0.0, rate * (i - 29) / 60.0, 0.0});
      }
      EXPECT_NEAR(fastestFootTurn(clip, roles), rate, 1e-6);
    }
  }
}

}  // namespace
}  // namespace amble

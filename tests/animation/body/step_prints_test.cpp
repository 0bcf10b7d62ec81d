#include "animation/body/step_prints.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/rotation.h"
#include "tests/animation/random_clip.h"

namespace amble {
namespace {

constexpr double kHeel = -0.1, kBall = 0.08;  // of a foot's ends from its middle [m]

/// A foot that stands flat at a place, or hangs level over it.
SolePrint standing(const Eigen::Vector3d& at, double heading) {
  const Eigen::Vector3d ahead = aboutZ(heading) * Eigen::Vector3d::UnitX();
  return {at, {at + kHeel * ahead, at + kBall * ahead}};
}

/// A left foot's step of 0.7 m, 0.1 m beside the right one's, on a way with this heading; it rises
/// as a parabola of `height` over the line between its prints.
StepPrints stepOf(double heading, double climb, double height) {
  const auto on = [&](double x, double y, double z) {
    return standing(aboutZ(heading) * Eigen::Vector3d(x, y, z), heading);
  };
  StepPrints prints{kLeft, on(-0.7, 0.1, -climb), on(0.7, 0.1, climb), on(0, 0, 0), heading, {}};
  for (int i = 0; i <= 20; ++i) {
    const double t = i / 20.0;
    const double z = -climb + 2.0 * climb * t + 4.0 * height * t * (1.0 - t);
    prints.swing.push_back(on(-0.7 + 1.4 * t, 0.1, z).ends);
  }
  return prints;
}

TEST(StepMeasure, IsTheSameWhicheverWayTheWalkFaces) {
  for (const double heading : {0.0, 0.5, 1.57, 3.0, -2.2}) {
    const StepMeasure step = measureStep(stepOf(heading, 0.17, 0.09));
    EXPECT_NEAR(step.stride, 0.7, 1e-12);
    EXPECT_NEAR(step.width, 0.1, 1e-12);
    EXPECT_NEAR(step.climb, 0.17, 1e-12);
    EXPECT_NEAR(step.lift, 0.09, 1e-12);
    EXPECT_NEAR(step.two_steps, 1.4, 1e-12);
  }
}

TEST(StepMeasure, WidthIsPositiveForEitherFootThatKeepsToItsSide) {
  StepPrints prints = stepOf(0.4, 0.0, 0.05);
  EXPECT_GT(measureStep(prints).width, 0.0);
  prints.side = kRight;
  EXPECT_LT(measureStep(prints).width, 0.0);
}

// A toe that is lifted while the heel stays at the ground clears nothing.
TEST(StepMeasure, WhoWalksBackwardsStepsAsWide) {
  for (const double facing : {0.0, 1.0, -2.5}) {
    StepPrints prints = stepOf(facing, 0.0, 0.05);
    std::swap(prints.from, prints.to);
    prints.along = facing + kPi;
    const StepMeasure step = measureStep(prints);
    EXPECT_NEAR(step.width, 0.1, 1e-12);
    EXPECT_NEAR(step.stride, 0.7, 1e-12);
  }
}

TEST(StepMeasure, LiftIsThatOfTheSolesLowestPoint) {
  StepPrints prints = stepOf(0.0, 0.0, 0.0);
  for (SoleEnds& sole : prints.swing) sole.ball.z() += 0.2;
  EXPECT_NEAR(measureStep(prints).lift, 0.0, 1e-12);
  for (SoleEnds& sole : prints.swing) sole.heel.z() += 0.06;
  EXPECT_NEAR(measureStep(prints).lift, 0.06, 1e-12);
}

// However the frames fall on a swing's course.
TEST(StepMeasure, LiftIsTheSameBetweenFrames) {
  for (double begin = 0.0; begin < 0.2; begin += 0.03) {
    StepPrints prints = stepOf(0.0, 0.0, 0.0);
    SoleEnds sole = prints.swing.front();
    const double heel = sole.heel.z(), ball = sole.ball.z();
    prints.swing.clear();
    for (double t = begin; t < 1.0; t += 0.2) {
      const double height = 0.1 * (1.0 - 4.0 * (t - 0.5) * (t - 0.5));
      sole.heel.z() = heel + height, sole.ball.z() = ball + height;
      prints.swing.push_back(sole);
    }
    EXPECT_NEAR(measureStep(prints).lift, 0.1, 1e-12) << begin;
  }
}

TEST(StepMeasure, ASwingThatWasNotSeenHasNoLift) {
  StepPrints prints = stepOf(0.0, 0.1, 0.05);
  prints.swing.clear();
  const StepMeasure step = measureStep(prints);
  EXPECT_EQ(step.lift, 0.0);
  EXPECT_EQ(step.two_steps, 0.0);
  EXPECT_NEAR(step.stride, 0.7, 1e-12);
}

TEST(StepMeasure, FeetThatToeOutAlikeGoTheWayBetween) {
  EXPECT_NEAR(headingBetween(1.0 + 0.2, 1.0 - 0.2), 1.0, 1e-12);
  EXPECT_NEAR(wrapAngle(headingBetween(kPi - 0.1, -kPi + 0.1) - kPi), 0.0, 1e-12);
}

StepPrints randomStep(Generator& generator) {
  StepPrints prints = stepOf(uniform(generator, -3.0, 3.0), uniform(generator, -0.2, 0.2),
                             uniform(generator, 0.02, 0.2));
  for (SoleEnds& sole : prints.swing) {
    sole.heel.z() += uniform(generator, 0.0, 0.03);
    sole.ball.z() += uniform(generator, 0.0, 0.03);
  }
  return prints;
}

/// All places of a step, changed by the same rule.
template <typename Change>
StepPrints changed(StepPrints prints, const Change& change) {
  for (SolePrint* const print : {&prints.from, &prints.to, &prints.other}) {
    print->at = change(print->at);
    print->ends = {change(print->ends.heel), change(print->ends.ball)};
  }
  for (SoleEnds& sole : prints.swing) sole = {change(sole.heel), change(sole.ball)};
  return prints;
}

TEST(StepMeasure, IsTheSameWhereverItIs) {
  Generator generator(421);
  for (int i = 0; i < 50; ++i) {
    const StepPrints prints = randomStep(generator);
    const Eigen::Vector3d shift = randomVector(generator, 50.0);
    const double turn = uniform(generator, -3.0, 3.0);
    StepPrints there = changed(prints, [&](const Eigen::Vector3d& p) -> Eigen::Vector3d {
      return aboutZ(turn) * p + shift;
    });
    there.along += turn;
    const StepMeasure a = measureStep(prints), b = measureStep(there);
    EXPECT_NEAR(a.stride, b.stride, 1e-12);
    EXPECT_NEAR(a.width, b.width, 1e-12);
    EXPECT_NEAR(a.climb, b.climb, 1e-12);
    EXPECT_NEAR(a.lift, b.lift, 1e-12);
    EXPECT_NEAR(a.two_steps, b.two_steps, 1e-12);
  }
}

TEST(StepMeasure, OfTheOtherFootInAMirrorIsTheSame) {
  Generator generator(422);
  for (int i = 0; i < 50; ++i) {
    const StepPrints prints = randomStep(generator);
    StepPrints image = changed(prints, [](const Eigen::Vector3d& p) -> Eigen::Vector3d {
      return {p.x(), -p.y(), p.z()};
    });
    image.along *= -1.0;
    image.side = other(prints.side);
    const StepMeasure a = measureStep(prints), b = measureStep(image);
    EXPECT_NEAR(a.stride, b.stride, 1e-12);
    EXPECT_NEAR(a.width, b.width, 1e-12);
    EXPECT_NEAR(a.lift, b.lift, 1e-12);
  }
}

TEST(StepMeasure, EveryLengthGrowsWithTheWalker) {
  Generator generator(423);
  for (int i = 0; i < 50; ++i) {
    const StepPrints prints = randomStep(generator);
    const StepMeasure a = measureStep(prints);
    const StepMeasure b = measureStep(
        changed(prints, [](const Eigen::Vector3d& p) -> Eigen::Vector3d { return 1.7 * p; }));
    EXPECT_NEAR(b.stride, 1.7 * a.stride, 1e-12);
    EXPECT_NEAR(b.width, 1.7 * a.width, 1e-12);
    EXPECT_NEAR(b.climb, 1.7 * a.climb, 1e-12);
    EXPECT_NEAR(b.lift, 1.7 * a.lift, 1e-12);
    EXPECT_NEAR(b.two_steps, 1.7 * a.two_steps, 1e-12);
  }
}

TEST(StepMeasure, StrideAndWidthAreTheLegsOfTheWayBetweenPrints) {
  Generator generator(424);
  for (int i = 0; i < 50; ++i) {
    StepPrints prints = randomStep(generator);
    prints.along = uniform(generator, -3.0, 3.0);
    const StepMeasure step = measureStep(prints);
    EXPECT_NEAR(std::hypot(step.stride, step.width),
                (prints.to.at - prints.other.at).head<2>().norm(), 1e-12);
  }
}

TEST(StepMeasure, AHigherSwingLiftsMoreAndALowerFrameTakesNothing) {
  Generator generator(425);
  for (int i = 0; i < 50; ++i) {
    StepPrints prints = randomStep(generator);
    const double lift = measureStep(prints).lift;
    StepPrints higher = prints;
    for (SoleEnds& sole : higher.swing) sole.heel.z() += 0.05, sole.ball.z() += 0.05;
    EXPECT_NEAR(measureStep(higher).lift, lift + 0.05, 1e-12);
    prints.swing.push_back(prints.from.ends);
    EXPECT_EQ(measureStep(prints).lift, lift);
  }
}

TEST(StepMeasure, HeightOverIsOfTheLineHoweverSteepAndNoneOnIt) {
  Generator generator(426);
  for (int i = 0; i < 50; ++i) {
    const SoleEnds from{randomVector(generator, 1.0), randomVector(generator, 1.0)},
        to{randomVector(generator, 1.0), randomVector(generator, 1.0)};
    const double t = uniform(generator, 0.0, 1.0), up = uniform(generator, 0.0, 0.3);
    SoleEnds sole{from.heel + t * (to.heel - from.heel), from.ball + t * (to.ball - from.ball)};
    EXPECT_NEAR(heightOver(from, to, sole), 0.0, 1e-9);
    sole.heel.z() += up;
    sole.ball.z() += 2.0 * up;
    EXPECT_NEAR(heightOver(from, to, sole), up, 1e-9);
  }
}

TEST(StepMeasure, TheHeadingBetweenIsAsFarFromBoth) {
  for (double a = -3.0; a < 3.1; a += 0.37) {
    for (double off = -2.9; off < 3.0; off += 0.41) {
      const double between = headingBetween(a, a + off);
      EXPECT_NEAR(wrapAngle(between - a), 0.5 * off, 1e-12);
      EXPECT_NEAR(wrapAngle(a + off - between), 0.5 * off, 1e-12);
    }
  }
}

}  // namespace
}  // namespace amble

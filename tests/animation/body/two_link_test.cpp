#include "animation/body/two_link.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/rotation.h"
#include "tests/animation/random_clip.h"

namespace amble {
namespace {

struct Leg {
  TwoLink links;
  Eigen::Vector3d normal;  // about which its knee is flexed
  double a, b;             // thigh and shank [m]
};

/// A leg anywhere, its knee flexed about `normal`; the flexion axis strays from that by `stray`.
Leg randomLeg(Generator& generator, double flexion, double stray = 0.5) {
  Leg leg;
  leg.a = uniform(generator, 0.3, 0.5);
  leg.b = uniform(generator, 0.3, 0.5);
  const Eigen::Quaterniond q = randomRotation(generator);
  leg.normal = q * Eigen::Vector3d::UnitY();
  const Eigen::Vector3d thigh = q * Eigen::Vector3d(0, 0, -1);
  const Eigen::Vector3d shank = Eigen::AngleAxisd(flexion, leg.normal) * thigh;
  leg.links.hip = randomVector(generator, 5.0);
  leg.links.knee = leg.links.hip + leg.a * thigh;
  leg.links.ankle = leg.links.knee + leg.b * shank;
  leg.links.flexion_axis = 3.0 * (leg.normal + stray * randomVector(generator, 1.0));
  return leg;
}

struct Solved {
  Eigen::Vector3d knee, ankle;
};

Solved apply(const TwoLink& leg, const TwoLinkSolution& solution) {
  const Eigen::Vector3d knee = leg.hip + solution.thigh * (leg.knee - leg.hip);
  return {knee, knee + solution.shank * (leg.ankle - leg.knee)};
}

Eigen::Vector3d reachable(Generator& generator, const Leg& leg, double most = 0.9999) {
  const double least = std::abs(leg.a - leg.b);
  const double distance = least + uniform(generator, 0.01, most) * (leg.a + leg.b - least);
  return leg.links.hip + distance * (randomRotation(generator) * Eigen::Vector3d::UnitX());
}

TEST(TwoLink, ATargetOutOfReachHasNoSolution) {
  Generator generator(51);
  for (int i = 0; i < 100; ++i) {
    const Leg leg = randomLeg(generator, uniform(generator, 0.0, 2.5));
    const Eigen::Vector3d way = randomRotation(generator) * Eigen::Vector3d::UnitX();
    EXPECT_FALSE(solveTwoLink(leg.links, leg.links.hip + (leg.a + leg.b + 1e-9) * way));
    const double nearest = std::abs(leg.a - leg.b) - 1e-9;
    if (nearest <= 0.0) continue;
    EXPECT_FALSE(solveTwoLink(leg.links, leg.links.hip + nearest * way));
  }
}

TEST(TwoLink, ATargetThatIsNoNumberHasNoSolution) {
  Generator generator(52);
  const Leg leg = randomLeg(generator, 1.0);
  EXPECT_FALSE(solveTwoLink(leg.links, Eigen::Vector3d(NAN, 0, 0)));
}

TEST(TwoLink, TheAnkleReachesTheTargetAndLinksKeepTheirLengths) {
  Generator generator(53);
  for (int i = 0; i < 2000; ++i) {
    const Leg leg = randomLeg(generator, uniform(generator, 0.0, 2.8));
    const Eigen::Vector3d target = reachable(generator, leg);
    const auto solution = solveTwoLink(leg.links, target);
    ASSERT_TRUE(solution);
    const Solved solved = apply(leg.links, *solution);
    EXPECT_LT((solved.ankle - target).norm(), 1e-12);
    EXPECT_NEAR((solved.knee - leg.links.hip).norm(), leg.a, 1e-13);
    EXPECT_NEAR((solved.ankle - solved.knee).norm(), leg.b, 1e-13);
  }
}

TEST(TwoLink, TheKneeFlexesForwardByTheAngleThatIsGivenBack) {
  Generator generator(54);
  for (int i = 0; i < 2000; ++i) {
    const Leg leg = randomLeg(generator, uniform(generator, 0.0, 2.8));
    const auto solution = solveTwoLink(leg.links, reachable(generator, leg));
    ASSERT_TRUE(solution);
    const Solved solved = apply(leg.links, *solution);
    const Eigen::Vector3d thigh = (solved.knee - leg.links.hip) / leg.a;
    const Eigen::Vector3d shank = (solved.ankle - solved.knee) / leg.b;
    const double angle = std::atan2(thigh.cross(shank).norm(), thigh.dot(shank));
    EXPECT_NEAR(angle, solution->knee_flexion, 1e-7);
    // In the thigh's own frame the shank turns to the side that the axis says.
    EXPECT_GE(thigh.cross(shank).dot(solution->thigh * leg.links.flexion_axis), -1e-9);
  }
}

TEST(TwoLink, TheKneeStaysInThePlaneWhereTheTargetIsInIt) {
  Generator generator(55);
  for (int i = 0; i < 500; ++i) {
    const Leg leg = randomLeg(generator, uniform(generator, 0.3, 2.5));
    const double distance = uniform(generator, 0.5, 0.99) * (leg.a + leg.b);
    const Eigen::Vector3d way = (leg.links.ankle - leg.links.hip).normalized();
    const Eigen::Vector3d turned =
        Eigen::AngleAxisd(uniform(generator, -1.0, 1.0), leg.normal) * way;
    const auto solution = solveTwoLink(leg.links, leg.links.hip + distance * turned);
    ASSERT_TRUE(solution);
    const Eigen::Vector3d knee = apply(leg.links, *solution).knee - leg.links.hip;
    EXPECT_NEAR(knee.dot(leg.normal), 0.0, 1e-7);
  }
}

TEST(TwoLink, TheLegDoesNotTurnAboutTheLineToItsTarget) {
  Generator generator(59);
  for (int i = 0; i < 500; ++i) {
    const Leg leg = randomLeg(generator, uniform(generator, 0.0, 2.5));
    const Eigen::Vector3d target = reachable(generator, leg);
    const auto solution = solveTwoLink(leg.links, target);
    ASSERT_TRUE(solution);
    const Eigen::Vector3d way = (target - leg.links.hip).normalized();
    EXPECT_NEAR(logRotation(solution->thigh).dot(way), 0.0, 1e-9);
  }
}

TEST(TwoLink, ATargetAtTheAnkleChangesNothing) {
  Generator generator(56);
  for (int i = 0; i < 500; ++i) {
    const Leg leg = randomLeg(generator, uniform(generator, 0.2, 2.5));
    const auto solution = solveTwoLink(leg.links, leg.links.ankle);
    ASSERT_TRUE(solution);
    EXPECT_NEAR(solution->thigh.angularDistance(Eigen::Quaterniond::Identity()), 0.0, 1e-7);
    EXPECT_NEAR(solution->shank.angularDistance(Eigen::Quaterniond::Identity()), 0.0, 1e-7);
  }
}

TEST(TwoLink, TheKneeMovesLittleWhenTheTargetDoes) {
  Generator generator(57);
  constexpr double kStep = 1e-5;
  for (int i = 0; i < 1000; ++i) {
    const Leg leg = randomLeg(generator, uniform(generator, 0.0, 1.5));
    // Targets around the ankle's own direction, as from frame to frame; not at full stretch, where
    // the knee moves as a square root.
    const Eigen::Vector3d way = (leg.links.ankle - leg.links.hip).normalized();
    const double distance = uniform(generator, 0.6, 0.97) * (leg.a + leg.b);
    const Eigen::Vector3d target =
        leg.links.hip + distance * (way + 0.3 * randomVector(generator, 1.0)).normalized();
    const auto one = solveTwoLink(leg.links, target);
    const auto two = solveTwoLink(leg.links, target + randomVector(generator, kStep));
    ASSERT_TRUE(one && two);
    const double moved = (apply(leg.links, *one).knee - apply(leg.links, *two).knee).norm();
    EXPECT_LT(moved, 10.0 * kStep);
  }
}

TEST(TwoLink, TheKneeMovesLittleAsAStraightPoseBends) {
  Generator generator(58);
  for (int i = 0; i < 50; ++i) {
    // The same leg, captured with its knee flexed from 0 to 15 degrees, about an axis that strays.
    const Generator same = generator;
    Eigen::Vector3d before;
    for (int k = 0; k <= 300; ++k) {
      Generator copy = same;
      const Leg leg = randomLeg(copy, 0.05 * k * kDegree);
      const Eigen::Vector3d thigh = (leg.links.knee - leg.links.hip) / leg.a;
      const auto solution = solveTwoLink(leg.links, leg.links.hip + 0.75 * (leg.a + leg.b) * thigh);
      ASSERT_TRUE(solution);
      const Eigen::Vector3d knee = apply(leg.links, *solution).knee;
      EXPECT_LT(k > 0 ? (knee - before).norm() : 0.0, 0.01);  // 0.05 degrees a step
      before = knee;
    }
    randomLeg(generator, 0.0);
  }
}

// Captured legs that are nearly straight are bent any way, by noise: sideways and backwards.
TEST(TwoLink, TheKneeMovesLittleAsANearlyStraightPosesKneePointsAnyWay) {
  constexpr double kThigh = 0.45;  // and shank [m]
  TwoLink leg;
  leg.hip = {0, 0, 1};
  leg.knee = {0, 0, 1 - kThigh};
  leg.flexion_axis = {0, 1, 0};
  for (const double flexion : {0.5, 2.0, 6.0}) {
    Eigen::Vector3d before;
    for (int k = 0; k <= 720; ++k) {
      const Eigen::Vector3d normal = aboutZ(0.5 * k * kDegree) * leg.flexion_axis;
      leg.ankle = leg.knee + kThigh * (Eigen::AngleAxisd(flexion * kDegree, normal) *
                                       Eigen::Vector3d(0, 0, -1));
      const auto solution = solveTwoLink(leg, {0, 0, 1 - 1.94 * kThigh});
      ASSERT_TRUE(solution);
      const Eigen::Vector3d knee = apply(leg, *solution).knee;
      EXPECT_LT(k > 0 ? (knee - before).norm() : 0.0, 0.002) << flexion << " " << 0.5 * k;
      EXPECT_GT(knee.x(), 0.03) << flexion << " " << 0.5 * k;  // of 0.11: forward
      before = knee;
    }
  }
}

TEST(TwoLink, AStraightLegBendsAboutTheFlexionAxis) {
  TwoLink leg;
  leg.hip = {0, 0, 1};
  leg.knee = {0, 0, 0.5};
  leg.ankle = {0, 0, 0};
  leg.flexion_axis = {0, 2, 0};  // faces +x, left is +y: the knee goes forward
  const auto solution = solveTwoLink(leg, {0, 0, 0.3});
  ASSERT_TRUE(solution);
  const Solved solved = apply(leg, *solution);
  EXPECT_NEAR(solved.knee.x(), std::sqrt(0.25 - 0.35 * 0.35), 1e-12);
  EXPECT_NEAR(solved.knee.y(), 0.0, 1e-12);
}

TEST(TwoLink, ALegStretchedToItsFullLengthIsStraight) {
  TwoLink leg;
  leg.hip = {0, 0, 1};
  leg.knee = {0.3, 0, 0.6};
  leg.ankle = {0, 0, 0.2};
  leg.flexion_axis = {0, 1, 0};
  const auto solution = solveTwoLink(leg, {0, 0, 0});
  ASSERT_TRUE(solution);
  EXPECT_NEAR(solution->knee_flexion, 0.0, 1e-7);
  EXPECT_LT(apply(leg, *solution).ankle.norm(), 1e-7);
}

TEST(TwoLink, TheHipItselfIsNoTargetEvenOfEqualLinks) {
  TwoLink leg;
  leg.hip = {0, 0, 1};
  leg.knee = {0.3, 0, 0.6};
  leg.ankle = {0, 0, 0.2};
  leg.flexion_axis = {0, 1, 0};
  EXPECT_FALSE(solveTwoLink(leg, leg.hip));
}

// What the header says, step by step, with the flexion found by bisection: the knee flexes in the
// leg's plane until the ankle is as far as the target, then the leg turns on the shortest way.
TEST(TwoLink, TheKneeIsWhereFlexingAndThenTurningOnTheShortestWayBringIt) {
  Generator generator(60);
  for (int i = 0; i < 300; ++i) {
    const Leg leg = randomLeg(generator, uniform(generator, 0.4, 2.5), 0.0);
    const Eigen::Vector3d target = reachable(generator, leg), reach = target - leg.links.hip;
    const auto solution = solveTwoLink(leg.links, target);
    ASSERT_TRUE(solution);
    const Eigen::Vector3d thigh = leg.links.knee - leg.links.hip;
    const auto flexed = [&](double angle) -> Eigen::Vector3d {
      return thigh + leg.b / leg.a * (Eigen::AngleAxisd(angle, leg.normal) * thigh);
    };
    double straight = 0.0, folded = kPi;
    for (int k = 0; k < 60; ++k) {
      const double middle = 0.5 * (straight + folded);
      (flexed(middle).norm() > reach.norm() ? straight : folded) = middle;
    }
    EXPECT_NEAR(solution->knee_flexion, straight, 1e-7);
    const Eigen::Quaterniond shortest = turnBetween(flexed(straight), reach);
    const Eigen::Vector3d knee = leg.links.hip + shortest * thigh;
    EXPECT_LT((apply(leg.links, *solution).knee - knee).norm(), 1e-6);
  }
}

TEST(TwoLink, TurnedMovedAndEnlargedALegIsSolvedTheSame) {
  Generator generator(61);
  for (int i = 0; i < 300; ++i) {
    const Leg leg = randomLeg(generator, uniform(generator, 0.0, 2.5));
    const Eigen::Vector3d target = reachable(generator, leg);
    const Eigen::Quaterniond turn = randomRotation(generator);
    const Eigen::Vector3d shift = randomVector(generator, 3.0);
    const double scale = uniform(generator, 0.3, 3.0);
    const auto there = [&](const Eigen::Vector3d& p) -> Eigen::Vector3d {
      return scale * (turn * p) + shift;
    };
    const auto one = solveTwoLink(leg.links, target);
    const auto two = solveTwoLink({there(leg.links.hip), there(leg.links.knee),
                                   there(leg.links.ankle), turn * leg.links.flexion_axis},
                                  there(target));
    ASSERT_TRUE(one && two);
    EXPECT_NEAR(one->knee_flexion, two->knee_flexion, 1e-6);
    EXPECT_LT(two->thigh.angularDistance(turn * one->thigh * turn.conjugate()), 1e-6);
    EXPECT_LT(two->shank.angularDistance(turn * one->shank * turn.conjugate()), 1e-6);
  }
}

TEST(TwoLink, FlexionIsByTheLawOfCosinesAndFallsWithDistance) {
  Generator generator(62);
  for (int i = 0; i < 200; ++i) {
    const Leg leg = randomLeg(generator, 1.0);
    const Eigen::Vector3d way = randomRotation(generator) * Eigen::Vector3d::UnitX();
    double before = kPi + 1e-9;
    for (double share = 0.05; share < 1.0; share += 0.05) {
      const double least = std::abs(leg.a - leg.b);
      const double d = least + share * (leg.a + leg.b - least);
      const auto solution = solveTwoLink(leg.links, leg.links.hip + d * way);
      ASSERT_TRUE(solution);
      const double cosine = (d * d - leg.a * leg.a - leg.b * leg.b) / (2.0 * leg.a * leg.b);
      EXPECT_NEAR(solution->knee_flexion, std::acos(std::clamp(cosine, -1.0, 1.0)), 1e-7);
      EXPECT_LT(solution->knee_flexion, before);
      before = solution->knee_flexion;
    }
  }
}

TEST(TwoLink, TheFlexionAxisCountsByItsDirectionAlone) {
  Generator generator(63);
  for (int i = 0; i < 200; ++i) {
    Leg leg = randomLeg(generator, uniform(generator, 0.0, 1.5));
    const Eigen::Vector3d target = reachable(generator, leg);
    const auto one = solveTwoLink(leg.links, target);
    leg.links.flexion_axis *= 0.01;
    const auto two = solveTwoLink(leg.links, target);
    ASSERT_TRUE(one && two);
    EXPECT_LT(one->thigh.angularDistance(two->thigh), 1e-7);
    EXPECT_LT(one->shank.angularDistance(two->shank), 1e-7);
  }
}

}  // namespace
}  // namespace amble

#include "animation/steps/foot_state.h"

#include <gtest/gtest.h>

#include "animation/ground/slope_ground.h"
#include "animation/steps/foot_blend.h"
#include "base/rotation.h"
#include "tests/animation/default_library.h"
#include "tests/animation/random_clip.h"

namespace amble {
namespace {

FootPlace onPlane(const Eigen::Vector2d& at, const Eigen::Vector2d& gradient, double height = 0.0) {
  FootPlace place;
  place.position << at, height + gradient.dot(at);
  place.normal = Eigen::Vector3d(-gradient.x(), -gradient.y(), 1.0).normalized();
  return place;
}

Eigen::Vector2d random2(Generator& generator, double size) {
  return randomVector(generator, size).head<2>();
}

TEST(TiltAlong, IsTheRiseOfThePlanePerMetre) {
  Generator generator(1);
  for (int trial = 0; trial < 50; ++trial) {
    const Eigen::Vector2d gradient = random2(generator, 0.6), way = random2(generator, 1.0);
    const FootPlace place = onPlane(random2(generator, 3.0), gradient);
    EXPECT_NEAR(tiltAlong(place, way), gradient.dot(way), 1e-12);
    EXPECT_NEAR(tiltAlong(place, -way), -gradient.dot(way), 1e-12);
  }
}

// A slope is no step, however steep and whichever way it is walked.
TEST(StepHeight, OnOnePlaneIsNone) {
  Generator generator(2);
  for (int trial = 0; trial < 50; ++trial) {
    const Eigen::Vector2d gradient = random2(generator, 0.6);
    const FootPlace a = onPlane(random2(generator, 2.0), gradient, 0.4);
    const FootPlace b = onPlane(random2(generator, 2.0), gradient, 0.4);
    EXPECT_NEAR(stepHeight(a, b), 0.0, 1e-12);
  }
}

TEST(StepHeight, BetweenParallelPlanesIsTheirDistanceUpright) {
  Generator generator(3);
  for (int trial = 0; trial < 50; ++trial) {
    const Eigen::Vector2d gradient = random2(generator, 0.5);
    const double up = uniform(generator, -0.3, 0.3);
    const FootPlace a = onPlane(random2(generator, 2.0), gradient);
    const FootPlace b = onPlane(random2(generator, 2.0), gradient, up);
    EXPECT_NEAR(stepHeight(a, b), up, 1e-12);
  }
}

TEST(StepHeight, TheOtherWayIsItsNegative) {
  Generator generator(4);
  for (int trial = 0; trial < 50; ++trial) {
    const FootPlace a = onPlane(random2(generator, 2.0), random2(generator, 0.5));
    const FootPlace b = onPlane(random2(generator, 2.0), random2(generator, 0.5), 0.2);
    EXPECT_NEAR(stepHeight(a, b), -stepHeight(b, a), 1e-12);
  }
}

TEST(StepHeight, DoesNotKnowWhereTheWorldIsAndWhichWayItFaces) {
  Generator generator(5);
  for (int trial = 0; trial < 50; ++trial) {
    FootPlace a = onPlane(random2(generator, 2.0), random2(generator, 0.5));
    FootPlace b = onPlane(random2(generator, 2.0), random2(generator, 0.5), 0.2);
    const double before = stepHeight(a, b);
    const Eigen::Quaterniond turn = aboutZ(uniform(generator, -kPi, kPi));
    const Eigen::Vector3d by = randomVector(generator, 10.0);
    for (FootPlace* place : {&a, &b}) {
      place->position = turn * place->position + by;
      place->normal = turn * place->normal;
    }
    EXPECT_NEAR(stepHeight(a, b), before, 1e-9);
  }
}

const std::vector<const FootCycle*>& libraryFeet() {
  static const std::vector<const FootCycle*> kFeet = [] {
    std::vector<const FootCycle*> feet;
    for (const Motion& motion : defaultLibrary().motions) {
      if (motion.kind != MotionKind::kWalk) continue;
      for (const FootCycle& foot : motion.cycle.feet) feet.push_back(&foot);
    }
    return feet;
  }();
  return kFeet;
}

TEST(FootBlend, OfOneCycleIsThatCycleToTheBit) {
  for (const FootCycle* foot : libraryFeet()) {
    const FootBlend blend(*foot);
    for (double tau = 0.0; tau <= 1.0; tau += 0.125) {
      EXPECT_EQ(blend.progress(tau), swingProgress(*foot, tau));
      EXPECT_EQ(blend.pitch(2.0 * tau), footPitch(*foot, 2.0 * tau));
      EXPECT_EQ(blend.polynomial(&FootCycle::height, tau), swingPolynomial(foot->height, tau));
    }
  }
}

// Blending what cycles do is blending the cycles: meanFoot averages their numbers.
TEST(FootBlend, AsOneCycleDoesTheSame) {
  Generator generator(6);
  const std::vector<const FootCycle*>& feet = libraryFeet();
  FootCycle own;
  for (size_t i = 0; i + 2 < feet.size(); ++i) {
    FootBlend blend;
    const double share = uniform(generator, 0.0, 0.5);
    blend.add(*feet[i], share), blend.add(*feet[i + 1], 0.3), blend.add(*feet[i + 2], 0.7 - share);
    const FootBlend one = blend.asOne(own);
    for (double tau = 0.0; tau <= 1.0; tau += 0.03) {
      EXPECT_NEAR(one.progress(tau), blend.progress(tau), 1e-15);
      EXPECT_NEAR(one.pitch(2.0 * tau), blend.pitch(2.0 * tau), 1e-14);
      EXPECT_NEAR(one.toeRoll(2.0 * tau), blend.toeRoll(2.0 * tau), 1e-15);
      for (const auto terms :
           {&FootCycle::height, &FootCycle::sideways, &FootCycle::roll, &FootCycle::yaw}) {
        double size = 0.0;
        for (const FootCycle* of : {feet[i], feet[i + 1], feet[i + 2]})
          for (const double term : of->*terms) size += std::abs(term);
        EXPECT_NEAR(one.polynomial(terms, tau), blend.polynomial(terms, tau), 1e-15 * size);
      }
    }
  }
  const FootBlend single(*feet[0]);  // is itself
  EXPECT_EQ(single.asOne(own).pitch(0.3), footPitch(*feet[0], 0.3));
}

TEST(FootBlend, OfThreeAlikeSharesIsTheirMeanFoot) {
  const auto& feet = libraryFeet();
  ASSERT_GE(feet.size(), 3u);
  for (size_t i = 0; i + 2 < feet.size(); ++i) {
    FootBlend blend;
    for (int k = 0; k < 3; ++k) blend.add(*feet[i + k], 1.0 / 3.0);
    const FootCycle mean = meanFoot({*feet[i], *feet[i + 1], *feet[i + 2]});
    for (double tau = 0.0; tau <= 1.0; tau += 0.125) {
      EXPECT_NEAR(blend.progress(tau), swingProgress(mean, tau), 1e-12);
      EXPECT_NEAR(blend.pitch(2.0 * tau), footPitch(mean, 2.0 * tau), 1e-12);
      EXPECT_NEAR(blend.polynomial(&FootCycle::yaw, tau), swingPolynomial(mean.yaw, tau), 1e-12);
    }
  }
}

TEST(FootBlend, DoesNotCareInWhichOrderItsPartsWereAdded) {
  const auto& feet = libraryFeet();
  FootBlend one, two;
  one.add(*feet[0], 0.3), one.add(*feet[1], 0.7);
  two.add(*feet[1], 0.7), two.add(*feet[0], 0.3);
  for (double tau = 0.0; tau <= 1.0; tau += 0.125) {
    EXPECT_NEAR(one.progress(tau), two.progress(tau), 1e-15);
    EXPECT_NEAR(one.pitch(2.0 * tau), two.pitch(2.0 * tau), 1e-15);
  }
}

}  // namespace
}  // namespace amble

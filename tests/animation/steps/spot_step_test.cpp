#include "animation/steps/spot_step.h"

#include <gtest/gtest.h>

#include <cmath>

#include "animation/library/foot_cycle.h"

namespace amble {
namespace {

TEST(SpotStep, AFootIsLiftedOnceAndAsHighAsItSays) {
  for (const double scale : {0.8, 1.0, 1.2}) {
    const FootCycle step = spotStep(scale);
    EXPECT_NEAR(swingPolynomial(step.height, 0.5), SpotStep::kLift * scale, 1e-12);
    for (double tau = 0.01; tau < 1.0; tau += 0.01) {
      const double rise =
          swingPolynomial(step.height, tau) - swingPolynomial(step.height, tau - 0.01);
      EXPECT_EQ(rise > 0.0, tau < 0.505) << tau;
    }
  }
}

// Of a leg that stands nearly straight the knee bends by the root of what its foot is lifted: that
// has to begin and to end with no speed.
TEST(SpotStep, AStraightLegsKneeBeginsAndEndsToBendWithoutAJerk) {
  const FootCycle step = spotStep(1.0);
  const auto bend = [&](double tau) {
    return std::sqrt(swingPolynomial(step.height, tau) / SpotStep::kLift);
  };
  constexpr double kShort = 0.01;  // of the swing
  EXPECT_LT(bend(kShort) / kShort, 0.2);
  EXPECT_LT(bend(1.0 - kShort) / kShort, 0.2);
  for (double tau = kShort; tau < 1.0 - kShort; tau += kShort)
    EXPECT_LT(std::abs(bend(tau + kShort) - bend(tau)) / kShort, 3.2);  // 4 where it begins at once
}

}  // namespace
}  // namespace amble

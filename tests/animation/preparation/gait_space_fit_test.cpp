#include "animation/preparation/gait_space_fit.h"

#include <gtest/gtest.h>

#include "tests/animation/drawn_engine.h"

namespace amble {
namespace {

TEST(GaitSpaceFit, MotionsOnALineOverSpeedNeedOneComponentAndComeBack) {
  const DrawnEngine drawn;
  const GaitSpace space = drawn.space({0.8, 1.0, 1.5});
  ASSERT_EQ(space.components.size(), 1u);
  EXPECT_NEAR(space.variance(), 1.0, 1e-9);
  EXPECT_NEAR(space.components[0].direction.norm(), 1.0, 1e-9);
  EXPECT_GT(space.components[0].coefficient.slope, 0.0);
  for (const double speed : {0.6, 1.2, 1.5}) {
    const Eigen::MatrixXd expected = drawn.cycle(0, speed).channels;
    const Eigen::MatrixXd vector = motionVectorAt(space, speed);
    EXPECT_LT((vector - expected.bottomRows(vector.rows())).cwiseAbs().maxCoeff(), 1e-9);
    EXPECT_NEAR(space.support[0].at(speed), DrawnEngine::support(speed), 1e-9);
  }
  EXPECT_NEAR(space.law.law.factor, DrawnEngine::kFactor, 1e-9);
  EXPECT_NEAR(space.law.law.power, DrawnEngine::kPower, 1e-9);
}

TEST(GaitSpaceFit, SpeedsThatAreNearEachOtherGiveTheirMeanAndNoLines) {
  const DrawnEngine drawn;
  const GaitSpace space = drawn.space({1.0, 1.05, 1.1});
  EXPECT_TRUE(space.components.empty());
  EXPECT_EQ(space.support[0].slope, 0.0);
  EXPECT_NEAR(space.support[0].at_zero, DrawnEngine::support(1.05), 1e-9);
  EXPECT_FALSE(space.law.own_power);
}

}  // namespace
}  // namespace amble

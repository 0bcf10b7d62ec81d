#include "scenarios/foot_measures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "animation/library/motion_library_reader.h"
#include "animation/synthesis/walk_synthesizer.h"

namespace amble {
namespace {

constexpr int kFrames = 21;

/// Somebody who stands for kFrames, and can be pushed about.
class SoleTracksTest : public testing::Test {
 protected:
  SoleTracksTest()
      : library_(openMotionLibrary("default")),
        synthesizer_(library_, ground_, {}),
        body_(makeBody(synthesizer_.skeleton(), synthesizer_.roles(), synthesizer_.stature(),
                       soleHeights(synthesizer_.feet()))) {
    AnimationBuffer one;
    synthesizer_.stand({}, one);
    poses_ = PoseArray(one.poses.joints());
    for (int i = 0; i < kFrames; ++i) poses_.append(one.poses[0]);
  }
  SoleTracks tracks() const { return {synthesizer_.skeleton(), body_, poses_, ground_}; }

  FlatGround ground_;
  MotionLibrary library_;
  WalkSynthesizer synthesizer_;
  Body body_;
  PoseArray poses_;
};

TEST_F(SoleTracksTest, FeetThatStandDoNotSlideAndDoNotSink) {
  for (const Side side : {kLeft, kRight}) {
    EXPECT_NEAR(tracks().slide(side, 0, kFrames - 1), 0.0, 1e-12);
    EXPECT_NEAR(tracks().height(side, 0), 0.0, 0.001);
    EXPECT_NEAR(tracks().ends(side, 0).ball.z(), 0.0, 0.001);
  }
  EXPECT_LT(tracks().penetration(), 0.001);
}

// Frame i is i mm to the side: the median is the middle frame's, and both ends are ten frames from
// it.
TEST_F(SoleTracksTest, ASlideIsTheLargestDistanceFromTheMedianPlace) {
  for (int i = 0; i < kFrames; ++i) poses_.p_WR(i).y() += 0.001 * i;
  EXPECT_NEAR(tracks().slide(kLeft, 0, kFrames - 1), 0.010, 1e-9);
  EXPECT_NEAR(tracks().slide(kRight, 0, 10), 0.005, 1e-9);
}

TEST_F(SoleTracksTest, AFootInTheAirDoesNotSlide) {
  for (int i = 0; i < kFrames; ++i) poses_.p_WR(i) += Eigen::Vector3d(0, 0.001 * i, 0.05);
  EXPECT_EQ(tracks().slide(kLeft, 0, kFrames - 1), 0.0);
}

TEST_F(SoleTracksTest, PenetrationIsTheDeepestFrame) {
  poses_.p_WR(7).z() -= 0.03;
  EXPECT_NEAR(tracks().penetration(), 0.03, 0.001);
}

TEST_F(SoleTracksTest, WhereThereIsNoGroundNothingIsMeasured) {
  class Nowhere : public Ground {
   public:
    std::optional<SurfacePoint> surface(double, double, double, double) const override {
      return {};
    }
  };
  const SoleTracks soles(synthesizer_.skeleton(), body_, poses_, Nowhere());
  EXPECT_EQ(soles.slide(kLeft, 0, kFrames - 1), 0.0);
  EXPECT_EQ(soles.penetration(), 0.0);
  EXPECT_EQ(soles.height(kLeft, 0), std::numeric_limits<double>::infinity());
}

// Footprints by hand: each 0.6 m before the other, the right 0.1 m higher.
TEST_F(SoleTracksTest, StridesAreMeasuredAlongTheFootsHeading) {
  AnimationBuffer walk;
  walk.poses = poses_;
  const double heading = 0.5;
  const Eigen::Vector3d ahead(std::cos(heading), std::sin(heading), 0.0);
  const Eigen::Vector3d aside(-ahead.y(), ahead.x(), 0.0);
  const Eigen::Vector3d left = 0.1 * aside, right = -0.1 * aside + Eigen::Vector3d(0, 0, 0.1);
  walk.footprints = {{kLeft, left, heading, 0, 5, {}},
                     {kRight, right, heading, 0, 8, {}},
                     {kLeft, left + 0.6 * ahead, heading, 8, 14, {}},
                     {kRight, right + 1.2 * ahead, heading, 12, 20, {}}};
  const std::vector<StepMeasure> steps = measureSteps(walk, tracks());
  ASSERT_EQ(steps.size(), 4u);
  EXPECT_EQ(steps[0].stride, 0.0);
  EXPECT_EQ(steps[1].stride, 0.0);
  EXPECT_NEAR(steps[2].stride, 0.6, 1e-12);
  EXPECT_NEAR(steps[3].stride, 0.6, 1e-12);
  EXPECT_NEAR(steps[2].climb, -0.1, 1e-12);
  EXPECT_NEAR(steps[3].climb, 0.1, 1e-12);
  EXPECT_NEAR(steps[3].strike, 12 * walk.frame_time, 1e-12);
  EXPECT_NEAR(steps[3].lift_off, 20 * walk.frame_time, 1e-12);
}

}  // namespace
}  // namespace amble

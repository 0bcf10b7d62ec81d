#include "animation/steps/swing_path.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "animation/ground/slope_ground.h"
#include "animation/ground/stair_ground.h"
#include "animation/library/motion_library_reader.h"
#include "animation/preparation/foot_cycle_fit.h"
#include "animation/synthesis/foot_controller.h"
#include "animation/synthesis/gait_blend.h"
#include "base/rotation.h"
#include "base/sample_stream.h"

namespace amble {
namespace {

/// The default library's left foot.
struct Character {
  MotionLibrary library = openMotionLibrary("default");
  std::array<FootShape, 2> feet = library.feet();
  GaitBlend blend{library, 1.0};
  const FootCycle& cycle = blend.foot(kLeft);
  const FootShape& foot = feet[kLeft];
};

const Character& character() {
  static const Character kCharacter;
  return kCharacter;
}

FootPlace placeAt(double x, double z = 0.0) {
  FootPlace place;
  place.position = {x, 0.0, z};
  return place;
}

/// A beam across the way, which nobody can stand on.
class BeamGround : public FlatGround {
 public:
  BeamGround(double from, double to, double height) : from_(from), to_(to), height_(height) {}
  double crest(const Eigen::Vector2d& a, const Eigen::Vector2d& b, double half_width, double low,
               double high) const override {
    const bool over = std::min(a.x(), b.x()) <= to_ && std::max(a.x(), b.x()) >= from_;
    if (over && height_ >= low && height_ <= high) return height_;
    return FlatGround::crest(a, b, half_width, low, high);
  }

 private:
  double from_, to_, height_;
};

constexpr double kHighest = 0.25;  // lift that is tried [m]

bool clears(const Ground& ground, const FootPlace& from, const FootPlace& to, SwingShape& shape) {
  const Character& c = character();
  return SwingClearance(ground, c.feet, kHighest).clear(from, to, kLeft, c.cycle, shape);
}

/// Least height of heel's end, toes' end and what lies between over what `top` gives at x.
template <typename Top>
double leastClearance(const FootPlace& from, const FootPlace& to, const SwingShape& shape,
                      Top top) {
  const Character& c = character();
  double least = std::numeric_limits<double>::infinity();
  for (int i = 1; i < 400; ++i) {
    const double tau = i / 400.0, along = swingAlong(shape, c.cycle, tau);
    const Eigen::Vector3d sole = from.position + along * (to.position - from.position);
    const double height = sole.z() + swingHeight(shape, c.cycle, tau);
    const double back = c.foot.heel_x - c.foot.radius, front = c.foot.tip_x + c.foot.radius;
    for (double x = back; x <= front; x += 0.002) {
      least = std::min(least, height - top(sole.x() + x));
    }
  }
  return least;
}

bool unchanged(const SwingShape& shape) {
  return shape.lift == 1.0 && shape.extra == 0.0 && shape.delay == 0.0 && shape.early == 0.0;
}

TEST(SwingPath, TheCapturedSwingIsKeptWhereNothingLiesInTheWay) {
  SwingShape shape;
  EXPECT_TRUE(clears(FlatGround(), placeAt(0.0), placeAt(1.3), shape));
  EXPECT_TRUE(unchanged(shape));
  for (const double degrees : {-20.0, 8.0, 20.0}) {
    const SlopeGround slope(degrees * kDegree);
    FootPlace from = placeAt(0.0), to = placeAt(1.2, std::tan(degrees * kDegree) * 1.2);
    from.normal = to.normal = slope.surface(0, 0, 0, 1)->normal;
    EXPECT_TRUE(clears(slope, from, to, shape));
    EXPECT_TRUE(unchanged(shape)) << degrees;
  }
}

TEST(SwingPath, WithoutAnEditItIsTheCapturedOne) {
  const Character& c = character();
  for (double tau = 0.0; tau <= 1.0; tau += 0.05) {
    EXPECT_EQ(swingAlong({}, c.cycle, tau), swingProgress(c.cycle, tau));
    EXPECT_EQ(swingHeight({}, c.cycle, tau), swingPolynomial(c.cycle.height, tau));
  }
}

TEST(SwingPath, TheLiftThatIsAskedForIsTheLiftThatComes) {
  const Character& c = character();
  FootState swing;
  swing.to = placeAt(1.3, 0.2);
  const double captured = swingLift(swing, c.cycle, c.foot);
  for (const double f : {0.5, 1.0, 2.0, 3.0}) {
    swing.swing.lift = liftFactor(f * captured, swing, c.cycle, c.foot);
    EXPECT_NEAR(swingLift(swing, c.cycle, c.foot), f * captured, 1e-6);
  }
  EXPECT_NEAR(liftFactor(captured, swing, c.cycle, c.foot), 1.0, 1e-6);
}

// Wherever it lies between the prints, however long the swing is.
TEST(SwingPath, NoSwingClearsWhatIsHigherThanTheHighestThatIsCleared) {
  const Character& c = character();
  const FlatGround flat;
  SampleStream stream(17, 0);
  int cleared = 0;
  for (int i = 0; i < 300; ++i) {
    const double length = stream.uniform(0.3, 1.8), thick = stream.uniform(0.0, 0.3);
    const double from = stream.uniform(0.0, length - std::min(thick, 0.2));
    for (const Side side : {kLeft, kRight}) {
      for (const FootCycle* cycle :
           {&c.blend.feet().walk[side], &c.blend.feet().first[side], &c.blend.feet().last[side]}) {
        const double highest = SwingClearance(flat, c.feet, kHighest).highestCleared(*cycle);
        const auto clears_at = [&](double high) {
          const BeamGround ground(from, from + thick, high);
          SwingShape shape;
          return SwingClearance(ground, c.feet, kHighest)
              .clear(placeAt(0.0), placeAt(length), side, *cycle, shape);
        };
        ASSERT_FALSE(clears_at(highest + 1e-6)) << length << ", " << from << ", " << thick;
        ASSERT_FALSE(clears_at(stream.uniform(highest, kHighest + SwingSearch::kSeen)));
        cleared += clears_at(highest - 0.005);
      }
    }
  }
  EXPECT_GT(cleared, 50);
}

TEST(SwingPath, FeetClearEveryNosingUpAndDown) {
  for (const double rise : {0.1, 0.17, 0.2, -0.1, -0.17, -0.2}) {
    const StairGround stairs({.rise = rise, .going = 0.29, .count = 8, .start = 0.0});
    const double middle = 0.145;
    const FootPlace from = placeAt(middle, rise), to = placeAt(middle + 0.58, 3.0 * rise);
    SwingShape shape;
    ASSERT_TRUE(clears(stairs, from, to, shape)) << rise;
    EXPECT_GT(shape.extra, 0.0);
    const double risers = rise > 0.0 ? 0.0 : 1.0;  // a nosing is the front of the higher tread
    for (int i = 1; i <= 2; ++i) {
      const double nosing = 0.29 * i, top = rise * (rise > 0.0 ? i + 1 : i - risers + 1.0);
      const double clearance = leastClearance(
          from, to, shape, [&](double x) { return std::abs(x - nosing) <= 0.001 ? top : -1.0; });
      EXPECT_GE(clearance, 0.01) << rise << " nosing " << i;
    }
  }
}

TEST(SwingPath, WhatLiesBetweenPrintsIsSteppedOverWithAMargin) {
  for (const double height : {0.03, 0.08, 0.15, 0.2}) {
    const BeamGround ground(0.55, 0.7, height);
    SwingShape shape;
    ASSERT_TRUE(clears(ground, placeAt(0.0), placeAt(1.25), shape)) << height;
    const double clearance = leastClearance(placeAt(0.0), placeAt(1.25), shape, [&](double x) {
      return x > 0.55 && x < 0.7 ? height : -1.0;
    });
    EXPECT_GE(clearance, 0.01) << height;
    EXPECT_LE(shape.extra, height + 0.05);
  }
}

TEST(SwingPath, WhatIsTooHighToStepOverIsRefusedAndWallsAreLeftToTheCollisionCheck) {
  SwingShape shape;
  EXPECT_FALSE(clears(BeamGround(0.55, 0.7, 0.3), placeAt(0.0), placeAt(1.25), shape));
  EXPECT_TRUE(clears(BeamGround(0.55, 0.7, 2.0), placeAt(0.0), placeAt(1.25), shape));
}

TEST(SwingPath, AFootThatStaysWhereItIsNeedsNoWay) {
  SwingShape shape;
  EXPECT_TRUE(clears(FlatGround(), placeAt(0.3), placeAt(0.3), shape));
  EXPECT_TRUE(unchanged(shape));
}

}  // namespace
}  // namespace amble

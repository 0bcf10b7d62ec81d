#include "animation/steps/foothold.h"

#include <gtest/gtest.h>

#include <cmath>

#include "animation/ground/slope_ground.h"
#include "animation/ground/stair_ground.h"
#include "animation/library/motion_library_reader.h"
#include "base/rotation.h"
#include "base/sample_stream.h"

namespace amble {
namespace {

using Refusal = Foothold::Refusal;

const std::array<FootShape, 2>& feet() {
  static const std::array<FootShape, 2> kFeet = openMotionLibrary("default").feet();
  return kFeet;
}
double front() { return feet()[kLeft].tip_x + feet()[kLeft].radius; }
double back() { return feet()[kLeft].radius - feet()[kLeft].heel_x; }

GroundLimits limits() { return {20.0 * kDegree, 0.25, 0.25}; }

Foothold standAt(const Ground& ground, double x, double heading = 0.0, double z = 0.0) {
  FootPlace place;
  place.position = {x, 0.0, z};
  place.heading = heading;
  return FootholdFinder(ground, feet(), limits()).at(place, kLeft, 0.3);
}

/// A post under the sole: no ground, but in the way.
class PostGround : public FlatGround {
 public:
  double crest(const Eigen::Vector2d& a, const Eigen::Vector2d& b, double half_width, double low,
               double high) const override {
    const Eigen::Vector2d post(0.05, 0.0), line = b - a;
    const double t =
        std::clamp((post - a).dot(line) / std::max(line.squaredNorm(), 1e-12), 0.0, 1.0);
    const bool over = (a + t * line - post).norm() <= half_width && kTop >= low && kTop <= high;
    return over ? kTop : FlatGround::crest(a, b, half_width, low, high);
  }
  static constexpr double kTop = 0.04;  // [m]
};

TEST(Foothold, WithoutGroundWithinReachThereIsNone) {
  EXPECT_EQ(standAt(FlatGround(0.5), 0.0).refusal, Refusal::kNoGround);
  EXPECT_EQ(standAt(FlatGround(0.2), 0.0).refusal, Refusal::kNone);
}

TEST(Foothold, OnLevelGroundASoleStandsWholeAndExactlyLevel) {
  const Foothold hold = standAt(FlatGround(0.2), 1.3, 0.7);
  EXPECT_EQ(hold.refusal, Refusal::kNone);
  EXPECT_EQ(hold.place.position, Eigen::Vector3d(1.3, 0.0, 0.2));
  EXPECT_EQ(hold.place.normal, Eigen::Vector3d::UnitZ());
  EXPECT_EQ(hold.supported, 1.0);
}

TEST(Foothold, OnASlopeASoleLiesInItsPlaneWhicheverWayItHeads) {
  for (const double degrees : {-19.0, -5.0, 10.0, 20.0}) {
    for (const double heading : {0.0, 0.9, 2.0, -1.6}) {
      const SlopeGround ground(degrees * kDegree);
      const Foothold hold = standAt(ground, 0.1, heading);
      ASSERT_EQ(hold.refusal, Refusal::kNone);
      const auto there = ground.surface(0.1, 0.0, 0.0, 1.0);
      EXPECT_LT((hold.place.normal - there->normal).norm(), 1e-9);
      EXPECT_NEAR(hold.place.position.z(), there->height, 1e-9);
      EXPECT_EQ(hold.supported, 1.0);
    }
  }
}

TEST(Foothold, GroundSteeperThanTheCharacterWalksIsRefused) {
  EXPECT_EQ(standAt(SlopeGround(20.5 * kDegree), 0.0).refusal, Refusal::kSlope);
  EXPECT_EQ(standAt(SlopeGround(-20.5 * kDegree), 0.0, 1.0).refusal, Refusal::kSlope);
}

TEST(Foothold, NothingMayStickUpUnderASole) {
  const StairGround stairs({.rise = 0.17, .going = 0.29, .count = 3, .start = 0.0});
  EXPECT_EQ(standAt(stairs, -front() - 0.005).refusal, Refusal::kNone);
  EXPECT_EQ(standAt(stairs, -front() + 0.02).refusal, Refusal::kEdge);
  EXPECT_EQ(standAt(PostGround(), 0.0).refusal, Refusal::kEdge);
  EXPECT_EQ(standAt(PostGround(), 0.4).refusal, Refusal::kNone);
}

TEST(Foothold, AnOverhangCostsSupportUpToThirtyPercentOfTheSole) {
  const StairGround step({.rise = 0.17, .going = 0.29, .count = 1, .start = 0.0});
  const double length = front() + back();
  double least = 1.0;
  for (double overhang = -0.02; overhang < 0.5 * length; overhang += 0.005) {
    const Foothold hold = standAt(step, back() - overhang, 0.0, 0.17);
    if (overhang < 0.0) {
      EXPECT_EQ(hold.supported, 1.0);
    }
    if (overhang > 0.35 * length) {
      EXPECT_EQ(hold.refusal, Refusal::kEdge) << overhang;
    }
    if (hold.refusal != Refusal::kNone) continue;
    EXPECT_EQ(hold.place.position.z(), 0.17);
    least = std::min(least, hold.supported);
  }
  EXPECT_LT(least, 0.9);
  EXPECT_GE(least, FootholdFinder::kLeastSupport);
}

TEST(Foothold, TheEdgeOfARugIsStoodAcross) {
  const StairGround rug({.rise = 0.01, .going = 1.0, .count = 1, .start = 0.0});
  const Foothold hold = standAt(rug, 0.02);
  EXPECT_EQ(hold.refusal, Refusal::kNone);
  EXPECT_EQ(hold.place.position.z(), 0.01);
  EXPECT_EQ(hold.supported, 1.0);
}

/// Squares of drawn heights, some without ground, that say that they are level, or do not.
class Terraces : public Ground {
 public:
  Terraces(std::uint64_t seed, double highest, bool says_so) : says_so_(says_so) {
    SampleStream random(seed, 0);
    for (double& height : heights_) height = random.uniform(0.0, highest);
    for (int k = 0; k < 6; ++k) heights_[random.below(kSide * kSide)] = -HUGE_VAL;
  }
  std::optional<SurfacePoint> surface(double x, double y, double z, double reach) const override {
    const int i = static_cast<int>(x / kSquare), j = static_cast<int>(y / kSquare);
    if (x < 0.0 || y < 0.0 || i >= kSide || j >= kSide) return std::nullopt;
    const double height = heights_[j * kSide + i];
    if (!(std::abs(height - z) <= reach)) return std::nullopt;
    return SurfacePoint{height, Eigen::Vector3d::UnitZ()};
  }
  bool isAllLevel() const override { return says_so_; }
  static constexpr int kSide = 8;
  static constexpr double kSquare = 0.17;  // [m]

 private:
  bool says_so_;
  std::array<double, kSide * kSide> heights_;
};

TEST(Foothold, OnLevelsIsWhatItIsWhetherOrNotTheGroundSaysThatItIsAllLevel) {
  std::array<int, 4> seen = {0, 0, 0, 0};
  for (const double highest : {0.02, 0.06, 0.4}) {
    const Terraces says(5, highest, true), tells_nothing(5, highest, false);
    const FootholdFinder quick(says, feet(), limits()), whole(tells_nothing, feet(), limits());
    SampleStream random(6, 0);
    for (int n = 0; n < 3000; ++n) {
      FootPlace place;
      place.position = {random.uniform(0.0, 1.36), random.uniform(0.0, 1.36), 0.5 * highest};
      place.heading = random.uniform(-3.0, 3.0);
      const Side side = n % 2 == 0 ? kLeft : kRight;
      const Foothold hold = quick.at(place, side, 0.25), same = whole.at(place, side, 0.25);
      ++seen[static_cast<int>(hold.refusal)];
      ASSERT_EQ(hold.refusal, same.refusal) << n;
      if (hold.refusal != Refusal::kNone) continue;
      EXPECT_EQ(hold.place.position, same.place.position);
      EXPECT_EQ(hold.place.normal, same.place.normal);
      EXPECT_EQ(hold.supported, same.supported);
    }
  }
  EXPECT_GT(seen[static_cast<int>(Refusal::kNone)], 500);
  EXPECT_GT(seen[static_cast<int>(Refusal::kNoGround)], 500);
  EXPECT_GT(seen[static_cast<int>(Refusal::kEdge)], 500);
}

}  // namespace
}  // namespace amble

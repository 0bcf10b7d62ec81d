#include "animation/ground/placed_ground.h"

#include <gtest/gtest.h>

#include <memory>

#include "animation/ground/slope_ground.h"
#include "animation/ground/stair_ground.h"
#include "base/rotation.h"
#include "tests/animation/random_clip.h"

namespace amble {
namespace {

constexpr double kAnyHeight = 100.0;

std::unique_ptr<Ground> groundOf(int kind) {
  if (kind == 0) return std::make_unique<FlatGround>(0.3);
  if (kind == 1) return std::make_unique<SlopeGround>(0.1, -0.2, 4.0, 0.7);
  Stairs stairs;
  stairs.count = 5;
  return std::make_unique<StairGround>(stairs);
}

class PlacedGrounds : public testing::TestWithParam<int> {};

TEST_P(PlacedGrounds, AreTheirGroundSomewhereElse) {
  Generator generator(1);
  const Eigen::Vector2d at(3.0, -7.0);
  const std::unique_ptr<Ground> here = groundOf(GetParam());
  const PlacedGround there(groundOf(GetParam()), at);
  for (int trial = 0; trial < 200; ++trial) {
    const Eigen::Vector2d p = randomVector(generator, 5.0).head<2>();
    const auto a = here->surface(p.x(), p.y(), 0.0, kAnyHeight);
    const auto b = there.surface(p.x() + at.x(), p.y() + at.y(), 0.0, kAnyHeight);
    ASSERT_EQ(a.has_value(), b.has_value());
    if (!a) continue;
    EXPECT_NEAR(a->height, b->height, 1e-9);
    EXPECT_LT((a->normal - b->normal).norm(), 1e-9);
  }
}

TEST_P(PlacedGrounds, PlacedTwiceAreWhereBothPlacesLeadTogether) {
  Generator generator(2);
  const PlacedGround once(groundOf(GetParam()), Eigen::Vector2d(1.0, 1.5));
  const PlacedGround twice(
      std::make_unique<PlacedGround>(groundOf(GetParam()), Eigen::Vector2d(-2.0, 0.5)),
      Eigen::Vector2d(3.0, 1.0));
  for (int trial = 0; trial < 100; ++trial) {
    const Eigen::Vector2d p = randomVector(generator, 5.0).head<2>();
    EXPECT_NEAR(once.height(p.x(), p.y(), 0.0, kAnyHeight).value_or(0.0),
                twice.height(p.x(), p.y(), 0.0, kAnyHeight).value_or(0.0), 1e-9);
  }
}

// A normal is upright to the way of the ground, wherever that is smooth.
TEST_P(PlacedGrounds, HaveTheNormalsOfTheirHeights) {
  Generator generator(3);
  const std::unique_ptr<Ground> ground = groundOf(GetParam());
  constexpr double kStep = 1e-5;
  const auto height = [&](double x, double y) {
    return ground->height(x, y, 0.0, kAnyHeight).value_or(0.0);
  };
  for (int trial = 0; trial < 100; ++trial) {
    const Eigen::Vector2d p = randomVector(generator, 3.0).head<2>();
    const double rise_x =
        (height(p.x() + kStep, p.y()) - height(p.x() - kStep, p.y())) / (2 * kStep);
    const double rise_y =
        (height(p.x(), p.y() + kStep) - height(p.x(), p.y() - kStep)) / (2 * kStep);
    if (std::abs(rise_x) + std::abs(rise_y) > 3.0) continue;  // a riser
    const Eigen::Vector3d wanted = Eigen::Vector3d(-rise_x, -rise_y, 1.0).normalized();
    const auto surface = ground->surface(p.x(), p.y(), 0.0, kAnyHeight);
    ASSERT_TRUE(surface);
    EXPECT_LT((surface->normal - wanted).norm(), 1e-4);
  }
}

TEST_P(PlacedGrounds, OutOfReachAreNotThere) {
  Generator generator(4);
  const std::unique_ptr<Ground> ground = groundOf(GetParam());
  for (int trial = 0; trial < 100; ++trial) {
    const Eigen::Vector2d p = randomVector(generator, 4.0).head<2>();
    const double height = ground->height(p.x(), p.y(), 0.0, kAnyHeight).value_or(0.0);
    const double reach = uniform(generator, 0.05, 1.0);
    for (const double side : {1.0, -1.0}) {
      EXPECT_TRUE(ground->surface(p.x(), p.y(), height + side * (reach - 1e-6), reach));
      EXPECT_FALSE(ground->surface(p.x(), p.y(), height + side * (reach + 1e-6), reach));
    }
  }
}

// What is asked of many points and pieces at once is what each has.
TEST_P(PlacedGrounds, AnswerForManyAsForEach) {
  Generator generator(5);
  const PlacedGround ground(groundOf(GetParam()), Eigen::Vector2d(0.4, -0.3));
  std::vector<Eigen::Vector2d> points;
  for (int i = 0; i < 32; ++i) points.push_back(randomVector(generator, 2.0).head<2>());
  std::vector<std::optional<SurfacePoint>> all(points.size());
  ground.surfaces(points, 0.0, 1.0, all);
  for (size_t i = 0; i < points.size(); ++i) {
    const auto one = ground.surface(points[i].x(), points[i].y(), 0.0, 1.0);
    ASSERT_EQ(one.has_value(), all[i].has_value());
    if (one) {
      EXPECT_EQ(one->height, all[i]->height);
      EXPECT_EQ(one->normal, all[i]->normal);
    }
  }
  std::vector<PlanSegment> pieces;
  for (int i = 0; i < 8; ++i) pieces.push_back({{0.25 * i, 0.1}, {0.25 * (i + 1), 0.1}});
  const std::vector<double> crests = ground.crests(pieces, 0.05, -1.0, 2.0);
  ASSERT_EQ(crests.size(), pieces.size());
  for (size_t i = 0; i < pieces.size(); ++i)
    EXPECT_EQ(crests[i], ground.crest(pieces[i].from, pieces[i].to, 0.05, -1.0, 2.0));
}

// No point of the strip is higher than its crest, and one is as high, but for what lies between
// samples of 2 cm.
TEST_P(PlacedGrounds, HaveCrestsThatAreTheHighestOfTheirStrips) {
  Generator generator(6);
  const std::unique_ptr<Ground> ground = groundOf(GetParam());
  for (int trial = 0; trial < 20; ++trial) {
    const Eigen::Vector2d a = randomVector(generator, 2.0).head<2>();
    const Eigen::Vector2d b = a + randomVector(generator, 0.6).head<2>();
    const Eigen::Vector2d way = (b - a).normalized(), left(-way.y(), way.x());
    const double crest = ground->crest(a, b, 0.05, -10.0, 10.0);
    double highest = -10.0;
    for (double t = 0.0; t <= 1.0; t += 0.005) {
      for (const double side : {-0.05, -0.025, 0.0, 0.025, 0.05}) {
        const Eigen::Vector2d p = a + t * (b - a) + side * left;
        highest = std::max(highest, ground->height(p.x(), p.y(), 0.0, kAnyHeight).value_or(-10.0));
      }
    }
    EXPECT_GE(crest, highest - (GetParam() == 2 ? 0.2 : 0.01));
    EXPECT_LE(crest, highest + 0.01);
  }
}

INSTANTIATE_TEST_SUITE_P(, PlacedGrounds, testing::Values(0, 1, 2));

}  // namespace
}  // namespace amble

#include "base/trigonometry.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "base/rotation.h"

namespace amble {
namespace {

// Of every size, and near the multiples of an eighth of a turn, where ranges meet.
std::vector<double> someAngles() {
  std::mt19937_64 generator(1);
  std::uniform_real_distribution<double> turn(-kPi, kPi), power(-20.0, 8.0), near(-1e-9, 1e-9);
  std::vector<double> angles = {0.0, -0.0, 1e-300, -1e-300, 1e5, 1e6, -1e18};
  for (int k = -4000; k <= 4000; ++k) angles.push_back(0.25 * kPi * k + near(generator));
  for (int n = 0; n < 100000; ++n) angles.push_back(turn(generator));
  for (int n = 0; n < 100000; ++n)
    angles.push_back(std::copysign(std::pow(10.0, power(generator)), turn(generator)));
  return angles;
}

TEST(Trigonometry, SinesAndCosinesAreThoseOfTheCLibraryToALastDigit) {
  const std::vector<double> angles = someAngles();
  std::vector<double> sines(angles.size()), cosines(angles.size());
  sinesAndCosines(angles, sines, cosines);
  for (size_t i = 0; i < angles.size(); ++i) {
    ASSERT_NEAR(sines[i], std::sin(angles[i]), 4e-16) << angles[i];
    ASSERT_NEAR(cosines[i], std::cos(angles[i]), 4e-16) << angles[i];
  }
}

TEST(Trigonometry, ArcTangentsAreThoseOfTheCLibraryAllAroundAndAtZeros) {
  std::vector<double> x, y;
  for (const double a : {0.0, -0.0, 1.0, -1.0, 1e-150, -1e150})
    for (const double b : {0.0, -0.0, 1.0, -1.0, 1e-150, -1e150, 0.66, -0.66}) {
      x.push_back(a);
      y.push_back(b);
    }
  for (const double angle : someAngles()) {
    const double size = 1.0 + std::abs(angle);
    x.push_back(size * std::cos(angle));
    y.push_back(size * std::sin(angle));
  }
  std::vector<double> found(x.size());
  arcTangents(y, x, found);
  for (size_t i = 0; i < x.size(); ++i) {
    const double right = std::atan2(y[i], x[i]);
    ASSERT_NEAR(found[i], right, 6e-16) << y[i] << " " << x[i];
    ASSERT_EQ(std::signbit(found[i]), std::signbit(right)) << y[i] << " " << x[i];
  }
}

TEST(Trigonometry, ANumberIsTheSameWhateverStandsBesideIt) {
  const std::vector<double> angles = {0.1, 2.0, -3.0, 0.7, 1.1, -0.4, 2.9};
  for (size_t count = 1; count <= angles.size(); ++count) {
    std::vector<double> sines(count), cosines(count), back(count);
    sinesAndCosines(std::span(angles).first(count), sines, cosines);
    arcTangents(sines, cosines, back);
    for (size_t i = 0; i < count; ++i) {
      double sine = 0.0, cosine = 0.0, alone = 0.0;
      sinesAndCosines({&angles[i], 1}, {&sine, 1}, {&cosine, 1});
      arcTangents({&sine, 1}, {&cosine, 1}, {&alone, 1});
      EXPECT_EQ(sines[i], sine);
      EXPECT_EQ(cosines[i], cosine);
      EXPECT_EQ(back[i], alone);
      EXPECT_NEAR(back[i], angles[i], 1e-15);
    }
  }
}

TEST(Trigonometry, HalfAnglesGiveTheRotationOfTheWholeInEveryOrder) {
  const Eigen::Vector3d angles(0.4, -2.9, 1.7);
  const Eigen::Array3d half = 0.5 * angles.array();
  for (const char* const order : {"XYZ", "XZY", "YXZ", "YZX", "ZXY", "ZYX"}) {
    const RotationOrder axes = {order[0], order[1], order[2]};
    const Eigen::Quaterniond q = fromHalfEuler(half.sin(), half.cos(), axes);
    EXPECT_LT((q.coeffs() - fromEuler(angles, axes).coeffs()).norm(), 1e-15) << order;
  }
}

}  // namespace
}  // namespace amble

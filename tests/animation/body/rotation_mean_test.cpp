#include "animation/body/rotation_mean.h"

#include <gtest/gtest.h>

#include "base/rotation.h"

namespace amble {
namespace {

TEST(RotationMean, OfATurnThereAndBackIsTheMiddle) {
  const Eigen::Quaterniond middle = expRotation({0.4, -1.1, 0.3});
  RotationMean mean;
  EXPECT_TRUE(mean.empty());
  for (const double angle : {0.3, -0.3, 0.1, -0.1}) {
    mean.add(middle * expRotation(angle * Eigen::Vector3d::UnitY()));
  }
  EXPECT_FALSE(mean.empty());
  EXPECT_LT(mean.mean().angularDistance(middle), 1e-9);
}

TEST(RotationMean, DoesNotDependOnTheSignsOfQuaternions) {
  const Eigen::Quaterniond a = expRotation({0.0, 0.0, 0.2}), b = expRotation({0.0, 0.0, 0.6});
  RotationMean mean;
  mean.add(a);
  mean.add(Eigen::Quaterniond(-b.coeffs()));
  EXPECT_LT(mean.mean().angularDistance(expRotation({0.0, 0.0, 0.4})), 1e-9);
}

}  // namespace
}  // namespace amble

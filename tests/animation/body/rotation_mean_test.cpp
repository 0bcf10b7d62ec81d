#include "animation/body/rotation_mean.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/rotation.h"
#include "tests/animation/random_clip.h"

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

std::vector<Eigen::Quaterniond> nearEachOther(Generator& generator, int count) {
  const Eigen::Quaterniond middle = randomRotation(generator);
  std::vector<Eigen::Quaterniond> turns;
  for (int i = 0; i < count; ++i) {
    turns.push_back(middle * expRotation(randomVector(generator, 0.4)));
  }
  return turns;
}

Eigen::Quaterniond meanOf(const std::vector<Eigen::Quaterniond>& turns) {
  RotationMean mean;
  for (const Eigen::Quaterniond& q : turns) mean.add(q);
  return mean.mean();
}

TEST(RotationMean, ManyOfOneAreThatOne) {
  Generator generator(411);
  for (int round = 0; round < 20; ++round) {
    const Eigen::Quaterniond q = randomRotation(generator);
    EXPECT_LT(meanOf(std::vector(7, q)).angularDistance(q), 1e-7);
  }
}

TEST(RotationMean, DoesNotDependOnTheOrder) {
  Generator generator(412);
  for (int round = 0; round < 20; ++round) {
    std::vector<Eigen::Quaterniond> turns = nearEachOther(generator, 9);
    const Eigen::Quaterniond mean = meanOf(turns);
    std::shuffle(turns.begin(), turns.end(), generator);
    EXPECT_LT(meanOf(turns).angularDistance(mean), 1e-7);
  }
}

TEST(RotationMean, TurnsWithWhatIsTurned) {
  Generator generator(413);
  for (int round = 0; round < 20; ++round) {
    std::vector<Eigen::Quaterniond> turns = nearEachOther(generator, 9);
    const Eigen::Quaterniond mean = meanOf(turns), left = randomRotation(generator),
                             right = randomRotation(generator);
    for (Eigen::Quaterniond& q : turns) q = left * q * right;
    EXPECT_LT(meanOf(turns).angularDistance(left * mean * right), 1e-7);
  }
}

// Of all rotations it is the one whose matrix is nearest to theirs, in the sum of squares.
TEST(RotationMean, NoNeighbourIsNearerToAll) {
  Generator generator(414);
  const auto distance = [](const std::vector<Eigen::Quaterniond>& turns,
                           const Eigen::Quaterniond& to) {
    double sum = 0.0;
    for (const Eigen::Quaterniond& q : turns) {
      const double chord = std::min((q.coeffs() - to.coeffs()).squaredNorm(),
                                    (q.coeffs() + to.coeffs()).squaredNorm());
      sum += chord;
    }
    return sum;
  };
  for (int round = 0; round < 20; ++round) {
    const std::vector<Eigen::Quaterniond> turns = nearEachOther(generator, 7);
    const Eigen::Quaterniond mean = meanOf(turns);
    for (int k = 0; k < 30; ++k) {
      const Eigen::Quaterniond near = mean * expRotation(randomVector(generator, 0.1));
      EXPECT_GE(distance(turns, near), distance(turns, mean) - 1e-12);
    }
  }
}

}  // namespace
}  // namespace amble

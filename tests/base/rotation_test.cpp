#include "base/rotation.h"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "tests/animation/random_clip.h"

namespace amble {
namespace {

const std::vector<RotationOrder> kOrders = {{'X', 'Y', 'Z'}, {'X', 'Z', 'Y'}, {'Y', 'X', 'Z'},
                                            {'Y', 'Z', 'X'}, {'Z', 'X', 'Y'}, {'Z', 'Y', 'X'}};

/// A rotation about one axis as books write it, apart from the code under test.
Eigen::Matrix3d axisMatrix(char axis, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  Eigen::Matrix3d m;
  if (axis == 'X') m << 1, 0, 0, 0, c, -s, 0, s, c;
  if (axis == 'Y') m << c, 0, s, 0, 1, 0, -s, 0, c;
  if (axis == 'Z') m << c, -s, 0, s, c, 0, 0, 0, 1;
  return m;
}

Eigen::Matrix3d eulerMatrix(const Eigen::Vector3d& angles, const RotationOrder& order) {
  return axisMatrix(order[0], angles[0]) * axisMatrix(order[1], angles[1]) *
         axisMatrix(order[2], angles[2]);
}

double difference(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b) {
  return (a.toRotationMatrix() - b.toRotationMatrix()).cwiseAbs().maxCoeff();
}

TEST(Rotation, EulerAnglesMultiplyInTheOrderOfTheChannels) {
  Generator generator(1);
  for (const RotationOrder& order : kOrders) {
    for (int i = 0; i < 200; ++i) {
      const Eigen::Vector3d angles = randomVector(generator, 10.0);
      const Eigen::Matrix3d R = fromEuler(angles, order).toRotationMatrix();
      EXPECT_LT((R - eulerMatrix(angles, order)).cwiseAbs().maxCoeff(), 1e-14);
    }
  }
}

TEST(Rotation, ToEulerInvertsFromEulerInEveryOrder) {
  Generator generator(2);
  for (const RotationOrder& order : kOrders) {
    for (int i = 0; i < 500; ++i) {
      const Eigen::Quaterniond q = randomRotation(generator);
      const Eigen::Vector3d angles = toEuler(q, order);
      EXPECT_LE(std::abs(angles[1]), kPi / 2);
      EXPECT_LT(difference(fromEuler(angles, order), q), 1e-14);
    }
  }
}

TEST(Rotation, ToEulerGivesAnglesBackInTheirOwnRange) {
  Generator generator(3);
  for (const RotationOrder& order : kOrders) {
    for (int i = 0; i < 500; ++i) {
      const Eigen::Vector3d angles(uniform(generator, -3.1, 3.1), uniform(generator, -1.5, 1.5),
                                   uniform(generator, -3.1, 3.1));
      EXPECT_LT((toEuler(fromEuler(angles, order), order) - angles).cwiseAbs().maxCoeff(), 1e-13);
    }
  }
}

TEST(Rotation, ToEulerIsRightAtAndNearGimbalLock) {
  Generator generator(4);
  for (const RotationOrder& order : kOrders) {
    for (const double away : {0.0, 1e-15, 1e-13, 1e-11, 1e-9, 1e-7, 1e-5}) {
      for (const double sign : {-1.0, 1.0}) {
        const Eigen::Vector3d angles(uniform(generator, -3, 3), sign * (kPi / 2 - away),
                                     uniform(generator, -3, 3));
        const Eigen::Quaterniond q = fromEuler(angles, order);
        EXPECT_LT(difference(fromEuler(toEuler(q, order), order), q), 5e-12);
      }
    }
  }
}

TEST(Rotation, LastAngleIsZeroInGimbalLock) {
  for (const RotationOrder& order : kOrders) {
    EXPECT_EQ(toEuler(fromEuler({0.3, kPi / 2, 0.4}, order), order)[2], 0.0);
  }
}

TEST(Rotation, UnwrappedAnglesMeanTheSameRotation) {
  Generator generator(5);
  for (const RotationOrder& order : kOrders) {
    for (int i = 0; i < 200; ++i) {
      const Eigen::Vector3d angles = randomVector(generator, 4.0),
                            previous = randomVector(generator, 30.0);
      const Eigen::Vector3d near = unwrapEuler(angles, previous);
      EXPECT_LT(difference(fromEuler(near, order), fromEuler(angles, order)), 1e-13);
      // Each angle is the nearest of its turns:
      // within half of one.
      EXPECT_LE((near - previous).cwiseAbs().maxCoeff(), kPi + 1e-9);
    }
  }
}

TEST(Rotation, UnwrappedAnglesFollowASmoothTurnThroughGimbalLock) {
  // The middle angle goes through 90 degrees: principal angles jump by half a turn there, unwrapped
  // ones do not.
  Eigen::Vector3d previous(0.1, 1.2, -0.2);
  for (double middle = 1.2; middle < 2.0; middle += 0.013) {
    const Eigen::Vector3d angles(0.1, middle, -0.2);
    const Eigen::Vector3d found =
        unwrapEuler(toEuler(fromEuler(angles, {'Z', 'X', 'Y'}), {'Z', 'X', 'Y'}), previous);
    EXPECT_LT((found - angles).cwiseAbs().maxCoeff(), 1e-9);
    previous = found;
  }
}

// Either side of where the series ends, at an angle of 2, and through 0.
TEST(Rotation, ExpIsTheHalfAnglesCosineAndSine) {
  Generator generator(11);
  for (double angle = 0.0; angle < 7.0; angle += 0.0137) {
    const Eigen::Vector3d axis = randomVector(generator, 1.0).normalized();
    const Eigen::Quaterniond q = expRotation(angle * axis);
    EXPECT_NEAR(q.w(), std::cos(0.5 * angle), 1e-15) << angle;
    EXPECT_LT((q.vec() - std::sin(0.5 * angle) * axis).norm(), 1e-15) << angle;
  }
}

TEST(Rotation, LogInvertsExpBelowHalfATurn) {
  Generator generator(6);
  for (const double size : {0.0, 1e-300, 1e-12, 1e-5, 1e-4, 1e-3, 0.1, 1.0, 1.8}) {
    const Eigen::Vector3d v = randomVector(generator, size);
    EXPECT_LT((logRotation(expRotation(v)) - v).norm(), 1e-14 + 1e-14 * v.norm());
    EXPECT_NEAR(expRotation(v).norm(), 1.0, 1e-15);
  }
}

TEST(Rotation, LogTakesTheShorterWay) {
  Generator generator(7);
  for (int i = 0; i < 200; ++i) {
    const Eigen::Quaterniond q = randomRotation(generator);
    const Eigen::Vector3d v = logRotation(q);
    EXPECT_LE(v.norm(), kPi + 1e-12);
    EXPECT_LT(difference(expRotation(v), q), 1e-14);
    EXPECT_LT((v - logRotation(Eigen::Quaterniond(-q.coeffs()))).norm(), 1e-12);
  }
}

TEST(Rotation, TheTurnBetweenTwoDirectionsTakesOneToTheOtherByTheAngleBetweenThem) {
  Generator generator(8);
  for (int i = 0; i < 500; ++i) {
    const Eigen::Vector3d from = randomVector(generator, 3.0);
    const Eigen::Vector3d to =
        i % 10 == 0 ? Eigen::Vector3d(2.0 * from) : Eigen::Vector3d(randomVector(generator, 0.1));
    const Eigen::Quaterniond turn = turnBetween(from, to);
    EXPECT_LT((turn * from.normalized() - to.normalized()).norm(), 1e-12);
    EXPECT_NEAR(logRotation(turn).norm(), std::atan2(from.cross(to).norm(), from.dot(to)), 1e-12);
  }
}

TEST(Rotation, TheTurnBetweenOppositeDirectionsIsHalfATurnAcrossThem) {
  Generator generator(9);
  // 1 plus a cosine near -1 is right to 1e-16, which is its share of beside^2.
  for (const double beside : {0.0, 1e-16, 1e-12, 1e-9, 1e-7, 1e-5}) {
    const Eigen::Vector3d from = randomVector(generator, 1.0);
    const Eigen::Vector3d to = -from + beside * from.unitOrthogonal();
    const Eigen::Quaterniond turn = turnBetween(from, to);
    EXPECT_NEAR(turn.norm(), 1.0, 1e-5) << beside;
    EXPECT_LT((turn * from.normalized() - to.normalized()).norm(), 2e-5) << beside;
    EXPECT_NEAR(turn.vec().dot(from.normalized()), 0.0, 1e-5) << beside;
  }
}

TEST(Rotation, WrappedAngleIsWithinHalfATurnAndTheSameDirection) {
  for (double angle = -50.0; angle < 50.0; angle += 0.37) {
    const double wrapped = wrapAngle(angle);
    EXPECT_GT(wrapped, -kPi);
    EXPECT_LE(wrapped, kPi);
    EXPECT_NEAR(std::cos(wrapped), std::cos(angle), 1e-13);
    EXPECT_NEAR(std::sin(wrapped), std::sin(angle), 1e-13);
  }
  EXPECT_EQ(wrapAngle(-kPi), kPi);
  EXPECT_EQ(wrapAngle(kPi), kPi);
}

TEST(Rotation, YUpFileAxesGoToWorldAsBlenderPlacesThem) {
  const Eigen::Vector3d file(1.0, 2.0, 3.0);
  EXPECT_LT((yUpToWorld() * file - Eigen::Vector3d(1.0, -3.0, 2.0)).norm(), 1e-15);
  EXPECT_LT((aboutZ(kPi / 2) * Eigen::Vector3d::UnitX() - Eigen::Vector3d::UnitY()).norm(), 1e-15);
}

}  // namespace
}  // namespace amble

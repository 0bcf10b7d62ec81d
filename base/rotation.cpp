#include "base/rotation.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace amble {
namespace {

// Below this angle sin(x)/x and its like are replaced by their series; the error is below 1e-17
// [rad].
constexpr double kSmallAngle = 1e-4;

// Where cos(middle angle) is below this the outer axes are one, and only their sum or difference is
// known.
constexpr double kGimbalCosine = 1e-12;

// 1 / (2 k)! and 1 / (2 k + 1)!, as far as they count up to that square of a half angle: turns of 2
// radians.
constexpr double kSeriesEnd = 1.0;
constexpr int kSeriesTerms = 10;
constexpr auto kSeries = [] {
  std::array<std::array<double, 2>, kSeriesTerms> terms = {};
  double factorial = 1.0;
  for (int k = 0; k < kSeriesTerms; ++k) {
    if (k > 0) factorial *= (2.0 * k - 1.0) * (2.0 * k);
    terms[k] = {1.0 / factorial, 1.0 / (factorial * (2.0 * k + 1.0))};
  }
  return terms;
}();

int axisIndex(char axis) {
  assert(axis == 'X' || axis == 'Y' || axis == 'Z');
  return axis - 'X';
}

// +1 where the order is X Y Z turned round (XYZ, YZX, ZXY), -1 for the other three.
double parity(int first, int second) { return (first + 1) % 3 == second ? 1.0 : -1.0; }

Eigen::Quaterniond aboutAxis(int axis, double angle) {
  Eigen::Quaterniond q(std::cos(0.5 * angle), 0.0, 0.0, 0.0);
  q.coeffs()[axis] = std::sin(0.5 * angle);
  return q;
}

// `angle` plus whole turns, nearest to `target`.
double nearestTurn(double angle, double target) {
  return angle + 2.0 * kPi * std::round((target - angle) / (2.0 * kPi));
}

}  // namespace

// Both parts are power series of the half angle's square x: cos is the sum of (-x)^k / (2 k)!,
// sin over the angle that of (-x)^k / (2 k + 1)!. Side by side, and alike on every machine.
Eigen::Quaterniond expRotation(const Eigen::Vector3d& v) {
  const double square = 0.25 * v.squaredNorm();
  if (square <= kSeriesEnd) {
    const auto term = [](int k) { return Eigen::Map<const Eigen::Array2d>(kSeries[k].data()); };
    Eigen::Array2d sum = term(kSeriesTerms - 1);
    for (int k = kSeriesTerms - 2; k >= 0; --k) sum = sum * -square + term(k);
    Eigen::Quaterniond q;
    q.w() = sum[0];
    q.vec() = (0.5 * sum[1]) * v;
    return q;
  }
  const double half = std::sqrt(square);
  Eigen::Quaterniond q;
  q.w() = std::cos(half);
  q.vec() = 0.5 * std::sin(half) / half * v;
  return q;
}

Eigen::Vector3d logRotation(const Eigen::Quaterniond& q) {
  const double sign = q.w() < 0.0 ? -1.0 : 1.0;
  const double sine = q.vec().norm();
  const double cosine = sign * q.w();
  if (sine < kSmallAngle * cosine) {
    const double tangent = sine / cosine;
    return sign * 2.0 / cosine * (1.0 - tangent * tangent / 3.0) * q.vec();
  }
  return sign * 2.0 * std::atan2(sine, cosine) / sine * q.vec();
}

Eigen::Quaterniond fromEuler(const Eigen::Vector3d& angles, RotationOrder order) {
  return aboutAxis(axisIndex(order[0]), angles[0]) * aboutAxis(axisIndex(order[1]), angles[1]) *
         aboutAxis(axisIndex(order[2]), angles[2]);
}

// With i, j, k the axes in order and e the parity, the product's entries are
//   R(i,i) = cos b cos c,  R(i,j) = -e cos b sin c,  R(i,k) = e sin b,
//   R(j,k) = -e cos b sin a,  R(k,k) = cos b cos a.
// The last angle is read from R_i(-a) R instead of from row i: near gimbal lock a is uncertain, and
// c then makes up for whatever a came out as, so that the product is right to rounding everywhere.
Eigen::Vector3d toEuler(const Eigen::Quaterniond& q, RotationOrder order) {
  const int i = axisIndex(order[0]), j = axisIndex(order[1]), k = axisIndex(order[2]);
  assert(i != j && j != k && i != k);
  const double e = parity(i, j);
  const Eigen::Matrix3d R = q.toRotationMatrix();
  const double cosine = std::hypot(R(i, i), R(i, j));
  const double b = std::atan2(e * R(i, k), cosine);
  if (cosine < kGimbalCosine) return {std::atan2(e * R(k, j), R(j, j)), b, 0.0};
  const double a = std::atan2(-e * R(j, k), R(k, k));
  const double sa = e * std::sin(a), ca = std::cos(a);
  const double c = std::atan2(e * (ca * R(j, i) + sa * R(k, i)), ca * R(j, j) + sa * R(k, j));
  return {a, b, c};
}

Eigen::Vector3d unwrapEuler(const Eigen::Vector3d& angles, const Eigen::Vector3d& previous) {
  const Eigen::Vector3d other(angles[0] + kPi, kPi - angles[1], angles[2] + kPi);
  Eigen::Vector3d same_near, other_near;
  for (int i = 0; i < 3; ++i) {
    same_near[i] = nearestTurn(angles[i], previous[i]);
    other_near[i] = nearestTurn(other[i], previous[i]);
  }
  const double same_distance = (same_near - previous).squaredNorm();
  const double other_distance = (other_near - previous).squaredNorm();
  return other_distance < same_distance ? other_near : same_near;
}

Eigen::Quaterniond turnBetween(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  const Eigen::Vector3d a = from.normalized(), b = to.normalized();
  const double cosine = b.dot(a);
  if (cosine < -1.0 + 1e-12) {  // the cross product has no direction left
    const double w2 = 0.5 * (1.0 + std::max(cosine, -1.0));
    const Eigen::Vector3d v = a.unitOrthogonal() * std::sqrt(1.0 - w2);
    return {std::sqrt(w2), v.x(), v.y(), v.z()};
  }
  const Eigen::Vector3d axis = a.cross(b);
  const double s = std::sqrt((1.0 + cosine) * 2.0), per_s = 1.0 / s;
  return {0.5 * s, axis.x() * per_s, axis.y() * per_s, axis.z() * per_s};
}

double wrapAngle(double angle) {
  if (angle > -kPi && angle <= kPi) return angle;
  const double wrapped = std::remainder(angle, 2.0 * kPi);
  return wrapped <= -kPi ? wrapped + 2.0 * kPi : wrapped;
}

Eigen::Quaterniond aboutZ(double heading) { return aboutAxis(2, heading); }

Eigen::Quaterniond yUpToWorld() { return {std::sqrt(0.5), std::sqrt(0.5), 0.0, 0.0}; }

}  // namespace amble

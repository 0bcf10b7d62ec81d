#include "base/trigonometry.h"

#include <array>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

#include "base/lanes.h"
#include "base/processor.h"

#define AMBLE_INLINE inline __attribute__((always_inline))

namespace amble {
namespace {

constexpr size_t kLanes = 4;
using Bits = LaneBits;

AMBLE_INLINE Bits bitsOf(const Lanes& x) { return reinterpret_cast<Bits>(x); }
AMBLE_INLINE Lanes numberOf(const Bits& x) { return reinterpret_cast<Lanes>(x); }

constexpr int64_t kSign = std::numeric_limits<int64_t>::min();

constexpr double kLargestCut = 1e5;  // angles beyond are left to the C library [rad]

// atan r = r + r^3 P(r^2) / Q(r^2), |r| <= 0.66; the highest power first, Q's is 1.
constexpr std::array<double, 5> kP = {-8.750608600031904122785e-01, -1.615753718733365076637e+01,
                                      -7.500855792314704667340e+01, -1.228866684490136173410e+02,
                                      -6.485021904942025371773e+01};
constexpr std::array<double, 6> kQ = {1.0,
                                      2.485846490142306297962e+01,
                                      1.650270098316988542046e+02,
                                      4.328810604912902668951e+02,
                                      4.853903996359136964868e+02,
                                      1.945506571482613964425e+02};
constexpr double kSteep = 0.66;  // above it 45 degrees are taken off
constexpr double kPi1 = 3.141592653589793116, kPi2 = 1.224646799147353207e-16;

AMBLE_INLINE Lanes arcTangent(const Lanes& y, const Lanes& x) {
  const Bits y_sign = bitsOf(y) & kSign, x_sign = bitsOf(x) & kSign;
  const Lanes up = numberOf(bitsOf(y) ^ y_sign), along = numberOf(bitsOf(x) ^ x_sign);
  const Bits swapped = up > along;
  const Lanes least = swapped ? along : up, most = swapped ? up : along;
  const Bits steep = least > kSteep * most;
  const Lanes zero = least * 0.0;
  const Lanes over = steep ? most + least : most;
  const Lanes r = (steep ? least - most : least) / (over > zero ? over : zero + 1.0);
  const Lanes z = r * r;
  Lanes p = zero + kP[0], q = zero + kQ[0];
#pragma GCC unroll 8
  for (int k = 1; k < 5; ++k) p = p * z + kP[k];
#pragma GCC unroll 8
  for (int k = 1; k < 6; ++k) q = q * z + kQ[k];
  Lanes angle = r * (z * p / q) + r;
  // What was cut off is put on again, its second piece first.
  angle = steep ? 0.25 * kPi1 + (angle + 0.25 * kPi2) : angle;
  angle = swapped ? 0.5 * kPi1 - (angle - 0.5 * kPi2) : angle;
  angle = x_sign != 0 ? kPi1 - (angle - kPi2) : angle;
  return numberOf(bitsOf(angle) | y_sign);
}

// The numbers from `first` on; zeros where there are no more.
AMBLE_INLINE Lanes load(std::span<const double> numbers, size_t first) {
  Lanes lanes = {};
  const size_t left = numbers.size() - first;
  if (left >= kLanes)
    std::memcpy(&lanes, numbers.data() + first, sizeof lanes);
  else
    std::memcpy(&lanes, numbers.data() + first, left * sizeof(double));
  return lanes;
}
AMBLE_INLINE void store(const Lanes& lanes, std::span<double> numbers, size_t first) {
  const size_t left = numbers.size() - first;
  if (left >= kLanes)
    std::memcpy(numbers.data() + first, &lanes, sizeof lanes);
  else
    std::memcpy(numbers.data() + first, &lanes, left * sizeof(double));
}

}  // namespace

AMBLE_FOR_EACH_PROCESSOR
void sinesAndCosines(std::span<const double> angles, std::span<double> sines,
                     std::span<double> cosines) {
  assert(angles.size() == sines.size() && angles.size() == cosines.size());
  for (size_t i = 0; i < angles.size(); i += kLanes) {
    const SinCos both = sinCos(load(angles, i));
    store(both.sine, sines, i);
    store(both.cosine, cosines, i);
  }
  for (size_t i = 0; i < angles.size(); ++i) {
    if (std::abs(angles[i]) <= kLargestCut) continue;
    sines[i] = std::sin(angles[i]);
    cosines[i] = std::cos(angles[i]);
  }
}

AMBLE_FOR_EACH_PROCESSOR
void arcTangents(std::span<const double> y, std::span<const double> x, std::span<double> angles) {
  assert(y.size() == x.size() && y.size() == angles.size());
  for (size_t i = 0; i < y.size(); i += kLanes)
    store(arcTangent(load(y, i), load(x, i)), angles, i);
}

// The product of three turns about the axes i, j, k; e is +1 where they are X Y Z turned round.
Eigen::Quaterniond fromHalfEuler(const Eigen::Vector3d& s, const Eigen::Vector3d& c,
                                 RotationOrder order) {
  const int i = order[0] - 'X', j = order[1] - 'X', k = order[2] - 'X';
  assert(i != j && j != k && i != k);
  const double e = (i + 1) % 3 == j ? 1.0 : -1.0;
  const double cc = c[0] * c[1], ss = s[0] * s[1], sc = s[0] * c[1], cs = c[0] * s[1];
  Eigen::Quaterniond q;
  q.w() = cc * c[2] - e * ss * s[2];
  q.coeffs()[i] = sc * c[2] + e * cs * s[2];
  q.coeffs()[j] = cs * c[2] - e * sc * s[2];
  q.coeffs()[k] = cc * s[2] + e * ss * c[2];
  return q;
}

}  // namespace amble

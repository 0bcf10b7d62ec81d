#include "animation/steps/stride_law.h"

#include <array>
#include <cmath>

namespace amble {

double StrideLaw::stepLength(double speed) const {
  const double ratio = speed / speed_;
  return step_ * (ratio >= slow_ ? std::pow(ratio, power_) : ratio / kSlowestCadence);
}

double StrideLaw::speed(double step_length) const {
  const double ratio = step_length / step_;
  const double slow = std::pow(kSlowestCadence, power_ / (1.0 - power_));
  return speed_ * (ratio >= slow ? std::pow(ratio, 1.0 / power_) : ratio * kSlowestCadence);
}

double doubleSupport(double speed, double leg_length) {
  struct Norm {
    double speed, share;
  };
  // Middles of the classes very slow, slow, free, fast, very fast.
  constexpr std::array<Norm, 5> kNorms = {
      {{0.16, 0.36}, {0.295, 0.24}, {0.4315, 0.19}, {0.568, 0.16}, {0.70, 0.14}}};
  constexpr double kGravity = 9.81;  // [m/s^2]
  const double v = speed / std::sqrt(kGravity * leg_length);
  if (v <= kNorms.front().speed) return kNorms.front().share;
  for (size_t i = 1; i < kNorms.size(); ++i) {
    if (v > kNorms[i].speed) continue;
    const double t = (v - kNorms[i - 1].speed) / (kNorms[i].speed - kNorms[i - 1].speed);
    return kNorms[i - 1].share + t * (kNorms[i].share - kNorms[i - 1].share);
  }
  return kNorms.back().share;
}

}  // namespace amble

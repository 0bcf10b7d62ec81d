#include "animation/body/step_prints.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/rotation.h"

namespace amble {
namespace {

constexpr int kThrough = 5;  // frames

// Of the polynomial through values at 0, 1, ... (Lagrange).
double throughFrames(const double* values, double t) {
  double sum = 0.0;
  for (int i = 0; i < kThrough; ++i) {
    double weight = 1.0;
    for (int k = 0; k < kThrough; ++k)
      if (k != i) weight *= (t - k) / (i - k);
    sum += weight * values[i];
  }
  return sum;
}

// The most that the sole is lifted [m, >= 0], between frames as a polynomial through those around
// the highest has it: at 60 frames a second the highest frame of a quick short swing is lower by up
// to 3 %, and a parabola through three, or without those of a swing's begin, is off by as much.
double highestOf(const StepPrints& prints) {
  constexpr int kBetween = 20;
  std::vector<double> heights;
  for (const SoleEnds& sole : prints.swing)
    heights.push_back(heightOver(prints.from.ends, prints.to.ends, sole));
  if (heights.empty()) return 0.0;
  const auto highest = std::ranges::max_element(heights);
  const int frames = static_cast<int>(heights.size());
  const int at = static_cast<int>(highest - heights.begin());
  const int begin = std::clamp(at - kThrough / 2, 0, std::max(0, frames - kThrough));
  double most = *highest;
  for (int i = -kBetween + 1; frames >= kThrough && i < kBetween; ++i) {
    const double t = at - begin + static_cast<double>(i) / kBetween;
    if (t >= 0.0 && t <= kThrough - 1.0) most = std::max(most, throughFrames(&heights[begin], t));
  }
  return std::max(0.0, most);
}

}  // namespace

StepMeasure measureStep(const StepPrints& prints) {
  StepMeasure step;
  step.side = prints.side;
  step.at = prints.to.at;
  const Eigen::Vector3d d = prints.to.at - prints.other.at;
  const double cosine = std::cos(prints.along), sine = std::sin(prints.along);
  step.stride = d.x() * cosine + d.y() * sine;  // Shanbhag's thesis, eq. 6.8: S parallel
  // Who walks backwards has his left on the right of his way.
  const Eigen::Vector3d ahead =
      prints.to.ends.ball - prints.to.ends.heel + prints.other.ends.ball - prints.other.ends.heel;
  const bool backwards = ahead.x() * cosine + ahead.y() * sine < 0.0;
  const double left = (prints.side == kLeft) != backwards ? 1.0 : -1.0;
  step.width = (d.y() * cosine - d.x() * sine) * left;
  step.climb = d.z();  // eq. 6.8: S perpendicular
  if (!prints.swing.empty()) step.two_steps = (prints.to.at - prints.from.at).head<2>().norm();
  step.lift = highestOf(prints);
  return step;
}

double headingBetween(double other, double landing) {
  return other + 0.5 * wrapAngle(landing - other);
}

}  // namespace amble

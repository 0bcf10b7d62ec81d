#include "animation/body/step_prints.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/rotation.h"

namespace amble {
namespace {

// The most that the sole is lifted [m, >= 0], between frames as a parabola through the highest and
// those beside it has it: at 60 frames a second the highest frame of a quick short swing is lower
// by up to 2 %.
double highestOf(const StepPrints& prints) {
  std::vector<double> heights;
  for (const SoleEnds& sole : prints.swing)
    heights.push_back(heightOver(prints.from.ends, prints.to.ends, sole));
  const auto highest = std::ranges::max_element(heights);
  if (highest == heights.end()) return 0.0;
  double most = *highest;
  if (highest != heights.begin() && highest + 1 != heights.end()) {
    const double before = highest[-1], after = highest[1];
    const double bend = 2.0 * *highest - before - after;
    if (bend > 0.0) most += (after - before) * (after - before) / (8.0 * bend);
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

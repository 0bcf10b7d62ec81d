#include "animation/body/step_prints.h"

#include <algorithm>
#include <cmath>

#include "base/rotation.h"

namespace amble {

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
  for (const SoleEnds& sole : prints.swing) {
    step.lift = std::max(step.lift, heightOver(prints.from.ends, prints.to.ends, sole));
  }
  return step;
}

double headingBetween(double other, double landing) {
  return other + 0.5 * wrapAngle(landing - other);
}

}  // namespace amble

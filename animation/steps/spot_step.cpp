#include "animation/steps/spot_step.h"

#include <cmath>

namespace amble {

FootCycle spotStep(double scale) {
  // tau^4 (1 - tau)^4, halfway: the square of what swingPolynomial() multiplies by. Of a leg that
  // stands nearly straight the knee bends by the root of what its foot is lifted.
  constexpr double kHalfway = 1.0 / 256.0;
  FootCycle step;
  const double lift = SpotStep::kLift * scale / kHalfway;
  step.height = {0.0, 0.0, lift, -2.0 * lift, lift};
  step.pitch.assign(FootCycle::kStanceSamples + FootCycle::kSwingSamples, 0.0);
  for (int i = 0; i < FootCycle::kSwingSamples; ++i) {
    const double tau = static_cast<double>(i) / FootCycle::kSwingSamples;
    // tau^2 (1 - tau)^4, 1 where it is highest: at a third.
    const double bump = std::pow(3.0 * tau, 2) * std::pow(1.5 * (1.0 - tau), 4);
    step.pitch[FootCycle::kStanceSamples + i] = SpotStep::kPitch * bump;
  }
  return step;
}

}  // namespace amble

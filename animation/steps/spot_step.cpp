#include "animation/steps/spot_step.h"

#include <cmath>

namespace amble {

FootCycle spotStep(double scale) {
  constexpr double kWindow = 1.0 / 16.0;  // what swingPolynomial() multiplies by, halfway
  FootCycle step;
  step.height[0] = SpotStep::kLift * scale / kWindow;
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

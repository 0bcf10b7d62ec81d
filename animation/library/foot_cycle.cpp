#include "animation/library/foot_cycle.h"

#include <algorithm>
#include <cmath>

#include "base/ease.h"

namespace amble {

FootCycle meanFoot(const std::vector<FootCycle>& feet) {
  const double share = 1.0 / static_cast<double>(feet.size());
  const auto wrapped = [](double phase) { return phase - std::floor(phase); };
  FootCycle mean;
  mean.pitch.assign(feet.front().pitch.size(), 0.0);
  double strike = 0.0, lift_off = 0.0;  // beyond the first foot's
  for (const FootCycle& foot : feet) {
    strike += share * (wrapped(foot.strike - feet.front().strike + 0.5) - 0.5);
    lift_off += share * (wrapped(foot.lift_off - feet.front().lift_off + 0.5) - 0.5);
    mean.slip += share * foot.slip;
    for (size_t k = 0; k < foot.progress.size(); ++k) {
      mean.progress[k] += share * foot.progress[k];
      mean.height[k] += share * foot.height[k];
      mean.sideways[k] += share * foot.sideways[k];
      mean.roll[k] += share * foot.roll[k];
      mean.yaw[k] += share * foot.yaw[k];
    }
    for (size_t i = 0; i < mean.pitch.size(); ++i) mean.pitch[i] += share * foot.pitch[i];
    for (size_t k = 0; k < mean.toes.size(); ++k) mean.toes[k] += share * foot.toes[k];
  }
  mean.strike = wrapped(feet.front().strike + strike);
  mean.lift_off = wrapped(feet.front().lift_off + lift_off);
  return mean;
}

double swingProgress(const FootCycle& foot, double tau) {
  return smoothstep(tau) + swingPolynomial(foot.progress, tau);
}

double footPitch(const FootCycle& foot, double x) {
  constexpr int kStance = FootCycle::kStanceSamples, kSwing = FootCycle::kSwingSamples;
  constexpr int n = kStance + kSwing;
  const double at = x < 1.0 ? x * kStance : kStance + (x - 1.0) * kSwing;
  const int floor = static_cast<int>(at);
  const double t = at - floor;
  const auto p = [&](int k) {
    const int i = floor + k;
    return foot.pitch[static_cast<size_t>(i < 0 ? i + n : i < n ? i : i - n)];
  };
  // Catmull-Rom: through the samples, with a continuous slope.
  const double m0 = 0.5 * (p(1) - p(-1)), m1 = 0.5 * (p(2) - p(0));
  const double a = 2.0 * (p(0) - p(1)) + m0 + m1, b = 3.0 * (p(1) - p(0)) - 2.0 * m0 - m1;
  return p(0) + t * (m0 + t * (b + t * a));
}

double toeSpline(int k, double x) {
  static_assert(FootCycle::kStanceSamples == FootCycle::kSwingSamples);
  const double d = std::abs(x * FootCycle::kStanceSamples - FootCycle::kToesFrom - k);
  if (d >= 2.0) return 0.0;
  if (d >= 1.0) return std::pow(2.0 - d, 3) / 6.0;
  return 2.0 / 3.0 - d * d * (1.0 - 0.5 * d);
}

double toeRoll(const FootCycle& foot, double x) {
  const double u = x * FootCycle::kStanceSamples - FootCycle::kToesFrom;
  if (u <= -2.0 || u >= FootCycle::kToeSplines + 1) return 0.0;
  double roll = 0.0;
  const int before = static_cast<int>(std::floor(u));
  const double t = u - before, rest = 1.0 - t;
  // Of the four splines that reach here, as toeSpline has them.
  const std::array<double, 4> splines = {
      rest * rest * rest / 6.0, 2.0 / 3.0 - t * t * (1.0 - 0.5 * t),
      2.0 / 3.0 - rest * rest * (1.0 - 0.5 * rest), t * t * t / 6.0};
  for (int i = 0; i < 4; ++i) {
    const int k = before - 1 + i;
    if (k >= 0 && k < FootCycle::kToeSplines) roll += foot.toes[k] * splines[i];
  }
  return roll;
}

}  // namespace amble

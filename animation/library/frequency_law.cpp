#include "animation/library/frequency_law.h"

#include <cassert>
#include <cmath>

namespace amble {

double FrequencyLaw::operator()(double V) const {
  return factor * std::pow(V, power);  // Glardon eq. 4 and 6
}

FrequencyFit fitFrequencyLaw(std::span<const FrequencySample> samples) {
  assert(!samples.empty());
  const double n = static_cast<double>(samples.size());
  double x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
  for (const FrequencySample& sample : samples) {
    x += std::log(sample.normalised_speed) / n;
    y += std::log(sample.frequency) / n;
  }
  for (const FrequencySample& sample : samples) {
    const double dx = std::log(sample.normalised_speed) - x;
    xx += dx * dx / n;
    xy += dx * (std::log(sample.frequency) - y) / n;
  }
  FrequencyFit fit;
  fit.samples = static_cast<int>(samples.size());
  fit.own_power = fit.samples >= 3 && std::sqrt(xx) >= kSpeedSpread;
  fit.law.power = fit.own_power ? xy / xx : kInmanLaw.power;
  fit.law.factor = std::exp(y - fit.law.power * x);
  double squares = 0.0;
  for (const FrequencySample& sample : samples) {
    squares += std::pow(std::log(sample.frequency / fit.law(sample.normalised_speed)), 2) / n;
  }
  fit.residual = std::sqrt(squares);
  return fit;
}

double lawBias(const FrequencyLaw& law, std::span<const FrequencySample> samples) {
  double sum = 0.0;
  for (const FrequencySample& sample : samples) {
    sum += law(sample.normalised_speed) / sample.frequency - 1.0;
  }
  return samples.empty() ? 0.0 : sum / static_cast<double>(samples.size());
}

}  // namespace amble

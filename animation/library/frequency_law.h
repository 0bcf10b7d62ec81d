/// How the cycle's frequency goes with speed, for subjects of any size: f = a V^b, with V = v / leg
/// (Glardon, Boulic & Thalmann 2004, §4.2).
#pragma once

#include <span>

namespace amble {

/// f = factor V^power, cycles (two steps) a second.
struct FrequencyLaw {
  double factor = 0.743;  ///< [> 0]
  double power = 0.5;

  /// @param V  speed over leg length [1/s, >= 0] @return [Hz]
  double operator()(double V) const;
};

inline constexpr FrequencyLaw kInmanLaw = {0.743, 0.5};   ///< Glardon eq. 4
inline constexpr FrequencyLaw kGlardonLaw = {0.85, 0.4};  ///< Glardon eq. 6

/// A walk as measured.
struct FrequencySample {
  double normalised_speed = 0.0;  ///< V [1/s, > 0]
  double frequency = 0.0;         ///< of cycles [Hz, > 0]
};

/// A subject's own law and how far it is off.
struct FrequencyFit {
  FrequencyLaw law;
  bool own_power = false;  ///< the power was fitted; else it is Inman's, and only the factor ours
  double residual = 0.0;   ///< rms of ln f, about the relative error [1, >= 0]
  int samples = 0;         ///< [>= 1]
};

/// Least squares of ln f over ln V. The power is fitted only where the speeds spread: a standard
/// deviation of ln V of at least kSpeedSpread, over three walks or more.
/// @pre samples are not empty and positive
FrequencyFit fitFrequencyLaw(std::span<const FrequencySample> samples);

/// A tenth: walks at one speed say nothing of how frequency goes with it.
inline constexpr double kSpeedSpread = 0.1;

/// Mean relative error of a law over the walks, positive where the law is too high [1].
double lawBias(const FrequencyLaw& law, std::span<const FrequencySample> samples);

}  // namespace amble

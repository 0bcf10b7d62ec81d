/// A low-pass without delay, for positions sampled at a fixed rate.
///
/// Butterworth of second order run forwards and then backwards (Winter, Biomechanics and Motor
/// Control of Human Movement, 4th ed., §3.4.4): together of fourth order and without phase. The
/// cut-off is that of the two runs together (-3 dB). Both ends are continued by reflection through
/// the end point, so that a straight line stays a straight line.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace amble {

/// Above this share of the rate there is nothing left to pass.
inline constexpr double kLargestCutoff = 0.45;

/// @param rows  samples x channels: a row a sample
/// @param rate  samples a second [Hz, > 0]
/// @param cutoff  [Hz, > 0]; from kLargestCutoff of the rate on nothing is filtered
void lowPass(Eigen::MatrixXd& rows, double rate, double cutoff);

/// First derivative by central differences, one-sided at the ends: rows as above, a second [1/s].
/// Zero for a single row.
Eigen::MatrixXd derivative(const Eigen::MatrixXd& rows, double rate);

}  // namespace amble

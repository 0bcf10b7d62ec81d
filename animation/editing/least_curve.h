/// The least smooth curve through what is asked of it at some times, and one over what is missing:
/// how corrections of single frames are spread so that nothing jumps.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace amble {

/// The curve c that makes the sum over frames of
///   weight (c - wanted)^2 + c^2 + (width^3 c''')^2
/// least: where nothing is asked it goes back to nothing within ten widths, and it has no corner
/// anywhere. A weight of 1e10 holds a frame to a billionth of what the others pull.
/// @param wanted  a row a frame, a column a coordinate
/// @param weights  of the frames [>= 0]
/// @param width  [s, > 0]; frame time [s, > 0]
/// Exact, by a banded Cholesky decomposition: linear in the frames.
Eigen::MatrixXd leastCurve(const Eigen::MatrixXd& wanted, const std::vector<double>& weights,
                           double frame_time, double width);

/// The values averaged over `width` on both sides, nearer ones weighing more: positive ones stay
/// so. Beyond the ends the last value goes on.
std::vector<double> averaged(const std::vector<double>& values, double frame_time, double width);

/// A smooth curve that is nowhere below `missing` and nowhere above its largest value within two
/// widths: the largest within a width, averaged over a width. Nothing missing gives exactly
/// nothing.
/// @param missing  a value a frame [>= 0]; width, frame time [s, > 0]
std::vector<double> curveOver(const std::vector<double>& missing, double frame_time, double width);

}  // namespace amble

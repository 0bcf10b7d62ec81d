/// The curves of a swing, fitted to values at even times of it.
#pragma once

#include <vector>

#include "animation/body/foot_shape.h"
#include "animation/library/foot_cycle.h"

namespace amble {

inline constexpr int kSwingPoints = 33;  ///< at which a swing is fitted, both ends with them
/// Coefficients that progress and height are fitted with: feet go quickly at first.
inline constexpr int kProgressTerms = 4, kHeightTerms = 5;

/// Lowest point of heel and ball over the ground in a swing, of a sole so pitched [rad] and so high
/// [m].
double soleClearance(const FootShape& shape, double pitch, double height);
/// What that is at least, at tau of the swing [m, >= 0].
double swingClearance(double tau);

/// Least squares of what swingPolynomial makes of the terms to kSwingPoints values: progress beyond
/// smoothstep [1], and sideways, roll and yaw [m, rad].
SwingTerms fitProgress(const std::vector<double>& values);
SwingTerms fitStray(const std::vector<double>& values);
/// The height over a swing that `height` [m] comes nearest to and with which the sole, rolled by
/// foot.pitch, clears the ground: low-pass and marker noise let toes dip.
SwingTerms fitSwingHeight(const FootShape& shape, const FootCycle& foot,
                          std::vector<double> height);

}  // namespace amble

/// Sines, cosines and arc tangents of many numbers at once: as exact as the C library's, several
/// times as fast, and alike on every machine.
///
/// Ranges are cut down as in fdlibm (Sun Microsystems 1993) and Cephes (Moshier 1989), whose
/// polynomials these are; four numbers side by side, without a branch.
#pragma once

#include <Eigen/Geometry>
#include <span>

#include "base/rotation.h"

namespace amble {

/// Of angles [rad]. Errors are below 3e-16.
/// @pre all spans have one length
void sinesAndCosines(std::span<const double> angles, std::span<double> sines,
                     std::span<double> cosines);

/// atan2(y, x) of each, -pi to pi, for zeros with a sign too [rad]. Errors are below 6e-16.
/// @pre all spans have one length; every y and x is finite, of a size that is 0 or 1e-150 to 1e150
void arcTangents(std::span<const double> y, std::span<const double> x, std::span<double> angles);

/// fromEuler of base/rotation.h, from sines and cosines of half the angles.
Eigen::Quaterniond fromHalfEuler(const Eigen::Vector3d& sines, const Eigen::Vector3d& cosines,
                                 RotationOrder order);

}  // namespace amble

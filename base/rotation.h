/// Rotations: the exponential map, Euler angles of any order in closed form, headings.
#pragma once

#include <Eigen/Geometry>
#include <array>

namespace amble {

inline constexpr double kPi = 3.14159265358979323846;
inline constexpr double kDegree = kPi / 180.0;  ///< [rad]

/// Order of a joint's rotation channels as a file writes them: {'Z','X','Y'} is R = Rz * Rx * Ry.
using RotationOrder = std::array<char, 3>;

/// Rotation by |v| about v. Inverse of logRotation for |v| < pi.
Eigen::Quaterniond expRotation(const Eigen::Vector3d& v);
/// The rotation vector of q, |v| <= pi, on the shorter way.
Eigen::Vector3d logRotation(const Eigen::Quaterniond& q);

/// R = R_order[0](angles[0]) * R_order[1](angles[1]) * R_order[2](angles[2]) [rad].
Eigen::Quaterniond fromEuler(const Eigen::Vector3d& angles, RotationOrder order);
/// Closed form for each of the six orders, middle angle in [-pi/2, pi/2]. In gimbal lock the last
/// angle is 0.
Eigen::Vector3d toEuler(const Eigen::Quaterniond& q, RotationOrder order);
/// Of the triples that mean the same rotation (2 pi turns of each, and the other solution), the one
/// nearest to `previous`.
Eigen::Vector3d unwrapEuler(const Eigen::Vector3d& angles, const Eigen::Vector3d& previous);

/// The smallest turn of direction `from` to direction `to`, neither of them 0; of opposite ones,
/// about any axis across. Quaterniond::FromTwoVectors, to the bit where they are not opposite,
/// without the SVD that costs each file which has it eight seconds to compile.
Eigen::Quaterniond turnBetween(const Eigen::Vector3d& from, const Eigen::Vector3d& to);

/// Angle in (-pi, pi].
double wrapAngle(double angle);
/// Rotation by `heading` about World z.
Eigen::Quaterniond aboutZ(double heading);
/// +90 degrees about x: takes a y-up file's axes to World.
Eigen::Quaterniond yUpToWorld();

}  // namespace amble

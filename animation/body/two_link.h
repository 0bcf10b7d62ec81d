/// Inverse kinematics of a leg in its own hip-knee-ankle plane (Shanbhag's thesis, §6.3).
#pragma once

#include <Eigen/Geometry>
#include <optional>

namespace amble {

/// A bent chain of two rigid links, all in World [m].
struct TwoLink {
  Eigen::Vector3d hip;
  Eigen::Vector3d knee;
  Eigen::Vector3d ankle;
  /// Axis about which the knee flexes, right-handed: the thigh's left. The less the leg is bent
  /// about it, from 10 degrees on, the more it takes the plane's place. Need not be a unit vector.
  Eigen::Vector3d flexion_axis;
};

/// World rotations that bring the ankle to the target: new q_WThigh = thigh * q_WThigh, new
/// q_WShank = shank * q_WShank.
struct TwoLinkSolution {
  Eigen::Quaterniond thigh;
  Eigen::Quaterniond shank;
  double knee_flexion;  ///< angle between the links, 0 straight [rad, >= 0]
};

/// The knee flexes in the plane of hip, knee and ankle until the ankle is as far as the target,
/// then the whole leg turns on the shortest way to it; it flexes forward only. None where the
/// target is farther than both links together, or nearer than their difference.
std::optional<TwoLinkSolution> solveTwoLink(const TwoLink& leg, const Eigen::Vector3d& target);

}  // namespace amble

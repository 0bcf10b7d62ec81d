/// A captured leg put on another ankle (Shanbhag's thesis, §6.3), as little changed as can be.
///
/// The thesis takes the plane of hip, knee and ankle at each frame for the one in which the knee
/// bends; of a leg that is nearly straight that plane is noise. Here the knee bends about one axis
/// of its thigh over the whole clip, the mean of those planes' normals, from where the capture has
/// it: what a capture's knee turns out of that plane stays, and a leg whose ankle stays is given
/// back, however straight, or bent back, it is. body/two_link.h is for walks that are made: it puts
/// the knee into the plane.
#pragma once

#include <Eigen/Geometry>
#include <array>

#include "animation/body/clip.h"
#include "animation/body/joint_roles.h"

namespace amble {

/// Axes about which the knees flex, right-handed: the thighs' left. In the thighs' joint frames, by
/// Side [unit].
using KneeHinges = std::array<Eigen::Vector3d, 2>;
KneeHinges kneeHinges(const Clip& clip, const JointRoles& roles);

/// A leg as it was captured, in World [m].
struct CapturedLeg {
  Eigen::Vector3d hip, knee, ankle;
  Eigen::Vector3d hinge;  ///< [unit]

  double length() const { return (knee - hip).norm() + (ankle - knee).norm(); }
  double reach() const { return (ankle - hip).norm(); }
};

/// World rotations that bring the ankle to where it shall be: new q_WThigh = thigh * q_WThigh, new
/// q_WShank = shank * q_WShank.
struct LegChange {
  Eigen::Quaterniond thigh = Eigen::Quaterniond::Identity();
  Eigen::Quaterniond shank = Eigen::Quaterniond::Identity();
  double miss = 0.0;  ///< how far the ankle stays from there, where the leg is too short [m, >= 0]
};

/// The knee bends about its hinge, forward only, until hip and ankle are as far apart as asked;
/// then the whole leg turns on the shortest way. A knee that was captured bent back comes forward
/// over the first millimetres that the leg gets shorter.
/// @param hip, ankle  where they shall be [m, World]
LegChange changeLeg(const CapturedLeg& leg, const Eigen::Vector3d& hip,
                    const Eigen::Vector3d& ankle);

}  // namespace amble

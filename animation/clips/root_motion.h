/// The root's way from frame to frame, seen from where it was: what of two motions can be mixed
/// without a glide (Shanbhag's thesis, §3.3.1).
///
/// The root's place is its point on the ground and the heading of the pelvis. A step leads from a
/// frame's place to the next one's, seen from the first; what is left of the root is its carriage,
/// how high it is and how it is turned against the heading. Steps that are added up from a first
/// place give the motion back, wherever it begins and whichever way it faces.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "animation/body/clip.h"
#include "animation/body/joint_roles.h"

namespace amble {

/// Where the root is over the ground, and which way the pelvis faces.
struct RootPlace {
  Eigen::Vector2d at = Eigen::Vector2d::Zero();  ///< World [m]
  double heading = 0.0;                          ///< [rad], without jumps from frame to frame
};

/// From a frame to the next.
struct RootStep {
  Eigen::Vector2d way = Eigen::Vector2d::Zero();  ///< seen from the first: forward, left [m]
  double yaw = 0.0;                               ///< left positive [rad]
};

/// The root without its place.
struct RootCarriage {
  double height = 0.0;                                       ///< over z = 0 [m]
  Eigen::Quaterniond q_HR = Eigen::Quaterniond::Identity();  ///< root seen from the heading
};

/// Frames [first, last] of a clip.
struct RootMotion {
  std::vector<RootPlace> places;
  std::vector<RootCarriage> carriages;

  /// From place `i` to the next. @pre i + 1 < places.size()
  RootStep step(int i) const;
};

/// @pre 0 <= first <= last < frames. One forward kinematics a frame.
RootMotion rootMotion(const Clip& clip, const JointRoles& roles, int first, int last);

/// The place that a step leads to.
RootPlace advanced(const RootPlace& from, const RootStep& step);
/// (1 - weight) of the one and `weight` [0 to 1] of the other: ways and angles linearly, the
/// carriage's turn by slerp.
RootStep mixed(const RootStep& a, const RootStep& b, double weight);
RootCarriage mixed(const RootCarriage& a, const RootCarriage& b, double weight);

/// Puts the root of a frame so.
void placeRoot(PoseArray& poses, int frame, const RootPlace& place, const RootCarriage& carriage);

/// A turn about the vertical, then a shift along the ground: brings a motion from one place to
/// another.
struct GroundShift {
  double turn = 0.0;                                // [rad]
  Eigen::Vector2d shift = Eigen::Vector2d::Zero();  // [m]

  Eigen::Vector3d operator*(const Eigen::Vector3d& p) const;
  JointFrame operator*(const JointFrame& joint) const;
};
/// The one that takes `from` to `to`.
GroundShift between(const RootPlace& from, const RootPlace& to);
/// Frames [first, last] of a motion, moved so.
void moveRoot(PoseArray& poses, int first, int last, const GroundShift& by);

}  // namespace amble

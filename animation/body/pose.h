/// Poses, many of them in contiguous memory, and forward kinematics.
///
/// World is right-handed, z up, metres. A pose is the root's position in World and one unit
/// quaternion a joint: q_WR for the root (joint 0), q_PJ (joint in its parent) for the others.
#pragma once

#include <Eigen/Geometry>
#include <span>
#include <vector>

#include "animation/body/skeleton.h"

namespace amble {

/// A pose that somebody else owns.
struct PoseView {
  const Eigen::Vector3d& p_WR;                    ///< root in World [m]
  std::span<const Eigen::Quaterniond> rotations;  ///< one a joint: q_WR, then q_PJ
};

struct Pose {
  Eigen::Vector3d p_WR = Eigen::Vector3d::Zero();
  std::vector<Eigen::Quaterniond> rotations;

  operator PoseView() const { return {p_WR, rotations}; }  // NOLINT: a pose is a view of itself
};

/// Poses of one skeleton, frame after frame, without an allocation a frame.
class PoseArray {
 public:
  PoseArray() = default;
  explicit PoseArray(int joints) : joints_(joints) {}

  int joints() const { return joints_; }
  int size() const { return static_cast<int>(p_WR_.size()); }
  bool empty() const { return p_WR_.empty(); }
  PoseView operator[](int frame) const { return {p_WR_[frame], rotations(frame)}; }

  Eigen::Vector3d& p_WR(int frame) { return p_WR_[frame]; }
  const Eigen::Vector3d& p_WR(int frame) const { return p_WR_[frame]; }
  std::span<Eigen::Quaterniond> rotations(int frame) {
    return {q_.data() + static_cast<size_t>(frame) * joints_, static_cast<size_t>(joints_)};
  }
  std::span<const Eigen::Quaterniond> rotations(int frame) const {
    return {q_.data() + static_cast<size_t>(frame) * joints_, static_cast<size_t>(joints_)};
  }

  /// New frames are the identity at the origin; memory that is there is kept.
  void resize(int frames);
  void clear() { resize(0); }
  void append(PoseView pose);
  /// Frames [first, first + count) of `other` are appended. @pre same number of joints.
  void append(const PoseArray& other, int first, int count);

 private:
  int joints_ = 0;
  std::vector<Eigen::Vector3d> p_WR_;
  std::vector<Eigen::Quaterniond> q_;  // frame-major
};

/// Where a joint is: X_WJ as rotation and origin.
struct JointFrame {
  Eigen::Quaterniond q_WJ = Eigen::Quaterniond::Identity();
  Eigen::Vector3d p_WJ = Eigen::Vector3d::Zero();

  /// A point given in the joint's frame, in World.
  Eigen::Vector3d operator*(const Eigen::Vector3d& p_J) const { return q_WJ * p_J + p_WJ; }
};

/// X_WJ of every joint. Allocates nothing. @pre frames.size() == skeleton.size() ==
/// pose.rotations.size().
void forwardKinematics(const Skeleton& skeleton, PoseView pose, std::span<JointFrame> frames);
/// The same of some joints only, in ascending order; with each its parent is among them, and the
/// root is the first. The frames of others stay as they are.
void forwardKinematics(const Skeleton& skeleton, PoseView pose, std::span<const int> chain,
                       std::span<JointFrame> frames);
/// Such joints: these and all that they hang on.
std::vector<int> chainOf(const Skeleton& skeleton, std::span<const int> joints);

/// The pose that a player shows at `t` [0, 1] between two frames (DESIGN.md, section 3): the root
/// moves linearly, each joint turns by slerp on the shorter way. Written into `out` (p_WR and
/// rotations), which may be neither input.
void interpolatePose(PoseView a, PoseView b, double t, Pose& out);

/// A pose of a rig in which it is upright, seen from its heading (x forward, y left, z up).
struct ReferencePose {
  std::vector<Eigen::Quaterniond> q_HJ;  ///< of each joint in the heading frame
};

}  // namespace amble

/// A skeleton: a tree of joints with fixed offsets, as a capture file describes it.
///
/// Frames: a joint's frame is as the capture made it (usually y up in the rest pose); its offset is
/// its origin in the parent's frame. Only the root is placed in World (z up), see DESIGN.md,
/// section 2. Metres.
#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

#include "base/rotation.h"

namespace amble {

struct Joint {
  std::string name;
  int parent = -1;  ///< index of the parent; -1 for the root
  Eigen::Vector3d offset =
      Eigen::Vector3d::Zero();            ///< origin in the parent's frame [m]; 0 for the root
  RotationOrder order = {'Z', 'X', 'Y'};  ///< channels of the source file
  /// Tips of the bones that end here ("End Site"), in this joint's frame [m]. Usually none or one.
  std::vector<Eigen::Vector3d> end_sites;
};

/// Joints in the order of the file: joint 0 is the root and every parent precedes its children.
class Skeleton {
 public:
  Skeleton() = default;
  /// @throws std::invalid_argument if joints is empty, a parent does not precede its child, or a
  /// number is not finite.
  explicit Skeleton(std::vector<Joint> joints);

  int size() const { return static_cast<int>(joints_.size()); }
  const Joint& joint(int i) const { return joints_[i]; }
  const std::vector<Joint>& joints() const { return joints_; }
  /// Index of the joint of this very name, or -1.
  int find(std::string_view name) const;
  /// Whether joint `ancestor` lies on the way from `joint` to the root; a joint is its own
  /// ancestor.
  bool isAncestor(int ancestor, int joint) const;
  /// The same skeleton with every offset and end site times `factor` [> 0].
  Skeleton scaled(double factor) const;

 private:
  std::vector<Joint> joints_;
};

}  // namespace amble

/// The upper clip's turns as the base's skeleton makes them.
#pragma once

#include <vector>

#include "animation/grafting/locomotive_clip.h"

namespace amble {

struct UpperOnBase {
  /// In the upper clip's frames, of the base's skeleton: each joint in its parent. Those of joints
  /// that follow nothing mean nothing.
  PoseArray poses;
  std::vector<bool> follows;  ///< one value a joint of the base
  int first = 0, last = 0;    ///< frames of the upper clip's motion: no others are looked at

  /// At a time between frames: a cubic through the four about it, at a frame that frame to the bit.
  /// By slerp a clip of few frames a second would jerk at each. @param frame  [first, last]
  void at(double frame, const std::vector<int>& joints,
          std::span<Eigen::Quaterniond> rotations) const;
};

/// Skeletons of the same joints and bones: as they are, the thesis' "DOF signals". Others: by role
/// relative to reference poses, as carriedOver() has it (carry_over.h); joints without a role
/// (fingers, tails) by name, relative to the same poses; those without a counterpart follow
/// nothing unless joints that do hang on them. Lengths do not matter.
UpperOnBase upperOnBase(const LocomotiveClip& upper, const LocomotiveClip& base);

}  // namespace amble

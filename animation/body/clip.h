/// A clip: a skeleton and its poses at a fixed frame time, whatever file it came from.
#pragma once

#include <string>
#include <vector>

#include "animation/body/pose.h"
#include "animation/body/skeleton.h"

namespace amble {

struct Clip {
  std::string name;  ///< for messages: the file's name or what made it
  Skeleton skeleton;
  double frame_time = 1.0 / 30.0;  ///< [s, > 0]
  PoseArray poses;                 ///< World, z up, metres
  /// Where a file moves joints other than the root (position channels replace the OFFSET): the
  /// origin of every joint in its parent's frame, frame-major, frames * joints of them [m]. Empty
  /// in most clips.
  std::vector<Eigen::Vector3d> joint_positions;

  int frames() const { return poses.size(); }
  double duration() const { return frames() < 2 ? 0.0 : (frames() - 1) * frame_time; }
};

/// X_WJ of every joint at a frame, with the clip's moving joints if it has such.
void forwardKinematics(const Clip& clip, int frame, std::span<JointFrame> frames);

}  // namespace amble

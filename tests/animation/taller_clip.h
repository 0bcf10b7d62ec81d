/// A clip of somebody who is taller and moves alike.
#pragma once

#include "animation/body/clip.h"

namespace amble {

/// All lengths times `by`; every joint turns as it did.
inline Clip taller(const Clip& clip, double by) {
  Clip tall = clip;
  std::vector<Joint> joints = clip.skeleton.joints();
  for (Joint& joint : joints) {
    joint.offset *= by;
    for (Eigen::Vector3d& tip : joint.end_sites) tip *= by;
  }
  tall.skeleton = Skeleton(joints);
  for (int i = 0; i < clip.frames(); ++i) tall.poses.p_WR(i) *= by;
  for (Eigen::Vector3d& place : tall.joint_positions) place *= by;
  return tall;
}

}  // namespace amble

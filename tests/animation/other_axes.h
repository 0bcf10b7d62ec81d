/// A clip of a rig whose joints' axes lie otherwise.
#pragma once

#include <vector>

#include "animation/body/clip.h"

namespace amble {

/// Every rotation turned about its own axes by as much as the joint's, as a rig has it whose joints
/// lie otherwise: where joints are does not change.
inline Clip otherAxes(const Clip& clip, const std::vector<Eigen::Quaterniond>& q_JK) {
  Clip result = clip;
  std::vector<Joint> joints = clip.skeleton.joints();
  for (size_t j = 0; j < joints.size(); ++j) {
    const Eigen::Quaterniond own = q_JK[j].conjugate();
    if (joints[j].parent >= 0)
      joints[j].offset = q_JK[joints[j].parent].conjugate() * joints[j].offset;
    for (Eigen::Vector3d& tip : joints[j].end_sites) tip = own * tip;
  }
  result.skeleton = Skeleton(joints);
  for (int i = 0; i < clip.frames(); ++i) {
    for (size_t j = 0; j < joints.size(); ++j) {
      Eigen::Quaterniond& q = result.poses.rotations(i)[j];
      if (joints[j].parent >= 0) q = q_JK[joints[j].parent].conjugate() * q;
      q = q * q_JK[j];
    }
  }
  return result;
}

}  // namespace amble

#include "animation/body/clip.h"

#include <cassert>

namespace amble {

void forwardKinematics(const Clip& clip, int frame, std::span<JointFrame> frames) {
  assert(frame >= 0 && frame < clip.frames());
  const PoseView pose = clip.poses[frame];
  if (clip.joint_positions.empty()) return forwardKinematics(clip.skeleton, pose, frames);
  const size_t joints = clip.skeleton.size();
  assert(clip.joint_positions.size() == joints * clip.frames() && frames.size() == joints);
  const Eigen::Vector3d* p_PJ = clip.joint_positions.data() + joints * frame;
  frames[0] = {pose.rotations[0], pose.p_WR};
  for (size_t j = 1; j < joints; ++j) {
    const JointFrame& parent = frames[clip.skeleton.joint(static_cast<int>(j)).parent];
    frames[j].p_WJ = parent * p_PJ[j];
    frames[j].q_WJ = parent.q_WJ * pose.rotations[j];
  }
}

}  // namespace amble

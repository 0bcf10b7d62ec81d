#include "animation/captures/root_at_hips.h"

#include <vector>

#include "animation/captures/capture_file.h"

namespace amble {
namespace {

/// Whether the hips, or what they hang on below the root, move in their parents.
bool movesAbove(const Clip& clip, int hips) {
  const size_t joints = clip.skeleton.size();
  for (int j = hips; j > 0; j = clip.skeleton.joint(j).parent) {
    for (size_t at = j + joints; at < clip.joint_positions.size(); at += joints) {
      const Eigen::Vector3d moved = clip.joint_positions[at] - clip.joint_positions[j];
      if (moved.cwiseAbs().maxCoeff() > kFixedOffsetTolerance) return true;
    }
  }
  return false;
}

/// The joints that hang on `top`, itself first, and the new index of each joint or -1.
struct Branch {
  std::vector<int> joints, index;

  Branch(const Skeleton& skeleton, int top) : index(skeleton.size(), -1) {
    for (int j = top; j < skeleton.size(); ++j) {
      const int parent = skeleton.joint(j).parent;
      if (j != top && (parent < 0 || index[parent] < 0)) continue;
      index[j] = static_cast<int>(joints.size());
      joints.push_back(j);
    }
  }

  Skeleton skeletonOf(const Skeleton& whole) const {
    std::vector<Joint> kept;
    for (const int j : joints) {
      kept.push_back(whole.joint(j));
      kept.back().parent = kept.size() == 1 ? -1 : index[whole.joint(j).parent];
    }
    kept[0].offset.setZero();
    return Skeleton(std::move(kept));
  }
};

}  // namespace

bool rootAtHips(Clip& clip, JointRoles& roles) {
  const int hips = roles.hips;
  if (hips <= 0 || !movesAbove(clip, hips)) return false;
  const Branch branch(clip.skeleton, hips);
  const int joints = static_cast<int>(branch.joints.size());
  Clip rooted{clip.name, branch.skeletonOf(clip.skeleton), clip.frame_time, PoseArray(joints), {}};
  rooted.poses.resize(clip.frames());
  std::vector<JointFrame> frames(clip.skeleton.size());
  for (int i = 0; i < clip.frames(); ++i) {
    forwardKinematics(clip, i, frames);
    const auto from = clip.poses.rotations(i);
    const auto to = rooted.poses.rotations(i);
    const size_t row = static_cast<size_t>(i) * clip.skeleton.size();
    for (int j = 0; j < joints; ++j) {
      to[j] = from[branch.joints[j]];
      rooted.joint_positions.push_back(clip.joint_positions[row + branch.joints[j]]);
    }
    to[0] = frames[hips].q_WJ;
    rooted.poses.p_WR(i) = frames[hips].p_WJ;
    rooted.joint_positions[static_cast<size_t>(i) * joints].setZero();
  }
  clip = std::move(rooted);
  for (const std::string& role : roleNames()) {
    const int joint = roleJoint(roles, role);
    if (joint >= 0) setRole(roles, role, branch.index[joint]);
  }
  return true;
}

}  // namespace amble

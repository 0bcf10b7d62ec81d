#include "animation/body/pose.h"

#include <algorithm>
#include <cassert>

namespace amble {

void PoseArray::resize(int frames) {
  assert(frames >= 0);
  p_WR_.resize(frames, Eigen::Vector3d::Zero());
  q_.resize(static_cast<size_t>(frames) * joints_, Eigen::Quaterniond::Identity());
}

void PoseArray::append(PoseView pose) {
  assert(static_cast<int>(pose.rotations.size()) == joints_);
  // `pose` may be one of our own frames, which growing would move: copy what is there before
  // letting go of it.
  const Eigen::Vector3d p_WR = pose.p_WR;
  const bool own = !q_.empty() && pose.rotations.data() >= q_.data() &&
                   pose.rotations.data() < q_.data() + q_.size();
  const ptrdiff_t offset = own ? pose.rotations.data() - q_.data() : 0;
  const size_t begin = q_.size();
  q_.resize(begin + joints_);
  const Eigen::Quaterniond* source = own ? q_.data() + offset : pose.rotations.data();
  std::copy(source, source + joints_, q_.data() + begin);
  p_WR_.push_back(p_WR);
}

void PoseArray::append(const PoseArray& other, int first, int count) {
  assert(other.joints_ == joints_ && first >= 0 && count >= 0 && first + count <= other.size());
  // By index: `other` may be this array.
  const size_t joints = joints_, begin = q_.size();
  p_WR_.reserve(p_WR_.size() + count);
  for (int i = 0; i < count; ++i) p_WR_.push_back(other.p_WR_[first + i]);
  q_.resize(begin + joints * count);
  const Eigen::Quaterniond* source = other.q_.data() + joints * first;
  std::copy(source, source + joints * count, q_.data() + begin);
}

namespace {

// X_WJ of a joint, given that of its parent.
inline JointFrame placed(const Joint& joint, const Eigen::Quaterniond& turn,
                         const JointFrame& parent) {
  return {parent.q_WJ * turn, parent * joint.offset};
}

}  // namespace

void forwardKinematics(const Skeleton& skeleton, PoseView pose, std::span<JointFrame> frames) {
  assert(static_cast<int>(frames.size()) == skeleton.size() &&
         frames.size() == pose.rotations.size());
  const std::vector<Joint>& joints = skeleton.joints();
  if (joints.empty()) return;
  frames[0] = {pose.rotations[0], pose.p_WR};
  for (size_t j = 1; j < joints.size(); ++j)
    frames[j] = placed(joints[j], pose.rotations[j], frames[joints[j].parent]);
}

void forwardKinematics(const Skeleton& skeleton, PoseView pose, std::span<const int> chain,
                       std::span<JointFrame> frames) {
  assert(static_cast<int>(frames.size()) == skeleton.size() && !chain.empty() && chain[0] == 0);
  const std::vector<Joint>& joints = skeleton.joints();
  frames[0] = {pose.rotations[0], pose.p_WR};
  for (const int j : chain.subspan(1))
    frames[j] = placed(joints[j], pose.rotations[j], frames[joints[j].parent]);
}

std::vector<int> chainOf(const Skeleton& skeleton, std::span<const int> joints) {
  std::vector<bool> wanted(skeleton.size(), false);
  for (int j : joints)
    for (; j >= 0; j = skeleton.joint(j).parent) wanted[j] = true;
  std::vector<int> chain;
  for (int j = 0; j < skeleton.size(); ++j)
    if (wanted[j]) chain.push_back(j);
  return chain;
}

void interpolatePose(PoseView a, PoseView b, double t, Pose& out) {
  assert(a.rotations.size() == b.rotations.size());
  out.p_WR = (1.0 - t) * a.p_WR + t * b.p_WR;
  out.rotations.resize(a.rotations.size());
  // Eigen's slerp takes the shorter way of q and -q.
  for (size_t j = 0; j < a.rotations.size(); ++j)
    out.rotations[j] = a.rotations[j].slerp(t, b.rotations[j]);
}

}  // namespace amble

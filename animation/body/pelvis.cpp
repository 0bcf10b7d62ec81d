#include "animation/body/pelvis.h"

#include <cmath>

#include "base/rotation.h"

namespace amble {

double pelvisHeading(std::span<const JointFrame> joints, const JointRoles& roles) {
  const Eigen::Vector3d left =
      joints[roles.legs[kLeft].up_leg].p_WJ - joints[roles.legs[kRight].up_leg].p_WJ;
  return std::atan2(-left.x(), left.y());
}

std::vector<double> pelvisHeadings(const Clip& clip, const JointRoles& roles) {
  std::vector<JointFrame> joints(clip.skeleton.size());
  std::vector<double> headings;
  headings.reserve(clip.frames());
  for (int i = 0; i < clip.frames(); ++i) {
    forwardKinematics(clip, i, joints);
    const double heading = pelvisHeading(joints, roles);
    headings.push_back(i == 0 ? heading : headings.back() + wrapAngle(heading - headings.back()));
  }
  return headings;
}

std::vector<Eigen::Vector3d> pelvisPath(const Clip& clip, const JointRoles& roles) {
  std::vector<JointFrame> joints(clip.skeleton.size());
  std::vector<Eigen::Vector3d> path;
  path.reserve(clip.frames());
  for (int i = 0; i < clip.frames(); ++i) {
    forwardKinematics(clip, i, joints);
    path.push_back(
        0.5 * (joints[roles.legs[kLeft].up_leg].p_WJ + joints[roles.legs[kRight].up_leg].p_WJ));
  }
  return path;
}

}  // namespace amble

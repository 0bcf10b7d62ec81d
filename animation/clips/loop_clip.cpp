#include "animation/clips/loop_clip.h"

#include <cmath>

#include "animation/body/pelvis.h"
#include "base/rotation.h"

namespace amble {

double poseGap(std::span<const JointFrame> a, std::span<const JointFrame> b,
               const JointRoles& roles) {
  const auto seen = [&](std::span<const JointFrame> joints) {
    const Eigen::Quaterniond back = aboutZ(-pelvisHeading(joints, roles));
    const Eigen::Vector3d& root = joints[0].p_WJ;
    std::vector<Eigen::Vector3d> places;
    for (const JointFrame& j : joints) {
      places.push_back(back *
                       Eigen::Vector3d(j.p_WJ.x() - root.x(), j.p_WJ.y() - root.y(), j.p_WJ.z()));
    }
    return places;
  };
  const auto from = seen(a), to = seen(b);
  double squares = 0.0;
  for (size_t i = 0; i < from.size(); ++i) squares += (from[i] - to[i]).squaredNorm();
  return std::sqrt(squares / static_cast<double>(from.size()));
}

std::optional<Clip> repeatedLoop(const Clip& clip, const JointRoles& roles, int times) {
  const int last = clip.frames() - 1;
  if (last < 1) return std::nullopt;
  std::vector<JointFrame> begin(clip.skeleton.size()), end(clip.skeleton.size());
  forwardKinematics(clip, 0, begin);
  forwardKinematics(clip, last, end);
  if (poseGap(begin, end, roles) > kLoopGap) return std::nullopt;
  const Eigen::Quaterniond turn =
      aboutZ(wrapAngle(pelvisHeading(end, roles) - pelvisHeading(begin, roles)));
  const Eigen::Vector3d first_root = clip.poses.p_WR(0);
  Clip loop = clip;
  Eigen::Quaterniond turned = Eigen::Quaterniond::Identity();
  for (int i = 1; i < times; ++i) {
    turned = (turned * turn).normalized();
    Eigen::Vector3d from = loop.poses.p_WR(loop.frames() - 1);
    from.z() = first_root.z();         // loops keep to their floor
    const int at = loop.frames() - 1;  // where the first frame would be again
    loop.poses.append(clip.poses, 1, last);
    if (!clip.joint_positions.empty()) {
      loop.joint_positions.insert(loop.joint_positions.end(),
                                  clip.joint_positions.begin() + clip.skeleton.size(),
                                  clip.joint_positions.end());
    }
    for (int k = 1; k <= last; ++k) {
      loop.poses.p_WR(at + k) = from + turned * (clip.poses.p_WR(k) - first_root);
      loop.poses.rotations(at + k)[0] = turned * clip.poses.rotations(k)[0];
    }
  }
  return loop;
}

}  // namespace amble

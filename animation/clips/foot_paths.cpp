#include "animation/clips/foot_paths.h"

#include <vector>

namespace amble {
namespace {

Eigen::Vector3d toePoint(const Clip& clip, const LegJoints& leg,
                         std::span<const JointFrame> joints) {
  if (leg.toe >= 0) return joints[leg.toe].p_WJ;
  const std::vector<Eigen::Vector3d>& tips = clip.skeleton.joint(leg.foot).end_sites;
  return tips.empty() ? joints[leg.foot].p_WJ : joints[leg.foot] * tips[0];
}

}  // namespace

FootPaths footPaths(const Clip& clip, const JointRoles& roles) {
  FootPaths paths;
  for (Eigen::MatrixXd& path : paths) path.resize(clip.frames(), 6);
  std::vector<JointFrame> joints(clip.skeleton.size());
  for (int i = 0; i < clip.frames(); ++i) {
    forwardKinematics(clip, i, joints);
    for (const Side side : {kLeft, kRight}) {
      const LegJoints& leg = roles.legs[side];
      paths[side].row(i) << joints[leg.foot].p_WJ.transpose(),
          toePoint(clip, leg, joints).transpose();
    }
  }
  return paths;
}

bool stands(const Eigen::MatrixXd& path, Eigen::Index frame, double leg, double frame_time) {
  constexpr double kStandingSpeed = 0.3;  // [leg lengths a second]
  const double slow = kStandingSpeed * leg * 2.0 * frame_time, limit = slow * slow;
  const auto way = path.row(frame + 1) - path.row(frame - 1);
  return way.head<3>().squaredNorm() < limit && way.tail<3>().squaredNorm() < limit;
}

std::array<double, 2> legLengths(const Clip& clip, const JointRoles& roles) {
  return {roles.legLength(clip.skeleton, kLeft), roles.legLength(clip.skeleton, kRight)};
}

}  // namespace amble

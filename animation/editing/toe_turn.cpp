#include "animation/editing/toe_turn.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "base/rotation.h"

namespace amble {

std::vector<Eigen::Vector3d> toeAxes(const std::vector<Eigen::Vector3d>& bones,
                                     const std::vector<Eigen::Quaterniond>& q_WF) {
  assert(bones.size() == q_WF.size());
  Eigen::Vector3d across_F = Eigen::Vector3d::Zero();
  for (size_t i = 0; i < bones.size(); ++i) {
    across_F += q_WF[i].conjugate() * bones[i].cross(Eigen::Vector3d::UnitZ());
  }
  std::vector<Eigen::Vector3d> axes;
  for (const Eigen::Quaterniond& q : q_WF) {
    const Eigen::Vector3d across = q * across_F;
    axes.emplace_back(Eigen::Vector3d(across.x(), across.y(), 0.0).normalized());
  }
  return axes;
}

double turnUp(const Eigen::Vector3d& bone, const Eigen::Vector3d& axis, double higher) {
  // Turned by an angle its tip is at: most cos(angle - highest).
  const double across = axis.cross(bone).z(), most = std::hypot(bone.z(), across);
  if (!(most > 0.0)) return 0.0;
  double highest = std::atan2(across, bone.z());
  if (highest < -0.5 * kPi) highest += 2.0 * kPi;  // toes that are bent under come up forward
  const double cosine = std::clamp((bone.z() + higher) / most, -1.0, 1.0);
  return std::max(0.0, highest - std::acos(cosine));
}

}  // namespace amble

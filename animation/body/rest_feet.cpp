#include "animation/body/rest_feet.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "animation/body/foot_shape.h"

namespace amble {

double restFootDrop(const Skeleton& skeleton, const JointRoles& roles) {
  double most = 0.0;
  for (const LegJoints& leg : roles.legs) {
    const Eigen::Vector3d down =
        (skeleton.joint(leg.leg).offset + skeleton.joint(leg.foot).offset).normalized();
    const Eigen::Vector3d toe = skeleton.joint(leg.toe).offset.normalized();
    most = std::max(most, std::asin(std::clamp(toe.dot(down), 0.0, 1.0)));
  }
  return most;
}

std::array<double, 2> footDrops(const Skeleton& skeleton, const JointRoles& roles) {
  const Eigen::Quaterniond q_HR = restToPelvisHeading(skeleton, roles);
  std::array<double, 2> drops;
  for (const Side side : {kLeft, kRight}) {
    const Eigen::Vector3d bone = q_HR * skeleton.joint(roles.legs[side].toe).offset;
    drops[side] = std::atan2(-bone.z(), bone.head<2>().norm());
  }
  return drops;
}

Skeleton withFootDrops(const Skeleton& skeleton, const JointRoles& roles,
                       const std::array<double, 2>& drops) {
  const Eigen::Vector3d up =
      restToPelvisHeading(skeleton, roles).conjugate() * Eigen::Vector3d::UnitZ();
  const std::array<double, 2> now = footDrops(skeleton, roles);
  std::vector<Joint> joints = skeleton.joints();
  for (const Side side : {kLeft, kRight}) {
    const LegJoints& leg = roles.legs[side];
    const Eigen::AngleAxisd turn(drops[side] - now[side],
                                 up.cross(joints[leg.toe].offset).normalized());
    for (Joint& joint : joints) {
      if (joint.parent == leg.foot) joint.offset = turn * joint.offset;
    }
    for (Eigen::Vector3d& tip : joints[leg.foot].end_sites) tip = turn * tip;
  }
  return Skeleton(std::move(joints));
}

}  // namespace amble

#include "animation/body/rest_feet.h"

#include <algorithm>
#include <cmath>

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

}  // namespace amble

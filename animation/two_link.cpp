#include "animation/two_link.h"

#include <algorithm>
#include <cmath>

namespace amble {
namespace {

// Below this sine of the angle between the links their plane is noise, and the flexion axis is used [1].
constexpr double kStraight = 1e-6;

// Unit normal of the leg's plane, on the flexion axis' side.
Eigen::Vector3d planeNormal(const TwoLink& leg, const Eigen::Vector3d& thigh,
                            const Eigen::Vector3d& shank) {
  const Eigen::Vector3d normal = thigh.cross(shank);
  if (normal.norm() > kStraight * thigh.norm() * shank.norm()) {
    return normal.dot(leg.flexion_axis) >= 0.0 ? normal.normalized() : (-normal).normalized();
  }
  const Eigen::Vector3d along = thigh.normalized();
  const Eigen::Vector3d axis = leg.flexion_axis - leg.flexion_axis.dot(along) * along;
  return axis.normalized();
}

}  // namespace

std::optional<TwoLinkSolution> solveTwoLink(const TwoLink& leg, const Eigen::Vector3d& target) {
  const Eigen::Vector3d thigh = leg.knee - leg.hip, shank = leg.ankle - leg.knee;
  const double a = thigh.norm(), b = shank.norm();
  const Eigen::Vector3d reach = target - leg.hip;
  const double distance = reach.norm();
  if (!(distance <= a + b) || !(distance >= std::abs(a - b)) || !(distance > 0.0)) {
    return std::nullopt;
  }
  // Signed flexion of the leg as it is, and the one that puts the ankle at the right distance.
  const Eigen::Vector3d normal = planeNormal(leg, thigh, shank);
  const double now = std::atan2(thigh.cross(shank).dot(normal), thigh.dot(shank));
  const double cosine = (distance * distance - a * a - b * b) / (2.0 * a * b);
  const double flexion = std::acos(std::clamp(cosine, -1.0, 1.0));

  const Eigen::Quaterniond bend(Eigen::AngleAxisd(flexion - now, normal));
  const Eigen::Vector3d bent = thigh + bend * shank;
  TwoLinkSolution solution;
  solution.thigh = Eigen::Quaterniond::FromTwoVectors(bent, reach);
  solution.shank = solution.thigh * bend;
  solution.knee_flexion = flexion;
  return solution;
}

}  // namespace amble

#include "animation/body/two_link.h"

#include <algorithm>
#include <cmath>

namespace amble {
namespace {

// Sine of the flexion about the axis below which the plane of hip, knee and ankle is more and more
// noise, and the axis takes over: 10 degrees.
constexpr double kNearlyStraight = 0.17;

// Unit normal of the leg's plane, at right angles to the thigh, on the flexion axis' side. What is
// added keeps its share along the axis above zero however the leg is bent, sideways and backwards
// too, so that the knee never changes sides at once.
Eigen::Vector3d planeNormal(const TwoLink& leg, const Eigen::Vector3d& thigh,
                            const Eigen::Vector3d& shank) {
  const Eigen::Vector3d normal = thigh.cross(shank);
  const Eigen::Vector3d axis =
      (leg.flexion_axis - leg.flexion_axis.dot(thigh) * thigh).normalized();
  const double straight = std::max(0.0, 1.0 - normal.dot(axis) / kNearlyStraight);
  return (normal + kNearlyStraight * straight * straight * axis).normalized();
}

}  // namespace

std::optional<TwoLinkSolution> solveTwoLink(const TwoLink& leg, const Eigen::Vector3d& target) {
  const double a = (leg.knee - leg.hip).norm(), b = (leg.ankle - leg.knee).norm();
  const Eigen::Vector3d reach = target - leg.hip;
  const double distance = reach.norm();
  if (!(distance <= a + b) || !(distance >= std::abs(a - b)) || !(distance > 0.0)) {
    return std::nullopt;
  }
  const Eigen::Vector3d thigh = (leg.knee - leg.hip) / a, shank = (leg.ankle - leg.knee) / b;
  const Eigen::Vector3d normal = planeNormal(leg, thigh, shank);
  // The flexion that puts the ankle at the right distance, then the leg as a whole towards the
  // target.
  const double cosine = (distance * distance - a * a - b * b) / (2.0 * a * b);
  const double flexion = std::acos(std::clamp(cosine, -1.0, 1.0));
  const Eigen::Vector3d bent = std::cos(flexion) * thigh + std::sin(flexion) * normal.cross(thigh);

  TwoLinkSolution solution;
  solution.thigh = Eigen::Quaterniond::FromTwoVectors(a * thigh + b * bent, reach);
  solution.shank = solution.thigh * Eigen::Quaterniond::FromTwoVectors(shank, bent);
  solution.knee_flexion = flexion;
  return solution;
}

}  // namespace amble

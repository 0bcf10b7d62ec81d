#include "environments/body/motion_bound.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace amble {
namespace {

// The angle between two rotations, on the shorter way: |a - b| = 2 sin(angle / 4). No less than it
// is.
double angleBetween(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b) {
  const double minus = (a.coeffs() - b.coeffs()).squaredNorm();
  const double plus = (a.coeffs() + b.coeffs()).squaredNorm();
  const double x = 0.5 * std::sqrt(std::min(minus, plus));
  // asin(x) <= x (1 + 0.19 x^2) up to x = 1/2, an angle of 120 degrees: its series has 1/6, 3/40,
  // ...
  return 4.0 * (x < 0.5 ? x * (1.0 + 0.19 * x * x) : std::asin(std::min(1.0, x)));
}

}  // namespace

MotionBound::MotionBound(const Skeleton& skeleton, const Body& body) {
  for (const Joint& joint : skeleton.joints()) {
    parent_.push_back(joint.parent);
    offset_.push_back(joint.offset.norm());
  }
  for (size_t i = 0; i < body.parts.size(); ++i) {
    const BodyPart& part = body.parts[i];
    const int first = static_cast<int>(levers_.size());
    for (int j = part.joint; j >= 0; j = parent_[j])
      levers_.push_back({j, body.reach[i][j] - part.radius});
    parts_.push_back({part.joint, std::max(part.from.norm(), part.to.norm()), first,
                      static_cast<int>(levers_.size()) - first});
  }
}

void MotionBound::compute(PoseView a, PoseView b, std::span<PartMotion> motions,
                          std::span<double> angles, std::span<double> sums) const {
  assert(motions.size() == parts_.size() && angles.size() == parent_.size());
  assert(sums.size() == 2 * parent_.size());
  const size_t joints = parent_.size();
  const double root = (b.p_WR - a.p_WR).norm();
  double* turned = sums.data();         // theta_1 + ... + theta_j along the way from the root
  double* bent = sums.data() + joints;  // A of the joint's origin
  for (size_t j = 0; j < joints; ++j) {
    angles[j] = angleBetween(a.rotations[j], b.rotations[j]);
    const int parent = parent_[j];
    turned[j] = angles[j] + (parent < 0 ? 0.0 : turned[parent]);
    bent[j] = parent < 0 ? 0.0 : bent[parent] + offset_[j] * turned[parent] * turned[parent];
  }
  for (size_t i = 0; i < parts_.size(); ++i) {
    const Part& part = parts_[i];
    double path = root;
    for (int k = 0; k < part.levers; ++k) {
      const Lever& lever = levers_[part.first_lever + k];
      path += angles[lever.joint] * lever.reach;
    }
    const double turn = turned[part.joint];
    motions[i] = {path, 0.125 * (bent[part.joint] + part.length * turn * turn)};
  }
}

}  // namespace amble

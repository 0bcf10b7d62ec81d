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
  for (const Joint& joint : skeleton.joints())
    links_.push_back({joint.parent, joint.offset.norm()});
  for (const BodyPart& part : body.parts)
    parts_.push_back({part.joint, std::max(part.from.norm(), part.to.norm())});
}

void MotionBound::compute(PoseView a, PoseView b, std::span<PartMotion> motions,
                          std::span<Turned> turned) const {
  assert(motions.size() == parts_.size() && turned.size() == links_.size());
  turned[0] = {angleBetween(a.rotations[0], b.rotations[0]), (b.p_WR - a.p_WR).norm(), 0.0};
  for (size_t j = 1; j < links_.size(); ++j) {
    const Turned& above = turned[links_[j].parent];
    const double arc = links_[j].offset * above.angle;
    turned[j] = {above.angle + angleBetween(a.rotations[j], b.rotations[j]), above.path + arc,
                 above.second + arc * above.angle};
  }
  for (size_t i = 0; i < parts_.size(); ++i) {
    const Turned& joint = turned[parts_[i].joint];
    const double arc = parts_[i].length * joint.angle;
    motions[i] = {joint.path + arc, 0.125 * (joint.second + arc * joint.angle)};
  }
}

}  // namespace amble

/// The mean of rotations that lie near each other, as the poses of a held posture do.
#pragma once

#include <Eigen/Geometry>

namespace amble {

/// Near means within 90 degrees of their mean. Their mean is then the sum of their quaternions,
/// each with the sign that it has on that side.
class RotationMean {
 public:
  void add(const Eigen::Quaterniond& q) {
    sum_ += q.coeffs().dot(sum_) < 0.0 ? Eigen::Vector4d(-q.coeffs()) : q.coeffs();
  }
  bool empty() const { return sum_.isZero(); }
  /// @pre not empty
  Eigen::Quaterniond mean() const { return Eigen::Quaterniond(Eigen::Vector4d(sum_.normalized())); }

 private:
  Eigen::Vector4d sum_ = Eigen::Vector4d::Zero();
};

}  // namespace amble

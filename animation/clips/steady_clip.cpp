#include "animation/clips/steady_clip.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace amble {
namespace {

constexpr double kReach = 3.0;  // beyond so many deviations a weight is nothing [1]

std::vector<double> halfOfBell(double deviation) {
  std::vector<double> weights;
  const int reach = static_cast<int>(std::ceil(kReach * deviation));
  for (int k = 0; k <= reach; ++k)
    weights.push_back(std::exp(-0.5 * k * k / (deviation * deviation)));
  return weights;
}

}  // namespace

Clip steadied(const Clip& clip, double width) {
  const std::vector<double> weights = halfOfBell(width / clip.frame_time);
  const int reach = static_cast<int>(weights.size()) - 1;
  Clip steady = clip;
  for (int i = 0; i < clip.frames(); ++i) {
    const std::span<const Eigen::Quaterniond> here = clip.poses.rotations(i);
    for (size_t j = 0; j < here.size(); ++j) {
      Eigen::Vector4d sum = Eigen::Vector4d::Zero();
      for (int k = std::max(0, i - reach); k <= std::min(clip.frames() - 1, i + reach); ++k) {
        const Eigen::Vector4d q = clip.poses.rotations(k)[j].coeffs();
        const double sign = q.dot(here[j].coeffs()) < 0.0 ? -1.0 : 1.0;
        sum += sign * weights[std::abs(k - i)] * q;
      }
      steady.poses.rotations(i)[j].coeffs() = sum.normalized();
    }
  }
  return steady;
}

}  // namespace amble

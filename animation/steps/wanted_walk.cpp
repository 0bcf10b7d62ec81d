#include "animation/steps/wanted_walk.h"

#include <algorithm>
#include <cmath>

#include "base/parts.h"

namespace amble {

WantedWalk::WantedWalk(const RootPath& path, const Stance& from, const Stance& to,
                       const SpeedLimits& limits, double step) {
  const StrideLaw& law = limits.law;
  const double length = path.length(), half = 0.5 * std::min(step, length);
  const int count = partsOf(length, kSpacing);
  spacing_ = length / count;
  const BesideStanding beside(law, from.standing, to.standing);
  // Most points are as fast as the one before.
  double of_speed = limits.speed, own_step = law.stepLength(of_speed);
  for (int i = 0; i <= count; ++i) {
    const double arc = i * spacing_;
    const double begin = std::clamp(arc - half, 0.0, length - half),
                 end = std::clamp(arc + half, half, length);
    const double curvature = (path.at(end).heading - path.at(begin).heading) / (end - begin);
    double speed = limits.pace ? limits.speed * limits.pace(arc) : limits.speed;
    speed = std::min(speed, beside.fastest(arc, length - arc));
    speed = std::min(speed, limits.max_turn_rate / std::max(std::abs(curvature), 1e-9));
    if (speed != of_speed) own_step = law.stepLength(of_speed = speed);
    const double rate = curvature * speed;
    points_.push_back({speed, rate, law.turnedShare(rate) * own_step});
  }
}

double WantedWalk::at(double arc, double Point::*value) const {
  const double place = std::clamp(arc / spacing_, 0.0, static_cast<double>(points_.size() - 1));
  const size_t i = std::min(static_cast<size_t>(place), points_.size() - 2);
  const double a = points_[i].*value, b = points_[i + 1].*value;
  return a + (place - static_cast<double>(i)) * (b - a);
}

}  // namespace amble

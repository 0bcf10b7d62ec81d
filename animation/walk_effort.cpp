#include "animation/walk_effort.h"

#include <algorithm>
#include <cmath>

namespace amble {

double effortOf(const GaitParameters& step, double captured_lift) {
  constexpr double kLevel = 2.5;                          // [J/kg/m]
  constexpr double kGravity = 9.81;                       // [m/s^2]
  constexpr double kConcentric = 0.25, kEccentric = 1.2;  // efficiencies of work done and absorbed
  constexpr double kLeg = 0.161;                          // of the body's mass
  const double work = kGravity * step.climb;
  const double climbing = work > 0.0 ? work / kConcentric : -work / kEccentric;
  const double lifting = kLeg * kGravity * std::max(0.0, step.lift - captured_lift) / kConcentric;
  return kLevel * std::abs(step.stride) + climbing + lifting;
}

}  // namespace amble

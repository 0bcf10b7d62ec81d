#include "planner/steering/walk_effort.h"

#include <algorithm>

namespace amble {
namespace {

// Metres of level walking that cost as much as one of height.
constexpr double kClimb = 19.6 / 2.5;
constexpr double kRaise = 6.3 / 2.5;
// Lifts differ by so much from step to step without anything to step over [m].
constexpr double kUsualLift = 0.01;

}  // namespace

double effortOf(const AnimationBuffer& walk, double captured_lift, double speed) {
  double metres = 0.0;
  for (const Footprint& print : walk.footprints) {
    metres += kClimb * std::max(0.0, print.gait.climb);
    const double lift = print.gait.lift - captured_lift;
    if (lift > kUsualLift) metres += kRaise * lift;
  }
  return metres / speed;
}

}  // namespace amble

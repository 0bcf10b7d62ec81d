#include "planner/steering/walk_effort.h"

#include <algorithm>

namespace amble {
namespace {

// Metres of level walking that cost as much as one of height.
constexpr double kClimb = 19.6 / 2.5;
constexpr double kRaise = 6.3 / 2.5;
// Lifts differ by so much from step to step without anything to step over [m].
constexpr double kUsualLift = 0.01;

// Adds what a step costs, as metres of level walking.
void addStep(const GaitParameters& step, double captured_lift, double& metres) {
  metres += kClimb * std::max(0.0, step.climb);
  const double lift = step.lift - captured_lift;
  if (lift > kUsualLift) metres += kRaise * lift;
}

}  // namespace

double effortOf(const AnimationBuffer& walk, double captured_lift, double speed) {
  double metres = 0.0;
  for (const Footprint& print : walk.footprints) addStep(print.gait, captured_lift, metres);
  return metres / speed;
}

double effortOf(std::span<const GaitParameters> steps, double captured_lift, double speed) {
  double metres = 0.0;
  for (const GaitParameters& step : steps) addStep(step, captured_lift, metres);
  return metres / speed;
}

}  // namespace amble

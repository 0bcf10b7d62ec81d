#include "planner/steering/walk_effort.h"

#include <algorithm>
#include <cmath>

namespace amble {
namespace {

// Metres of level walking that cost as much as one of height.
constexpr double kClimb = 19.6 / 2.5;
constexpr double kRaise = 6.3 / 2.5;
// Of hips, up and down: on level ground, and on most stairs, none accelerate by more than 5
// [m/s^2].
constexpr double kSmooth = 8.0;
constexpr double kJolt = 0.25;  // for each time that once more [s]; by trial
// Lifts differ by so much from step to step without anything to step over [m].
constexpr double kUsualLift = 0.01;

// Adds what a step costs, as metres of level walking.
void addStep(const GaitParameters& step, double captured_lift, double& metres) {
  metres += kClimb * std::max(0.0, step.climb);
  const double lift = step.lift - captured_lift;
  if (lift > kUsualLift) metres += kRaise * lift;
}

// The most by which hips accelerate up or down [m/s^2, >= 0].
double largestJolt(const AnimationBuffer& walk) {
  double most = 0.0;
  const auto height = [&](int frame) { return walk.poses.p_WR(frame).z(); };
  for (int i = 1; i + 1 < walk.size(); ++i)
    most = std::max(most, std::abs(height(i + 1) - 2.0 * height(i) + height(i - 1)));
  return most / (walk.frame_time * walk.frame_time);
}

}  // namespace

double effortOf(const AnimationBuffer& walk, double captured_lift, double speed) {
  double metres = 0.0;
  for (const Footprint& print : walk.footprints) addStep(print.gait, captured_lift, metres);
  const double jolt = kJolt * std::max(0.0, largestJolt(walk) / kSmooth - 1.0);
  return metres / speed + jolt;
}

double effortOf(std::span<const GaitParameters> steps, double captured_lift, double speed) {
  double metres = 0.0;
  for (const GaitParameters& step : steps) addStep(step, captured_lift, metres);
  return metres / speed;
}

}  // namespace amble

#include "planner/steering/steering.h"

namespace amble {

void SteeringCount::add(const SteerResult& result) {
  ++asked;
  poses += result.poses;
  if (!result.edge) add(result.failure);
}

void SteeringCount::add(const SteeringCount& other) {
  for (const auto& [rule, count] : other.refusals) refusals[rule] += count;
  poses += other.poses;
  asked += other.asked;
}

}  // namespace amble

#include "planner/steering/steering.h"

namespace amble {

SteeringStage stageOf(WalkRule rule) {
  switch (rule) {
    case WalkRule::kNone:
    case WalkRule::kNoCurve:
    case WalkRule::kDisconnected:
    case WalkRule::kBounds:
      return SteeringStage::kRootPath;
    case WalkRule::kStepLength:
    case WalkRule::kTurnRate:
      return SteeringStage::kLimits;
    case WalkRule::kContact:
      return SteeringStage::kValidation;
    default:
      return SteeringStage::kAnimation;
  }
}

void SteeringCount::add(const SteerResult& result) {
  ++asked;
  poses += result.poses;
  if (!result.edge && !result.too_dear && !result.leads_nowhere) add(result.failure);
}

void SteeringCount::add(const SteeringCount& other) {
  for (const auto& [rule, count] : other.refusals) refusals[rule] += count;
  poses += other.poses;
  asked += other.asked;
}

}  // namespace amble

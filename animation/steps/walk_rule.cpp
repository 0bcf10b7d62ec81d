#include "animation/steps/walk_rule.h"

namespace amble {

std::string_view walkRuleName(WalkRule rule) {
  switch (rule) {
    case WalkRule::kNone:
      return "none";
    case WalkRule::kNoCurve:
      return "no_curve";
    case WalkRule::kDisconnected:
      return "disconnected";
    case WalkRule::kBounds:
      return "bounds";
    case WalkRule::kContact:
      return "contact";
    case WalkRule::kStepLength:
      return "step_length";
    case WalkRule::kTurnRate:
      return "turn_rate";
    case WalkRule::kReach:
      return "reach";
    case WalkRule::kNoGround:
      return "no_ground";
    case WalkRule::kFoothold:
      return "foothold";
    case WalkRule::kSlope:
      return "slope";
    case WalkRule::kStepHeight:
      return "step_height";
  }
  return "none";
}

}  // namespace amble

#include "animation/grafting/graft_rules.h"

namespace amble {
namespace {

struct Rule {
  const char* number;
  const char* permits;  // for people
  bool on[4];           // stand, walk, run, jump
};

// By the upper body's type, in the same order.
constexpr Rule kRules[4] = {
    {"1", "standing goes on all", {true, true, true, true}},
    {"2", "walking goes on walks and runs", {false, true, true, false}},
    {"3", "running goes on walks and runs", {false, true, true, false}},
    {"4", "jumping goes on jumps only", {false, false, false, true}},
};

int indexOf(MotionType type) {
  switch (type) {
    case MotionType::kStand:
      return 0;
    case MotionType::kWalk:
      return 1;
    case MotionType::kRun:
      return 2;
    case MotionType::kJump:
      return 3;
    case MotionType::kUnknown:
    case MotionType::kOther:
      break;
  }
  return -1;
}

}  // namespace

std::string graftRefusal(MotionType upper, MotionType base) {
  const int above = indexOf(upper), below = indexOf(base);
  if (above < 0 || below < 0) {
    return "only one stand, walk, run or jump is grafted on another (thesis 5.1.5)";
  }
  const Rule& rule = kRules[above];
  if (rule.on[below]) return "";
  return std::string(motionTypeName(upper)) + " on " + std::string(motionTypeName(base)) +
         " is not permitted: " + rule.permits + " (thesis 5.4.2, rule " + rule.number + ")";
}

}  // namespace amble

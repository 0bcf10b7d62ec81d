#include "animation/grafting/graft_rules.h"

#include <gtest/gtest.h>

#include <set>

namespace amble {
namespace {

// §5.4.2, as the thesis has it: upper body motion set, lower body motion sets.
TEST(GraftRules, PermitTheNineOfSixteenPairsOfTheThesis) {
  using enum MotionType;
  const std::set<std::pair<MotionType, MotionType>> permitted = {
      {kStand, kStand}, {kStand, kWalk}, {kStand, kRun}, {kStand, kJump}, {kWalk, kWalk},
      {kWalk, kRun},    {kRun, kWalk},   {kRun, kRun},   {kJump, kJump}};
  for (const MotionType upper : {kStand, kWalk, kRun, kJump}) {
    for (const MotionType base : {kStand, kWalk, kRun, kJump}) {
      const std::string refusal = graftRefusal(upper, base);
      EXPECT_EQ(refusal.empty(), permitted.contains({upper, base})) << refusal;
      if (refusal.empty()) continue;
      const int rule = 1 + static_cast<int>(upper) - static_cast<int>(kStand);
      EXPECT_NE(refusal.find("rule " + std::to_string(rule)), std::string::npos) << refusal;
      EXPECT_EQ(refusal.find('\n'), std::string::npos);
    }
    EXPECT_NE(graftRefusal(upper, kOther).find("5.1.5"), std::string::npos);
    EXPECT_NE(graftRefusal(kUnknown, upper).find("5.1.5"), std::string::npos);
  }
}

}  // namespace
}  // namespace amble

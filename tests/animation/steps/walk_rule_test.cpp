#include "animation/steps/walk_rule.h"

#include <gtest/gtest.h>

#include <set>

namespace amble {
namespace {

TEST(WalkRule, EveryRuleHasANameOfItsOwn) {
  std::set<std::string_view> names;
  for (int i = 0; i <= kWalkRules - 1; ++i) {
    const std::string_view name = walkRuleName(static_cast<WalkRule>(i));
    EXPECT_TRUE(names.insert(name).second) << name;
    EXPECT_EQ(name.find_first_not_of("abcdefghijklmnopqrstuvwxyz_"), std::string_view::npos);
    EXPECT_EQ(name == "none", i == 0);
  }
}

TEST(WalkRule, ReportsCountTheSameNamesAsEver) {
  EXPECT_EQ(walkRuleName(WalkRule::kStepLength), "step_length");
  EXPECT_EQ(walkRuleName(WalkRule::kTurnRate), "turn_rate");
  EXPECT_EQ(walkRuleName(WalkRule::kReach), "reach");
  EXPECT_EQ(walkRuleName(WalkRule::kNoGround), "no_ground");
  EXPECT_EQ(walkRuleName(WalkRule::kFoothold), "foothold");
  EXPECT_EQ(walkRuleName(WalkRule::kSlope), "slope");
  EXPECT_EQ(walkRuleName(WalkRule::kStepHeight), "step_height");
  EXPECT_EQ(walkRuleName(WalkRule::kBounds), "bounds");
}

}  // namespace
}  // namespace amble

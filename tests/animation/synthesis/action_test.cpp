#include "animation/synthesis/action.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "tests/animation/default_library.h"

namespace amble {
namespace {

TEST(Action, WhatIsNoMovementOrPostureIsNone) {
  EXPECT_EQ(findAction(defaultLibrary(), "nobody"), nullptr);
  EXPECT_EQ(findAction(defaultLibrary(), "walk-slow"), nullptr);
  EXPECT_EQ(findAction(defaultLibrary(), "start"), nullptr);
  EXPECT_THROW(makeAction(defaultLibrary(), "walk-slow"), std::invalid_argument);
}

TEST(Action, WhatIsValidForAPartOfAWalkOnlyIsNone) {
  MotionLibrary other = defaultLibrary();
  for (Motion& motion : other.motions) {
    if (motion.name == "carry") motion.valid.when = Validity::When::kAtStart;
  }
  EXPECT_NE(findAction(defaultLibrary(), "carry"), nullptr);
  EXPECT_EQ(findAction(other, "carry"), nullptr);
  EXPECT_THROW(makeAction(other, "carry"), std::invalid_argument);
  EXPECT_EQ(listActions(other).find("carry"), std::string::npos);
}

TEST(Action, EveryNameThatIsListedIsFound) {
  const std::string names = listActions(defaultLibrary());
  for (const Motion& motion : defaultLibrary().motions) {
    EXPECT_EQ(names.find(" " + motion.name) != std::string::npos,
              findAction(defaultLibrary(), motion.name) != nullptr)
        << motion.name;
  }
}

TEST(Action, WithoutChainsEverythingButHipsAndLegsIsMoved) {
  Motion motion;
  const std::vector<int> moved = movedJoints(defaultLibrary(), motion);
  const auto isMoved = [&](int joint) {
    return std::find(moved.begin(), moved.end(), joint) != moved.end();
  };
  EXPECT_FALSE(isMoved(defaultLibrary().roles.hips));
  for (const LegJoints& leg : defaultLibrary().roles.legs) {
    for (const int joint : {leg.up_leg, leg.leg, leg.foot, leg.toe}) EXPECT_FALSE(isMoved(joint));
  }
  for (const ArmJoints& arm : defaultLibrary().roles.arms) EXPECT_TRUE(isMoved(arm.arm));
  EXPECT_TRUE(isMoved(defaultLibrary().roles.chest));
  EXPECT_TRUE(isMoved(defaultLibrary().roles.head));
  motion.chains = {"left_arm"};
  EXPECT_EQ(movedJoints(defaultLibrary(), motion),
            chainJoints(defaultLibrary().skeleton, defaultLibrary().roles, "left_arm"));
}

}  // namespace
}  // namespace amble

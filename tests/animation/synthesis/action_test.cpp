#include "animation/synthesis/action.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "animation/library/motion_library_reader.h"

namespace amble {
namespace {

const MotionLibrary& library() {
  static const MotionLibrary kLibrary = openMotionLibrary("default");
  return kLibrary;
}

TEST(Action, WhatIsNoMovementOrPostureIsNone) {
  EXPECT_EQ(findAction(library(), "nobody"), nullptr);
  EXPECT_EQ(findAction(library(), "walk-slow"), nullptr);
  EXPECT_EQ(findAction(library(), "start"), nullptr);
  EXPECT_THROW(makeAction(library(), "walk-slow"), std::invalid_argument);
}

TEST(Action, WhatIsValidForAPartOfAWalkOnlyIsNone) {
  MotionLibrary other = library();
  for (Motion& motion : other.motions) {
    if (motion.name == "carry") motion.valid.when = Validity::When::kAtStart;
  }
  EXPECT_NE(findAction(library(), "carry"), nullptr);
  EXPECT_EQ(findAction(other, "carry"), nullptr);
  EXPECT_THROW(makeAction(other, "carry"), std::invalid_argument);
  EXPECT_EQ(listActions(other).find("carry"), std::string::npos);
}

TEST(Action, EveryNameThatIsListedIsFound) {
  const std::string names = listActions(library());
  for (const Motion& motion : library().motions) {
    EXPECT_EQ(names.find(" " + motion.name) != std::string::npos,
              findAction(library(), motion.name) != nullptr)
        << motion.name;
  }
}

TEST(Action, WithoutChainsEverythingButHipsAndLegsIsMoved) {
  Motion motion;
  const std::vector<int> moved = movedJoints(library(), motion);
  const auto isMoved = [&](int joint) {
    return std::find(moved.begin(), moved.end(), joint) != moved.end();
  };
  EXPECT_FALSE(isMoved(library().roles.hips));
  for (const LegJoints& leg : library().roles.legs) {
    for (const int joint : {leg.up_leg, leg.leg, leg.foot, leg.toe}) EXPECT_FALSE(isMoved(joint));
  }
  for (const ArmJoints& arm : library().roles.arms) EXPECT_TRUE(isMoved(arm.arm));
  EXPECT_TRUE(isMoved(library().roles.chest));
  EXPECT_TRUE(isMoved(library().roles.head));
  motion.chains = {"left_arm"};
  EXPECT_EQ(movedJoints(library(), motion),
            chainJoints(library().skeleton, library().roles, "left_arm"));
}

}  // namespace
}  // namespace amble

#include "animation/library/motion_library.h"

#include <gtest/gtest.h>

#include <set>

#include "animation/body/foot_shape.h"
#include "tests/animation/default_library.h"

namespace amble {
namespace {

TEST(MotionLibrary, LacksAStandThenAStraightWalkThenNothing) {
  MotionLibrary made;
  EXPECT_NE(whatItLacks(made).problem.find("stand"), std::string::npos);
  Motion stand;
  stand.name = "stand";  // a walk of that name is no posture
  made.motions = {stand};
  EXPECT_NE(whatItLacks(made).problem.find("stand"), std::string::npos);
  made.motions[0].kind = MotionKind::kPosture;
  Motion walk;
  walk.turning = true;
  made.motions.push_back(walk);
  EXPECT_NE(whatItLacks(made).problem.find("straight walk"), std::string::npos);
  made.motions.back().turning = false;
  EXPECT_TRUE(whatItLacks(made).problem.empty());
}

TEST(MotionLibrary, FindsEveryMotionByItsNameAndNoOther) {
  for (const Motion& motion : defaultLibrary().motions) {
    ASSERT_NE(defaultLibrary().find(motion.name), nullptr);
    EXPECT_EQ(defaultLibrary().find(motion.name)->name, motion.name);
  }
  EXPECT_EQ(defaultLibrary().find(""), nullptr);
  EXPECT_EQ(defaultLibrary().find("Stand"), nullptr);
}

// Actions are laid over each other by chain, and feet are the steps'.
TEST(MotionLibrary, ChainsShareNoJointAndHaveNoneOfTheLegs) {
  std::set<int> legs;
  for (const LegJoints& leg : defaultLibrary().roles.legs) {
    for (int j = 0; j < defaultLibrary().skeleton.size(); ++j) {
      if (defaultLibrary().skeleton.isAncestor(leg.up_leg, j)) legs.insert(j);
    }
  }
  std::set<int> seen;
  for (const std::string& chain : chainNames()) {
    const std::vector<int> joints =
        chainJoints(defaultLibrary().skeleton, defaultLibrary().roles, chain);
    EXPECT_FALSE(joints.empty()) << chain;
    for (const int j : joints) {
      EXPECT_TRUE(seen.insert(j).second) << chain << " and " << j;
      EXPECT_FALSE(legs.contains(j)) << chain;
      EXPECT_NE(j, defaultLibrary().roles.hips) << chain;
    }
  }
}

TEST(MotionLibrary, AChainThatTheRigHasNotIsEmpty) {
  EXPECT_TRUE(chainJoints(defaultLibrary().skeleton, defaultLibrary().roles, "tail").empty());
  JointRoles roles = defaultLibrary().roles;
  roles.neck = roles.head = roles.spine = -1;
  EXPECT_TRUE(chainJoints(defaultLibrary().skeleton, roles, "head").empty());
  EXPECT_TRUE(chainJoints(defaultLibrary().skeleton, roles, "trunk").empty());
}

TEST(MotionLibrary, ItsFeetAreAPersonsFeet) {
  for (const FootShape& foot : defaultLibrary().feet()) {
    const double length = foot.tip_x + foot.radius - (foot.heel_x - foot.radius);
    EXPECT_NEAR(length, kFootLengthOfStature * defaultLibrary().stature,
                0.02 * defaultLibrary().stature);
    EXPECT_GT(foot.ankle_height, foot.radius);
  }
}

}  // namespace
}  // namespace amble

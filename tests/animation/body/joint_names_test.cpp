#include "animation/body/joint_names.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tests/animation/person.h"

namespace amble {
namespace {

TEST(JointNames, AreTheSkeletonsOwnWhereNoNamingIsAsked) {
  const Skeleton skeleton = walkingPerson().skeleton;
  const std::vector<std::string> names =
      jointNames(skeleton, guessJointRoles(skeleton, "person"), "");
  for (int j = 0; j < skeleton.size(); ++j) EXPECT_EQ(names[j], skeleton.joint(j).name);
}

// What other tools find by them we find as well.
TEST(JointNames, EveryNamingGivesEveryJointItsRoleAgain) {
  const Skeleton skeleton = walkingPerson().skeleton;
  const JointRoles roles = guessJointRoles(skeleton, "person");
  for (const std::string& naming : jointNamings()) {
    const JointRoles again =
        guessJointRoles(renamed(skeleton, jointNames(skeleton, roles, naming)), naming);
    for (const std::string& role : roleNames())
      EXPECT_EQ(roleJoint(again, role), roleJoint(roles, role)) << naming << ' ' << role;
  }
}

TEST(JointNames, JointsWithoutARoleKeepTheirsAndAllStayDifferent) {
  std::vector<Joint> joints = walkingPerson().skeleton.joints();
  const int known = static_cast<int>(joints.size());
  for (const char* name : {"Tail", "pelvis", "head", "thigh_l"}) {  // two of them are Unreal's
    Joint joint;
    joint.name = name;
    joint.parent = 0;
    joints.push_back(joint);
  }
  const Skeleton skeleton(joints);
  const JointRoles roles = guessJointRoles(walkingPerson().skeleton, "person");
  const std::vector<std::string> names = jointNames(skeleton, roles, "unreal");
  EXPECT_EQ(names[known], "Tail");
  EXPECT_EQ(names[roles.hips], "pelvis");
  EXPECT_EQ(names[known + 1], "pelvis_2");
  EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), names.size());
}

TEST(JointNames, ASkeletonThatIsNobodysKeepsItsNames) {
  Joint root;
  root.name = "Cart";
  const Skeleton cart({root});
  JointRoles nobody;
  nobody.hips = -1;
  for (const std::string& naming : jointNamings())
    EXPECT_EQ(jointNames(cart, nobody, naming), std::vector<std::string>{"Cart"});
}

}  // namespace
}  // namespace amble

#include "animation/grafting/kinematic_chains.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "animation/captures/role_guess.h"
#include "base/error.h"
#include "tests/animation/grafting/graft_sources.h"

namespace amble {
namespace {

// Joints as "name parent", in order.
Skeleton treeOf(const std::vector<std::pair<std::string, std::string>>& tree) {
  std::vector<Joint> joints;
  for (const auto& [name, parent] : tree) {
    Joint joint;
    joint.name = name;
    joint.offset = Eigen::Vector3d(0.0, 0.1, 0.0);
    for (size_t i = 0; i < joints.size(); ++i) {
      if (joints[i].name == parent) joint.parent = static_cast<int>(i);
    }
    if (parent.empty()) joint.offset.setZero();
    joints.push_back(joint);
  }
  return Skeleton(std::move(joints));
}

// Figure 5.1 of the thesis, as CMU's skeletons are.
Skeleton figure51() {
  return treeOf({{"root", ""},
                 {"lhipjoint", "root"},
                 {"lfemur", "lhipjoint"},
                 {"ltibia", "lfemur"},
                 {"lfoot", "ltibia"},
                 {"ltoes", "lfoot"},
                 {"rhipjoint", "root"},
                 {"rfemur", "rhipjoint"},
                 {"rtibia", "rfemur"},
                 {"rfoot", "rtibia"},
                 {"rtoes", "rfoot"},
                 {"lowerback", "root"},
                 {"upperback", "lowerback"},
                 {"thorax", "upperback"},
                 {"lowerneck", "thorax"},
                 {"upperneck", "lowerneck"},
                 {"head", "upperneck"},
                 {"lclavicle", "thorax"},
                 {"lhumerus", "lclavicle"},
                 {"lradius", "lhumerus"},
                 {"lwrist", "lradius"},
                 {"rclavicle", "thorax"},
                 {"rhumerus", "rclavicle"},
                 {"rradius", "rhumerus"},
                 {"rwrist", "rradius"}});
}

std::vector<std::string> namesOf(const std::vector<KinematicChain>& chains) {
  std::vector<std::string> names;
  for (const KinematicChain& chain : chains) names.push_back(chain.name);
  return names;
}

std::vector<std::string> jointsOf(const Skeleton& skeleton, const std::vector<int>& joints) {
  std::vector<std::string> names;
  for (const int j : joints) names.push_back(skeleton.joint(j).name);
  return names;
}

TEST(KinematicChains, OfTheThesisFigureAreItsSixAndTheRoot) {
  const Skeleton skeleton = figure51();
  const auto chains = kinematicChains(skeleton, guessJointRoles(skeleton, "figure"));
  EXPECT_EQ(namesOf(chains), (std::vector<std::string>{"root", "left_leg", "right_leg", "trunk",
                                                       "head", "left_arm", "right_arm"}));
  EXPECT_EQ(jointsOf(skeleton, chains[5].joints),
            (std::vector<std::string>{"lclavicle", "lhumerus", "lradius", "lwrist"}));
  EXPECT_EQ(skeleton.joint(chains[5].hangs_on).name, "thorax");
}

TEST(KinematicChains, HoldEveryJointOfEveryCaptureOnceWithItsParentsBeforeIt) {
  AMBLE_NEEDS_CAPTURES();
  std::set<std::string> folders;
  for (const Capture& capture : captures()) {
    if (!folders.insert(capture.path.substr(0, capture.path.find('/'))).second) continue;
    CapturedMotion motion = readMotion(capture.file);
    const Skeleton& skeleton = motion.clip.skeleton;
    std::vector<int> times(skeleton.size(), 0);
    const auto chains = kinematicChains(skeleton, motion.roles);
    for (const KinematicChain& chain : chains) {
      for (size_t i = 0; i < chain.joints.size(); ++i) {
        ++times[chain.joints[i]];
        const int above = i == 0 ? chain.hangs_on : chain.joints[i - 1];
        EXPECT_EQ(skeleton.joint(chain.joints[i]).parent, above);
      }
    }
    EXPECT_EQ(times, std::vector<int>(skeleton.size(), 1)) << capture.path;
    for (const char* const limb :
         {"root", "left_leg", "right_leg", "left_arm", "right_arm", "head"}) {
      const auto names = namesOf(chains);
      EXPECT_EQ(std::count(names.begin(), names.end(), limb), 1) << capture.path << " " << limb;
    }
  }
}

// Twist bones, fingers, a tail, and a root above the hips.
Skeleton odd() {
  return treeOf({{"Armature", ""},
                 {"Hips", "Armature"},
                 {"Tail1", "Hips"},
                 {"Tail2", "Tail1"},
                 {"LeftUpLeg", "Hips"},
                 {"LeftLeg", "LeftUpLeg"},
                 {"LeftFoot", "LeftLeg"},
                 {"RightUpLeg", "Hips"},
                 {"RightLeg", "RightUpLeg"},
                 {"RightFoot", "RightLeg"},
                 {"Spine", "Hips"},
                 {"Spine1", "Spine"},
                 {"Neck", "Spine1"},
                 {"Head", "Neck"},
                 {"LeftEye", "Head"},
                 {"RightEye", "Head"},
                 {"LeftArm", "Spine1"},
                 {"LeftArmTwist", "LeftArm"},
                 {"LeftForeArm", "LeftArm"},
                 {"LeftHand", "LeftForeArm"},
                 {"LeftHandThumb1", "LeftHand"},
                 {"LeftHandIndex1", "LeftHand"},
                 {"RightArm", "Spine1"},
                 {"RightForeArm", "RightArm"},
                 {"RightHand", "RightForeArm"}});
}

TEST(KinematicChains, AnArmHasItsFingersAndTwistBonesAndATailIsItsOwn) {
  const Skeleton skeleton = odd();
  const JointRoles roles = guessJointRoles(skeleton, "odd");
  EXPECT_EQ(jointsOf(skeleton, graftedJoints(skeleton, roles, {"left_arm"}, "odd")),
            (std::vector<std::string>{"LeftArm", "LeftArmTwist", "LeftForeArm", "LeftHand",
                                      "LeftHandThumb1", "LeftHandIndex1"}));
  EXPECT_EQ(jointsOf(skeleton, graftedJoints(skeleton, roles, {"Tail1"}, "odd")),
            (std::vector<std::string>{"Tail1", "Tail2"}));
  EXPECT_EQ(jointsOf(skeleton, graftedJoints(skeleton, roles, {"LeftHandThumb1", "head"}, "odd")),
            (std::vector<std::string>{"Neck", "Head", "LeftEye", "RightEye", "LeftHandThumb1"}));
  const std::vector<int> upper = graftedJoints(skeleton, roles, {"upper"}, "odd");
  const std::vector<bool> lower = lowerBody(skeleton, roles);
  EXPECT_EQ(static_cast<int>(upper.size()) + std::count(lower.begin(), lower.end(), true),
            skeleton.size());
  EXPECT_TRUE(lower[skeleton.find("Armature")] && lower[skeleton.find("LeftFoot")]);
  EXPECT_FALSE(lower[skeleton.find("Tail1")] || lower[skeleton.find("Spine")]);
}

TEST(KinematicChains, TheLowerBodyAndUnknownNamesAreRefused) {
  const Skeleton skeleton = odd();
  const JointRoles roles = guessJointRoles(skeleton, "odd");
  for (const char* const name : {"left_leg", "root", "arm", ""}) {
    EXPECT_THROW(graftedJoints(skeleton, roles, {name}, "odd"), InputError) << name;
  }
}

}  // namespace
}  // namespace amble

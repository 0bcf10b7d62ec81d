// What must hold for any rig, tried on a walk of each that the shared folder has: neither names,
// nor unit, axes or format of a file change the motion or whose joint is whose.

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <sstream>

#include "animation/captures/motion_guesses.h"
#include "animation/captures/motion_reader.h"
#include "animation/captures/role_guess.h"
#include "animation/captures/role_tree.h"
#include "animation/clips/good_frames.h"
#include "base/rotation.h"
#include "tests/animation/captures.h"
#include "tests/animation/node_files.h"
#include "tests/animation/person.h"
#include "tests/animation/random_clip.h"

namespace amble {
namespace {

struct RigWalk {
  std::string path;
  Clip clip;  // its first seconds that are a motion
  JointRoles roles;
};

const std::vector<RigWalk>& rigs() {
  static const std::vector<RigWalk> kRigs = [] {
    std::vector<RigWalk> all;
    for (const char* const path :
         {"accad_female1/Female1_B03_Walk1.bvh", "accad_male1/Male1_B3_Walk.bvh",
          "cmu_asfamc/07_05-walk.amc", "cmu_daz/07_01.bvh", "cmu_max/131_01.bvh",
          "cmu_max/scaled_131_01.bvh", "cmu_mb2/07_01.bvh", "cmu_style_loops/142_08_EDIT_LOOP.bvh",
          "formats/mass_walk.bvh"}) {
      const CapturedMotion motion = readMotion(sharedFolder() / "mocap" / path);
      const GoodFrames good = goodFrames(motion.clip);
      const Clip clip = trimmed(motion.clip, good.first, std::min(good.last, good.first + 240));
      all.push_back({path, clip, motion.roles});
    }
    return all;
  }();
  return kRigs;
}

void expectSameRoles(const JointRoles& roles, const JointRoles& wanted, const std::string& rig) {
  for (const std::string& role : roleNames()) {
    EXPECT_EQ(roleJoint(roles, role), roleJoint(wanted, role)) << role << " of " << rig;
  }
}

// What other programs call the joints of a person; % is the side's letter, $ its word.
using Names = std::map<std::string, std::string>;
const std::map<std::string, Names> kStyles = {{"Mixamo",
                                               {{"hips", "mixamorig:Hips"},
                                                {"spine", "mixamorig:Spine"},
                                                {"chest", "mixamorig:Spine2"},
                                                {"neck", "mixamorig:Neck"},
                                                {"head", "mixamorig:Head"},
                                                {"shoulder", "mixamorig:$Shoulder"},
                                                {"arm", "mixamorig:$Arm"},
                                                {"fore_arm", "mixamorig:$ForeArm"},
                                                {"hand", "mixamorig:$Hand"},
                                                {"up_leg", "mixamorig:$UpLeg"},
                                                {"leg", "mixamorig:$Leg"},
                                                {"foot", "mixamorig:$Foot"},
                                                {"toe", "mixamorig:$ToeBase"}}},
                                              {"Biped",
                                               {{"hips", "Bip01 Pelvis"},
                                                {"spine", "Bip01 Spine"},
                                                {"chest", "Bip01 Spine2"},
                                                {"neck", "Bip01 Neck"},
                                                {"head", "Bip01 Head"},
                                                {"shoulder", "Bip01 % Clavicle"},
                                                {"arm", "Bip01 % UpperArm"},
                                                {"fore_arm", "Bip01 % Forearm"},
                                                {"hand", "Bip01 % Hand"},
                                                {"up_leg", "Bip01 % Thigh"},
                                                {"leg", "Bip01 % Calf"},
                                                {"foot", "Bip01 % Foot"},
                                                {"toe", "Bip01 % Toe0"}}},
                                              {"Unreal",
                                               {{"hips", "pelvis"},
                                                {"spine", "spine_01"},
                                                {"chest", "spine_03"},
                                                {"neck", "neck_01"},
                                                {"head", "head"},
                                                {"shoulder", "clavicle_%"},
                                                {"arm", "upperarm_%"},
                                                {"fore_arm", "lowerarm_%"},
                                                {"hand", "hand_%"},
                                                {"up_leg", "thigh_%"},
                                                {"leg", "calf_%"},
                                                {"foot", "foot_%"},
                                                {"toe", "ball_%"}}},
                                              {"VRM",
                                               {{"hips", "J_Bip_C_Hips"},
                                                {"spine", "J_Bip_C_Spine"},
                                                {"chest", "J_Bip_C_UpperChest"},
                                                {"neck", "J_Bip_C_Neck"},
                                                {"head", "J_Bip_C_Head"},
                                                {"shoulder", "J_Bip_%_Shoulder"},
                                                {"arm", "J_Bip_%_UpperArm"},
                                                {"fore_arm", "J_Bip_%_LowerArm"},
                                                {"hand", "J_Bip_%_Hand"},
                                                {"up_leg", "J_Bip_%_UpperLeg"},
                                                {"leg", "J_Bip_%_LowerLeg"},
                                                {"foot", "J_Bip_%_Foot"},
                                                {"toe", "J_Bip_%_ToeBase"}}}};

std::string nameIn(const Names& style, const std::string& role, bool small) {
  const bool left = role.starts_with("left_"), right = role.starts_with("right_");
  std::string name = style.at(left || right ? role.substr(role.find('_') + 1) : role);
  const std::string letter = small ? (left ? "l" : "r") : (left ? "L" : "R");
  for (const auto& [mark, side] : {std::pair('%', letter), {'$', left ? "Left" : "Right"}}) {
    if (const size_t at = name.find(mark); at != name.npos) name.replace(at, 1, side);
  }
  return name;
}

Clip renamed(Clip clip, const std::vector<std::string>& names) {
  std::vector<Joint> joints = clip.skeleton.joints();
  for (size_t j = 0; j < joints.size(); ++j) joints[j].name = names[j];
  clip.skeleton = Skeleton(joints);
  return clip;
}

// Largest distance of joints of the same index in the same frame [m].
double farthestByIndex(const Clip& a, const Clip& b) {
  EXPECT_EQ(a.frames(), b.frames());
  EXPECT_EQ(a.skeleton.size(), b.skeleton.size());
  double worst = 0.0;
  for (int i = 0; i < std::min(a.frames(), b.frames()); ++i) {
    const std::vector<JointFrame> x = jointFrames(a, i), y = jointFrames(b, i);
    for (size_t j = 0; j < std::min(x.size(), y.size()); ++j) {
      worst = std::max(worst, (x[j].p_WJ - y[j].p_WJ).norm());
    }
  }
  return worst;
}

class EveryRig : public testing::Test {
 protected:
  void SetUp() override { AMBLE_NEEDS_CAPTURES(); }
};

TEST_F(EveryRig, IsAPersonWhoseJointsEachHaveOneRole) {
  for (const RigWalk& rig : rigs()) {
    SCOPED_TRACE(rig.path);
    EXPECT_EQ(missingRole(rig.roles), "");
    std::set<int> limbs;
    int count = 0;
    for (const std::string& role : roleNames()) {
      if (role == "spine" || role == "chest") continue;  // may be one joint
      const int joint = roleJoint(rig.roles, role);
      if (joint < 0) continue;
      limbs.insert(joint);
      ++count;
    }
    EXPECT_EQ(static_cast<int>(limbs.size()), count);
    for (const LegJoints& leg : rig.roles.legs) {
      EXPECT_TRUE(rig.clip.skeleton.isAncestor(leg.up_leg, leg.leg));
      EXPECT_TRUE(rig.clip.skeleton.isAncestor(leg.leg, leg.foot));
    }
  }
}

TEST_F(EveryRig, HasTheSameRolesWhateverProgramNamesItsJoints) {
  for (const RigWalk& rig : rigs()) {
    for (const auto& [style, names] : kStyles) {
      std::vector<std::string> called(rig.clip.skeleton.size());
      for (size_t j = 0; j < called.size(); ++j) called[j] = "x" + std::to_string(j);
      for (const std::string& role : roleNames()) {
        const int joint = roleJoint(rig.roles, role);
        if (joint >= 0) called[joint] = nameIn(names, role, style == "Unreal");
      }
      const Clip clip = renamed(rig.clip, called);
      expectSameRoles(guessRoles(clip, "it.bvh").roles, rig.roles, rig.path + " as " + style);
    }
  }
}

TEST_F(EveryRig, HasTheSameRolesWithNumbersBehindAndASpaceInFrontOfItsNames) {
  for (const RigWalk& rig : rigs()) {
    std::vector<std::string> numbered, in_space;
    for (const Joint& joint : rig.clip.skeleton.joints()) {
      numbered.push_back(joint.name + ".001");
      in_space.push_back("Actor_7:" + joint.name);
    }
    for (const auto& names : {numbered, in_space}) {
      const Clip clip = renamed(rig.clip, names);
      expectSameRoles(guessRoles(clip, "it.bvh").roles, rig.roles, rig.path + names[0]);
    }
  }
}

// The order in which siblings are written, the unit and where the file lies say nothing.
TEST_F(EveryRig, HasTheSameShapeInAnyUnitAndPlace) {
  for (const RigWalk& rig : rigs()) {
    const JointRoles roles = rolesByTree(rig.clip);
    Clip other = rig.clip;
    std::vector<Joint> joints = other.skeleton.joints();
    for (Joint& joint : joints) joint.offset *= 39.37;
    other.skeleton = Skeleton(joints);
    for (int i = 0; i < other.frames(); ++i) {
      other.poses.p_WR(i) = 39.37 * other.poses.p_WR(i) + Eigen::Vector3d(1e3, -2e3, 5e2);
    }
    expectSameRoles(rolesByTree(other), roles, rig.path);
  }
}

TEST_F(EveryRig, IsTheSameMotionInEveryUnit) {
  const TestFolder folder;
  for (const RigWalk& rig : rigs()) {
    for (const double times : {1.0, 10.0, 100.0, 1.0 / 0.0254, 1000.0}) {
      const auto file = folder.path() / "it.bvh";
      writeBvh(file, rig.clip, {.metres_per_unit = 1.0 / times});
      const CapturedMotion motion = readMotion(file);
      EXPECT_NEAR(motion.metres_per_unit.value * times, 1.0, 1e-9)
          << rig.path << ": " << motion.metres_per_unit.text;
      EXPECT_LT(farthestByIndex(motion.clip, rig.clip), 1e-4) << rig.path;
      expectSameRoles(motion.roles, rig.roles, rig.path);
    }
  }
}

TEST_F(EveryRig, IsTheSameMotionWithEitherAxisUp) {
  const TestFolder folder;
  for (const RigWalk& rig : rigs()) {
    for (const UpAxis up : {UpAxis::kY, UpAxis::kZ}) {
      const auto file = folder.path() / "it.bvh";
      writeInAxes(file, rig.clip, 0.01, up);
      const CapturedMotion motion = readMotion(file);
      EXPECT_EQ(motion.up.value, up) << rig.path << ": " << motion.up.text;
      EXPECT_TRUE(motion.up.sure) << rig.path << ": " << motion.up.text;
      EXPECT_LT(farthestByIndex(motion.clip, rig.clip), 1e-4) << rig.path;
    }
  }
}

TEST_F(EveryRig, WrittenReadAndWrittenAgainIsTheSameBytes) {
  for (const RigWalk& rig : rigs()) {
    for (const double unit : {1.0, 0.01}) {
      std::ostringstream once, again;
      writeBvh(once, rig.clip, {.metres_per_unit = unit});
      std::istringstream in(once.str());
      writeBvh(again, readBvh(in, "it.bvh", {.metres_per_unit = unit}), {.metres_per_unit = unit});
      EXPECT_EQ(once.str(), again.str()) << rig.path;
    }
  }
}

TEST_F(EveryRig, IsTheSameMotionAsGltfAndCollada) {
  const TestFolder folder;
  for (const RigWalk& rig : rigs()) {
    if (!rig.clip.joint_positions.empty()) continue;
    const Clip some = trimmed(rig.clip, 0, 20);
    for (const auto& [name, text] :
         {std::pair("it.gltf", gltfOf(some)), {"it.dae", colladaOf(some, 0.0254, true)}}) {
      const CapturedMotion motion = readMotion(folder.write(name, text));
      ASSERT_EQ(motion.clip.frames(), some.frames()) << rig.path << ' ' << name;
      double worst = 0.0;
      for (int i = 0; i < some.frames(); ++i) {
        const std::vector<JointFrame> a = jointFrames(some, i), b = jointFrames(motion.clip, i);
        for (const std::string& role : roleNames()) {
          const int joint = roleJoint(rig.roles, role), copy = roleJoint(motion.roles, role);
          ASSERT_EQ(joint < 0, copy < 0) << rig.path << ' ' << name << ' ' << role;
          if (joint >= 0) worst = std::max(worst, (a[joint].p_WJ - b[copy].p_WJ).norm());
        }
      }
      EXPECT_LT(worst, 1e-3) << rig.path << ' ' << name;
    }
  }
}

Clip turnedAbout(Clip clip, const Eigen::Quaterniond& turn) {
  for (int i = 0; i < clip.frames(); ++i) {
    clip.poses.p_WR(i) = turn * clip.poses.p_WR(i);
    clip.poses.rotations(i)[0] = turn * clip.poses.rotations(i)[0];
  }
  return clip;
}

TEST_F(EveryRig, FacesElsewhereByWhatItIsTurned) {
  for (const RigWalk& rig : rigs()) {
    const Reading<double> facing = guessFacing(rig.clip, rig.roles);
    EXPECT_TRUE(facing.sure) << rig.path << ": " << facing.text;
    for (const double angle : {0.7, 2.5, -1.9}) {
      const Clip turned = turnedAbout(rig.clip, aboutZ(angle));
      const double off = guessFacing(turned, rig.roles).value - facing.value - angle;
      EXPECT_NEAR(wrapAngle(off), 0.0, 1e-9) << rig.path;
    }
  }
}

TEST_F(EveryRig, WhoseLeftIsItsRightIsAskedAbout) {
  for (const RigWalk& rig : rigs()) {
    JointRoles exchanged = rig.roles;
    std::swap(exchanged.legs[kLeft], exchanged.legs[kRight]);
    const Reading<double> facing = guessFacing(rig.clip, exchanged);
    if (rig.roles.legs[kLeft].toe < 0) continue;
    EXPECT_FALSE(facing.sure) << rig.path;
    EXPECT_NE(facing.text.find("are left and right exchanged?"), std::string::npos) << facing.text;
  }
}

// Head down is no axis that is up: then the usual one is taken, and said to be unsure.
TEST_F(EveryRig, OnItsSideHasNoAxisThatIsSurelyUp) {
  for (const RigWalk& rig : rigs()) {
    EXPECT_EQ(guessUp(rig.clip, rig.roles).value, UpAxis::kZ) << rig.path;
    EXPECT_EQ(guessUp(turnedAbout(rig.clip, yUpToWorld().conjugate()), rig.roles).value,
              UpAxis::kY);
    const Eigen::Quaterniond aside(Eigen::AngleAxisd(0.5 * kPi, Eigen::Vector3d::UnitY()));
    const Reading<UpAxis> lying = guessUp(turnedAbout(rig.clip, aside), rig.roles);
    EXPECT_EQ(lying.value, UpAxis::kY);
    EXPECT_FALSE(lying.sure) << rig.path << ": " << lying.text;
  }
}

}  // namespace
}  // namespace amble

#include "animation/body/joint_roles.h"

#include <gtest/gtest.h>

#include <set>

#include "animation/captures/bvh.h"
#include "base/error.h"
#include "tests/animation/captures.h"

namespace amble {
namespace {

/// A person's tree: pelvis, spine, neck, head, then left and right clavicle, arm, elbow, hand,
/// thigh, shin, foot, toe, where a side's names have `@` for its letter or word.
Skeleton person(const std::vector<std::string>& trunk, const std::vector<std::string>& limbs,
                const std::string& left, const std::string& right) {
  std::vector<Joint> joints;
  const auto add = [&](const std::string& name, int parent) {
    Joint joint;
    joint.name = name;
    joint.parent = parent;
    joint.offset = {0, parent < 0 ? 0.0 : 0.4, 0};
    joints.push_back(joint);
    return static_cast<int>(joints.size()) - 1;
  };
  for (size_t i = 0; i < trunk.size(); ++i) add(trunk[i], static_cast<int>(i) - 1);
  for (const std::string& side : {left, right}) {
    for (size_t i = 0; i < limbs.size(); ++i) {
      std::string name = limbs[i];
      for (size_t at = name.find('@'); at != name.npos; at = name.find('@'))
        name.replace(at, 1, side);
      const int hung = i == 0 ? 1 : 0;
      add(name, i == 0 || i == 4 ? hung : static_cast<int>(joints.size()) - 1);
    }
  }
  return Skeleton(joints);
}

struct NamedRig {
  const char* name;
  std::vector<std::string> trunk;
  std::vector<std::string> limbs;  // clavicle, arm, elbow, hand, thigh, shin, foot, toe
  std::string left, right;
};

const std::vector<NamedRig> kRigs = {
    {"MotionBuilder",
     {"Hips", "Spine", "Neck", "Head"},
     {"@Shoulder", "@Arm", "@ForeArm", "@Hand", "@UpLeg", "@Leg", "@Foot", "@ToeBase"},
     "Left",
     "Right"},
    {"Mixamo",
     {"mixamorig:Hips", "mixamorig:Spine", "mixamorig:Neck", "mixamorig:Head"},
     {"mixamorig:@Shoulder", "mixamorig:@Arm", "mixamorig:@ForeArm", "mixamorig:@Hand",
      "mixamorig:@UpLeg", "mixamorig:@Leg", "mixamorig:@Foot", "mixamorig:@ToeBase"},
     "Left",
     "Right"},
    {"Rokoko",
     {"Hips", "Spine1", "Neck", "Head"},
     {"@Shoulder", "@Arm", "@ForeArm", "@Hand", "@Thigh", "@Shin", "@Foot", "@Toe"},
     "Left",
     "Right"},
    {"Biped",
     {"Bip01 Pelvis", "Bip01 Spine", "Bip01 Neck", "Bip01 Head"},
     {"Bip01 @ Clavicle", "Bip01 @ UpperArm", "Bip01 @ Forearm", "Bip01 @ Hand", "Bip01 @ Thigh",
      "Bip01 @ Calf", "Bip01 @ Foot", "Bip01 @ Toe0"},
     "L",
     "R"},
    {"Daz",
     {"hip", "chest", "neck", "head"},
     {"@Collar", "@Shldr", "@ForeArm", "@Hand", "@Thigh", "@Shin", "@Foot", "@Toe"},
     "l",
     "r"},
    {"Acclaim",
     {"root", "thorax", "lowerneck", "head"},
     {"@clavicle", "@humerus", "@radius", "@wrist", "@femur", "@tibia", "@foot", "@toes"},
     "l",
     "r"},
    {"CMU for 3ds Max",
     {"Hips", "Chest", "Neck", "Head"},
     {"@Collar", "@Shoulder", "@Elbow", "@Wrist", "@Hip", "@Knee", "@Ankle", "@Toe"},
     "Left",
     "Right"},
    {"Unreal",
     {"pelvis", "spine_01", "neck_01", "head"},
     {"clavicle_@", "upperarm_@", "lowerarm_@", "hand_@", "thigh_@", "calf_@", "foot_@", "ball_@"},
     "l",
     "r"},
    {"VRM",
     {"hips", "spine", "neck", "head"},
     {"@Shoulder", "@UpperArm", "@LowerArm", "@Hand", "@UpperLeg", "@LowerLeg", "@Foot", "@Toes"},
     "left",
     "right"},
    {"VRoid",
     {"J_Bip_C_Hips", "J_Bip_C_Spine", "J_Bip_C_Neck", "J_Bip_C_Head"},
     {"J_Bip_@_Shoulder", "J_Bip_@_UpperArm", "J_Bip_@_LowerArm", "J_Bip_@_Hand",
      "J_Bip_@_UpperLeg", "J_Bip_@_LowerLeg", "J_Bip_@_Foot", "J_Bip_@_ToeBase"},
     "L",
     "R"},
    {"sides behind upper and lower",
     {"Hips", "Spine", "Neck", "Head"},
     {"Clavicle_@", "UpperArm_@", "LowerArm_@", "Hand_@", "UpperLeg_@", "LowerLeg_@", "Foot_@",
      "Toes_@"},
     "L",
     "R"},
    {"shortened",
     {"Hips", "Spine", "Neck", "Head"},
     {"@Collar", "@UpArm", "@LoArm", "@Hand", "@UpLeg", "@LowLeg", "@Foot", "@Toe"},
     "L",
     "R"},
    {"arms and legs with the side behind",
     {"Hips", "Spine", "Neck", "Head"},
     {"Shoulder_@", "Arm_@", "ForeArm_@", "Hand_@", "UpLeg_@", "Leg_@", "Foot_@", "ToeBase_@"},
     "L",
     "R"},
    {"numbered copies",
     {"hips.001", "spine.001", "neck.001", "head.001"},
     {"shoulder.@.001", "upper_arm.@.001", "forearm.@.001", "hand.@.001", "thigh.@.001",
      "shin.@.001", "foot.@.001", "toe.@.001"},
     "L",
     "R"},
    {"numbers without a mark",
     {"Hips", "Spine", "Neck", "Head1"},
     {"@Collar1", "@Arm1", "@ForeArm1", "@Hand1", "@UpLeg1", "@Leg1", "@Foot1", "@Toe1"},
     "Left",
     "Right"},
    {"SMPL",
     {"Pelvis", "Spine1", "Neck", "Head"},
     {"@_Collar", "@_Shoulder", "@_Elbow", "@_Wrist", "@_Hip", "@_Knee", "@_Ankle", "@_Foot"},
     "L",
     "R"},
    {"Kinect",
     {"SpineBase", "SpineMid", "Neck", "Head"},
     {"Collar@", "Shoulder@", "Elbow@", "Wrist@", "Hip@", "Knee@", "Ankle@", "Foot@"},
     "Left",
     "Right"},
    {"OptiTrack",
     {"Hip", "Chest", "Neck", "Head"},
     {"@Shoulder", "@UArm", "@FArm", "@Hand", "@Thigh", "@Shin", "@Foot", "@Toe"},
     "L",
     "R"},
    {"Auto-Rig Pro",
     {"root.x", "spine_01.x", "neck.x", "head.x"},
     {"shoulder.@", "arm_stretch.@", "forearm_stretch.@", "hand.@", "thigh_stretch.@",
      "leg_stretch.@", "foot.@", "toes_01.@"},
     "l",
     "r"},
    {"upper and lower behind",
     {"Hips", "Spine", "Neck", "Head"},
     {"@Shoulder", "@ArmUpper", "@ArmLower", "@Hand", "@LegUpper", "@LegLower", "@Foot", "@Toe"},
     "Left",
     "Right"},
    {"Maya",
     {"C_hip_jnt", "C_spine1_jnt", "C_neck_jnt", "C_head_jnt"},
     {"@_clavicle_jnt", "@_shoulder_jnt", "@_elbow_jnt", "@_wrist_jnt", "@_hip_jnt", "@_knee_jnt",
      "@_ankle_jnt", "@_ball_jnt"},
     "L",
     "R"},
    {"H-Anim",
     {"humanoid_root", "vl5", "vc4", "skullbase"},
     {"@_sternoclavicular", "@_shoulder", "@_elbow", "@_wrist", "@_hip", "@_knee", "@_ankle",
      "@_midtarsal"},
     "l",
     "r"},
    {"H-Anim 2",
     {"humanoid_root", "vl5", "vc4", "skullbase"},
     {"@_sternoclavicular", "@_shoulder", "@_elbow", "@_radiocarpal", "@_hip", "@_knee",
      "@_talocrural", "@_metatarsophalangeal"},
     "l",
     "r"},
};

TEST(JointRoles, HAnimsLegsHangBesideTheSpine) {
  std::vector<Joint> joints = person(kRigs[0].trunk, kRigs[0].limbs, "Left", "Right").joints();
  // A joint between the root and the legs, as H-Anim's sacroiliac.
  Joint sacrum;
  sacrum.name = "sacroiliac";
  sacrum.parent = 0;
  joints.insert(joints.begin() + 4, sacrum);
  for (size_t j = 5; j < joints.size(); ++j) {
    if (joints[j].parent >= 4) ++joints[j].parent;
    if (joints[j].name.ends_with("UpLeg")) joints[j].parent = 4;
  }
  const JointRoles roles = rolesByName(Skeleton(joints));
  EXPECT_EQ(roles.hips, 0);
  EXPECT_EQ(roles.spine, 1);
}

TEST(JointRoles, BonesThatTwistAreBetweenTheJointsOfALimbAndNotOfThem) {
  // Daz Genesis 3: each bone but the shin is two, one that bends and one that twists.
  const std::vector<std::string> limbs = {"@Collar",      "@ShldrBend",    "@ShldrTwist",
                                          "@ForearmBend", "@ForearmTwist", "@Hand"};
  std::vector<Joint> joints =
      person({"hip", "abdomenLower", "neckLower", "head"}, limbs, "l", "r").joints();
  const auto hang = [&joints](const std::string& name, int parent) {
    Joint joint;
    joint.name = name;
    joint.parent = parent;
    joints.push_back(joint);
    return static_cast<int>(joints.size()) - 1;
  };
  for (const std::string side : {"l", "r"}) {
    int parent = 0;
    for (const char* const name : {"ThighBend", "ThighTwist", "Shin", "Foot", "Toe"})
      parent = hang(side + name, parent);
  }
  // The arms of `person` hang their fifth joint on the pelvis: a forearm hangs on its arm.
  for (size_t j = 0; j < joints.size(); ++j) {
    if (joints[j].name.ends_with("ForearmTwist")) joints[j].parent = static_cast<int>(j) - 1;
  }
  const Skeleton skeleton(joints);
  const JointRoles roles = guessJointRoles(skeleton, "genesis3.bvh");
  for (const std::string side : {"left", "right"}) {
    const std::string letter = side.substr(0, 1);
    for (const auto& [role, name] :
         std::vector<std::pair<std::string, std::string>>{{"arm", "ShldrBend"},
                                                          {"fore_arm", "ForearmBend"},
                                                          {"hand", "Hand"},
                                                          {"up_leg", "ThighBend"},
                                                          {"leg", "Shin"},
                                                          {"foot", "Foot"},
                                                          {"toe", "Toe"}}) {
      EXPECT_EQ(roleJoint(roles, side + "_" + role), skeleton.find(letter + name)) << role;
    }
  }
}

TEST(JointRoles, ASkeletonWithoutAPersonIsRefusedByTheFirstRoleMissing) {
  const NamedRig& rig = kRigs[0];
  std::vector<std::string> limbs = rig.limbs;
  limbs[5] = "@Bone7";
  try {
    guessJointRoles(person(rig.trunk, limbs, rig.left, rig.right), "rig.bvh");
    ADD_FAILURE() << "no error";
  } catch (const InputError& error) {
    EXPECT_EQ(error.file(), "rig.bvh");
    EXPECT_NE(error.problem().find("left_leg"), std::string::npos) << error.what();
  }
  EXPECT_THROW(guessJointRoles(Skeleton(), "empty.bvh"), InputError);
}

TEST(JointRoles, AreFoundInTheCommonRigs) {
  const std::vector<std::string> limb_roles = {"shoulder", "arm", "fore_arm", "hand",
                                               "up_leg",   "leg", "foot",     "toe"};
  for (const NamedRig& rig : kRigs) {
    const JointRoles roles =
        guessJointRoles(person(rig.trunk, rig.limbs, rig.left, rig.right), rig.name);
    EXPECT_EQ(roles.hips, 0) << rig.name;
    EXPECT_EQ(roles.spine, 1) << rig.name;
    EXPECT_EQ(roles.chest, 1) << rig.name;
    EXPECT_EQ(roles.neck, 2) << rig.name;
    EXPECT_EQ(roles.head, 3) << rig.name;
    for (int side : {kLeft, kRight}) {
      for (int i = 0; i < 8; ++i) {
        const std::string role = (side == kLeft ? "left_" : "right_") + limb_roles[i];
        EXPECT_EQ(roleJoint(roles, role), 4 + 8 * side + i) << rig.name << " " << role;
      }
    }
  }
}

TEST(JointRoles, EveryRoleCanBeSetAndAskedByItsName) {
  JointRoles roles;
  int joint = 100;
  for (const std::string& role : roleNames()) EXPECT_TRUE(setRole(roles, role, joint++)) << role;
  joint = 100;
  for (const std::string& role : roleNames()) EXPECT_EQ(roleJoint(roles, role), joint++) << role;
  EXPECT_EQ(roleNames().front(), "hips");
  EXPECT_EQ(roles.legs[kRight].toe, roleJoint(roles, "right_toe"));
  for (const char* const none :
       {"", "left", "left_", "leftfoot", "middle_foot", "left_wing", "Hips"}) {
    EXPECT_FALSE(setRole(roles, none, 1)) << none;
    EXPECT_EQ(roleJoint(roles, none), -1) << none;
  }
}

TEST(JointRoles, LegLengthIsThighAndShank) {
  const NamedRig& rig = kRigs[0];
  const Skeleton skeleton = person(rig.trunk, rig.limbs, rig.left, rig.right);
  EXPECT_NEAR(guessJointRoles(skeleton, "").legLength(skeleton, kRight), 0.8, 1e-15);
}

TEST(JointRoles, TheUnitIsTheOneThatMakesALegOfAPersonsLength) {
  const NamedRig& rig = kRigs[0];
  const Skeleton metres = person(rig.trunk, rig.limbs, rig.left, rig.right);
  const JointRoles roles = guessJointRoles(metres, "");
  for (const double unit : {1.0, 0.01, 0.0254, 0.056444, 0.001}) {
    EXPECT_EQ(guessUnit(metres.scaled(1.0 / unit), roles), unit);
  }
}

TEST(JointRolesOfCaptures, AreAllFoundAndDifferent) {
  AMBLE_NEEDS_CAPTURES();
  for (const Capture& capture : captures()) {
    const Skeleton skeleton =
        readBvh(capture.file, {.metres_per_unit = capture.metres_per_unit}).skeleton;
    const JointRoles roles = guessJointRoles(skeleton, capture.path);
    std::set<int> seen;
    for (const std::string& role : roleNames()) {
      const int joint = roleJoint(roles, role);
      const bool toe = role.ends_with("toe");  // Daz rigs of this set have none
      EXPECT_TRUE(joint >= 0 || (toe && capture.path.starts_with("cmu_daz")))
          << capture.path << " " << role;
      EXPECT_TRUE(joint < 0 || seen.insert(joint).second) << capture.path << " " << role;
    }
    for (const int side : {kLeft, kRight}) {
      EXPECT_NEAR(roles.legLength(skeleton, static_cast<Side>(side)), 0.83, 0.13) << capture.path;
      // Left is left: with the rest pose facing +z of a y-up file the left limbs lie towards +x,
      // mostly.
      EXPECT_TRUE(skeleton.isAncestor(roles.hips, roles.legs[side].foot));
      EXPECT_TRUE(skeleton.isAncestor(roles.chest, roles.arms[side].fore_arm));
    }
  }
}

TEST(JointRolesOfCaptures, TheUnitIsGuessedAsTheManifestHasIt) {
  AMBLE_NEEDS_CAPTURES();
  for (const Capture& capture : captures()) {
    const Skeleton skeleton = readBvh(capture.file).skeleton;
    EXPECT_EQ(guessUnit(skeleton, guessJointRoles(skeleton, capture.path)), capture.metres_per_unit)
        << capture.path;
  }
}

}  // namespace
}  // namespace amble

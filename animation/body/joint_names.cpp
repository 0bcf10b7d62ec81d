#include "animation/body/joint_names.h"

#include <array>
#include <set>

namespace amble {
namespace {

// Mixamo's FBX; VRM 1.0's humanoid bones; Unreal's Mannequin; Unity's HumanBodyBones; CMU's ASF.
constexpr std::array<const char*, 5> kNamings = {"mixamo", "vrm", "unreal", "unity", "acclaim"};

struct RoleNames {
  const char* role;  // of the trunk, or of the limb on either side
  std::array<const char*, kNamings.size()> names;
};

constexpr std::array<RoleNames, 5> kTrunk = {
    {{"hips", {"mixamorig:Hips", "hips", "pelvis", "Hips", "root"}},
     {"spine", {"mixamorig:Spine", "spine", "spine_01", "Spine", "lowerback"}},
     {"chest", {"mixamorig:Spine2", "chest", "spine_03", "Chest", "thorax"}},
     {"neck", {"mixamorig:Neck", "neck", "neck_01", "Neck", "lowerneck"}},
     {"head", {"mixamorig:Head", "head", "head", "Head", "head"}}}};

// '*' is the side, as each naming writes it.
constexpr std::array<RoleNames, 8> kLimbs = {
    {{"up_leg", {"mixamorig:*UpLeg", "*UpperLeg", "thigh_*", "*UpperLeg", "*femur"}},
     {"leg", {"mixamorig:*Leg", "*LowerLeg", "calf_*", "*LowerLeg", "*tibia"}},
     {"foot", {"mixamorig:*Foot", "*Foot", "foot_*", "*Foot", "*foot"}},
     {"toe", {"mixamorig:*ToeBase", "*Toes", "ball_*", "*Toes", "*toes"}},
     {"shoulder", {"mixamorig:*Shoulder", "*Shoulder", "clavicle_*", "*Shoulder", "*clavicle"}},
     {"arm", {"mixamorig:*Arm", "*UpperArm", "upperarm_*", "*UpperArm", "*humerus"}},
     {"fore_arm", {"mixamorig:*ForeArm", "*LowerArm", "lowerarm_*", "*LowerArm", "*radius"}},
     {"hand", {"mixamorig:*Hand", "*Hand", "hand_*", "*Hand", "*wrist"}}}};
constexpr std::array<std::array<const char*, kNamings.size()>, 2> kSides = {
    {{"Left", "left", "l", "Left", "l"}, {"Right", "right", "r", "Right", "r"}}};

// Of joints with a role, by joint; "" of others.
std::vector<std::string> roleNamesOf(const Skeleton& skeleton, const JointRoles& roles,
                                     size_t naming) {
  std::vector<std::string> names(skeleton.size());
  const auto set = [&](const std::string& role, std::string name) {
    const int joint = roleJoint(roles, role);
    if (joint >= 0 && names[joint].empty()) names[joint] = std::move(name);
  };
  for (const RoleNames& trunk : kTrunk) set(trunk.role, trunk.names[naming]);
  for (const Side side : {kLeft, kRight})
    for (const RoleNames& limb : kLimbs) {
      std::string name = limb.names[naming];
      name.replace(name.find('*'), 1, kSides[side][naming]);
      set((side == kLeft ? "left_" : "right_") + std::string(limb.role), std::move(name));
    }
  return names;
}

}  // namespace

const std::vector<std::string>& jointNamings() {
  static const std::vector<std::string> names(kNamings.begin(), kNamings.end());
  return names;
}

std::vector<std::string> jointNames(const Skeleton& skeleton, const JointRoles& roles,
                                    std::string_view naming) {
  std::vector<std::string> names(skeleton.size());
  for (size_t i = 0; i < kNamings.size(); ++i)
    if (naming == kNamings[i]) names = roleNamesOf(skeleton, roles, i);
  std::set<std::string> taken(names.begin(), names.end());
  for (int j = 0; j < skeleton.size(); ++j) {
    if (!names[j].empty()) continue;
    const std::string& own = skeleton.joint(j).name;
    names[j] = own;
    if (naming.empty()) continue;
    for (int i = 2; !taken.insert(names[j]).second; ++i) names[j] = own + "_" + std::to_string(i);
  }
  return names;
}

Skeleton renamed(const Skeleton& skeleton, const std::vector<std::string>& names) {
  std::vector<Joint> joints = skeleton.joints();
  for (size_t j = 0; j < joints.size(); ++j) joints[j].name = names[j];
  return Skeleton(std::move(joints));
}

}  // namespace amble

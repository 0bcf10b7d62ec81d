#include "animation/library/motion_library.h"

#include "animation/body/foot_shape.h"
#include "base/text.h"

namespace amble {

const std::vector<std::string>& motionKindNames() {
  static const std::vector<std::string> kNames = {"walk", "movement", "posture",     "start",
                                                  "stop", "blocking", "turn_on_spot"};
  return kNames;
}

std::string partText(const MotionSource& source) {
  if (source.speed) return source.clip + " at " + shortNumber(*source.speed) + " m/s";
  return source.clip + " frames " + std::to_string(source.frames[0]) + " to " +
         std::to_string(source.frames[1]);
}

const std::vector<std::string>& chainNames() {
  static const std::vector<std::string> kNames = {"left_arm", "right_arm", "trunk", "head"};
  return kNames;
}

std::vector<int> chainJoints(const Skeleton& skeleton, const JointRoles& roles,
                             const std::string& chain) {
  const auto below = [&](int top) {
    std::vector<int> joints;
    for (int j = 0; top >= 0 && j < skeleton.size(); ++j) {
      if (skeleton.isAncestor(top, j)) joints.push_back(j);
    }
    return joints;
  };
  for (const Side side : {kLeft, kRight}) {
    const std::string name = side == kLeft ? "left_" : "right_";
    const ArmJoints& arm = roles.arms[side];
    if (chain == name + "arm") return below(arm.shoulder >= 0 ? arm.shoulder : arm.arm);
  }
  if (chain == "head") return below(roles.neck >= 0 ? roles.neck : roles.head);
  if (chain != "trunk" || roles.spine < 0 || roles.chest < 0) return {};
  std::vector<int> joints;  // on the way from the hips to the chest
  for (int j = roles.chest; j > roles.hips; j = skeleton.joint(j).parent) joints.push_back(j);
  return joints;
}

const Motion* MotionLibrary::find(const std::string& motion) const {
  for (const Motion& m : motions) {
    if (m.name == motion) return &m;
  }
  return nullptr;
}

std::array<FootShape, 2> MotionLibrary::feet() const {
  return makeFootShapes(skeleton, roles, stature);
}

MotionLack whatItLacks(const MotionLibrary& library) {
  const Motion* stand = library.find("stand");
  if (stand == nullptr || stand->kind != MotionKind::kPosture) {
    return {"no posture `stand`", "a motion of that name and kind"};
  }
  for (const Motion& motion : library.motions) {
    if (motion.kind == MotionKind::kWalk && !motion.turning) return {};
  }
  return {"no straight walk", "a motion of kind walk, turning straight"};
}

}  // namespace amble

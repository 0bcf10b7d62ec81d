/// A skeleton of everyday proportions, y up and facing +z in its rest pose, for tests that need
/// somebody.
#pragma once

#include <vector>

#include "animation/body/foot_shape.h"
#include "animation/body/joint_roles.h"
#include "animation/body/pose.h"
#include "animation/body/skeleton.h"
#include "animation/synthesis/animation_buffer.h"
#include "base/rotation.h"
#include "environments/body/body.h"

namespace amble {

struct TestWalker {
  Skeleton skeleton{joints()};
  JointRoles roles = guessJointRoles(skeleton, "test walker");
  double stature = 1.70;
  FootShape foot = makeFootShape(skeleton, roles, kLeft, stature);
  Body body = makeBody(skeleton, roles, stature, evenSoles({foot.ankle_height, foot.radius}));
  /// Of the root while it stands as in the rest pose on z = 0 [m].
  double root_height = foot.ankle_height + 0.89;

  int part(const std::string& name) const {
    for (size_t i = 0; i < body.parts.size(); ++i)
      if (body.parts[i].name == name) return static_cast<int>(i);
    return -1;
  }

  /// Standing with arms hanging, its root over (x, y), facing `heading`.
  Pose standing(double x, double y, double heading = 0.0, double floor = 0.0) const {
    Pose pose;
    pose.p_WR = {x, y, floor + root_height};
    pose.rotations.assign(skeleton.size(), Eigen::Quaterniond::Identity());
    // The rest pose faces the file's z, which is World's -y: 90 degrees to the left of it is +x.
    pose.rotations[0] = aboutZ(heading + 0.5 * kPi) * yUpToWorld();
    const Eigen::Vector3d forward = Eigen::Vector3d::UnitZ();
    pose.rotations[roles.arms[kLeft].arm] = expRotation(-0.45 * kPi * forward);
    pose.rotations[roles.arms[kRight].arm] = expRotation(0.45 * kPi * forward);
    return pose;
  }

  static std::vector<Joint> joints() {
    std::vector<Joint> list;
    const auto add = [&](const char* name, const char* parent, const Eigen::Vector3d& offset) {
      Joint joint;
      joint.name = name;
      for (size_t i = 0; i < list.size(); ++i)
        if (list[i].name == parent) joint.parent = static_cast<int>(i);
      joint.offset = offset;
      list.push_back(joint);
    };
    add("Hips", "", {0, 0, 0});
    add("Spine", "Hips", {0, 0.10, 0});
    add("Chest", "Spine", {0, 0.13, 0});
    add("Neck", "Chest", {0, 0.27, 0});
    add("Head", "Neck", {0, 0.10, 0.02});
    for (const double side : {1.0, -1.0}) {
      const bool left = side > 0.0;
      add(left ? "LeftShoulder" : "RightShoulder", "Chest", {side * 0.06, 0.2, 0});
      add(left ? "LeftArm" : "RightArm", left ? "LeftShoulder" : "RightShoulder",
          {side * 0.12, 0, 0});
      add(left ? "LeftForeArm" : "RightForeArm", left ? "LeftArm" : "RightArm",
          {side * 0.29, 0, 0});
      add(left ? "LeftHand" : "RightHand", left ? "LeftForeArm" : "RightForeArm",
          {side * 0.25, 0, 0});
      add(left ? "LeftUpLeg" : "RightUpLeg", "Hips", {side * 0.09, -0.06, 0});
      add(left ? "LeftLeg" : "RightLeg", left ? "LeftUpLeg" : "RightUpLeg", {0, -0.42, 0});
      add(left ? "LeftFoot" : "RightFoot", left ? "LeftLeg" : "RightLeg", {0, -0.41, 0});
      add(left ? "LeftToeBase" : "RightToeBase", left ? "LeftFoot" : "RightFoot", {0, -0.05, 0.13});
      list.back().end_sites = {{0, 0, 0.06}};
    }
    return list;
  }
};

/// Of frames with both feet planted, or neither.
inline std::vector<SolePhases> solesOf(int frames, bool planted) {
  const SolePhase phase = planted ? SolePhase::kPlanted : SolePhase::kSwinging;
  return std::vector<SolePhases>(frames, {phase, phase});
}

}  // namespace amble

#include "animation/clips/carry_over.h"

#include <cmath>
#include <string>

#include "base/rotation.h"

namespace amble {
namespace {

// A role's joint, the role at the end of its bone, and the role whose bone lies before it.
struct BoneRole {
  std::string joint, next, before;
};

std::vector<BoneRole> boneRoles() {
  std::vector<BoneRole> bones = {
      {"spine", "chest", ""}, {"chest", "neck", ""}, {"neck", "head", ""}};
  for (const std::string side : {"left_", "right_"}) {
    bones.push_back({side + "up_leg", side + "leg", ""});
    bones.push_back({side + "leg", side + "foot", ""});
    bones.push_back({side + "shoulder", side + "arm", ""});
    bones.push_back({side + "arm", side + "fore_arm", ""});
    bones.push_back({side + "fore_arm", side + "hand", ""});
    bones.push_back({side + "hand", "", side + "fore_arm"});
  }
  return bones;
}

// Which joint of the source a joint of the target follows (-1: none), and the rotation of
// q_WT = q_WS * q_ST.
struct Following {
  int source = -1;
  Eigen::Quaterniond q_ST = Eigen::Quaterniond::Identity();
};

class Matching {
 public:
  Matching(const UprightRig& from, const UprightRig& to)
      : from_(from),
        to_(to),
        there_(posed(from.skeleton, from.reference.q_HJ)),
        here_(posed(to.skeleton, to.reference.q_HJ)) {}

  std::vector<Following> match() const {
    std::vector<Following> following(to_.skeleton.size());
    for (const std::string& role : roleNames())
      follow(following, role, Eigen::Quaterniond::Identity());
    std::vector<std::pair<std::string, Eigen::Quaterniond>> swings;
    for (const BoneRole& bone : boneRoles()) {
      Eigen::Quaterniond swing = Eigen::Quaterniond::Identity();
      for (const auto& [role, earlier] : swings) {
        if (role == bone.before) swing = earlier;
      }
      if (!bone.next.empty()) swing = swingOf(bone);
      follow(following, bone.joint, swing);
      swings.emplace_back(bone.joint, swing);
    }
    followNames(following);
    for (const std::string side : {"left_", "right_"}) {  // soles are flat: they only face alike
      const BoneRole foot{side + "foot", side + "toe", ""};
      const Eigen::Quaterniond turn = aboutZ(yawOf(foot));
      follow(following, foot.joint, turn);
      follow(following, foot.next, turn);
    }
    return following;
  }

 private:
  // Joints of the trunk without a role follow those of their name, which rigs of one make have.
  void followNames(std::vector<Following>& following) const {
    for (int j = 0; j < to_.skeleton.size(); ++j) {
      if (following[j].source >= 0 || to_.roles.head < 0 ||
          !to_.skeleton.isAncestor(j, to_.roles.head))
        continue;
      const int source = from_.skeleton.find(to_.skeleton.joint(j).name);
      if (source < 0 || from_.roles.head < 0 ||
          !from_.skeleton.isAncestor(source, from_.roles.head))
        continue;
      following[j] = {source, from_.reference.q_HJ[source].conjugate() * to_.reference.q_HJ[j]};
    }
  }

  Eigen::Vector3d boneOf(const UprightRig& rig, const std::vector<JointFrame>& frames,
                         const BoneRole& bone) const {
    const int joint = roleJoint(rig.roles, bone.joint), next = roleJoint(rig.roles, bone.next);
    if (joint < 0 || next < 0) return Eigen::Vector3d::Zero();
    return frames[next].p_WJ - frames[joint].p_WJ;
  }

  // From the target's bone to the source's.
  Eigen::Quaterniond swingOf(const BoneRole& bone) const {
    const Eigen::Vector3d b = boneOf(to_, here_, bone), a = boneOf(from_, there_, bone);
    if (a.norm() < 1e-6 || b.norm() < 1e-6) return Eigen::Quaterniond::Identity();
    return turnBetween(b, a);
  }
  double yawOf(const BoneRole& bone) const {
    const Eigen::Vector3d b = boneOf(to_, here_, bone), a = boneOf(from_, there_, bone);
    if (a.norm() < 1e-6 || b.norm() < 1e-6) return 0.0;
    return std::atan2(a.y(), a.x()) - std::atan2(b.y(), b.x());
  }

  void follow(std::vector<Following>& following, const std::string& role,
              const Eigen::Quaterniond& swing) const {
    const int source = roleJoint(from_.roles, role), joint = roleJoint(to_.roles, role);
    if (source < 0 || joint < 0) return;
    following[joint] = {
        source, from_.reference.q_HJ[source].conjugate() * swing * to_.reference.q_HJ[joint]};
  }

  const UprightRig& from_;
  const UprightRig& to_;
  std::vector<JointFrame> there_, here_;
};

Eigen::Vector3d middleOfHips(const std::vector<JointFrame>& frames, const JointRoles& roles) {
  return 0.5 * (frames[roles.legs[kLeft].up_leg].p_WJ + frames[roles.legs[kRight].up_leg].p_WJ);
}

}  // namespace

Clip carriedOver(const Clip& clip, const UprightRig& from, const UprightRig& to) {
  const std::vector<Following> following = Matching(from, to).match();
  const double ratio = legOf(to.skeleton, to.roles) / legOf(from.skeleton, from.roles);
  const int joints = to.skeleton.size();
  Clip carried{clip.name, to.skeleton, clip.frame_time, PoseArray(joints), {}};
  carried.poses.resize(clip.frames());
  std::vector<JointFrame> source(clip.skeleton.size()), frames(joints);
  std::vector<Eigen::Quaterniond> q_WJ(joints);
  for (int i = 0; i < clip.frames(); ++i) {
    forwardKinematics(clip, i, source);
    const auto rotations = carried.poses.rotations(i);
    for (int j = 0; j < joints; ++j) {
      const int parent = to.skeleton.joint(j).parent;
      const Following& f = following[j];
      if (f.source >= 0) {
        q_WJ[j] = (source[f.source].q_WJ * f.q_ST).normalized();
        rotations[j] = parent < 0 ? q_WJ[j] : q_WJ[parent].conjugate() * q_WJ[j];
        continue;
      }
      rotations[j] = parent < 0 ? to.reference.q_HJ[j]
                                : to.reference.q_HJ[parent].conjugate() * to.reference.q_HJ[j];
      q_WJ[j] = parent < 0 ? rotations[j] : q_WJ[parent] * rotations[j];
    }
    carried.poses.p_WR(i).setZero();
    forwardKinematics(to.skeleton, carried.poses[i], frames);
    carried.poses.p_WR(i) =
        ratio * middleOfHips(source, from.roles) - middleOfHips(frames, to.roles);
  }
  return carried;
}

}  // namespace amble

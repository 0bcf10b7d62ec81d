#include "animation/body/reference_pose.h"

#include <cmath>

#include "animation/body/foot_shape.h"
#include "animation/body/pelvis.h"
#include "animation/body/rotation_mean.h"
#include "base/rotation.h"

namespace amble {

std::vector<JointFrame> posed(const Skeleton& skeleton,
                              const std::vector<Eigen::Quaterniond>& q_HJ) {
  std::vector<JointFrame> frames(skeleton.size());
  for (int j = 0; j < skeleton.size(); ++j) {
    frames[j].q_WJ = q_HJ[j];
    const int parent = skeleton.joint(j).parent;
    if (parent >= 0) frames[j].p_WJ = frames[parent] * skeleton.joint(j).offset;
  }
  return frames;
}

double legOf(const Skeleton& skeleton, const JointRoles& roles) {
  return 0.5 * (roles.legLength(skeleton, kLeft) + roles.legLength(skeleton, kRight));
}

namespace {

// A rest pose is one to stand in if feet hang below the hips by this share of the leg's length, the
// head rises over them, and hips and shoulders are where left and right are, by such shares of
// their width.
constexpr double kUprightLegs = 0.9;
constexpr double kUprightTrunk = 0.3;
constexpr double kUprightWidth = 0.9;
constexpr double kSlow = 0.3;  // a standing foot, in leg lengths a second, as in fitFloor

ReferencePose restPose(const Skeleton& skeleton, const JointRoles& roles) {
  return {std::vector<Eigen::Quaterniond>(skeleton.size(), restToHeading(skeleton, roles))};
}

bool isUpright(const Skeleton& skeleton, const JointRoles& roles, const ReferencePose& pose) {
  const std::vector<JointFrame> frames = posed(skeleton, pose.q_HJ);
  const double leg = legOf(skeleton, roles);
  const auto height = [&](int joint) { return frames[joint].p_WJ.z(); };
  const auto squarely = [&](int left, int right) {
    const Eigen::Vector3d across = frames[left].p_WJ - frames[right].p_WJ;
    return across.y() > kUprightWidth * across.norm();
  };
  if (!squarely(roles.legs[kLeft].up_leg, roles.legs[kRight].up_leg)) return false;
  const int left = roles.arms[kLeft].arm, right = roles.arms[kRight].arm;
  if (left >= 0 && right >= 0 && !squarely(left, right)) return false;
  for (const LegJoints& l : roles.legs) {
    if (height(l.up_leg) - height(l.foot) < kUprightLegs * leg) return false;
  }
  return roles.head < 0 || height(roles.head) - height(roles.hips) > kUprightTrunk * leg;
}

}  // namespace

ReferencePose meanPose(const Clip& clip, const JointRoles& roles) {
  const int joints = clip.skeleton.size();
  std::vector<RotationMean> mean(joints), standing(joints);
  std::vector<JointFrame> frames(joints), before(joints);
  const double slow = kSlow * legOf(clip.skeleton, roles) * clip.frame_time;
  for (int i = 0; i < clip.frames(); ++i) {
    forwardKinematics(clip, i, frames);
    const Eigen::Quaterniond back = aboutZ(-pelvisHeading(frames, roles));
    for (int j = 0; j < joints; ++j) mean[j].add(back * frames[j].q_WJ);
    for (const LegJoints& leg : roles.legs) {
      const auto still = [&](int j) {
        return j < 0 || (frames[j].p_WJ - before[j].p_WJ).norm() < slow;
      };
      if (i == 0 || !still(leg.foot) || !still(leg.toe)) continue;
      standing[leg.foot].add(back * frames[leg.foot].q_WJ);
      if (leg.toe >= 0) standing[leg.toe].add(back * frames[leg.toe].q_WJ);
    }
    std::swap(frames, before);
  }
  ReferencePose pose;
  for (const RotationMean& joint : mean) pose.q_HJ.push_back(joint.mean());
  // Who walks in a curve leans into it, in the mean too: upright are both hips at one height.
  const std::vector<JointFrame> leant = posed(clip.skeleton, pose.q_HJ);
  const Eigen::Vector3d left =
      leant[roles.legs[kLeft].up_leg].p_WJ - leant[roles.legs[kRight].up_leg].p_WJ;
  const Eigen::Quaterniond upright = turnBetween(left.normalized(), Eigen::Vector3d::UnitY());
  for (int j = 0; j < joints; ++j) {
    pose.q_HJ[j] = standing[j].empty() ? upright * pose.q_HJ[j] : standing[j].mean();
  }
  return pose;
}

ReferencePose referenceOf(const Clip& clip, const JointRoles& roles) {
  const ReferencePose rest = restPose(clip.skeleton, roles);
  return isUpright(clip.skeleton, roles, rest) ? rest : meanPose(clip, roles);
}

ReferencePose referenceOf(const Skeleton& skeleton, const JointRoles& roles,
                          const std::vector<Eigen::Quaterniond>& stand) {
  const ReferencePose rest = restPose(skeleton, roles);
  if (isUpright(skeleton, roles, rest)) return rest;
  ReferencePose pose;
  for (int j = 0; j < skeleton.size(); ++j) {
    const int parent = skeleton.joint(j).parent;
    pose.q_HJ.push_back(parent < 0 ? stand[j] : pose.q_HJ[parent] * stand[j]);
  }
  return pose;
}

std::array<Eigen::Vector3d, 2> kneeAxes(const JointRoles& roles, const ReferencePose& reference) {
  const auto axis = [&](Side side) -> Eigen::Vector3d {
    return reference.q_HJ[roles.legs[side].up_leg].conjugate() * Eigen::Vector3d::UnitY();
  };
  return {axis(kLeft), axis(kRight)};
}

}  // namespace amble

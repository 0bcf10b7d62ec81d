#include "animation/clips/rest_feet_flat.h"

#include <cmath>

#include "animation/body/foot_shape.h"
#include "animation/body/reference_pose.h"
#include "animation/body/rest_feet.h"
#include "animation/clips/foot_paths.h"
#include "base/rotation.h"
#include "base/statistics.h"

namespace amble {
namespace {

// How far below level a bone of the rest pose points, towards where the walker faces, in the
// heading frame [rad].
double dropOf(const Eigen::Vector3d& bone) { return std::atan2(-bone.z(), bone.x()); }

// Of feet and toes, and what is below them: the turn after which feet drop by `drop` and toes not
// at all.
void turnFeet(const Skeleton& skeleton, const JointRoles& roles, double drop,
              std::vector<Eigen::Quaterniond>& turns) {
  const Eigen::Quaterniond q_HR = restToPelvisHeading(skeleton, roles);
  const auto lowered = [&](double by) {
    return (q_HR.conjugate() * Eigen::AngleAxisd(by, Eigen::Vector3d::UnitY()) * q_HR).normalized();
  };
  const auto turnFrom = [&](int root, const Eigen::Quaterniond& turn) {
    for (int j = root; j < skeleton.size(); ++j) {
      if (skeleton.isAncestor(root, j)) turns[j] = turn;
    }
  };
  for (const LegJoints& leg : roles.legs) {
    const Joint& toe = skeleton.joint(leg.toe);
    turnFrom(leg.foot, lowered(dropOf(q_HR * toe.offset) - drop));
    if (toe.end_sites.empty() || toe.end_sites[0].isZero()) continue;
    turnFrom(leg.toe, lowered(dropOf(q_HR * toe.end_sites[0])));
  }
}

// From a joint to what hangs on it first, in its own frame; zero where nothing does.
Eigen::Vector3d boneOf(const Skeleton& skeleton, int joint) {
  for (int j = joint + 1; j < skeleton.size(); ++j) {
    if (skeleton.joint(j).parent == joint) return skeleton.joint(j).offset;
  }
  const std::vector<Eigen::Vector3d>& tips = skeleton.joint(joint).end_sites;
  return tips.empty() ? Eigen::Vector3d::Zero() : tips[0];
}

// Of arms and hands: the turn after which a limb that is taken from its mean pose to where it is at
// rest, on the shortest way, is at rest.
void turnArms(const Clip& clip, const JointRoles& roles, std::vector<Eigen::Quaterniond>& turns) {
  const Skeleton& skeleton = clip.skeleton;
  const Eigen::Quaterniond q_HR = restToPelvisHeading(skeleton, roles);
  const ReferencePose mean = meanPose(clip, roles);
  for (const ArmJoints& arm : roles.arms) {
    for (int j = arm.arm; j >= 0 && j < skeleton.size(); ++j) {
      const Eigen::Vector3d bone = boneOf(skeleton, j);
      if (!skeleton.isAncestor(arm.arm, j) || bone.isZero()) continue;
      const Eigen::Quaterniond swing = turnBetween(mean.q_HJ[j] * bone, q_HR * bone);
      turns[j] = ((swing * mean.q_HJ[j]).conjugate() * q_HR).normalized();
    }
  }
}

}  // namespace

Clip withTurnedFrames(const Clip& clip, const std::vector<Eigen::Quaterniond>& turns) {
  Clip turned = clip;
  std::vector<Joint> joints = clip.skeleton.joints();
  const size_t count = joints.size();
  for (size_t j = 0; j < count; ++j) {
    for (Eigen::Vector3d& tip : joints[j].end_sites) tip = turns[j].conjugate() * tip;
    if (j == 0) continue;
    const Eigen::Quaterniond back = turns[joints[j].parent].conjugate();
    joints[j].offset = back * joints[j].offset;
    for (int i = 0; i < clip.frames(); ++i) {
      Eigen::Quaterniond& q = turned.poses.rotations(i)[j];
      q = (back * q * turns[j]).normalized();
      if (clip.joint_positions.empty()) continue;
      Eigen::Vector3d& p = turned.joint_positions[i * count + j];
      p = back * p;
    }
  }
  turned.skeleton = Skeleton(std::move(joints));
  return turned;
}

std::optional<double> standingFootDrop(const Clip& clip, const JointRoles& roles) {
  const FootPaths paths = footPaths(clip, roles);
  const std::array<double, 2> legs = legLengths(clip, roles);
  std::vector<double> drops;
  for (const Side side : {kLeft, kRight}) {
    for (int i = 1; i + 1 < clip.frames(); ++i) {
      if (!stands(paths[side], i, legs[side], clip.frame_time)) continue;
      const Eigen::Vector3d foot = paths[side].row(i).tail<3>() - paths[side].row(i).head<3>();
      drops.push_back(std::atan2(-foot.z(), foot.head<2>().norm()));
    }
  }
  if (drops.empty()) return std::nullopt;
  return upperMedian(drops);
}

bool restFeetFlat(Clip& clip, const JointRoles& roles) {
  if (restFootDrop(clip.skeleton, roles) <= kHangingFoot) return false;
  const std::optional<double> drop = standingFootDrop(clip, roles);
  if (!drop) return false;
  std::vector<Eigen::Quaterniond> turns(clip.skeleton.size(), Eigen::Quaterniond::Identity());
  turnFeet(clip.skeleton, roles, *drop, turns);
  turnArms(clip, roles, turns);
  clip = withTurnedFrames(clip, turns);
  return true;
}

}  // namespace amble

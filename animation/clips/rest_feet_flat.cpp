#include "animation/clips/rest_feet_flat.h"

#include <algorithm>
#include <cmath>

#include "animation/body/foot_shape.h"
#include "animation/body/reference_pose.h"
#include "animation/body/rest_feet.h"
#include "animation/clips/foot_paths.h"
#include "base/rotation.h"
#include "base/statistics.h"

namespace amble {
namespace {

// Feet that stand as they are at rest but for so much stand so [rad].
constexpr double kStandsAsAtRest = 0.1 * kDegree;

// Where a foot points at rest, in the heading frame; one that hangs says little of that.
Eigen::Vector3d aheadOf(const Eigen::Vector3d& bone, bool hangs) {
  if (hangs) return Eigen::Vector3d::UnitX();
  return Eigen::Vector3d(bone.x(), bone.y(), 0.0).normalized();
}

// Of feet and toes, and what is below them: the turn after which feet drop by `drops` and toes not
// at all.
void turnFeet(const Skeleton& skeleton, const JointRoles& roles, const std::array<double, 2>& drops,
              std::vector<Eigen::Quaterniond>& turns) {
  const Eigen::Quaterniond q_HR = restToPelvisHeading(skeleton, roles);
  const bool hangs = restFootDrop(skeleton, roles) > kHangingFoot;
  for (const Side side : {kLeft, kRight}) {
    const LegJoints& leg = roles.legs[side];
    const Joint& toe = skeleton.joint(leg.toe);
    const Eigen::Vector3d ahead = aheadOf(q_HR * toe.offset, hangs);
    const Eigen::Vector3d left = Eigen::Vector3d::UnitZ().cross(ahead);
    // How far a bone drops below level towards where the foot points.
    const auto dropOf = [&](const Eigen::Vector3d& bone) {
      const Eigen::Vector3d seen = q_HR * bone;
      return std::atan2(-seen.z(), seen.dot(ahead));
    };
    const auto turnFrom = [&](int root, double by) {
      const Eigen::Quaterniond turn =
          (q_HR.conjugate() * Eigen::AngleAxisd(by, left) * q_HR).normalized();
      for (int j = root; j < skeleton.size(); ++j) {
        if (skeleton.isAncestor(root, j)) turns[j] = turn;
      }
    };
    turnFrom(leg.foot, dropOf(toe.offset) - drops[side]);
    if (toe.end_sites.empty() || toe.end_sites[0].isZero()) continue;
    turnFrom(leg.toe, dropOf(toe.end_sites[0]));
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

std::optional<std::array<double, 2>> standingFootDrops(const Clip& clip, const JointRoles& roles) {
  const FootPaths paths = footPaths(clip, roles);
  const std::array<double, 2> legs = legLengths(clip, roles);
  std::array<std::optional<double>, 2> median;
  for (const Side side : {kLeft, kRight}) {
    std::vector<double> drops;
    for (int i = 1; i + 1 < clip.frames(); ++i) {
      if (!stands(paths[side], i, legs[side], clip.frame_time)) continue;
      const Eigen::Vector3d foot = paths[side].row(i).tail<3>() - paths[side].row(i).head<3>();
      drops.push_back(std::atan2(-foot.z(), foot.head<2>().norm()));
    }
    if (!drops.empty()) median[side] = upperMedian(drops);
  }
  if (!median[kLeft] && !median[kRight]) return std::nullopt;
  return std::array{median[kLeft].value_or(median[kRight].value_or(0.0)),
                    median[kRight].value_or(median[kLeft].value_or(0.0))};
}

Clip withFeetAtRest(const Clip& clip, const JointRoles& roles, const std::array<double, 2>& drops) {
  std::vector<Eigen::Quaterniond> turns(clip.skeleton.size(), Eigen::Quaterniond::Identity());
  turnFeet(clip.skeleton, roles, drops, turns);
  return withTurnedFrames(clip, turns);
}

bool restFeetFlat(Clip& clip, const JointRoles& roles) {
  const std::optional<std::array<double, 2>> drops = standingFootDrops(clip, roles);
  if (!drops) return false;
  const bool hangs = restFootDrop(clip.skeleton, roles) > kHangingFoot;
  const std::array<double, 2> now = footDrops(clip.skeleton, roles);
  const auto off = [&](Side side) { return std::abs((*drops)[side] - now[side]); };
  if (!hangs && std::max(off(kLeft), off(kRight)) < kStandsAsAtRest) return false;
  std::vector<Eigen::Quaterniond> turns(clip.skeleton.size(), Eigen::Quaterniond::Identity());
  turnFeet(clip.skeleton, roles, *drops, turns);
  if (hangs) turnArms(clip, roles, turns);
  clip = withTurnedFrames(clip, turns);
  return true;
}

}  // namespace amble

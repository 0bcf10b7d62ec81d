#include "animation/clips/add_toes.h"

#include <algorithm>

#include "animation/body/foot_shape.h"
#include "base/error.h"

namespace amble {
namespace {

// A foot's tip that lies further from the ankle is that of its toes, a nearer one is its ball: of
// stature. Between the 0.075 and 0.11 of people (Drillis & Contini's foot of 0.152, a quarter of it
// behind the ankle).
constexpr double kToesFrom = 0.09;
constexpr double kToesOfStature = 0.035;  // length of the toes, as FootShape has it

// The joint that follows the foot in the skeleton, its offset and its tip. Its name is one that
// readers of captures know, ours too.
Joint toeOf(Side side, const Joint& foot, int foot_index, double stature) {
  const Eigen::Vector3d& tip = foot.end_sites.front();
  const double reach = tip.norm();
  const double toes = reach > kToesFrom * stature ? kToesOfStature * stature / reach : 0.0;
  Joint toe;
  toe.name = side == kLeft ? "LeftToeBase" : "RightToeBase";
  toe.parent = foot_index;
  toe.offset = (1.0 - toes) * tip;
  toe.end_sites = {toes * tip};
  return toe;
}

// Joint indices after one was put in at `at`.
int moved(int joint, int at) { return joint >= at ? joint + 1 : joint; }

Skeleton withJoint(const Skeleton& skeleton, const Joint& added, int at) {
  std::vector<Joint> joints = skeleton.joints();
  for (Joint& joint : joints) joint.parent = moved(joint.parent, at);
  joints[at - 1].end_sites.clear();
  joints.insert(joints.begin() + at, added);
  return Skeleton(std::move(joints));
}

PoseArray withStillJoint(const PoseArray& poses, int at) {
  PoseArray result(poses.joints() + 1);
  result.resize(poses.size());
  for (int i = 0; i < poses.size(); ++i) {
    result.p_WR(i) = poses.p_WR(i);
    const auto from = poses.rotations(i);
    const auto to = result.rotations(i);
    std::copy(from.begin(), from.begin() + at, to.begin());
    std::copy(from.begin() + at, from.end(), to.begin() + at + 1);
  }
  return result;
}

int firstChild(const Skeleton& skeleton, int joint) {
  for (int j = joint + 1; j < skeleton.size(); ++j) {
    if (skeleton.joint(j).parent == joint && skeleton.joint(j).offset.norm() > 0.0) return j;
  }
  return -1;
}

}  // namespace

void addToes(Clip& clip, JointRoles& roles, const std::string& file) {
  const double stature = statureOf(clip.skeleton, roles);
  for (const Side side : {kLeft, kRight}) {
    const int foot = roles.legs[side].foot;
    int& toe = roles.legs[side].toe;
    if (toe >= 0) continue;
    toe = firstChild(clip.skeleton, foot);
    if (toe >= 0) continue;
    const Joint& joint = clip.skeleton.joint(foot);
    if (joint.end_sites.empty() || !(joint.end_sites.front().norm() > 0.0)) {
      throw InputError(file, 0, "a foot without toes or a tip: joint " + joint.name,
                       "a joint or an End Site at its end");
    }
    const int at = foot + 1;  // behind the foot, as BVH has them
    const Skeleton with = withJoint(clip.skeleton, toeOf(side, joint, foot, stature), at);
    for (const std::string& role : roleNames()) {
      setRole(roles, role, moved(roleJoint(roles, role), at));
    }
    roles.legs[side].toe = at;
    clip.poses = withStillJoint(clip.poses, at);
    clip.skeleton = with;
    clip.joint_positions.clear();  // feet on moving joints are taken as their skeleton has them
  }
}

}  // namespace amble

#include "animation/grafting/upper_on_base.h"

#include <algorithm>
#include <cmath>

#include "animation/clips/carry_over.h"

namespace amble {
namespace {

// Bones of one rig in files of other units and persons point alike, to rounding [rad].
constexpr double kSameDirection = 1e-4;

bool sameRig(const Skeleton& a, const Skeleton& b) {
  if (a.size() != b.size()) return false;
  for (int j = 0; j < a.size(); ++j) {
    const Joint &left = a.joint(j), &right = b.joint(j);
    if (left.name != right.name || left.parent != right.parent) return false;
    const double la = left.offset.norm(), lb = right.offset.norm();
    if (j == 0 || (la == 0.0 && lb == 0.0)) continue;
    if (left.offset.cross(right.offset).norm() > kSameDirection * la * lb ||
        left.offset.dot(right.offset) <= 0.0) {
      return false;
    }
  }
  return true;
}

// The joint of a name that a joint without a role follows, where it hangs on the like; else -1.
int namesake(const LocomotiveClip& upper, const Skeleton& base, int joint) {
  const int there = upper.clip.skeleton.find(base.joint(joint).name);
  const int parent = base.joint(joint).parent;
  if (there < 0 || parent < 0) return -1;
  const int above = upper.clip.skeleton.joint(there).parent;
  return above >= 0 && upper.clip.skeleton.joint(above).name == base.joint(parent).name ? there
                                                                                        : -1;
}

Eigen::Quaterniond inParent(const Skeleton& skeleton, const ReferencePose& reference, int joint) {
  return reference.q_HJ[skeleton.joint(joint).parent].conjugate() * reference.q_HJ[joint];
}

std::vector<bool> haveRoles(const LocomotiveClip& upper, const LocomotiveClip& base) {
  std::vector<bool> have(base.clip.skeleton.size(), false);
  for (const std::string& role : roleNames()) {
    const int joint = roleJoint(base.roles, role);
    if (joint >= 0 && roleJoint(upper.roles, role) >= 0) have[joint] = true;
  }
  return have;
}

// What it turns by in the upper clip's reference, seen from there, it turns by in the base's.
void followNamesake(const LocomotiveClip& upper, const ReferencePose& from, int source,
                    const Skeleton& to_skeleton, const ReferencePose& to, int joint,
                    PoseArray& poses) {
  const Eigen::Quaterniond q_from = inParent(upper.clip.skeleton, from, source);
  const Eigen::Quaterniond q_to = inParent(to_skeleton, to, joint);
  const Eigen::Quaterniond q_ST = from.q_HJ[source].conjugate() * to.q_HJ[joint];
  for (int i = 0; i < upper.clip.frames(); ++i) {
    const Eigen::Quaterniond turn = q_from.conjugate() * upper.clip.poses.rotations(i)[source];
    poses.rotations(i)[joint] = q_to * q_ST.conjugate() * turn * q_ST;
  }
}

}  // namespace

UpperOnBase upperOnBase(const LocomotiveClip& upper, const LocomotiveClip& base) {
  const Skeleton& skeleton = base.clip.skeleton;
  UpperOnBase result;
  result.first = upper.first;
  result.last = upper.last;
  if (sameRig(upper.clip.skeleton, skeleton)) {
    result.poses = upper.clip.poses;
    result.follows.assign(skeleton.size(), true);
    return result;
  }
  const ReferencePose from = referenceOf(upper.clip, upper.roles);
  const ReferencePose to = referenceOf(base.clip, base.roles);
  result.poses =
      carriedOver(upper.clip, {upper.clip.skeleton, upper.roles, from}, {skeleton, base.roles, to})
          .poses;
  result.follows = haveRoles(upper, base);
  for (int j = skeleton.size() - 1; j > 0; --j) {  // children first
    if (result.follows[j]) {
      result.follows[skeleton.joint(j).parent] = true;
      continue;
    }
    const int source = namesake(upper, skeleton, j);
    if (source < 0) continue;
    followNamesake(upper, from, source, skeleton, to, j, result.poses);
    result.follows[j] = true;
  }
  return result;
}

void UpperOnBase::at(double frame, const std::vector<int>& joints,
                     std::span<Eigen::Quaterniond> rotations) const {
  const int i = std::clamp(static_cast<int>(std::floor(frame)), first, last);
  const double t = std::clamp(frame - i, 0.0, 1.0);
  const auto of = [&](int k) { return poses.rotations(std::clamp(k, first, last)); };
  for (const int j : joints) {
    const Eigen::Quaterniond& b = of(i)[j];
    if (t == 0.0 || i == last) {
      rotations[j] = b;
      continue;
    }
    const auto near = [&](int k) -> Eigen::Vector4d {
      const Eigen::Vector4d q = of(k)[j].coeffs();
      return q.dot(b.coeffs()) < 0.0 ? Eigen::Vector4d(-q) : q;
    };
    const Eigen::Vector4d q0 = near(i - 1), q1 = b.coeffs(), q2 = near(i + 1), q3 = near(i + 2);
    const Eigen::Vector4d m1 = 0.5 * (q2 - q0), m2 = 0.5 * (q3 - q1), rise = q2 - q1;
    const Eigen::Vector4d bend = (m1 - rise) * (1.0 - t) + (rise - m2) * t;
    rotations[j] = Eigen::Quaterniond(Eigen::Vector4d(q1 + t * rise + t * (1.0 - t) * bend));
    rotations[j].normalize();
  }
}

}  // namespace amble

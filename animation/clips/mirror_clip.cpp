#include "animation/clips/mirror_clip.h"

#include <algorithm>
#include <cmath>

#include "animation/body/foot_shape.h"
#include "animation/body/rest_feet.h"
#include "animation/clips/carry_over.h"
#include "base/rotation.h"

namespace amble {
namespace {

// Every rotation and offset mirrored in the plane y = 0: a rig whose left side is the other's
// right.
Eigen::Vector3d mirrored(const Eigen::Vector3d& p) { return {p.x(), -p.y(), p.z()}; }
Eigen::Quaterniond mirrored(const Eigen::Quaterniond& q) { return {q.w(), -q.x(), q.y(), -q.z()}; }

Skeleton mirrored(const Skeleton& skeleton) {
  std::vector<Joint> joints = skeleton.joints();
  for (Joint& joint : joints) {
    joint.offset = mirrored(joint.offset);
    for (Eigen::Vector3d& tip : joint.end_sites) tip = mirrored(tip);
  }
  return Skeleton(std::move(joints));
}

JointRoles mirrored(JointRoles roles) {
  std::swap(roles.legs[kLeft], roles.legs[kRight]);
  std::swap(roles.arms[kLeft], roles.arms[kRight]);
  return roles;
}

// With feet that stand on their soles as they head: markers roll each foot in its own way, by which
// it would be turned otherwise than its image.
void standFeet(const Skeleton& skeleton, const JointRoles& roles, ReferencePose& reference) {
  for (const Side side : {kLeft, kRight}) {
    const LegJoints& leg = roles.legs[side];
    const FootShape foot = makeFootShape(skeleton, roles, side, 1.0);
    const Eigen::Vector3d ahead =
        reference.q_HJ[leg.foot] * foot.q_SF.conjugate() * Eigen::Vector3d::UnitX();
    reference.q_HJ[leg.foot] = aboutZ(std::atan2(ahead.y(), ahead.x())) * foot.q_SF;
    reference.q_HJ[leg.toe] = reference.q_HJ[leg.foot];
  }
}

}  // namespace

Clip mirrorClip(const Clip& clip, const JointRoles& roles) {
  ReferencePose reference = referenceOf(clip, roles);
  if (restFootDrop(clip.skeleton, roles) <= kHangingFoot)
    standFeet(clip.skeleton, roles, reference);
  Clip other = clip;
  other.skeleton = mirrored(clip.skeleton);
  for (int i = 0; i < clip.frames(); ++i) {
    other.poses.p_WR(i) = mirrored(clip.poses.p_WR(i));
    for (Eigen::Quaterniond& q : other.poses.rotations(i)) q = mirrored(q);
  }
  ReferencePose other_reference;
  for (const Eigen::Quaterniond& q : reference.q_HJ) other_reference.q_HJ.push_back(mirrored(q));
  const JointRoles other_roles = mirrored(roles);
  return carriedOver(other, {other.skeleton, other_roles, other_reference},
                     {clip.skeleton, roles, reference});
}

}  // namespace amble
